// The recorder of a context: the only owner of its command buffers, of the pass that is open and of what is
// bound. Whatever a context does on the device goes through it.
#pragma once

#include <volk.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "layer/vulkan/geometry/geometry.h"
#include "layer/vulkan/pipelines/pipeline_key.h"
#include "layer/vulkan/pipelines/shader_library.h"
#include "layer/vulkan/plan/draw_plan.h"
#include "layer/vulkan/recording/command_stream.h"
#include "layer/vulkan/recording/pass.h"
#include "layer/vulkan/resources/stream.h"

namespace anteroom::render {
class Listener;
}

namespace anteroom::vulkan {

// A quad over a target, by one of the renderer's own shaders.
struct Quad {
  // Over all of the target, under no test; it writes no component yet.
  explicit Quad(const Target& target);

  DrawState state;
  const OwnShader* fragment = &kFlatFragment;
  std::array<float, 4> color{};          // of kFlatFragment
  VkImageView texels = VK_NULL_HANDLE;   // of kCopyFragment
  std::span<const std::byte> constants;  // of the fragment shader; at most kConstantRange bytes
  bool withDepth = false;                // it tests or writes depth or stencil
  Counted counted = Counted::Yes;        // No: no statistics tell of its pipeline and of its pass
};

class Recorder {
 public:
  explicit Recorder(VulkanDevice& device);
  bool initialise() { return commands_.initialise(); }
  // Hears when a draw waits for a pipeline; null: nobody.
  void setListener(render::Listener* listener) { listener_ = listener; }

  VulkanDevice& device() { return device_; }
  // The command buffer, begun when necessary. Null: the device is lost or out of memory.
  VkCommandBuffer commands();
  // Changes with each command buffer.
  uint64_t recordingId() const { return commands_.recordingId(); }
  bool lost() const { return commands_.lost(); }

  // Ends the pass, and submits what was recorded, if anything was. `signal`: a semaphore for presenting.
  // False: the device is lost or out of memory.
  bool submit(VkSemaphore signal = VK_NULL_HANDLE);
  // For each draw: submits before a recording gets long, where the device works on the program's own CPU.
  void submitLong();
  // The number of the last submission.
  uint64_t lastSubmitted() const { return commands_.lastSubmitted(); }
  // Waits for what was submitted, or for the last use of `store`, which is submitted first.
  bool waitForSubmitted();
  bool waitFor(const ImageStore& store);
  // Drops the references of submissions that are complete.
  void retire() { commands_.retire(); }

  // Memory that lives as long as the recording is in use.
  Stream& vertices() { return vertices_; }
  Stream& indices() { return indices_; }
  Stream& staging() { return staging_; }
  Stream& readBack() { return readBack_; }

  // The pass. Makes sure that one on `target` is open, with its depth and stencil when `withDepth`. False:
  // out of memory.
  bool openPass(const Target& target, bool withDepth);
  void endPass();
  bool passIsOn(const Target& target) const { return pass_.activeOn(target); }
  bool passHasDepth() const { return pass_.hasDepth(); }
  bool passAttaches(const ImageStore& store) const { return pass_.attaches(store); }

  // Opens the pass and binds all that a draw needs. False: out of memory.
  bool bind(const DrawPlan& plan, const Geometry& geometry);
  // Draws with what is bound.
  void draw(const DrawRange& range);
  // The same, but the draw is held back: more vertices may join it until anything else is recorded. Not
  // indexed.
  void holdBack(const DrawRange& range);
  // Vertices of the draw that is held back; 0: none is.
  uint32_t held() const { return held_.count; }
  void growHeld(uint32_t count) { held_.count += count; }
  void drawHeld();
  // Opens a pass and draws. False: out of memory.
  bool quad(const Target& target, const Quad& quad);
  // Inside the pass that is open.
  void clear(std::span<const VkClearAttachment> attachments, const VkRect2D& rect);

  // Commands that read one image, write another (null: none), or both are about to be recorded: ends the
  // pass, and waits for what they depend on. Null: the device is lost or out of memory.
  VkCommandBuffer beginTransfer(const std::shared_ptr<ImageStore>* read,
                                const std::shared_ptr<ImageStore>* written);
  // Between commands of one transfer that depend on each other.
  void barrier() { commands_.barrier(); }
  // The window system is about to read the image, a swapchain's. False: the device is lost or out of memory.
  bool leaveForPresentation(const std::shared_ptr<ImageStore>& store);
  // Draws are about to sample the image: ends the pass only if it must. False: as above.
  bool beginSampling(const std::shared_ptr<ImageStore>& store);

  void countUpload(uint64_t bytes) { uploaded_ += bytes; }
  uint64_t uploaded() const { return uploaded_; }
  uint64_t submits() const { return submits_; }
  uint64_t passes() const { return pass_.passes() - uncountedPasses_; }

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
    uint64_t pushVersion = 0;
    uint32_t pushed = 0;  // bytes of push constants that are valid
    BoundSet vertex, fragment, palette;
    uint32_t units = 0;  // whose textures are bound
    std::array<Texture, gen::kMaxTextureUnits> textures{};
  };
  // A block of constants, as it came into the stream last.
  struct SentBlock {
    uint64_t recording = 0;
    uint64_t version = 0;
    uint32_t size = 0;
    StreamPiece piece;
  };
  using Block = ConstantBlock<kConstantRange>;

  // bindings.cpp
  void startBound();
  void bindVertices(VkCommandBuffer commands, const VertexArrays& arrays);
  bool bindPipeline(VkCommandBuffer commands, const DrawPlan& plan, const VertexLayout& layout,
                    const BakedState& state);
  void tellWaited(const DrawPlan& plan);
  bool sendBlock(const Block& block, SentBlock& sent);
  void bindSet(VkCommandBuffer commands, uint32_t index, VkDescriptorSet set, const StreamPiece& piece,
               BoundSet& bound);
  bool bindConstants(VkCommandBuffer commands, const DrawPlan& plan);
  bool bindTextures(VkCommandBuffer commands, uint32_t units, const Texture* textures);

  VkCommandBuffer bindQuad(const Target& target, const Quad& quad);

  VulkanDevice& device_;
  CommandStream commands_;
  PassEncoder pass_;
  Stream vertices_, indices_, constants_, staging_, readBack_;
  render::Listener* listener_ = nullptr;

  Bound bound_;
  DrawState sent_;  // valid with bound_.stateSent
  DrawRange held_;
  PipelineKey pipelineKey_;  // of pipeline_
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  SentBlock vertexBlock_, fragmentBlock_, paletteBlock_;

  uint32_t drawsSinceSubmit_ = 0;
  uint64_t submits_ = 0, uploaded_ = 0;
  uint64_t uncountedPasses_ = 0;
};

}  // namespace anteroom::vulkan
