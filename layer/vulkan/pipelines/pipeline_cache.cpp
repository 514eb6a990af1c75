#include "layer/vulkan/pipelines/pipeline_cache.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <chrono>
#include <cstdio>

#include "layer/cache/shader_cache.h"
#include "layer/vulkan/debug/shader_dump.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/no_fork.h"
#include "layer/vulkan/pipelines/driver_cache.h"
#include "layer/vulkan/pipelines/legacy_passes.h"
#include "layer/vulkan/pipelines/pipeline_words.h"
#include "layer/vulkan/pipelines/shader_library.h"

namespace anteroom::vulkan {
namespace {

// The parts of a VkGraphicsPipelineCreateInfo, and what they point to.
class PipelineBuilder {
 public:
  PipelineBuilder(const PipelineKey& key, const Features& features) : key_(key), features_(features) {}

  VkGraphicsPipelineCreateInfo build(const Shader& vertex, const Shader& fragment);

 private:
  void bakedState();
  void stages(const Shader& vertex, const Shader& fragment);
  void vertexInput();
  void rasterization();
  void dynamicStates();
  void rendering();

  const PipelineKey& key_;
  const Features& features_;
  VkPipelineShaderStageCreateInfo stages_[2]{};
  VkVertexInputBindingDescription bindings_[kMostArrays];
  VkVertexInputAttributeDescription attributes_[kMostArrays];
  VkPipelineVertexInputStateCreateInfo input_{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly_{
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  VkPipelineViewportStateCreateInfo viewport_{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  VkPipelineRasterizationStateCreateInfo raster_{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  VkPipelineRasterizationProvokingVertexStateCreateInfoEXT provoking_{
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_PROVOKING_VERTEX_STATE_CREATE_INFO_EXT};
  VkPipelineRasterizationLineStateCreateInfoEXT line_{
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_LINE_STATE_CREATE_INFO_EXT};
  VkPipelineMultisampleStateCreateInfo multisample_{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  VkSampleMask sampleMask_ = 0;
  VkPipelineDepthStencilStateCreateInfo depth_{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  VkPipelineColorBlendAttachmentState attachment_{};
  VkPipelineColorBlendStateCreateInfo blend_{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  VkDynamicState dynamic_[40];
  uint32_t dynamicCount_ = 0;
  VkPipelineDynamicStateCreateInfo dynamicInfo_{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  VkFormat colorFormat_ = VK_FORMAT_UNDEFINED;
  VkPipelineRenderingCreateInfoKHR rendering_{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO_KHR};
};

template <class Place>
void put(Place& place, uint8_t value) {
  place = static_cast<Place>(value);
}

void PipelineBuilder::bakedState() {
#define BAKED_PART(member, word, values, primitives, place, command) put(place, key_.state.member);
#include "layer/vulkan/pipelines/baked_state.inc"
  depth_.back = depth_.front;
}

void PipelineBuilder::stages(const Shader& vertex, const Shader& fragment) {
  for (auto& stage : stages_) {
    stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    stage.pName = "main";
  }
  stages_[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
  stages_[0].module = vertex.module;
  stages_[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
  stages_[1].module = fragment.module;
}

void PipelineBuilder::vertexInput() {
  for (uint32_t i = 0; i < key_.layout.count; ++i) {
    const VertexLayout::Array& array = key_.layout.arrays[i];
    bindings_[i] = {i, array.stride, VK_VERTEX_INPUT_RATE_VERTEX};
    attributes_[i] = {array.location, i, static_cast<VkFormat>(array.format), 0};
  }
  input_.vertexBindingDescriptionCount = input_.vertexAttributeDescriptionCount = key_.layout.count;
  input_.pVertexBindingDescriptions = bindings_;
  input_.pVertexAttributeDescriptions = attributes_;
  viewport_.viewportCount = viewport_.scissorCount = 1;
}

void PipelineBuilder::rasterization() {
  raster_.polygonMode = VK_POLYGON_MODE_FILL;
  raster_.lineWidth = 1;
  if (features_.provokingVertexLast) {
    provoking_.provokingVertexMode = VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
    provoking_.pNext = raster_.pNext;
    raster_.pNext = &provoking_;
  }
  if (features_.bresenhamLines) {
    line_.pNext = raster_.pNext;
    raster_.pNext = &line_;
  }
  multisample_.rasterizationSamples = static_cast<VkSampleCountFlagBits>(key_.samples);
  if (!features_.dynamicState3) multisample_.pSampleMask = &sampleMask_;
  blend_.attachmentCount = key_.colorFormat ? 1 : 0;
  blend_.pAttachments = &attachment_;
}

void PipelineBuilder::dynamicStates() {
  const Features& f = features_;
  const auto add = [this](VkDynamicState state) { dynamic_[dynamicCount_++] = state; };
  for (VkDynamicState state :
       {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR, VK_DYNAMIC_STATE_LINE_WIDTH,
        VK_DYNAMIC_STATE_DEPTH_BIAS, VK_DYNAMIC_STATE_STENCIL_COMPARE_MASK,
        VK_DYNAMIC_STATE_STENCIL_WRITE_MASK, VK_DYNAMIC_STATE_STENCIL_REFERENCE})
    add(state);
#define BAKED_COMMAND(command, feature, state, send) \
  if (feature) add(VK_DYNAMIC_STATE_##state);
#include "layer/vulkan/pipelines/baked_state.inc"
  if (f.dynamicVertexInput) add(VK_DYNAMIC_STATE_VERTEX_INPUT_EXT);
  dynamicInfo_.dynamicStateCount = dynamicCount_;
  dynamicInfo_.pDynamicStates = dynamic_;
}

void PipelineBuilder::rendering() {
  colorFormat_ = static_cast<VkFormat>(key_.colorFormat);
  const auto depth = static_cast<VkFormat>(key_.depthFormat);
  const bool stencilOnly = depth == VK_FORMAT_S8_UINT;
  const bool both = depth == VK_FORMAT_D24_UNORM_S8_UINT || depth == VK_FORMAT_D32_SFLOAT_S8_UINT;
  rendering_.colorAttachmentCount = colorFormat_ ? 1 : 0;
  rendering_.pColorAttachmentFormats = &colorFormat_;
  rendering_.depthAttachmentFormat = stencilOnly ? VK_FORMAT_UNDEFINED : depth;
  rendering_.stencilAttachmentFormat = stencilOnly || both ? depth : VK_FORMAT_UNDEFINED;
}

VkGraphicsPipelineCreateInfo PipelineBuilder::build(const Shader& vertex, const Shader& fragment) {
  bakedState();
  stages(vertex, fragment);
  vertexInput();
  rasterization();
  dynamicStates();
  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  if (features_.dynamicRendering) {
    rendering();
    info.pNext = &rendering_;
  }
  info.stageCount = 2;
  info.pStages = stages_;
  info.pVertexInputState = &input_;
  info.pInputAssemblyState = &assembly_;
  info.pViewportState = &viewport_;
  info.pRasterizationState = &raster_;
  info.pMultisampleState = &multisample_;
  info.pDepthStencilState = &depth_;
  info.pColorBlendState = &blend_;
  info.pDynamicState = &dynamicInfo_;
  return info;
}

}  // namespace

size_t PipelineCache::Hash::operator()(const PipelineKey& key) const {
  return XXH3_64bits(&key, sizeof key);
}

PipelineCache::~PipelineCache() {
  pipelines_.visit(
      [this](const Made& made) { device_.fn().vkDestroyPipeline(device_.handle(), made.pipeline, nullptr); });
}

VkPipeline PipelineCache::create(const PipelineKey& key, const Shader& vertex, const Shader& fragment) {
  PipelineBuilder builder(key, device_.features());
  VkGraphicsPipelineCreateInfo info = builder.build(vertex, fragment);
  info.layout = device_.pipelineLayout();
  if (!device_.features().dynamicRendering) {
    const PassFormats formats{static_cast<VkFormat>(key.colorFormat), static_cast<VkFormat>(key.depthFormat),
                              key.samples};
    info.renderPass = device_.legacyPasses().get(formats, {}, false);
    if (!info.renderPass) return VK_NULL_HANDLE;
  }
  VkPipeline pipeline = VK_NULL_HANDLE;
  const ValidationScope validation;
  const VkResult result = device_.fn().vkCreateGraphicsPipelines(
      device_.handle(), device_.driverCache().handle(), 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS) {
    if (isFault(result))
      report("the driver refuses a pipeline, VkResult " + std::to_string(result), key, vertex, fragment,
             validation.messages());
    else
      std::fprintf(stderr, "anteroom: a pipeline cannot be made (VkResult %d): check the Vulkan driver\n",
                   result);
    return VK_NULL_HANDLE;
  }
  if (!validation.messages().empty())
    report("validation finds fault with a pipeline", key, vertex, fragment, validation.messages());
  device_.countObject();
  if (device_.labels().nameAll())
    device_.labels().name(VK_OBJECT_TYPE_PIPELINE, pipeline,
                          describe(ShaderText{vertex.kind, vertex.key}) + " | " +
                              describe(ShaderText{fragment.kind, fragment.key}) + " | " +
                              describe(key, device_.features()));
  return pipeline;
}

void PipelineCache::report(const std::string& fault, const PipelineKey& key, const Shader& vertex,
                           const Shader& fragment, const std::string& log) const {
  const ShaderText texts[] = {{vertex.kind, vertex.key}, {fragment.kind, fragment.key}};
  reportFailure(device_, fault, texts, describe(key, device_.features()), log);
}

bool PipelineCache::create(const PipelineKey& key, const Shader& vertex, const Shader& fragment, Made& made) {
  const NoFork noFork;
  const auto start = std::chrono::steady_clock::now();
  made.pipeline = create(key, vertex, fragment);
  const auto time = std::chrono::steady_clock::now() - start;
  made.microseconds = std::chrono::duration_cast<std::chrono::microseconds>(time).count();
  return made.pipeline;
}

VkPipeline PipelineCache::get(const PipelineKey& key, const Shader& vertex, const Shader& fragment,
                              Counted counted) {
  Made& made = pipelines_.get(key, [&](const PipelineKey&, Made& value) {
    const bool good = create(key, vertex, fragment, value);
    awaited_ += counted == Counted::Yes;
    created_ += good && counted == Counted::Yes;
    return good;
  });
  if (made.pipeline && counted == Counted::Yes && !made.used.load(std::memory_order_relaxed) &&
      !made.used.exchange(true))
    noteUse(key, vertex, fragment, made.microseconds);
  return made.pipeline;
}

bool PipelineCache::makeAhead(const PipelineKey& key, const Shader& vertex, const Shader& fragment) {
  const Made& made = pipelines_.get(key, [&](const PipelineKey&, Made& value) {
    const bool good = create(key, vertex, fragment, value);
    ahead_ += good;
    created_ += good;
    return good;
  });
  return made.pipeline;
}

void PipelineCache::noteUse(const PipelineKey& key, const Shader& vertex, const Shader& fragment,
                            int64_t microseconds) {
  cache::ShaderCache& cache = cache::ShaderCache::process();
  if (!cache.wanted()) return;
  cache::PipelineRow row;
  row.vertex = cache::wordsOf(vertex.kind, vertex.key);
  row.fragment = cache::wordsOf(fragment.kind, fragment.key);
  row.state = describe(key, device_.features());
  row.createMicroseconds = microseconds;
  cache.use(std::move(row));
}

}  // namespace anteroom::vulkan
