// The road of a draw: what changed is looked at again, what is bound already is not bound again.
#include <algorithm>
#include <bit>
#include <cstring>

#include "layer/vulkan/context.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "layer/vulkan/pipelines/shader_library.h"
#include "layer/vulkan/resources/sampler.h"

namespace anteroom::vulkan {
namespace {

using gen::Groups;

// What translate() reads.
constexpr Groups kDrawStateGroups = gen::kGroupRaster | gen::kGroupFragmentOps | gen::kGroupViewport |
                                    gen::kGroupFramebuffer | gen::kGroupPrimitive;

// On a CPU device the queue's thread should not wait for the end of a long frame.
constexpr uint32_t kDrawsASubmission = 1500;

}  // namespace

VulkanContext::ArrayShapes VulkanContext::shapesOf(const gen::State& state) {
  ArrayShapes shapes;
  for (int a = 0; a < gen::kAttributeCount; ++a)
    shapes[a] = {state.attributes[a].array, state.attributes[a].size, state.attributes[a].type};
  return shapes;
}

// Takes over what changed of the state; nothing of it is looked at again after that. False: out of memory.
bool VulkanContext::take(const render::State& state, Groups changed) {
  if (!taken_) changed = gen::kAllGroups;
  NewKeys made{!taken_, !taken_};
  taken_ = false;
  takeTarget(state, changed);
  if (keysStale(state, changed) && !takeKeys(state, made)) return false;
  if (changed & kDrawStateGroups)
    nothing_ = translate(state, target_, device_.features(), device_.limits(), wanted_).nothing;
  packConstants(state, changed, made);
  if (changed & gen::kGroupArrays || made.vertex)
    fetch_.configure(state, vertexKey_, carried_, push_.data(), blocks_.pushSize);
  if (changed & gen::kGroupTextures || made.fragment) takeTextures(state);
  taken_ = true;
  return true;
}

void VulkanContext::takeTarget(const render::State& state, Groups changed) {
  if (!(changed & gen::kGroupFramebuffer)) return;
  Target target = targetOf(state.framebuffer);
  if (!target.same(target_)) target_ = std::move(target);
}

// Whether something changed that the keys depend on. Arrays that lie elsewhere but look the same change no
// key.
bool VulkanContext::keysStale(const render::State& state, Groups changed) const {
  if (changed & gen::keyGroups() & ~gen::kGroupArrays) return true;
  return changed & gen::kGroupArrays && shapesOf(state.fixed) != shapes_;
}

bool VulkanContext::takeKeys(const render::State& state, NewKeys& made) {
  const gen::Profile& profile = device_.caps().profile;
  shapes_ = shapesOf(state.fixed);
  const gen::FragmentKey fragment = gen::canonicaliseFragment(state.fixed, profile);
  const auto color = carried_ == Carried::Color ? gen::CurrentColor::OfVertices : gen::CurrentColor::OfState;
  gen::VertexKey vertex = gen::canonicaliseVertex(state.fixed, fragment, profile, color);
  vertex.ownValues = carried_ == Carried::Values;
  made.fragment |= !(fragment == fragmentKey_);
  made.vertex |= !(vertex == vertexKey_);
  if (!made.fragment && !made.vertex) return true;
  if (made.fragment) {
    fragmentKey_ = fragment;
    fragmentShader_ = device_.shaders().get(fragment);
    units_ = gen::unitsSampled(fragment);
  }
  if (made.vertex) {
    vertexKey_ = vertex;
    vertexShader_ = device_.shaders().get(vertex);
  }
  blocks_ = gen::blocks(vertexKey_, fragmentKey_);
  pipeline_ = VK_NULL_HANDLE;
  return vertexShader_ && fragmentShader_ && blocks_.pushSize <= kPushRange &&
         blocks_.vertexSize <= kConstantRange && blocks_.fragmentSize <= kConstantRange &&
         blocks_.paletteSize <= kConstantRange;
}

bool VulkanContext::draw(const render::State& state, Groups changed, const render::DrawCall& call) {
  ++stats_.draws;
  state_ = &state;
  if (batch_.count && join(state, changed, call)) return true;
  flushBatch();
  submitEarly();
  if (!take(state, changed | watch(state, changed, call))) return false;
  if (nothing_ || (!target_.color && !target_.depth)) return true;

  const VkCommandBuffer commands = commands_.commands();
  if (!commands || !placeConstants() || !fetchTextures()) return false;
  Geometry geometry;
  if (!this->geometry(call, geometry)) return false;
  if (geometry.count == 0) return true;
  const bool withDepth = wanted_.fixed.depthTest || wanted_.fixed.stencilTest;
  if (target_.color && target_.color->alphaStale && !pass_.activeOn(target_))
    if (!opaqueAlpha(*target_.color, target_.colorLevel, target_.colorLayer)) return false;
  if (!openPass(target_, withDepth) || !bindAll(commands)) return false;
  if (!openBatch(call, geometry)) record(commands, geometry);
  return true;
}

void VulkanContext::submitEarly() {
  if (++drawsSinceSubmit_ <= kDrawsASubmission || !device_.isCpu()) return;
  submit();
}

void VulkanContext::packConstants(const render::State& state, Groups changed, const NewKeys& made) {
  if (made.vertex || changed & blocks_.pushGroups) {
    alignas(16) std::array<std::byte, kPushRange> packed;
    gen::packPush(vertexKey_, state.fixed, packed.data());
    if (made.vertex || std::memcmp(packed.data(), push_.data(), blocks_.pushSize) != 0) {
      std::memcpy(push_.data(), packed.data(), blocks_.pushSize);
      bound_.pushed = 0;
    }
  }
  if (blocks_.vertexSize && (made.vertex || changed & blocks_.vertexGroups)) {
    gen::packVertex(vertexKey_, state.fixed, vertexConstants_.data.data());
    vertexConstants_.placed = false;
  }
  if (blocks_.fragmentSize && (made.fragment || changed & blocks_.fragmentGroups)) {
    gen::packFragment(fragmentKey_, state.fixed, fragmentConstants_.data.data());
    fragmentConstants_.placed = false;
  }
  if (blocks_.paletteSize && (made.vertex || changed & blocks_.paletteGroups)) {
    gen::packPalette(vertexKey_, state.fixed, paletteConstants_.data.data());
    paletteConstants_.placed = false;
  }
}

bool VulkanContext::placeConstants() {
  return place(vertexConstants_, blocks_.vertexSize) && place(fragmentConstants_, blocks_.fragmentSize) &&
         place(paletteConstants_, blocks_.paletteSize);
}

// Brings a block into the stream, when it is new or this recording has not got it yet.
bool VulkanContext::place(Constants& constants, uint32_t size) {
  if (size == 0) return true;
  const bool here = constants.recording == commands_.recordingId() && constants.size == size;
  if (here && (constants.placed || !std::memcmp(constants.data.data(), constants.piece.mapped, size))) {
    constants.placed = true;
    return true;
  }
  constants.piece = constants_.allocate(size, device_.limits().minUniformBufferOffsetAlignment);
  if (!constants.piece) return false;
  std::memcpy(constants.piece.mapped, constants.data.data(), size);
  constants.size = size;
  constants.placed = true;
  constants.recording = commands_.recordingId();
  return true;
}

void VulkanContext::takeTextures(const render::State& state) {
  for (uint32_t units = units_; units; units &= units - 1) {
    const int unit = std::countr_zero(units);
    const render::TextureBinding& binding = state.textures[unit];
    sampled_[unit] = {static_cast<VulkanImage*>(binding.image), binding.onlyLevel, binding.onlyLayer};
    if (!binding.image) continue;
    const int levels = binding.onlyLevel < 0 ? binding.image->desc().levels : 1;
    samplers_[unit] = device_.samplers().get(binding.sampler, levels, state.fixed.units[unit].env.lodBias);
  }
}

// The views that the draw samples. What was rendered into them is made visible, which may end the pass.
bool VulkanContext::fetchTextures() {
  for (uint32_t units = units_; units; units &= units - 1) {
    const int unit = std::countr_zero(units);
    const Sampled& sampled = sampled_[unit];
    if (!sampled.image) return false;
    VulkanImage& image = *sampled.image;
    if (image.pending.aspects && !materialise(image)) return false;
    ImageStore* store = readable(image);
    if (!store || !samplers_[unit]) return false;
    const auto& held = heldReadable(image);
    if (commands_.mustWaitToRead(*store) || pass_.attaches(*store)) leavePass(*store, false);
    commands_.read(held);
    views_[unit] = sampled.onlyLevel < 0
                       ? store->view
                       : store->partView(sampled.onlyLevel, sampled.onlyLayer, image.format().swizzle);
    if (!views_[unit]) return false;
  }
  return true;
}

Expansion VulkanContext::expansionOf(GLenum mode) const {
  const Features& features = device_.features();
  if (!features.provokingVertexLast && state_->fixed.shadeModel == GL_FLAT && mode != GL_POINTS)
    return Expansion::ToListRotated;
  if (mode == GL_LINE_LOOP) return Expansion::LoopToStrip;
  if (mode == GL_TRIANGLE_FAN && !features.triangleFans) return Expansion::ToList;
  return Expansion::None;
}

bool VulkanContext::geometry(const render::DrawCall& call, Geometry& out) {
  if (call.count <= 0 || call.first < 0) return true;
  if (takesList(call)) return listGeometry(call, out);
  const Expansion expansion = expansionOf(call.mode);
  GLenum mode = call.mode;
  if (expansion == Expansion::ToList || expansion == Expansion::ToListRotated)
    mode = state_->fixed.primitive == gen::PrimitiveClass::Lines ? GL_LINES : GL_TRIANGLES;
  wanted_.fixed.topology = static_cast<uint8_t>(topologyOf(mode));
  return call.indexType ? elementsGeometry(call, expansion, out) : arraysGeometry(call, expansion, out);
}

bool VulkanContext::arraysGeometry(const render::DrawCall& call, Expansion expansion, Geometry& out) {
  const auto first = static_cast<uint32_t>(call.first), count = static_cast<uint32_t>(call.count);
  const bool inside = fetch_.inside(uint64_t{first} + count);
  if (inside ? !fetch_.fetchRange(first, count, vertices_, commands_)
             : !fetch_.fetchList(0, nullptr, first, count, vertices_, commands_))
    return false;
  const uint32_t start = static_cast<uint32_t>(fetch_.vertexOffset()) + (inside ? first : 0);
  if (expansion != Expansion::None) return writeIndices(call, expansion, nullptr, count, start, out);
  out.count = count;
  out.first = start;
  return true;
}

bool VulkanContext::elementsGeometry(const render::DrawCall& call, Expansion expansion, Geometry& out) {
  auto count = static_cast<uint32_t>(call.count);
  const uint32_t size = indexSize(call.indexType);
  const auto* indices = static_cast<const std::byte*>(call.indices);
  VulkanBuffer* const buffer = call.indexBuffer ? &vulkan(*call.indexBuffer) : nullptr;
  const size_t offset = reinterpret_cast<uintptr_t>(call.indices);
  IndexRange range;
  if (buffer) {
    // Indices beyond the buffer's end are not drawn.
    const size_t have = offset < buffer->size() ? (buffer->size() - offset) / size : 0;
    count = static_cast<uint32_t>(std::min<size_t>(count, have));
    if (count == 0) return true;
    indices = buffer->contents() + offset;
    range = buffer->indexRange(call.indexType, offset, count);
  } else {
    range = scanIndices(call.indexType, indices, count);
  }
  const uint64_t span = uint64_t{range.most} - range.least + 1;
  const bool sparse = fetch_.gathers() && span > 4 * uint64_t{count} + 256;
  if (sparse || !fetch_.inside(uint64_t{range.most} + 1)) {
    if (!fetch_.fetchList(call.indexType, indices, 0, count, vertices_, commands_)) return false;
    const auto start = static_cast<uint32_t>(fetch_.vertexOffset());
    if (expansion != Expansion::None) return writeIndices(call, expansion, nullptr, count, start, out);
    out.count = count;
    out.first = start;
    return true;
  }
  if (!fetch_.fetchRange(range.least, static_cast<uint32_t>(span), vertices_, commands_)) return false;
  const bool small = call.indexType == GL_UNSIGNED_BYTE && !device_.features().indexUint8;
  if (expansion != Expansion::None || small)
    return writeIndices(call, expansion, indices, count, static_cast<uint32_t>(fetch_.vertexOffset()), out);

  out.indexed = true;
  out.count = count;
  out.vertexOffset = fetch_.vertexOffset();
  out.indexType = size == 1   ? VK_INDEX_TYPE_UINT8_EXT
                  : size == 2 ? VK_INDEX_TYPE_UINT16
                              : VK_INDEX_TYPE_UINT32;
  if (buffer && offset % size == 0) {
    commands_.hold(buffer->store());
    const Allocation& memory = buffer->store()->memory;
    // The buffer is bound at its start: draws from other parts of it change only the first index.
    out.indexBuffer = memory.buffer;
    out.indexOffset = memory.offset;
    out.first = static_cast<uint32_t>(offset / size);
    return true;
  }
  const StreamPiece piece = indices_.allocate(VkDeviceSize{count} * size, 4);
  if (!piece) return false;
  std::memcpy(piece.mapped, indices, size_t{count} * size);
  out.indexBuffer = piece.buffer;
  out.indexOffset = piece.offset;
  return true;
}

// Indices of 32 bits, made here. `base` is added to each.
bool VulkanContext::writeIndices(const render::DrawCall& call, Expansion expansion, const std::byte* indices,
                                 uint32_t count, uint32_t base, Geometry& out) {
  if (count > (1u << 29)) return false;
  const bool widen = expansion == Expansion::None;
  const GLenum mode = widen ? GLenum{GL_POINTS} : call.mode;  // as they are
  out.indexed = true;
  out.indexType = VK_INDEX_TYPE_UINT32;
  out.count = expandedCount(mode, expansion, count);
  if (out.count == 0) return true;
  const StreamPiece piece = indices_.allocate(VkDeviceSize{out.count} * 4, 4);
  if (!piece) return false;
  expandIndices(mode, expansion, call.indexType, indices, count, base,
                reinterpret_cast<uint32_t*>(piece.mapped));
  out.indexBuffer = piece.buffer;
  out.indexOffset = piece.offset;
  return true;
}

void VulkanContext::startBound() {
  if (bound_.recording == commands_.recordingId()) return;
  bound_ = {};
  bound_.recording = commands_.recordingId();
}

bool VulkanContext::bindAll(VkCommandBuffer commands) {
  startBound();
  bindVertices(commands);
  if (!bindPipeline(commands)) return false;
  emit(device_, commands, pass_.formats().samples, wanted_, sent_, !bound_.stateSent);
  bound_.stateSent = true;
  bindConstants(commands);
  return bindTextures(commands, units_, views_.data(), samplers_.data());
}

bool VulkanContext::bindPipeline(VkCommandBuffer commands) {
  const Features& features = device_.features();
  PipelineKey key;
  key.vertexShader = vertexShader_->id;
  key.fragmentShader = fragmentShader_->id;
  key.colorFormat = pass_.formats().color;
  key.depthFormat = pass_.formats().depth;
  key.samples = pass_.formats().samples;
  if (!features.dynamicVertexInput) key.layout = fetch_.layout();
  key.state = baked(wanted_.fixed, features);
  if (!pipeline_ || !(key == pipelineKey_)) {
    pipelineKey_ = key;
    const uint64_t before = listener_ ? device_.pipelines().awaited() : 0;
    pipeline_ = device_.pipelines().get(key, *vertexShader_, *fragmentShader_);
    if (!pipeline_) return false;
    if (listener_ && device_.pipelines().awaited() != before) tellCompiled();
  }
  if (pipeline_ == bound_.pipeline) return true;
  device_.fn().vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
  bound_.pipeline = pipeline_;
  return true;
}

void VulkanContext::tellCompiled() {
  listener_->slow("A draw waits for a pipeline that is compiled for its state: " + describe(fragmentKey_) +
                  ". Draw once with every combination of state while loading.");
}

void VulkanContext::bindVertices(VkCommandBuffer commands) {
  const VertexLayout& layout = fetch_.layout();
  if (device_.features().dynamicVertexInput && !(layout == bound_.layout)) {
    VkVertexInputBindingDescription2EXT bindings[kMostArrays];
    VkVertexInputAttributeDescription2EXT attributes[kMostArrays];
    for (uint32_t i = 0; i < layout.count; ++i) {
      const VertexLayout::Array& array = layout.arrays[i];
      bindings[i] = {VK_STRUCTURE_TYPE_VERTEX_INPUT_BINDING_DESCRIPTION_2_EXT,
                     nullptr,
                     i,
                     array.stride,
                     VK_VERTEX_INPUT_RATE_VERTEX,
                     1};
      attributes[i] = {VK_STRUCTURE_TYPE_VERTEX_INPUT_ATTRIBUTE_DESCRIPTION_2_EXT,
                       nullptr,
                       array.location,
                       i,
                       static_cast<VkFormat>(array.format),
                       0};
    }
    device_.fn().vkCmdSetVertexInputEXT(commands, layout.count, bindings, layout.count, attributes);
    bound_.layout = layout;
  }
  // One call for the bindings between the first and the last that changed.
  uint32_t first = layout.count, end = 0;
  for (uint32_t i = 0; i < layout.count; ++i) {
    if (i < bound_.arrays && bound_.buffers[i] == fetch_.buffers()[i] &&
        bound_.offsets[i] == fetch_.offsets()[i])
      continue;
    first = std::min(first, i);
    end = i + 1;
  }
  if (first >= end) return;
  device_.fn().vkCmdBindVertexBuffers(commands, first, end - first, fetch_.buffers().data() + first,
                                      fetch_.offsets().data() + first);
  for (uint32_t i = first; i < end; ++i) {
    bound_.buffers[i] = fetch_.buffers()[i];
    bound_.offsets[i] = fetch_.offsets()[i];
  }
  bound_.arrays = std::max(bound_.arrays, end);
}

void VulkanContext::bindConstants(VkCommandBuffer commands) {
  const auto& fn = device_.fn();
  if (!vertexKey_.ownValues && bound_.pushed < blocks_.pushSize) {
    fn.vkCmdPushConstants(commands, device_.pipelineLayout(), VK_SHADER_STAGE_VERTEX_BIT, 0, blocks_.pushSize,
                          push_.data());
    bound_.pushed = blocks_.pushSize;
  }
  const auto bindBlock = [&](uint32_t index, VkDescriptorSet set, const Constants& constants,
                             BoundSet& bound) {
    const auto offset = static_cast<uint32_t>(constants.piece.offset);
    if (set == bound.set && offset == bound.offset) return;
    fn.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, device_.pipelineLayout(), index, 1,
                               &set, 1, &offset);
    bound = {set, offset};
  };
  if (blocks_.vertexSize)
    bindBlock(0, vertexConstants_.piece.constants.vertex, vertexConstants_, bound_.vertexConstants);
  if (blocks_.fragmentSize)
    bindBlock(2, fragmentConstants_.piece.constants.fragment, fragmentConstants_, bound_.fragmentConstants);
  if (blocks_.paletteSize)
    bindBlock(3, paletteConstants_.piece.constants.vertex, paletteConstants_, bound_.paletteConstants);
}

