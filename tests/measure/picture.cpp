#include "tests/measure/picture.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace measure {

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

void writeRaw(const std::string& file, const Picture& picture) {
  std::ofstream out(file, std::ios::binary);
  const std::int32_t size[] = {picture.width, picture.height};
  out.write(reinterpret_cast<const char*>(size), sizeof size);
  out.write(reinterpret_cast<const char*>(picture.rgba.data()),
            static_cast<std::streamsize>(picture.rgba.size()));
  if (!out) throw std::runtime_error("cannot write " + file);
}

Picture readRaw(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::int32_t size[2] = {};
  Picture picture;
  if (!in.read(reinterpret_cast<char*>(size), sizeof size) || size[0] <= 0 || size[1] <= 0) return picture;
  picture.rgba.resize(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * 4);
  if (!in.read(reinterpret_cast<char*>(picture.rgba.data()),
               static_cast<std::streamsize>(picture.rgba.size())))
    return {};
  picture.width = size[0];
  picture.height = size[1];
  return picture;
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

double rmsDifference(const Picture& a, const Picture& b) {
  if (a.rgba.empty() || a.width != b.width || a.rgba.size() != b.rgba.size()) return -1;
  double squares = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const int error = int{a.rgba[i]} - int{b.rgba[i]};
    if (i % 4 != 3) squares += error * error;
  }
  return std::sqrt(squares / (0.75 * static_cast<double>(a.rgba.size())));
}

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

std::string fileName(const std::string& name) {
  std::string result = name;
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c == '/' || c == ' ' || c == ','; }, '-');
  return result;
}

}  // namespace measure
