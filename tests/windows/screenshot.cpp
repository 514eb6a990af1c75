// anteroom-screenshot FILE: writes what is on the screen of the X or Wayland server that the environment
// names.
#include <OpenImageIO/imageio.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

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
  CLI::App app("Writes what is on the screen of the X or Wayland server that the environment names.");
  app.set_version_flag("--version", "anteroom-screenshot " ANTEROOM_VERSION);
  std::string file;
  app.add_option("FILE", file, "the picture, for instance screen.png")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? 2 : 0;
  }
  const auto platforms = windows::platforms();
  if (platforms.empty()) {
    std::fprintf(stderr, "anteroom-screenshot: neither DISPLAY nor WAYLAND_DISPLAY is set\n");
    return 1;
  }
  try {
    // Wayland where there is both.
    if (write(file.c_str(), windows::NativeDisplay::open(platforms.back())->screen())) return 0;
    std::fprintf(stderr, "anteroom-screenshot: cannot write %s\n", file.c_str());
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "anteroom-screenshot: %s\n", failure.what());
  }
  return 1;
}
