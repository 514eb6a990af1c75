// The whole road of a fragment, 2.12 to 4.2.2: random states against the evaluators of the single chapters
// chained. States that are set but have no effect are part of it: disabled lights, units, fog, tests keep
// their settings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "environment_reference.h"
#include "fragment_reference.h"
#include "harness.h"
#include "lighting_reference.h"

namespace conformance {
namespace {

class Pipeline : public GlTest {};

class RandomState {
 public:
  explicit RandomState(unsigned seed) : random_(seed) {}

  double unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  bool coin() { return random_() % 2; }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  Vec4 color() { return {unit(), unit(), unit(), unit()}; }
  // A colour that 8 bits hold exactly.
  Texel texel() {
    return {static_cast<std::uint8_t>(below(256)), static_cast<std::uint8_t>(below(256)),
            static_cast<std::uint8_t>(below(256)), static_cast<std::uint8_t>(below(256))};
  }
  template <class List>
  auto pick(const List& list) {
    return list[random_() % std::size(list)];
  }

 private:
  std::mt19937 random_;
};

std::array<GLfloat, 4> floats(const Vec4& v) {
  return {static_cast<GLfloat>(v[0]), static_cast<GLfloat>(v[1]), static_cast<GLfloat>(v[2]),
          static_cast<GLfloat>(v[3])};
}

void setSwitch(GLenum name, bool on) {
  (on ? glEnable : glDisable)(name);
}

// 2.12: the current colour, or what the lights make of it.
Vec4 vertexColor(RandomState& random) {
  const Vec4 current = random.color();
  std::vector<LightParameters> lights(static_cast<std::size_t>(random.below(4)));
  for (LightParameters& light : lights) {
    for (Vec4* c : {&light.ambient, &light.diffuse, &light.specular}) *c = random.color();
    light.position = {random.unit() - 0.5, random.unit() - 0.5, 0.5 + random.unit(),
                      random.coin() ? 1.0 : 0.0};
    light.constantAttenuation = 0.5 + random.unit();
    light.linearAttenuation = random.unit();
    if (light.position[3] != 0 && random.coin()) {
      light.spotCutoff = 60;
      light.spotExponent = random.below(5);
    }
  }
  MaterialParameters material;
  for (Vec4* c : {&material.ambient, &material.diffuse, &material.specular}) *c = random.color();
  material.shininess = random.below(20);
  const Vec4 scene = random.color();
  glDisable(GL_COLOR_MATERIAL);
  applyLights(lights);
  applyMaterial(material);
  applySceneAmbient(scene);
  const bool lit = random.coin(), tracked = random.coin();
  setSwitch(GL_LIGHTING, lit);
  setSwitch(GL_COLOR_MATERIAL, tracked);
  glColor4f(floats(current)[0], floats(current)[1], floats(current)[2], floats(current)[3]);
  if (!lit) return current;
  if (tracked) material.ambient = material.diffuse = current;
  return litColor(material, scene, lights, {0, 0, 0, 1}, {0, 0, 1});
}

Combiner randomCombiner(RandomState& random) {
  constexpr GLenum functions[] = {GL_REPLACE,    GL_MODULATE,    GL_ADD,
                                  GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT};
  constexpr GLenum sources[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
  constexpr GLenum operands[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
  constexpr double scales[] = {1, 2, 4};
  Combiner c;
  for (int half = 0; half < 2; ++half) {
    c.function[half] = half == 0 && random.below(6) == 0 ? GLenum{GL_DOT3_RGB} : random.pick(functions);
    for (int slot = 0; slot < 3; ++slot) {
      c.source[half][slot] = random.pick(sources);
      c.operand[half][slot] = operands[half == 0 ? random.below(4) : 2 + random.below(2)];
    }
    c.scale[half] = random.pick(scales);
  }
  return c;
}

// 3.7.12, 3.7.13 over up to four units, some disabled.
Vec4 textured(RandomState& random, const Vec4& primary, std::vector<GLuint>& names) {
  constexpr GLenum formats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA};
  constexpr GLenum modes[] = {GL_REPLACE, GL_MODULATE, GL_BLEND, GL_ADD, GL_DECAL, GL_COMBINE};
  Vec4 previous = primary;
  for (GLenum unit = 0; unit < 4; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    const bool on = random.below(3) != 0;
    setSwitch(GL_TEXTURE_2D, on);
    const GLenum mode = random.pick(modes);
    const GLenum format = mode == GL_DECAL ? GLenum{GL_RGBA} : random.pick(formats);
    const Texel texel = random.texel();
    const Vec4 constant = random.color();
    const Combiner combiner = randomCombiner(random);
    names.push_back(solidTexture(format, texel));
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, floats(constant).data());
    apply(combiner);
    setEnvironment(GL_TEXTURE_ENV_MODE, mode);
    if (!on) continue;
    const Vec4 source = sourceColor(format, texel);
    previous = mode == GL_COMBINE ? combine(combiner, {source, constant, primary, previous})
                                  : environment(mode, format, previous, source, constant);
  }
  glActiveTexture(GL_TEXTURE0);
  return previous;
}

// 3.8 at an eye distance of 1.
Vec4 fogged(RandomState& random, const Vec4& color) {
  const Vec4 fog = random.color();
  constexpr GLenum modes[] = {GL_LINEAR, GL_EXP, GL_EXP2};
  const GLenum mode = random.pick(modes);
  const double density = random.unit() * 2, end = 1.2 + random.unit() * 3;
  glFogfv(GL_FOG_COLOR, floats(fog).data());
  glFogf(GL_FOG_MODE, static_cast<GLfloat>(mode));
  glFogf(GL_FOG_DENSITY, static_cast<GLfloat>(density));
  glFogf(GL_FOG_START, 0.5f);
  glFogf(GL_FOG_END, static_cast<GLfloat>(end));
  const bool on = random.coin();
  setSwitch(GL_FOG, on);
  if (!on) return color;
  const double f = mode == GL_LINEAR ? (end - 1) / (end - 0.5)
                   : mode == GL_EXP  ? std::exp(-density)
                                     : std::exp(-density * density);
  Vec4 result = color;
  for (std::size_t i = 0; i < 3; ++i) result[i] = f * color[i] + (1 - f) * fog[i];
  return result;
}

struct Outcome {
  Vec4 pixel;
  double tolerance = kOneStep;
  // The alpha test may fall either way within the error of the alpha.
  bool decided = true;
};

// 4.1.4, 4.1.7, 4.2.2
Outcome written(RandomState& random, const Vec4& fragment, const Vec4& stored) {
  const GLenum function = random.pick(kComparisons), sourceFactor = random.pick(kSourceFactors);
  const GLenum destinationFactor = random.pick(kDestinationFactors);
  const int reference = random.below(256);
  const bool test = random.coin(), blend = random.coin();
  const int mask = random.below(4) == 0 ? random.below(16) : 15;
  glAlphaFunc(function, static_cast<GLfloat>(reference) / 255);
  glBlendFunc(sourceFactor, destinationFactor);
  glColorMask(mask & 1 ? 1 : 0, mask & 2 ? 1 : 0, mask & 4 ? 1 : 0, mask & 8 ? 1 : 0);
  setSwitch(GL_ALPHA_TEST, test);
  setSwitch(GL_BLEND, blend);
  if (test) {
    const double alpha = fragment[3] * 255;
    if (std::abs(alpha - reference) < 1) return {stored, kOneStep, false};
    if (!compare(function, alpha, reference)) return {stored};
  }
  Vec4 color = fragment;
  if (blend) {
    const Vec4 fs = blendFactor(sourceFactor, fragment, stored),
               fd = blendFactor(destinationFactor, fragment, stored);
    for (std::size_t i = 0; i < 4; ++i) color[i] = fragment[i] * fs[i] + stored[i] * fd[i];
  }
  Vec4 pixel = stored;
  for (std::size_t i = 0; i < 4; ++i) {
    if (mask >> i & 1) pixel[i] = std::clamp(color[i], 0.0, 1.0);
  }
  return {pixel, blend ? std::max(kOneStep, driverError("blending")) : kOneStep};
}

TEST_F(Pipeline, RandomStates) {
  Cells cells;
  glNormal3f(0, 0, 1);
  glMatrixMode(GL_PROJECTION);
  // Vertices within 10^-6 of the eye's axis for the lights, one unit away for the fog.
  glScalef(1e6f, 1e6f, 0);
  glMatrixMode(GL_MODELVIEW);
  int undecided = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomState random(seed);
    std::vector<GLuint> names;
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (GLenum name : {GL_ALPHA_TEST, GL_BLEND, GL_FOG, GL_LIGHTING}) glDisable(static_cast<GLenum>(name));
    for (GLenum unit = 4; unit-- > 0;) {
      glActiveTexture(GL_TEXTURE0 + unit);
      glDisable(GL_TEXTURE_2D);
    }
    const Texel background = random.texel();
    // The lights' positions are given for a vertex at the origin; the quad is moved to z = -1 with them.
    glLoadIdentity();
    glTranslatef(0, 0, -1);
    Outcome outcome;
    const Vec4 stored = sourceColor(GL_RGBA, background);
    cells.add(fmt::format("seed {}", seed), stored, [&] {
      glColor4ub(background[0], background[1], background[2], background[3]);
      drawRect({-1e-6, -1e-6, 1e-6, 1e-6});
      const Vec4 color = clamp01(vertexColor(random));
      outcome = written(random, fogged(random, textured(random, color, names)), stored);
      // Mesa does not clamp a lit colour before texturing (see Lighting.LitColorIsClampedBeforeTexturing).
      if (onMesa() && *std::max_element(color.begin(), color.begin() + 3) == 1) outcome = {stored, 0, false};
      if (outcome.decided) {
        drawRect({-1e-6, -1e-6, 1e-6, 1e-6});
      } else {
        ++undecided;
      }
    });
    cells.expectLast(outcome.pixel, outcome.tolerance);
    glDeleteTextures(static_cast<GLsizei>(names.size()), names.data());
  }
  EXPECT_LT(undecided, onMesa() ? 100 : 20);
}

}  // namespace
}  // namespace conformance
