// A context: its commands, what is bound, and the road of a draw.
#pragma once

#include <volk.h>

#include "layer/render/renderer.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/geometry/primitive_lists.h"
#include "layer/vulkan/geometry/vertex_fetch.h"
#include "layer/vulkan/pipelines/draw_state.h"
#include "layer/vulkan/pipelines/pipeline_key.h"
#include "layer/vulkan/recording/command_stream.h"
#include "layer/vulkan/recording/pass.h"
#include "layer/vulkan/resources/stream.h"

namespace anteroom::vulkan {

class VulkanWindow;
struct OwnShader;
struct Shader;
enum class Counted : bool;

class VulkanContext final : public render::Context {
 public:
  explicit VulkanContext(VulkanDevice& device);
  ~VulkanContext() override;
  bool initialise() { return commands_.initialise(); }

  void setListener(render::Listener* listener) override { listener_ = listener; }
  void pushGroup(std::string_view text) override;
  void popGroup() override;
  void mark(std::string_view text) override;
  bool lost() const override { return commands_.lost(); }
  bool draw(const render::State& state, gen::Groups changed, const render::DrawCall& call) override;
  bool clear(const render::State& state, gen::Groups changed, GLbitfield mask) override;
  bool readPixels(const render::Framebuffer& framebuffer, const render::Rect& rect, render::Format format,
                  void* out, size_t rowPitch) override;
  bool upload(render::Image& image, const render::Region& region, const void* data, size_t rowPitch,
              size_t slicePitch) override;
  bool copyFromFramebuffer(render::Image& image, const render::Region& region,
                           const render::Framebuffer& source, int x, int y) override;
  bool copyLevel(render::Image& image, int level, render::Image& source, int sourceLevel) override;
  bool generateMipmaps(render::Image& image) override;
  void flush() override;
  void finish() override;
  render::Presented present(render::Window& window, std::span<const render::Rect> damage) override;
  uint64_t insertFence() override;
  bool waitFence(uint64_t fence, uint64_t timeout) override;
  void drawHud(const render::Framebuffer& framebuffer, const render::Hud& hud) override;
  const render::Stats& stats() const override;

 private:
  struct BoundSet {
    VkDescriptorSet set = VK_NULL_HANDLE;
    uint32_t offset = 0;
  };
  // What the present recording has bound.
  struct Bound {
    uint64_t recording = 0;
    VkPipeline pipeline = VK_NULL_HANDLE;
    bool stateSent = false;
    VertexLayout layout;
    uint32_t arrays = 0;  // bindings that have a buffer
    std::array<VkBuffer, kMostArrays> buffers{};
    std::array<VkDeviceSize, kMostArrays> offsets{};
    VkBuffer indexBuffer = VK_NULL_HANDLE;
    VkDeviceSize indexOffset = 0;
    VkIndexType indexType = VK_INDEX_TYPE_MAX_ENUM;
    uint32_t pushed = 0;  // bytes of push constants that are valid
    BoundSet vertexConstants, fragmentConstants, paletteConstants;
    uint32_t textures = 0;  // units
    std::array<VkImageView, gen::kMaxTextureUnits> views{};
    std::array<VkSampler, gen::kMaxTextureUnits> samplers{};
  };
  // A block of constants: as it was packed last, and where the present recording has it.
  struct Constants {
    alignas(16) std::array<std::byte, kConstantRange> data;
    uint32_t size = 0;
    bool placed = false;  // `data` is in the stream, unless this is another recording
    uint64_t recording = 0;
    StreamPiece piece;
  };
  // A draw whose vertices are in place.
  struct Geometry {
    uint32_t count = 0;
    uint32_t first = 0;
    int32_t vertexOffset = 0;
    bool indexed = false;
    VkBuffer indexBuffer = VK_NULL_HANDLE;
    VkDeviceSize indexOffset = 0;
    VkIndexType indexType = VK_INDEX_TYPE_UINT16;
  };

  // Draws of separate primitives that were joined into one, which is not recorded yet.
  struct Batch {
    GLenum mode = 0;
    uint32_t first = 0, count = 0;  // vertices; count 0: no batch
  };
  // The structure of the arrays, without the places where they lie.
  struct ArrayShape {
    bool array = false;
    uint8_t size = 0;
    GLenum type = 0;
    bool operator==(const ArrayShape&) const = default;
  };
  using ArrayShapes = std::array<ArrayShape, gen::kAttributeCount>;
  struct NewKeys {
    bool vertex = false, fragment = false;
  };

  // batch.cpp
  bool join(const render::State& state, gen::Groups changed, const render::DrawCall& call);
  bool openBatch(const render::DrawCall& call, const Geometry& geometry);
  void flushBatch();
  gen::Groups harmless() const;
  bool isSmall(const render::DrawCall& call, Carried carried) const;
  bool takesList(const render::DrawCall& call) const;
  uint32_t listOf(const render::DrawCall& call, uint32_t* list) const;
  bool appendTo(const render::State& state, bool moved, const render::DrawCall& call, uint32_t& count);
  gen::Groups watch(const render::State& state, gen::Groups changed, const render::DrawCall& call);
  gen::Groups carry(Carried carried);

