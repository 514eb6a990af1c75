#include "tests/reference/reference_device.h"

#include <new>

#include "tests/reference/reference_context.h"

namespace anteroom::reference {

namespace {

class ReferenceDevice final : public render::Device {
 public:
  ReferenceDevice() {
    caps_.deviceName = "float64 reference";
    caps_.origin.driver = "Anteroom reference";
    caps_.maxTextureSize = 4096;
    caps_.maxCubeMapSize = 4096;
    caps_.maxViewport[0] = caps_.maxViewport[1] = 4096;
    caps_.pointSizeRange[1] = caps_.smoothPointSizeRange[1] = 256;
    caps_.lineWidthRange[1] = caps_.smoothLineWidthRange[1] = 256;
    caps_.subpixelBits = 8;
    caps_.maxSamples = 4;
    for (bool& renderable : caps_.renderable) renderable = true;
  }

  const render::Caps& caps() const override { return caps_; }

  std::shared_ptr<render::Image> createImage(const render::ImageDesc& desc) override {
    const int largest =
        desc.dimension == render::Dimension::Volume ? caps_.maxVolumeSize : caps_.maxTextureSize;
    if (desc.width > largest || desc.height > largest || desc.depth > largest) return nullptr;
    try {
      return std::make_shared<StoredImage>(desc);
    } catch (const std::bad_alloc&) {
      return nullptr;
    }
  }

  std::shared_ptr<render::Buffer> createBuffer(size_t size, const void* data) override {
    // Sanitizers end the program where an allocation of such a size would throw.
    constexpr size_t kLargest = size_t{1} << 32;
    if (size > kLargest) return nullptr;
    try {
      return std::make_shared<StoredBuffer>(size, data);
    } catch (const std::bad_alloc&) {
      return nullptr;
    }
  }

  std::unique_ptr<render::Context> createContext() override { return std::make_unique<ReferenceContext>(); }

 private:
  render::Caps caps_;
};

}  // namespace

}  // namespace anteroom::reference

anteroom::render::Device* anteroomCreateReferenceDevice() {
  return new anteroom::reference::ReferenceDevice();
}
