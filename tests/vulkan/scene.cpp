#include "tests/vulkan/scene.h"

#include "layer/vulkan/vulkan_device.h"

namespace anteroom::test {
namespace {

std::unique_ptr<render::Device> make(bool minimal, bool validation) {
  vulkan::DeviceOptions options;
  if (validation) options.debug.validation = render::DebugOptions::Validation::Log;
  options.minimal = minimal;
  std::string error;
  auto device = vulkan::createDevice(options, error);
  if (!device) {
    ADD_FAILURE() << error;
    std::abort();
  }
  return device;
}

}  // namespace

namespace {

// Devices end with the tests: at exit the globals of driver and layers may be gone before ours.
class Devices final : public ::testing::Environment {
 public:
  void TearDown() override {
    for (auto& pair : held)
      for (auto& device : pair) device.reset();
  }
  std::unique_ptr<render::Device> held[2][2];
};
Devices& devices = *static_cast<Devices*>(::testing::AddGlobalTestEnvironment(new Devices));

}  // namespace

render::Device& device(bool minimal, bool validation) {
  auto& held = devices.held[minimal][validation];
  if (!held) held = make(minimal, validation);
  return *held;
}

Scene::Scene(bool minimal, int width, int height, render::Format color, render::Format depthStencil,
             int samples)
    : Scene(test::device(minimal), width, height, color, depthStencil, samples) {}

Scene::Scene(render::Device& on, int width, int height, render::Format color, render::Format depthStencil,
             int samples)
    : device(on), context(on.createContext()) {
  render::ImageDesc desc;
  desc.format = color;
  desc.width = width;
  desc.height = height;
  desc.samples = samples;
  desc.renderable = true;
  render::Framebuffer& framebuffer = state.framebuffer;
  framebuffer.color.image = device.createImage(desc);
  if (depthStencil != render::Format::None) {
    desc.format = depthStencil;
    framebuffer.depth.image = device.createImage(desc);
    if (render::info(depthStencil).stencil) framebuffer.stencil.image = framebuffer.depth.image;
  }
  framebuffer.width = width;
  framebuffer.height = height;
  framebuffer.samples = samples;
  state.fixed.viewport = {0, 0, width, height};
  state.depthFar = 1;
  state.fixed.multisample = samples > 1;
  state.fixed.alphaBits = render::info(color).alpha;
  this->color(1, 1, 1);
}

void Scene::array(gen::Attribute attribute, const float* data, int size) {
  state.fixed.attributes[attribute].array = true;
  state.fixed.attributes[attribute].type = GL_FLOAT;
  state.fixed.attributes[attribute].size = static_cast<uint8_t>(size);
  state.arrays[attribute] = {nullptr, data, static_cast<uint32_t>(size) * 4};
  changed |= gen::kGroupArrays;
}

void Scene::noArray(gen::Attribute attribute) {
  state.fixed.attributes[attribute].array = false;
  changed |= gen::kGroupArrays;
}

void Scene::color(float r, float g, float b, float a) {
  state.fixed.attributes[gen::kColor].current = {r, g, b, a};
  changed |= gen::kGroupCurrentColor;
}

void Scene::draw(GLenum mode, int count, int first) {
  const auto primitive = mode == GL_POINTS                           ? gen::PrimitiveClass::Points
                         : mode >= GL_LINES && mode <= GL_LINE_STRIP ? gen::PrimitiveClass::Lines
                                                                     : gen::PrimitiveClass::Triangles;
  if (primitive != state.fixed.primitive) changed |= gen::kGroupPrimitive;
  state.fixed.primitive = primitive;
  render::DrawCall call;
  call.mode = mode;
  call.first = first;
  call.count = count;
  draw(call);
}

void Scene::draw(const render::DrawCall& call) {
  ASSERT_TRUE(context->draw(state, changed, call));
  changed = 0;
}

void Scene::cover(float z) {
  const float quad[] = {-1, -1, z, 1, -1, z, -1, 1, z, 1, 1, z};
  array(gen::kPosition, quad, 3);
  draw(GL_TRIANGLE_STRIP, 4);
}

void Scene::clear(GLbitfield mask, float r, float g, float b, float a) {
  state.clear.color = {r, g, b, a};
  ASSERT_TRUE(context->clear(state, changed, mask));
}

std::vector<Pixel> Scene::read() {
  const render::Framebuffer& framebuffer = state.framebuffer;
  std::vector<Pixel> pixels(static_cast<size_t>(framebuffer.width) * framebuffer.height);
  EXPECT_TRUE(context->readPixels(framebuffer, {0, 0, framebuffer.width, framebuffer.height},
                                  render::Format::RGBA8, pixels.data(),
                                  static_cast<size_t>(framebuffer.width) * 4));
  return pixels;
}

Pixel Scene::at(int x, int y) {
  Pixel pixel{};
  EXPECT_TRUE(context->readPixels(state.framebuffer, {x, y, 1, 1}, render::Format::RGBA8, pixel.data(), 4));
  return pixel;
}

}  // namespace anteroom::test
