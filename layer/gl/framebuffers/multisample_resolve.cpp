// APPLE_framebuffer_multisample: samples of the framebuffer that is read become pixels of the one that is
// drawn to.
#include <algorithm>

#include "layer/gl/framebuffers/framebuffer_object.h"

using namespace anteroom::gl;
namespace render = anteroom::render;

namespace {

// Null: the two suit each other.
const char* mismatch(const render::Framebuffer& read, const render::Framebuffer& draw) {
  if (read.samples <= 1) return "The framebuffer that is read is not multisampled";
  if (draw.samples > 1) return "The framebuffer that is drawn to is multisampled";
  if (!read.color.image || !draw.color.image) return "One of the framebuffers has no color attachment";
  if (read.width != draw.width || read.height != draw.height) return "The framebuffers differ in size";
  const auto alpha = [](const render::Framebuffer& f) {
    return render::info(f.color.image->desc().format).alpha;
  };
  if (alpha(draw) != 0 && alpha(read) == 0)
    return "The framebuffer that is drawn to has alpha, the other has none";
  return nullptr;
}

render::Rect scissored(const render::State& state) {
  const render::Framebuffer& framebuffer = state.framebuffer;
  if (!state.scissorTest) return {0, 0, framebuffer.width, framebuffer.height};
  const auto end = [](int start, int size, int limit) {
    return static_cast<int>(std::clamp<int64_t>(int64_t{start} + size, 0, limit));
  };
  const render::Rect& scissor = state.scissor;
  const int x = std::clamp(scissor.x, 0, framebuffer.width), y = std::clamp(scissor.y, 0, framebuffer.height);
  return {x, y, end(scissor.x, scissor.width, framebuffer.width) - x,
          end(scissor.y, scissor.height, framebuffer.height) - y};
}

}  // namespace

GL_API void GL_APIENTRY glResolveMultisampleFramebufferAPPLE(void) {
  Context* c = current();
  if (!c) return;
  ShareLock lock(*c->group);
  if (!c->framebufferComplete() || !c->readFramebufferComplete())
    return c->setError(GL_INVALID_FRAMEBUFFER_OPERATION_OES,
                       wrongState("One of the bound framebuffers is not complete",
                                  "Ask glCheckFramebufferStatusOES of READ_ and DRAW_FRAMEBUFFER_APPLE why"));
  const render::Framebuffer& draw = c->state.framebuffer;
  render::Framebuffer read = c->readFramebuffer;
  if (const char* sentence = mismatch(read, draw))
    return c->setError(
        GL_INVALID_OPERATION,
        wrongState(sentence,
                   "Bind the multisampled one to READ_FRAMEBUFFER_APPLE, and one without samples "
                   "of the same size and components to DRAW_FRAMEBUFFER_APPLE"));
  render::Rect rect = scissored(c->state);
  if (rect.width <= 0 || rect.height <= 0) return;
  // Texels are addressed as they lie in memory: where the image that is written is upside down, so is what is
  // read.
  if (draw.yDown) {
    rect.y = draw.height - rect.y - rect.height;
    read.yDown = !read.yDown;
  }
  const render::Attachment& to = draw.color;
  const render::Region region{to.level, to.layer, rect.x, rect.y, 0, rect.width, rect.height, 1};
  if (!c->renderer->copyFromFramebuffer(*to.image, region, read, rect.x, rect.y))
    c->setError(GL_OUT_OF_MEMORY);
}
