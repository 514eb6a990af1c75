// Pictures that processes hand each other, and what lies between two of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace measure {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // lower left row first
};

// As bytes: width and height in 32 bits each, then RGBA. Writing throws std::runtime_error.
void writeRaw(const std::string& file, const Picture& picture);
// An empty picture when the file is not there or broken.
Picture readRaw(const std::string& file);

// A PNG as it is, alpha 255 when it has none; an empty picture when it is not there or broken.
Picture readPng(const std::string& file);

// Root of the mean square of the differences of red, green and blue, in 1/255; -1 of pictures of two sizes.
double rmsDifference(const Picture& a, const Picture& b);

// Pictures side by side, the lower left row last, as a PNG; enlarged to a readable size. The last picture is
// followed by the errors of all against the first, 32 times. Throws std::runtime_error.
void writeSideBySide(const std::string& file, const std::vector<Picture>& pictures);

// What is measured under that name, as the name of a file.
std::string fileName(const std::string& name);

}  // namespace measure
