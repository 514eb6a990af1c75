// Renders scenes on whichever libEGL.so.1 this process found.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace comparison {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // lower left row first
};

// All geometry moved by so many pixels; the first is where it belongs. One unit of Vulkan's 8 sub-pixel bits
// in each direction: what the edges of a primitive may move through rounding of its vertices.
struct Shift {
  double x, y;
};
inline constexpr Shift kShifts[] = {{0, 0},
                                    {1.0 / 256, 1.0 / 256},
                                    {-1.0 / 256, 1.0 / 256},
                                    {1.0 / 256, -1.0 / 256},
                                    {-1.0 / 256, -1.0 / 256}};
inline constexpr int kShiftCount = 5;

struct WorkerTask {
  std::string directory;            // where pictures go
  std::vector<std::string> scenes;  // their names
  int shifts = 1;                   // how many of kShifts
  int repeats = 1;                  // of the first shift; the last one is timed
};

// Writes a file a picture, and to standard output two lines a scene, words apart by tabs: "begin NAME", then
// "done NAME MILLISECONDS" or "skip NAME REASON".
void work(const WorkerTask& task);

std::string pictureFile(const std::string& directory, const std::string& scene, int shift);
// An empty picture when the file is not there or broken.
Picture readPicture(const std::string& file);

}  // namespace comparison