// The views and samplers of `units`, indexed by unit.
bool VulkanContext::bindTextures(VkCommandBuffer commands, uint32_t units, const VkImageView* views,
                                 const VkSampler* samplers) {
  bool changed = (bound_.textures & units) != units;
  for (uint32_t left = units; left && !changed; left &= left - 1) {
    const int unit = std::countr_zero(left);
    changed = views[unit] != bound_.views[unit] || samplers[unit] != bound_.samplers[unit];
  }
  if (!changed) return true;
  const bool push = device_.features().pushDescriptors;
  const VkDescriptorSet set = push ? VkDescriptorSet{} : commands_.allocateTextureSet();
  if (!push && !set) return false;
  VkDescriptorImageInfo images[gen::kMaxTextureUnits];
  VkWriteDescriptorSet writes[gen::kMaxTextureUnits];
  uint32_t count = 0;
  for (uint32_t left = units; left; left &= left - 1) {
    const int unit = std::countr_zero(left);
    images[count] = {samplers[unit], views[unit], VK_IMAGE_LAYOUT_GENERAL};
    VkWriteDescriptorSet& write = writes[count];
    write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = static_cast<uint32_t>(unit);
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = &images[count++];
    bound_.views[unit] = views[unit];
    bound_.samplers[unit] = samplers[unit];
  }
  const auto& fn = device_.fn();
  if (push) {
    fn.vkCmdPushDescriptorSetKHR(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, device_.pipelineLayout(), 1,
                                 count, writes);
    bound_.textures |= units;
  } else {
    for (uint32_t unit = 0; device_.quirks().readsUnusedBindings && unit < gen::kMaxTextureUnits; ++unit) {
      if (units >> unit & 1) continue;
      writes[count] = writes[0];
      writes[count++].dstBinding = unit;
    }
    fn.vkUpdateDescriptorSets(device_.handle(), count, writes, 0, nullptr);
    fn.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, device_.pipelineLayout(), 1, 1,
                               &set, 0, nullptr);
    bound_.textures = units;
  }
  return true;
}

void VulkanContext::record(VkCommandBuffer commands, const Geometry& g) {
  const auto& fn = device_.fn();
  if (!g.indexed) {
    const bool nine = g.count / 3 == 3 && wanted_.fixed.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    const uint32_t apart = nine && device_.quirks().losesNineVertices ? 3 : 0;
    if (apart) fn.vkCmdDraw(commands, 6, 1, g.first, 0);
    fn.vkCmdDraw(commands, apart ? apart : g.count, 1, g.first + (apart ? 6 : 0), 0);
    return;
  }
  if (g.indexBuffer != bound_.indexBuffer || g.indexOffset != bound_.indexOffset ||
      g.indexType != bound_.indexType) {
    fn.vkCmdBindIndexBuffer(commands, g.indexBuffer, g.indexOffset, g.indexType);
    bound_.indexBuffer = g.indexBuffer;
    bound_.indexOffset = g.indexOffset;
    bound_.indexType = g.indexType;
  }
  fn.vkCmdDrawIndexed(commands, g.count, 1, g.first, g.vertexOffset, 0);
}

}  // namespace anteroom::vulkan
