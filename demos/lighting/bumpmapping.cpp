#include "bumpmapping.h"

#include <GLES/gl.h>

#include <glm/gtc/type_ptr.hpp>

#include "lighting.h"
#include "room/passes.h"

namespace lighting {

// The scales of units 1 and 2 make up for the constant color, which ends at 1, and for what attenuation
// takes.
void drawBump(const LightVectors& lit, const Spotlight& light, const glm::dmat4& view, double gain) {
  beginPass();
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_ALPHA, GL_ONE);
  const glm::vec4 color(light.color * (0.5 * gain), 1.0);
  for (const auto& [part, colors] : lit.parts()) {
    place(*part, view);
    room::useTexture(0, part->material->normal);
    room::combine(GL_DOT3_RGB, GL_TEXTURE, GL_PRIMARY_COLOR);
    room::useTexture(1, part->material->base);
    room::combine(GL_MODULATE, GL_TEXTURE, GL_PREVIOUS, 2);
    room::useTexture(2, part->material->base);
    room::combine(GL_MODULATE, GL_PREVIOUS, GL_CONSTANT, 2);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(color));
    part->mesh->bindPositions();
    for (int unit = 0; unit < kUnits; ++unit) room::useTexCoords(unit, *part->mesh);
    if (part->material->space == NormalSpace::Tangent) {
      glEnableClientState(GL_COLOR_ARRAY);
      glColorPointer(4, GL_FLOAT, 0, colors->data());
    } else {
      // One light vector for the whole object, in the space of its normal map.
      glDisableClientState(GL_COLOR_ARRAY);
      const glm::dvec3 lamp(glm::inverse(part->model) * glm::dvec4(light.position, 1.0));
      room::setColor(glm::normalize(lamp - part->center) * 0.5 + 0.5);
    }
    part->mesh->draw();
  }
}

}  // namespace lighting
