#include "tests/reference/reference_context.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <thread>

#include "tests/reference/fragment_operations.h"
#include "tests/reference/primitives.h"
#include "tests/reference/rasterisation.h"

namespace anteroom::reference {

using render::Attachment;
using render::Format;
using render::Framebuffer;

namespace {

StoredImage& stored(render::Image& image) {
  return static_cast<StoredImage&>(image);
}

// Calls work(fromRow, toRow) on interleaved bands of rows, a thread each; the order of fragments in a pixel
// is kept.
template <typename Work>
void overRows(int height, const Work& work) {
  constexpr int kBand = 8;
  const int threads = std::max(1, static_cast<int>(std::min(std::thread::hardware_concurrency(), 8u)));
  const auto bands = [&](int thread) {
    for (int row = thread * kBand; row < height; row += threads * kBand)
      work(row, std::min(row + kBand, height));
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(bands, i);
  bands(0);
  for (std::thread& thread : others) thread.join();
}

// The mean of a pixel's samples, as copies and reads see it: sRGB colors are encoded.
glm::dvec4 resolved(const Framebuffer& framebuffer, int x, int y) {
  const Attachment& at = framebuffer.readable();
  StoredImage& image = stored(*at.image);
  const int samples = image.desc().samples;
  glm::dvec4 sum(0);
  for (int s = 0; s < samples; ++s)
    sum += image.level(at.level).color[image.index(at.level, x, memoryRow(framebuffer, y), at.layer, s)];
  return encoded(image.desc().format, sum / double(samples));
}

// Calls `visit(index of the texel, index of its first sample)` for each pixel of a framebuffer whose samples
// belong to a level of a texture.
template <typename Visit>
void overSamples(const Framebuffer& framebuffer, const Visit& visit) {
  const Attachment& to = framebuffer.resolve;
  for (int y = 0; y < framebuffer.height; ++y)
    for (int x = 0; x < framebuffer.width; ++x)
      visit(stored(*to.image).index(to.level, x, y, to.layer),
            stored(*framebuffer.color.image).index(framebuffer.color.level, x, y, framebuffer.color.layer));
}

// EXT_multisampled_render_to_texture: all samples of a pixel have the texel's value, unless they made it.
void loadSamples(const Framebuffer& framebuffer) {
  const Attachment& from = framebuffer.resolve;
  if (!from.image) return;
  StoredImage& samples = stored(*framebuffer.color.image);
  StoredImage& texture = stored(*from.image);
  if (samples.follows == texture.contents(from.level, from.layer)) return;
  std::vector<glm::dvec4>& color = samples.level(framebuffer.color.level).color;
  overSamples(framebuffer, [&](size_t texel, size_t first) {
    std::fill_n(color.begin() + static_cast<std::ptrdiff_t>(first), framebuffer.samples,
                texture.level(from.level).color[texel]);
  });
}

// After every change of a color attachment.
void colorChanged(const Framebuffer& framebuffer) {
  if (framebuffer.color.image) ++stored(*framebuffer.color.image).version;
  const Attachment& to = framebuffer.resolve;
  if (!to.image) return;
  StoredImage& samples = stored(*framebuffer.color.image);
  StoredImage& texture = stored(*to.image);
  const std::vector<glm::dvec4>& color = samples.level(framebuffer.color.level).color;
  overSamples(framebuffer, [&](size_t texel, size_t first) {
    glm::dvec4 sum(0);
    for (size_t s = 0; s < static_cast<size_t>(framebuffer.samples); ++s) sum += color[first + s];
    texture.level(to.level).color[texel] = quantise(texture.desc().format, sum / double(framebuffer.samples));
  });
  ++texture.version;
  samples.follows = texture.contents(to.level, to.layer);
}

}  // namespace

bool ReferenceContext::draw(const render::State& state, gen::Groups, const render::DrawCall& call) {
  ++stats_.draws;
  const std::vector<int64_t> indices = elements(call);
  const VertexStage vertexStage(state);
  std::map<int64_t, Vertex> processed;
  for (int64_t index : indices)
    if (!processed.contains(index)) processed.emplace(index, vertexStage.process(index));

  const Rasteriser rasteriser(state);
  std::vector<WindowPrimitive> primitives;
  assemble(call.mode, indices.size(), [&](const std::vector<size_t>& positions) {
    std::vector<Vertex> vertices;
    for (size_t position : positions) vertices.push_back(processed.at(indices[position]));
    rasteriser.add(vertices, primitives);
  });
  if (primitives.empty()) return true;

  loadSamples(state.framebuffer);
  const FragmentStage fragmentStage(state);
  int firstRow = state.framebuffer.height, lastRow = -1;
  for (const WindowPrimitive& primitive : primitives) {
    firstRow = std::min(firstRow, primitive.firstRow);
    lastRow = std::max(lastRow, primitive.lastRow);
  }
  overRows(state.framebuffer.height, [&](int fromRow, int toRow) {
    if (toRow <= firstRow || fromRow > lastRow) return;
    for (const WindowPrimitive& primitive : primitives)
      rasteriser.rasterise(primitive, fromRow, toRow, [&](const Fragment& f) { fragmentStage.process(f); });
    quantiseColor(state.framebuffer, fromRow, toRow);
  });
  colorChanged(state.framebuffer);
  return true;
}

bool ReferenceContext::clear(const render::State& state, gen::Groups, GLbitfield mask) {
  const Framebuffer& framebuffer = state.framebuffer;
  render::Rect area{0, 0, framebuffer.width, framebuffer.height};
  if (state.scissorTest) {
    const int right =
        static_cast<int>(std::min<int64_t>(area.width, int64_t(state.scissor.x) + state.scissor.width));
    const int top =
        static_cast<int>(std::min<int64_t>(area.height, int64_t(state.scissor.y) + state.scissor.height));
    area.x = std::max(0, state.scissor.x);
    area.y = std::max(0, state.scissor.y);
    area.width = std::max(0, right - area.x);
    area.height = std::max(0, top - area.y);
  }
  const auto eachSample = [&](const Attachment& at, const auto& set) {
    StoredImage& image = stored(*at.image);
    for (int y = area.y; y < area.y + area.height; ++y)
      for (int x = area.x; x < area.x + area.width; ++x)
        for (int s = 0; s < image.desc().samples; ++s)
          set(image.level(at.level), image.index(at.level, x, memoryRow(framebuffer, y), at.layer, s));
  };
  if ((mask & GL_COLOR_BUFFER_BIT) != 0 && framebuffer.color.image != nullptr) {
    loadSamples(framebuffer);
    const glm::dvec4 color = quantise(framebuffer.color.image->desc().format, glm::dvec4(state.clear.color));
    eachSample(framebuffer.color, [&](Level& level, size_t i) {
      for (int c = 0; c < 4; ++c)
        if (state.ops.colorMask[static_cast<size_t>(c)]) level.color[i][c] = color[c];
    });
    colorChanged(framebuffer);
  }
  if ((mask & GL_DEPTH_BUFFER_BIT) != 0 && framebuffer.depth.image != nullptr && state.ops.depthMask) {
    const double z = quantiseDepth(framebuffer.depth.image->desc().format, double(state.clear.depth));
    eachSample(framebuffer.depth, [&](Level& level, size_t i) { level.z[i] = z; });
  }
  if ((mask & GL_STENCIL_BUFFER_BIT) != 0 && framebuffer.stencil.image != nullptr) {
    const uint32_t writeMask = state.ops.stencilWriteMask;
    eachSample(framebuffer.stencil, [&](Level& level, size_t i) {
      level.stencil[i] = static_cast<uint8_t>((level.stencil[i] & ~writeMask) |
                                              (static_cast<uint32_t>(state.clear.stencil) & writeMask));
    });
  }
  return true;
}

bool ReferenceContext::readPixels(const Framebuffer& framebuffer, const render::Rect& rect, Format format,
                                  void* out, size_t rowPitch) {
  for (int y = 0; y < rect.height; ++y) {
    for (int x = 0; x < rect.width; ++x) {
      const int64_t px = int64_t(rect.x) + x, py = int64_t(rect.y) + y;
      if (px < 0 || py < 0 || px >= framebuffer.width || py >= framebuffer.height) continue;
      std::byte* to = static_cast<std::byte*>(out) + static_cast<size_t>(y) * rowPitch +
                      static_cast<size_t>(x) * render::info(format).bytes;
      encode(format, resolved(framebuffer, static_cast<int>(px), static_cast<int>(py)), to);
    }
  }
  return true;
}

bool ReferenceContext::upload(render::Image& target, const render::Region& region, const void* data,
                              size_t rowPitch, size_t slicePitch) {
  StoredImage& image = stored(target);
  ++image.version;
  const Format format = image.desc().format;
  const size_t bytes = render::info(format).bytes;
  for (int z = 0; z < region.depth; ++z)
    for (int y = 0; y < region.height; ++y)
      for (int x = 0; x < region.width; ++x) {
        const std::byte* from = static_cast<const std::byte*>(data) + static_cast<size_t>(z) * slicePitch +
                                static_cast<size_t>(y) * rowPitch + static_cast<size_t>(x) * bytes;
        const size_t at = image.index(region.level, region.x + x, region.y + y, region.z + region.layer + z);
        image.level(region.level).color[at] = linear(format, decode(format, from));
      }
  stats_.bytesUploaded += static_cast<uint64_t>(region.width) * static_cast<uint64_t>(region.height) *
                          static_cast<uint64_t>(region.depth) * bytes;
  return true;
}

bool ReferenceContext::copyFromFramebuffer(render::Image& target, const render::Region& region,
                                           const Framebuffer& source, int x, int y) {
  StoredImage& image = stored(target);
  ++image.version;
  for (int j = 0; j < region.height; ++j)
    for (int i = 0; i < region.width; ++i) {
      const int64_t px = int64_t(x) + i, py = int64_t(y) + j;
      if (px < 0 || py < 0 || px >= source.width || py >= source.height) continue;
      const glm::dvec4 color = resolved(source, static_cast<int>(px), static_cast<int>(py));
      const size_t at = image.index(region.level, region.x + i, region.y + j, region.layer + region.z);
      image.level(region.level).color[at] = quantise(image.desc().format, linear(image.desc().format, color));
    }
  return true;
}

bool ReferenceContext::copyLevel(render::Image& target, int level, render::Image& source, int sourceLevel) {
  ++stored(target).version;
  stored(target).level(level) = stored(source).level(sourceLevel);
  return true;
}

bool ReferenceContext::generateMipmaps(render::Image& target) {
  StoredImage& image = stored(target);
  ++image.version;
  const bool volume = image.desc().dimension == render::Dimension::Volume;
  for (int i = 1; i < image.levelCount(); ++i) {
    const Level& from = image.level(i - 1);
    Level& to = image.level(i);
    for (int z = 0; z < to.depth; ++z)
      for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x) {
          // The texels of the larger level under this one: 2 by 2, or 1 where the level is no larger.
          glm::dvec4 sum(0);
          int count = 0;
          for (int dz = 0; dz < (volume ? 2 : 1); ++dz)
            for (int dy = 0; dy < 2; ++dy)
              for (int dx = 0; dx < 2; ++dx) {
                const int fx = std::min(2 * x + dx, from.width - 1),
                          fy = std::min(2 * y + dy, from.height - 1);
                const int fz = volume ? std::min(2 * z + dz, from.depth - 1) : z;
                sum += from.color[image.index(i - 1, fx, fy, fz)];
                ++count;
              }
          to.color[image.index(i, x, y, z)] = quantise(image.desc().format, sum / double(count));
        }
  }
  return true;
}

}  // namespace anteroom::reference
