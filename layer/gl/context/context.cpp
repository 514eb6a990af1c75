#include "layer/gl/context/context.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "layer/gl/context/params.h"
#include "layer/gl/debug/debug_output.h"
#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/vertices/vertex_arrays.h"

namespace anteroom::gl {

constinit thread_local Context* currentContextOfThread = nullptr;
constinit std::mutex sharedImagesMutex;

namespace {

// The nearest int32, ties away from zero, saturating.
int32_t saturate(double value) {
  if (std::isnan(value)) return 0;
  constexpr double kLow = std::numeric_limits<int32_t>::min(), kHigh = std::numeric_limits<int32_t>::max();
  return static_cast<int32_t>(std::round(std::clamp(value, kLow, kHigh)));
}

}  // namespace

GLfixed toFixed(double value) {
  return saturate(value * 65536.0);
}
GLint roundToInt(double value) {
  return saturate(value);
}
// Zero lies between -1 and 0: it becomes 0.
GLint normalisedToInt(double value) {
  return saturate(std::nearbyint((4294967295.0 * value - 1.0) / 2.0));
}

void Results::putOne(Kind kind, double value) {
  if (!out_) return;
  const int i = count_++;
  switch (form_) {
    case Form::Boolean:
      static_cast<GLboolean*>(out_)[i] = value != 0 ? GL_TRUE : GL_FALSE;
      break;
    case Form::Integer:
      static_cast<GLint*>(out_)[i] = kind == Kind::Normalised ? normalisedToInt(value) : roundToInt(value);
      break;
    case Form::Integer64:
      static_cast<GLint64*>(out_)[i] =
          kind == Kind::Normalised ? normalisedToInt(value) : static_cast<GLint64>(std::round(value));
      break;
    case Form::Fixed:
      static_cast<GLfixed*>(out_)[i] = kind == Kind::Enum ? roundToInt(value) : toFixed(value);
      break;
    case Form::Float:
      static_cast<GLfloat*>(out_)[i] = static_cast<GLfloat>(value);
      break;
  }
}

Context::Context(render::Device& d, std::shared_ptr<ShareGroup> shareGroup,
                 std::unique_ptr<render::Context> renderContext, const ContextOptions& contextOptions)
    : device(d),
      group(std::move(shareGroup)),
      renderer(std::move(renderContext)),
      options(contextOptions),
      groupsCommands(d.caps().drawGroups),
      debugOutput(contextOptions.debug),
      debug(std::make_unique<DebugOutput>()) {
  updateListener(*this);
  const render::Caps& caps = device.caps();
  rendererName = "Anteroom on " + caps.deviceName;

  gen::State& fixed = state.fixed;
  fixed.attributes[gen::kNormal].size = 3;
  fixed.attributes[gen::kNormal].current = {0, 0, 1, 1};
  fixed.attributes[gen::kColor].current = {1, 1, 1, 1};
  fixed.attributes[gen::kPointSize].size = 1;
  defaultVertexArray = boundVertexArray = std::make_shared<VertexArrayObject>(0);

  fixed.lighting.lights[0].diffuse = {1, 1, 1, 1};
  fixed.lighting.lights[0].specular = {1, 1, 1, 1};

  fixed.points.sizeMax = std::max(caps.pointSizeRange[1], caps.smoothPointSizeRange[1]);
  fixed.points.deviceMin = caps.pointSizeRange[0];
  fixed.points.deviceMax = caps.pointSizeRange[1];

  ++group->contexts;  // nothing throws any more
  group->awaitCommand();
  const ShareLock lock(*group);
  nextOfGroup = std::exchange(group->first, this);
}

VertexArrays initialVertexArrays() {
  VertexArrays initial;
  initial.arrays[gen::kNormal].size = 3;
  initial.arrays[gen::kPointSize].size = 1;
  initial.arrays[gen::kMatrixIndex].size = initial.arrays[gen::kWeight].size = 0;
  initial.arrays[gen::kMatrixIndex].type = GL_UNSIGNED_BYTE;
  return initial;
}

bool Context::hasWindowToReady() const {
  const render::Window* const draw = defaultFramebuffer.window;
  const render::Window* const read = defaultReadFramebuffer.window;
  return (draw && !draw->isReady()) || (read && !read->isReady());
}

// The next picture of a window may be of another size.
void Context::readyWindows() {
  for (const render::Framebuffer* framebuffer : {&defaultFramebuffer, &defaultReadFramebuffer})
    if (framebuffer->window && !framebuffer->window->makeReady()) setError(GL_OUT_OF_MEMORY);
  bool moved = false;
  for (render::Framebuffer* framebuffer : {&defaultFramebuffer, &defaultReadFramebuffer}) {
    if (!framebuffer->window) continue;
    const render::Framebuffer& next = framebuffer->window->framebuffer();
    if (next.color.image == framebuffer->color.image) continue;
    *framebuffer = next;
    moved = true;
  }
  if (moved && !boundFramebuffer) useDefaultFramebuffer(*this);
}

// What became of objects that the group shares.
void Context::hear() {
  const gen::Groups groups = std::exchange(told, 0);
  if (groups & gen::kGroupArrays) syncArrays(*this);
  if (groups & gen::kGroupFramebuffer && boundFramebuffer) updateFramebuffer(*this);
  mark(groups & ~gen::kGroupFramebuffer);
}

bool Context::framebufferComplete() {
  if (told) hear();
  if (!boundFramebuffer && hasWindowToReady()) [[unlikely]]
    readyWindows();
  return hasFramebuffer;
}

bool Context::readFramebufferComplete() {
  if (boundReadFramebuffer) return updateReadFramebuffer(*this);
  if (hasWindowToReady()) [[unlikely]]
    readyWindows();
  readFramebuffer = defaultReadFramebuffer;
  return hasDefaultFramebuffer;
}

void Context::reportError(GLenum code, const Fault& fault, const char* command) const {
  if (options.logErrors) logError(code, fault, command);
  if (debugOutput) debug->error(code, fault, command);
}

void updateMultisample(Context& c) {
  const bool on = c.state.ops.multisample && c.hasFramebuffer && c.state.framebuffer.samples > 1;
  constexpr gen::Groups kGroups = gen::kGroupFragmentOps | gen::kGroupFramebuffer;
  c.set(c.state.fixed.multisample, on, kGroups);
  c.set(c.state.fixed.sampleAlphaToOne, on && c.state.ops.sampleAlphaToOne, kGroups);
}

void useFramebuffer(Context& c, const render::Framebuffer* framebuffer, const render::Framebuffer* read) {
  c.hasFramebuffer = framebuffer != nullptr;
  c.state.framebuffer = framebuffer ? *framebuffer : render::Framebuffer{};
  c.readFramebuffer = read ? *read : c.state.framebuffer;
  c.mark(gen::kGroupFramebuffer);

  const render::Framebuffer& now = c.state.framebuffer;
  gen::State& fixed = c.state.fixed;
  const uint8_t alphaBits = now.color.image ? render::info(now.color.image->desc().format).alpha : 0;
  c.set(fixed.alphaBits, alphaBits, gen::kGroupFramebuffer | gen::kGroupAlphaTest);
  c.set(fixed.framebufferYDown, now.yDown, gen::kGroupFramebuffer);
  updateMultisample(c);
  applyStencilRef(c);
}

void useDefaultFramebuffer(Context& c) {
  useFramebuffer(c, c.hasDefaultFramebuffer ? &c.defaultFramebuffer : nullptr, &c.defaultReadFramebuffer);
}

int stencilBits(const Context& c) {
  const auto& image = c.state.framebuffer.stencil.image;
  return image ? render::info(image->desc().format).stencil : 0;
}

void applyStencilRef(Context& c) {
  const int highest = (1 << stencilBits(c)) - 1;
  c.set(c.state.ops.stencilRef, std::clamp(c.stencilRef, 0, highest), gen::kGroupFragmentOps);
}

}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API GLenum GL_APIENTRY glGetError(void) {
  Context* c = current();
  if (!c) return GL_NO_ERROR;
  const GLenum code = c->error;
  c->error = GL_NO_ERROR;
  return code;
}
