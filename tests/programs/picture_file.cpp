#include "picture_file.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>

namespace programs {
namespace {

OIIO::stride_t rowOf(const windows::Image& image) {
  return OIIO::stride_t(sizeof(windows::Rgb)) * image.width;
}

}  // namespace

windows::Image readPicture(const std::string& file) {
  const auto input = OIIO::ImageInput::open(file);
  if (!input) throw std::runtime_error("cannot read " + file + ": " + OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  windows::Image image(spec.width, spec.height);
  if (spec.nchannels < 3 ||
      !input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, &image.at(0, spec.height - 1),
                         OIIO::stride_t(sizeof(windows::Rgb)), -rowOf(image)))
    throw std::runtime_error("cannot read " + file + ": no three channels, or " + input->geterror());
  return image;
}

void writePicture(const std::string& file, const windows::Image& image) {
  const auto output = OIIO::ImageOutput::create(file);
  const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  if (!output || !output->open(file, spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, &image.at(0, image.height - 1), OIIO::AutoStride,
                           -rowOf(image)) ||
      !output->close())
    throw std::runtime_error("cannot write " + file);
}

}  // namespace programs
