// Texture environments as combiners, and their reduction to what the picture depends on.
#pragma once

#include "gen/key.h"

namespace anteroom::gen {

// Number of arguments that a function reads.
constexpr int argumentCount(Function function) {
  constexpr int kCounts[] = {0, 1, 2, 2, 2, 3, 2, 2, 3, 3, 3};
  return kCounts[static_cast<int>(function)];
}

constexpr bool readsAlpha(Operand operand) {
  return operand == Operand::Alpha || operand == Operand::OneMinusAlpha;
}
constexpr bool complements(Operand operand) {
  return operand == Operand::OneMinusColor || operand == Operand::OneMinusAlpha;
}

// The unit that a source samples, or -1.
constexpr int sampledUnit(Source source) {
  if (source < Source::Texture0 || source > Source::TextureLast) return -1;
  return static_cast<int>(source) - static_cast<int>(Source::Texture0);
}

// The unit whose result a source is, or -1.
constexpr int outputUnit(Source source) {
  return source < Source::Output0 ? -1 : static_cast<int>(source) - static_cast<int>(Source::Output0);
}

// Calls visit(argument) for every argument that the unit's combiners read.
template <class Visit>
void forEachArgument(const FragmentUnit& unit, Visit visit) {
  for (const Combiner* combiner : {&unit.rgb, &unit.alpha})
    for (int i = 0; i < argumentCount(combiner->function); ++i) visit(combiner->arguments[i]);
}

// Section 3.7.12 for one unit: its environment as two combiners; both Keep for a unit that is off.
void translateEnvironment(const State& state, int unit, FragmentUnit& out);

// Removes everything that cannot be seen: constant arguments, functions that change nothing, results that
// later units replace. A fixed point: reducing twice is reducing once.
void reduceCombiners(std::array<FragmentUnit, kMaxTextureUnits>& units);

// Bit u set: some combiner reads the texture of unit u.
uint32_t texturesRead(const std::array<FragmentUnit, kMaxTextureUnits>& units);

// Whether some combiner reads the source.
bool reads(const std::array<FragmentUnit, kMaxTextureUnits>& units, Source source);

// Whether the primary color is read, or reaches the end.
bool readsPrimaryColor(const std::array<FragmentUnit, kMaxTextureUnits>& units);

}  // namespace anteroom::gen
