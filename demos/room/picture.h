// Pictures of the current surface, and files of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace room {

// 8-bit RGB as it is displayed (sRGB), top row first.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

// Reads the color buffer of the current surface.
Picture readPicture(int width, int height);

// Averages blocks of factor x factor pixels; the size must be a multiple of the factor.
Picture reducePicture(const Picture& picture, int factor);

// Pictures of one size side by side, in rows that together are about as wide as high.
class ContactSheet {
 public:
  explicit ContactSheet(int count);
  // Throws std::invalid_argument when the size is another than the first one's, or there is no place left.
  void add(const Picture& picture);
  const Picture& picture() const { return sheet_; }

 private:
  int columns_;
  int rows_;
  int added_ = 0;
  int width_ = 0;
  int height_ = 0;
  Picture sheet_;
};

// PNG, or EXR (half floats, linear light), by the file's extension. Throws std::runtime_error.
void writePicture(const std::filesystem::path& file, const Picture& picture);

// One animated GIF, a frame at a time.
class GifWriter {
 public:
  GifWriter(std::filesystem::path file, double framesPerSecond);
  ~GifWriter();
  void add(const Picture& picture);
  void close();

 private:
  struct Output;
  std::unique_ptr<Output> output_;
};

}  // namespace room
