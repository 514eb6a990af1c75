// Section 3.9: images. No platform has native pixmaps to make them of: their sources are GL's.
#pragma once

#include <memory>

#include "layer/gl/front_end.h"

namespace anteroom::egl {

struct Image {
  explicit Image(std::shared_ptr<gl::SharedImage> of) : shared(std::move(of)) {}

  void* handle = nullptr;
  const std::shared_ptr<gl::SharedImage> shared;
};

// What an image of a display, which is a Display*, shows. Null: no such image.
std::shared_ptr<gl::SharedImage> findImage(void* display, void* image);

}  // namespace anteroom::egl
