// OES_EGL_image: what an EGLImage shows. Its siblings are textures and renderbuffers, of any share group on
// the device; each holds it, and so does the EGLImage itself.
#pragma once

#include <GLES/gl.h>

#include <memory>

#include "layer/render/renderer.h"

namespace anteroom::gl {

class ShareGroup;

struct SharedImage {
  std::shared_ptr<render::Image> image;
  int level = 0, layer = 0;   // of image
  int width = 0, height = 0;  // texels of that level
  GLenum internalFormat = 0;  // as a texture has it
};

// Whether nothing else is a sibling.
inline bool isAlone(const std::shared_ptr<SharedImage>& shared) {
  return shared.use_count() <= 1;
}

// From now on the group's commands exclude those of other groups that share images.
void shareImages(ShareGroup& group);

}  // namespace anteroom::gl
