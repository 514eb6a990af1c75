#include "picture.h"

#include <GLES/gl.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace room {
namespace {

std::runtime_error writeError(const std::filesystem::path& file, const std::string& why) {
  return std::runtime_error(fmt::format("{} could not be written: {}", file.string(), why));
}

float linearOf(std::uint8_t displayed) {
  const float x = static_cast<float>(displayed) / 255.0F;
  return x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
}

std::unique_ptr<OIIO::ImageOutput> create(const std::filesystem::path& file) {
  auto output = OIIO::ImageOutput::create(file.string());
  if (!output) throw writeError(file, OIIO::geterror());
  return output;
}

}  // namespace

Picture readPicture(int width, int height) {
  const auto w = static_cast<std::size_t>(width);
  const auto h = static_cast<std::size_t>(height);
  std::vector<std::uint8_t> rgba(w * h * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  Picture picture{width, height, std::vector<std::uint8_t>(w * h * 3)};
  for (std::size_t y = 0; y < h; ++y) {
    const std::uint8_t* from = rgba.data() + (h - 1 - y) * w * 4;
    std::uint8_t* to = picture.rgb.data() + y * w * 3;
    for (std::size_t x = 0; x < w; ++x) std::copy_n(from + 4 * x, 3, to + 3 * x);
  }
  return picture;
}

Picture reducePicture(const Picture& picture, int factor) {
  if (factor == 1) return picture;
  const auto f = static_cast<std::size_t>(factor);
  const std::size_t width = static_cast<std::size_t>(picture.width) * 3;
  Picture small{picture.width / factor, picture.height / factor, {}};
  small.rgb.reserve(picture.rgb.size() / (f * f));
  for (std::size_t y = 0; y < static_cast<std::size_t>(small.height); ++y) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(small.width) * 3; ++x) {
      const std::uint8_t* block = picture.rgb.data() + y * f * width + x / 3 * 3 * f + x % 3;
      std::size_t sum = f * f / 2;
      for (std::size_t i = 0; i < f * f; ++i) sum += block[i / f * width + i % f * 3];
      small.rgb.push_back(static_cast<std::uint8_t>(sum / (f * f)));
    }
  }
  return small;
}

ContactSheet::ContactSheet(int count)
    : columns_(std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))))),
      rows_((count + columns_ - 1) / columns_) {}

void ContactSheet::add(const Picture& picture) {
  constexpr int kGap = 4;  // pixels
  constexpr std::uint8_t kGround = 24;
  if (added_ == 0) {
    width_ = picture.width;
    height_ = picture.height;
    sheet_.width = columns_ * (width_ + kGap) + kGap;
    sheet_.height = rows_ * (height_ + kGap) + kGap;
    sheet_.rgb.assign(static_cast<std::size_t>(sheet_.width) * static_cast<std::size_t>(sheet_.height) * 3,
                      kGround);
  }
  if (picture.width != width_ || picture.height != height_ || added_ >= columns_ * rows_) {
    throw std::invalid_argument("a contact sheet holds so many pictures of one size");
  }
  const auto left = static_cast<std::size_t>(kGap + added_ % columns_ * (width_ + kGap));
  const auto top = static_cast<std::size_t>(kGap + added_ / columns_ * (height_ + kGap));
  const auto row = static_cast<std::size_t>(width_) * 3;
  for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y) {
    std::copy_n(picture.rgb.data() + y * row, row,
                sheet_.rgb.data() + ((top + y) * static_cast<std::size_t>(sheet_.width) + left) * 3);
  }
  ++added_;
}

void writePicture(const std::filesystem::path& file, const Picture& picture) {
  auto output = create(file);
  const bool linear = file.extension() == ".exr";
  OIIO::ImageSpec spec(picture.width, picture.height, 3,
                       linear ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  if (!output->open(file.string(), spec)) throw writeError(file, output->geterror());
  bool written = false;
  if (linear) {
    std::vector<float> light(picture.rgb.size());
    std::transform(picture.rgb.begin(), picture.rgb.end(), light.begin(), linearOf);
    written = output->write_image(OIIO::TypeDesc::FLOAT, light.data());
  } else {
    written = output->write_image(OIIO::TypeDesc::UINT8, picture.rgb.data());
  }
  if (!written || !output->close()) throw writeError(file, output->geterror());
}

struct GifWriter::Output {
  std::filesystem::path file;
  double framesPerSecond;
  std::unique_ptr<OIIO::ImageOutput> image;
  bool opened = false;
};

GifWriter::GifWriter(std::filesystem::path file, double framesPerSecond)
    : output_(new Output{std::move(file), framesPerSecond, nullptr}) {
  output_->image = create(output_->file);
}

GifWriter::~GifWriter() = default;

void GifWriter::add(const Picture& picture) {
  OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:Movie", 1);
  spec.attribute("gif:Interlacing", 0);
  const float rate = static_cast<float>(output_->framesPerSecond);
  spec.attribute("FramesPerSecond", OIIO::TypeDesc::FLOAT, &rate);
  const auto mode = output_->opened ? OIIO::ImageOutput::AppendSubimage : OIIO::ImageOutput::Create;
  if (!output_->image->open(output_->file.string(), spec, mode) ||
      !output_->image->write_image(OIIO::TypeDesc::UINT8, picture.rgb.data())) {
    throw writeError(output_->file, output_->image->geterror());
  }
  output_->opened = true;
}

void GifWriter::close() {
  if (!output_->image->close()) throw writeError(output_->file, output_->image->geterror());
}

}  // namespace room