  // draw.cpp
  bool take(const render::State& state, gen::Groups changed);
  void takeTarget(const render::State& state, gen::Groups changed);
  bool takeKeys(const render::State& state, NewKeys& made);
  static ArrayShapes shapesOf(const gen::State& state);
  bool keysStale(const render::State& state, gen::Groups changed) const;
  void packConstants(const render::State& state, gen::Groups changed, const NewKeys& made);
  void takeTextures(const render::State& state);
  bool placeConstants();
  bool place(Constants& constants, uint32_t size);
  bool fetchTextures();
  void startBound();
  bool bindAll(VkCommandBuffer commands);
  bool bindPipeline(VkCommandBuffer commands);
  void bindVertices(VkCommandBuffer commands);
  void bindConstants(VkCommandBuffer commands);
  bool bindTextures(VkCommandBuffer commands, uint32_t units, const VkImageView* views,
                    const VkSampler* samplers);
  void record(VkCommandBuffer commands, const Geometry& geometry);
  bool geometry(const render::DrawCall& call, Geometry& out);
  bool listGeometry(const render::DrawCall& call, Geometry& out);
  bool arraysGeometry(const render::DrawCall& call, Expansion expansion, Geometry& out);
  bool elementsGeometry(const render::DrawCall& call, Expansion expansion, Geometry& out);
  bool writeIndices(const render::DrawCall& call, Expansion expansion, const std::byte* indices,
                    uint32_t count, uint32_t base, Geometry& out);
  Expansion expansionOf(GLenum mode) const;
  void tellCompiled();
  void submitEarly();

  // clear.cpp
  bool remember(VulkanImage& image, int level, int layer, VkImageAspectFlags aspects,
                const PendingClear& values);
  bool clearInPass(VkImageAspectFlags aspects, const render::Rect& rect, const PendingClear& values);
  static DrawState plainQuad(const Target& target);
  bool bindQuad(const Target& target, const DrawState& quad, const OwnShader& fragment, bool withDepth,
                Counted counted);
  bool drawQuad(const Target& target, const DrawState& quad, const VkClearColorValue& color, bool withDepth,
                VkImageView copied = VK_NULL_HANDLE);
  bool clearMasked(const render::State& state, VkImageAspectFlags aspects, const render::Rect& rect);
  bool materialise(VulkanImage& image);
  bool opaqueAlpha(VulkanImage& image, int level, int layer);

  // hud.cpp
  bool drawHud(const Target& target, const render::Hud& hud);
  bool drawHud(VulkanWindow& window);

  // implicit_samples.cpp
  bool openPass(const Target& target, bool withDepth);
  bool loadSamples(const Target& target);

  // transfer.cpp
  void uploadMapped(const VulkanImage& image, ImageStore& store, const render::Region& region,
                    const std::byte* data, size_t rowPitch, size_t slicePitch);
  bool uploadStaged(VulkanImage& image, const render::Region& region, const std::byte* data, size_t rowPitch,
                    size_t slicePitch);
  ImageStore* writableMapped(VulkanImage& image, bool whole);
  ImageStore* readable(VulkanImage& image);
  const std::shared_ptr<ImageStore>& heldReadable(VulkanImage& image);
  bool waitFor(const ImageStore& store);
  void leavePass(ImageStore& store, bool write);
  bool copyOnDevice(VulkanImage& image, const render::Region& region, const render::Framebuffer& source,
                    int x, int y);
  bool copyThroughMemory(VulkanImage& image, const render::Region& region, const render::Framebuffer& source,
                         int x, int y);
  // mipmaps.cpp
  bool blitMipmaps(VulkanImage& image);
  bool submit(VkSemaphore signal = VK_NULL_HANDLE);
  // present.cpp
  bool copyStore(const std::shared_ptr<ImageStore>& from, const std::shared_ptr<ImageStore>& to,
                 VkExtent2D extent);
  bool leaveForPresentation(const std::shared_ptr<ImageStore>& store);
  render::Presented show(VulkanWindow& window, std::span<const render::Rect> damage);

  VulkanDevice& device_;
  CommandStream commands_;
  PassEncoder pass_;
  Stream vertices_, indices_, constants_, staging_, readBack_;
  VertexFetch fetch_;
  Bound bound_;

  bool taken_ = false;                    // what follows from the state is that of the last draw's
  const render::State* state_ = nullptr;  // of the draw that is made
  Target target_;
  gen::FragmentKey fragmentKey_{};
  gen::VertexKey vertexKey_{};
  const Shader* vertexShader_ = nullptr;
  const Shader* fragmentShader_ = nullptr;
  gen::Blocks blocks_;
  uint32_t units_ = 0;  // sampled
  ArrayShapes shapes_{};
  Batch batch_;
  const bool carriesValues_;  // the device takes so many vertex inputs
  Carried carried_ = Carried::Nothing;
  uint32_t valueChanges_ = 0, valueChangesNeeded_ = 32, alone_ = 0;

  render::Listener* listener_ = nullptr;
  int openGroups_ = 0;
  uint64_t ownPasses_ = 0;  // that no command of GL needed

  DrawState wanted_, sent_;
  bool nothing_ = false;
  PipelineKey pipelineKey_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  alignas(16) std::array<std::byte, kPushRange> push_{};
  Constants vertexConstants_, fragmentConstants_, paletteConstants_;
  std::array<VkImageView, gen::kMaxTextureUnits> views_{};
  std::array<VkSampler, gen::kMaxTextureUnits> samplers_{};
  // An image, or one level of one of its layers (onlyLevel >= 0).
  struct Sampled {
    VulkanImage* image;
    int onlyLevel, onlyLayer;
  };
  std::array<Sampled, gen::kMaxTextureUnits> sampled_{};
  uint32_t drawsSinceSubmit_ = 0;
  mutable render::Stats stats_;
};

}  // namespace anteroom::vulkan
