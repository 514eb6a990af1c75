// What is drawn and compared: small pictures, each of one subject of the specification. A scene sees only the
// EGL and GLES headers.
#pragma once

#include <string>
#include <vector>

namespace comparison {

// The pbuffer of a scene; the colour sizes are those of an exact config.
struct Surface {
  int width = 64, height = 64;
  int samples = 0;
  bool rgb565 = false;
};

// Where a driver may be less exact than a step: tests/driver measures how much.
enum class Driver { kExact, kFilter, kLevelOfDetail, kBlend, kLine, kSmoothLine };

struct Scene {
  std::string name;     // "subject/what"
  std::string section;  // of the specification: what it exercises
  void (*draw)();       // in a fresh context, everything cleared, modelview current
  Surface surface = {};
  int blendedPasses = 0;  // 8-bit roundings that add up
  Driver driver = Driver::kExact;
  std::string mesaDiffers = {};  // the section that decides, and how Mesa departs; empty: it agrees
  double coordinateUlp = 0;      // what float32 tells apart at the texture coordinates, where that is coarse
  // Why ours is further from the reference than the bound: a deviation that is known, printed and not
  // counted.
  std::string deviates = {};
  bool extreme = false;  // of the stiff and extreme ones
};

using Scenes = std::vector<Scene>;

void addLightingScenes(Scenes& scenes);
void addTextureScenes(Scenes& scenes);
void addFragmentScenes(Scenes& scenes);
void addPrimitiveScenes(Scenes& scenes);
void addPaletteScenes(Scenes& scenes);
void addMatrixExtremes(Scenes& scenes);
void addLightingExtremes(Scenes& scenes);
void addTextureExtremes(Scenes& scenes);
void addVertexExtremes(Scenes& scenes);
void addPaletteExtremes(Scenes& scenes);

// All of them, in the order of the table.
const Scenes& allScenes();

}  // namespace comparison
