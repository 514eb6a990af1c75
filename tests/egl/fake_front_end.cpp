#include "tests/egl/fake_front_end.h"

#include "layer/egl/renderer.h"

namespace anteroom {
namespace fake {

World& world() {
  static World instance;
  return instance;
}

namespace {

struct Device : test::FakeDevice {
  Device() : FakeDevice(world().log) { ++world().devices; }
  ~Device() override { --world().devices; }
  const render::Caps& caps() const override { return world().caps; }
};

std::unique_ptr<render::Device> createFake(const egl::RendererOptions&, std::string& error) {
  if (!world().noDevice) return std::make_unique<Device>();
  error = "no fake device, as ordered";
  return nullptr;
}

[[maybe_unused]] const bool added = egl::addRenderer("fake", createFake);

}  // namespace
}  // namespace fake

namespace gl {

class Context {
 public:
  Context() { ++fake::world().contexts; }
  ~Context() { --fake::world().contexts; }
  test::FakeContext renderer{fake::world().log};
  render::Framebuffer framebuffer, readFramebuffer;
  std::shared_ptr<render::Image> texture;
};

namespace {
thread_local Context* currentOfThread = nullptr;
}

std::unique_ptr<Context, void (*)(Context*)> createContext(render::Device&, Context*, const ContextOptions&) {
  Context* context = fake::world().log.outOfMemory ? nullptr : new Context;
  return {context, [](Context* old) { delete old; }};
}
Context* currentContext() {
  return currentOfThread;
}
void makeCurrent(Context* context) {
  if (currentOfThread != nullptr && currentOfThread != context) currentOfThread->renderer.flush();
  currentOfThread = context;
}
void setDefaultFramebuffer(Context& context, const render::Framebuffer* framebuffer,
                           const render::Framebuffer* read) {
  context.readFramebuffer = read == nullptr ? render::Framebuffer{} : *read;
  context.framebuffer = framebuffer == nullptr ? render::Framebuffer{} : *framebuffer;
}
bool bindTexImage(Context& context, GLenum, const std::shared_ptr<render::Image>& image, bool) {
  context.texture = image;
  return true;
}
void releaseTexImage(Context& context, const std::shared_ptr<render::Image>& image) {
  if (context.texture == image) context.texture.reset();
}
ShareStatus shareImage(Context&, const ImageSource&, std::shared_ptr<SharedImage>&) {
  return ShareStatus::NoSource;
}
void shareImages(Context&) {}

void abandonContexts() {}

bool hasCompany(const Context&) {
  return false;
}
render::Context& rendererOf(Context& context) {
  return context.renderer;
}
RendererLock::RendererLock(Context& context) : context_(context), group_(false), images_(false) {}
RendererLock::~RendererLock() = default;
render::Context* RendererLock::operator->() const {
  return &context_.renderer;
}
Proc procAddress(std::string_view) {
  return nullptr;
}

}  // namespace gl

const render::Framebuffer& fake::currentFramebuffer() {
  return gl::currentOfThread->framebuffer;
}
const render::Framebuffer& fake::currentReadFramebuffer() {
  return gl::currentOfThread->readFramebuffer;
}
void fake::deleteTexture() {
  gl::currentOfThread->texture.reset();
}

}  // namespace anteroom
