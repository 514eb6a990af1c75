// anteroom-screenshot FILE: writes what is on the screen of the X or Wayland server that the environment
// names.
#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <exception>

#include "native.h"

namespace {

bool write(const char* path, const windows::Image& image) {
  const auto output = OIIO::ImageOutput::create(path);
  if (!output) return false;
  const auto& pixels = image.pixels;
  const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  const OIIO::stride_t row = OIIO::stride_t(sizeof pixels[0]) * image.width;
  return output->open(path, spec) &&
         output->write_image(OIIO::TypeDesc::UINT8, pixels.data() + pixels.size() - std::size_t(image.width),
                             OIIO::AutoStride, -row) &&
         output->close();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: anteroom-screenshot FILE.png\n");
    return 2;
  }
  const auto platforms = windows::platforms();
  if (platforms.empty()) {
    std::fprintf(stderr, "anteroom-screenshot: neither DISPLAY nor WAYLAND_DISPLAY is set\n");
    return 1;
  }
  try {
    // Wayland where there is both.
    if (write(argv[1], windows::NativeDisplay::open(platforms.back())->screen())) return 0;
    std::fprintf(stderr, "anteroom-screenshot: cannot write %s\n", argv[1]);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "anteroom-screenshot: %s\n", failure.what());
  }
  return 1;
}
