// Reflection mapping from a cube map (GL_OES_texture_cube_map).
#pragma once

#include <GLES/gl.h>
#include <GLES/glext.h>

#include <glm/glm.hpp>
#include <string_view>

#include "framebuffer.h"

namespace room {

class ReflectionMapping {
 public:
  // Throws MissingExtension without cube maps; `demo` is named in it.
  explicit ReflectionMapping(std::string_view demo);
  // The unit's texture becomes what the target's camera saw in the direction that the eye's ray is thrown to.
  // Reflection vectors are in eye coordinates; the texture matrix turns them back to the world's by the
  // inverse of the view's rotation, so that the reflection stays where it is when the camera moves. Makes the
  // unit active.
  void enable(int unit, const CubeTarget& surroundings, const glm::dmat4& view) const;
  void disable(int unit) const;

 private:
  PFNGLTEXGENIOESPROC texGeni_;
};

}  // namespace room
