// State in, SPIR-V out: the interface of the generator. Everything here is pure: no Vulkan object, no GL
// context, no global but glslang's own tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gen/key.h"
#include "gen/profile.h"
#include "gen/state.h"

namespace anteroom::gen {

// The groups that can change a key. A change in any other group leaves both keys as they are.
Groups keyGroups();

// Reduces the state to the least that its picture depends on. The fragment key is made first; what it does
// not read, the vertex shader does not write.
FragmentKey canonicaliseFragment(const State& state, const Profile& profile);
// Where the color comes from while there is no array of colors: the state has one for all vertices, or each
// brings four floats.
enum class CurrentColor : uint8_t { OfState, OfVertices };
VertexKey canonicaliseVertex(const State& state, const FragmentKey& fragment, const Profile& profile,
                             CurrentColor color = CurrentColor::OfState);

// One line in words, and back. parse* return false, and leave `key` alone, when the text describes no valid
// key.
std::string describe(const VertexKey& key);
std::string describe(const FragmentKey& key);
bool parse(const std::string& text, VertexKey& key);
bool parse(const std::string& text, FragmentKey& key);

// Whether bytes from outside are a key that canonicalise could have made: every field in range, no dead
// state.
bool valid(const VertexKey& key);
bool valid(const FragmentKey& key);

uint64_t hash(const VertexKey& key);
uint64_t hash(const FragmentKey& key);

// GLSL 4.50 for Vulkan: a function of the key alone, so that a key means the same shader everywhere.
std::string emitVertex(const VertexKey& key);
std::string emitFragment(const FragmentKey& key);

enum class Stage : uint8_t { Vertex, Fragment };

struct CompileResult {
  std::vector<uint32_t> spirv;  // empty: the compile failed
  std::string log;
};
// glslang. Thread-safe. The first call in a process builds glslang's tables (about 75 ms): warmCompiler()
// does that ahead of time, on any thread.
CompileResult compile(Stage stage, const std::string& glsl);
void warmCompiler();

// What a pipeline must bind.
// Set 0, binding 0: the vertex constants. Set 1, binding u: the texture of unit u, only the units that the
// fragment key samples. Set 2, binding 0: the fragment constants. Constants are uniform buffers with dynamic
// offsets, each in a set of its own: drivers that look at sets stage by stage leave the other stage alone
// when one changes. Set 3, binding 0: the matrix palette, vertex stage, a uniform buffer like set 0's. Push
// constants: vertex stage only, from byte 0.

// Images: a sampled texel has 0 for a color and 1 for an alpha that its base format has not (table 3.9):
// ALPHA reads as (0, 0, 0, A), LUMINANCE as (L, L, L, 1), LUMINANCE_ALPHA as (L, L, L, A), RGB as (R, G, B,
// 1). TextureEnv::lodBias is the sampler's.
//
// Attributes: FLOAT as it is; unsigned bytes of colors as UNORM; FIXED, and other BYTE and SHORT, as SINT,
// converted by the shader. Components that an array has not are filled as Vulkan does (0, 0, 0, 1), except
// that the shader does not read the fourth of an integer format that has only three.
//
// Points: gl_PointSize is written whenever the primitive is points. Smooth ones are rasterised a pixel wider
// than they are, so the largest smooth size that a context offers is the device's less 1.

// Bit `a` set: the shader reads array attribute a from vertex input location a. An attribute that is not an
// array comes from constants.
uint32_t attributesRead(const VertexKey& key);
// Whether its location is declared as float, signed or unsigned integers in the shader.
enum class InputClass : uint8_t { Float, Int, Uint };
InputClass inputClass(const VertexKey& key, Attribute attribute);

// Where a key has ownValues, each vertex also brings the bytes of packPush(), 16 of them a location, as four
// floats, from this location on, and nothing is pushed.
inline constexpr uint32_t kOwnValuesLocation = 16;
inline constexpr uint32_t kMostOwnValues = 8;  // locations

// Bit u set: unit u is sampled.
uint32_t unitsSampled(const FragmentKey& key);

// Constants: sizes in bytes (0: the block does not exist) and the groups whose change makes a block stale.
struct Blocks {
  uint32_t pushSize = 0;
  uint32_t vertexSize = 0;
  uint32_t fragmentSize = 0;
  uint32_t paletteSize = 0;
  Groups pushGroups = 0;
  Groups vertexGroups = 0;
  Groups fragmentGroups = 0;
  Groups paletteGroups = 0;
};
Blocks blocks(const VertexKey& vertex, const FragmentKey& fragment);

// Write exactly the sizes above. No allocation. Matrix products are made in float64 and rounded once. The
// clip coordinates that the vertex shader writes have Vulkan's depth range, 0 <= z <= w; y is not flipped.
void packPush(const VertexKey& key, const State& state, std::byte* out);
void packVertex(const VertexKey& key, const State& state, std::byte* out);
void packFragment(const FragmentKey& key, const State& state, std::byte* out);
void packPalette(const VertexKey& key, const State& state, std::byte* out);

}  // namespace anteroom::gen
