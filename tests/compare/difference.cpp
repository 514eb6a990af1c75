#include "difference.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace comparison {

Expectation::Expectation(std::vector<Picture> pictures) {
  if (pictures.empty()) return;
  least_ = greatest_ = pictures.front().rgba;
  for (const Picture& picture : pictures) {
    for (std::size_t i = 0; i < least_.size() && i < picture.rgba.size(); ++i) {
      least_[i] = std::min(least_[i], picture.rgba[i]);
      greatest_[i] = std::max(greatest_[i], picture.rgba[i]);
    }
  }
  picture_ = std::move(pictures.front());
}

bool Expectation::edge(std::size_t pixel) const {
  for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i)
    if (greatest_[i] - least_[i] > 1) return true;
  return false;
}

int Expectation::outside(std::size_t channel, int value) const {
  return std::max({0, least_[channel] - value, value - greatest_[channel]});
}

Difference difference(const Expectation& expected, const Picture& actual) {
  Difference result;
  const Picture& reference = expected.picture();
  if (actual.rgba.empty() || actual.rgba.size() != reference.rgba.size() || actual.width != reference.width)
    return result;
  result.present = true;
  double squares = 0;
  std::size_t interior = 0;
  for (std::size_t pixel = 0; pixel < reference.rgba.size() / 4; ++pixel) {
    int worst = 0, outside = 0;
    const bool edge = expected.edge(pixel);
    for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i) {
      const int error = std::abs(int{actual.rgba[i]} - int{reference.rgba[i]});
      worst = std::max(worst, error);
      outside = std::max(outside, expected.outside(i, actual.rgba[i]));
      if (!edge) squares += error * error;
    }
    if (edge) {
      ++result.edgePixels;
      result.coverage += worst > 1;
      result.worstOutside = std::max(result.worstOutside, outside);
      continue;
    }
    ++interior;
    if (worst > result.worst) {
      result.worst = worst;
      result.x = static_cast<int>(pixel) % reference.width;
      result.y = static_cast<int>(pixel) / reference.width;
    }
  }
  if (interior > 0) result.rms = std::sqrt(squares / (4.0 * static_cast<double>(interior)));
  return result;
}

int disagreements(const Expectation& expected, const Picture& a, const Picture& b, int steps) {
  if (a.rgba.size() != b.rgba.size()) return 0;
  int count = 0;
  for (std::size_t pixel = 0; pixel < a.rgba.size() / 4; ++pixel) {
    if (expected.edge(pixel)) continue;
    int worst = 0;
    for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i)
      worst = std::max(worst, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
    count += worst > steps;
  }
  return count;
}

namespace {

Picture errorPicture(const Picture& a, const Picture& b) {
  Picture result = a;
  for (std::size_t i = 0; i < result.rgba.size(); ++i) {
    const int error = i < b.rgba.size() ? std::abs(int{a.rgba[i]} - int{b.rgba[i]}) : 255;
    result.rgba[i] = static_cast<std::uint8_t>(std::min(255, 32 * error));
  }
  return result;
}

}  // namespace

void writeSideBySide(const std::string& file, const std::vector<Picture>& pictures) {
  std::vector<Picture> all = pictures;
  for (std::size_t i = 1; i < pictures.size(); ++i) all.push_back(errorPicture(pictures[0], pictures[i]));
  const int width = all[0].width, height = all[0].height;
  const int scale = std::max(1, 192 / std::max(width, height)), gap = 4;
  const int columns = static_cast<int>(all.size());
  const int totalWidth = columns * (width * scale + gap), totalHeight = height * scale;
  std::vector<std::uint8_t> out(
      static_cast<std::size_t>(totalWidth) * static_cast<std::size_t>(totalHeight) * 3, 128);
  for (int column = 0; column < columns; ++column) {
    const Picture& picture = all[static_cast<std::size_t>(column)];
    if (picture.width != width || picture.height != height) continue;
    for (int y = 0; y < totalHeight; ++y) {
      for (int x = 0; x < width * scale; ++x) {
        const std::size_t from =
            4 * (static_cast<std::size_t>(height - 1 - y / scale) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x / scale));
        const std::size_t to = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(totalWidth) +
                                    static_cast<std::size_t>(column * (width * scale + gap) + x));
        std::copy_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(from), 3,
                    out.begin() + static_cast<std::ptrdiff_t>(to));
      }
    }
  }
  const auto png = OIIO::ImageOutput::create(file);
  const OIIO::ImageSpec spec(totalWidth, totalHeight, 3, OIIO::TypeDesc::UINT8);
  if (!png || !png->open(file, spec) || !png->write_image(OIIO::TypeDesc::UINT8, out.data()) || !png->close())
    throw std::runtime_error("cannot write " + file);
}

Picture readPng(const std::string& file) {
  Picture picture;
  const auto in = OIIO::ImageInput::open(file);
  if (!in) return picture;
  const OIIO::ImageSpec& spec = in->spec();
  const auto pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<std::uint8_t> bytes(pixels * channels);
  if (channels < 3 || !in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, bytes.data()))
    return picture;
  picture.width = spec.width;
  picture.height = spec.height;
  picture.rgba.assign(pixels * 4, 255);
  const auto width = static_cast<std::size_t>(spec.width);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::size_t flipped = (pixels / width - 1 - i / width) * width + i % width;
    for (std::size_t c = 0; c < std::min<std::size_t>(4, channels); ++c)
      picture.rgba[4 * flipped + c] = bytes[channels * i + c];
  }
  return picture;
}

}  // namespace comparison
