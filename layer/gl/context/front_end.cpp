// What EGL needs of GL: the life of contexts, and which one is current.
#include "layer/gl/front_end.h"

#include <new>

#include "layer/gl/context/context.h"
#include "layer/gl/debug/debug_output.h"
#include "layer/gl/framebuffers/framebuffer_object.h"
#include "layer/gl/textures/texture.h"

namespace anteroom::gl {

namespace {

void destroyContext(Context* context) {
  if (currentContextOfThread == context) currentContextOfThread = nullptr;
  delete context;
}

}  // namespace

std::unique_ptr<Context, void (*)(Context*)> createContext(render::Device& device, Context* shareWith,
                                                           const ContextOptions& options) {
  std::unique_ptr<Context, void (*)(Context*)> context(nullptr, destroyContext);
  try {
    auto renderer = device.createContext();
    if (!renderer) return context;
    auto group = shareWith ? shareWith->group : std::make_shared<ShareGroup>(device);
    context.reset(new Context(device, std::move(group), std::move(renderer), options));
    initTextures(*context);
  } catch (const std::bad_alloc&) {
    context.reset();
  }
  return context;
}

// Objects that die with the context may be seen by others of its group until then.
Context::~Context() {
  {
    ShareLock lock(*group);
    vertexArrays = {};
    vertexArrayObjects = {};
    arrayBuffer.reset();
    boundFramebuffer.reset();
    boundReadFramebuffer.reset();
    boundRenderbuffer.reset();
    units = {};
    defaultTextures = {};
    renderer.reset();
    Context** at = &group->first;
    while (*at != this) at = &(*at)->nextOfGroup;
    *at = nextOfGroup;
  }
  --group->contexts;
}

Context* currentContext() {
  return current();
}

void makeCurrent(Context* context) {
  Context* former = currentContextOfThread;
  if (former == context) return;
  if (former) RendererLock(*former)->flush();
  currentContextOfThread = context;
}

void abandonContexts() {
  currentContextOfThread = nullptr;
  new (&sharedImagesMutex) std::mutex;  // another thread of the parent may have it
}

void setDefaultFramebuffer(Context& c, const render::Framebuffer* framebuffer,
                           const render::Framebuffer* read) {
  c.defaultFramebuffer = framebuffer ? *framebuffer : render::Framebuffer{};
  c.defaultReadFramebuffer = read ? *read : c.defaultFramebuffer;
  c.hasDefaultFramebuffer = framebuffer != nullptr;
  if (!c.boundFramebuffer) useDefaultFramebuffer(c);
  if (!framebuffer || c.hadFramebuffer) return;
  c.hadFramebuffer = true;
  c.state.fixed.viewport = {0, 0, framebuffer->width, framebuffer->height};
  c.state.scissor = c.state.fixed.viewport;
  c.mark(gen::kGroupViewport);
}

render::Context& rendererOf(Context& c) {
  return *c.renderer;
}

RendererLock::RendererLock(Context& context) : context_(context) {
  const ShareLock::Held held = ShareLock::lock(*context.group);
  group_ = held.group;
  images_ = held.images;
}

RendererLock::~RendererLock() {
  ShareLock::unlock(*context_.group, {group_, images_});
}

render::Context* RendererLock::operator->() const {
  return context_.renderer.get();
}

}  // namespace anteroom::gl
