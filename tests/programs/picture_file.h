// Pictures in files, PNG and PPM.
#pragma once

#include <string>

#include "image.h"

namespace programs {

// Throw std::runtime_error.
windows::Image readPicture(const std::string& file);
void writePicture(const std::string& file, const windows::Image& image);

}  // namespace programs
