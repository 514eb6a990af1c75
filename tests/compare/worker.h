// Renders scenes on whichever libEGL.so.1 this process found.
#pragma once

#include <string>
#include <vector>

#include "scene.h"

namespace comparison {

// How a picture of the reference is varied, to see what rounding may make of it. The first variant of every
// scene changes nothing.
struct Variant {
  double x = 0, y = 0;  // all geometry moved by so many pixels
  double scale = 1;     // texture coordinates multiplied
  double s = 0, t = 0;  // and moved
};

// Geometry moves by one unit of Vulkan's 8 sub-pixel bits in each direction: what the edges of a primitive
// may move through rounding of its vertices. The level of detail moves by `lodError`, the driver's measured
// one, and texture coordinates by one unit in float32's last place, where the scene names these.
std::vector<Variant> variants(const Scene& scene, double lodError);

struct WorkerTask {
  std::string directory;            // where pictures go
  std::vector<std::string> scenes;  // their names
  bool varied = false;              // all variants, else the first alone
  double lodError = 0;
  int repeats = 1;  // of the first variant; the last one is timed
};

// Writes a file a picture, and to standard output two lines a scene, words apart by tabs: "begin NAME", then
// "done NAME MILLISECONDS" or "skip NAME REASON".
void work(const WorkerTask& task);

std::string pictureFile(const std::string& directory, const std::string& scene, int variant);
}  // namespace comparison
