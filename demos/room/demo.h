// What a demo offers to the program that runs it.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace room {

struct View {
  int width = 0;    // pixels
  int height = 0;   // pixels
  double time = 0;  // seconds
  // How the demo's own camera is moved about what it looks at (transform.h: orbited).
  double yaw = 0;   // radians, to the right
  double zoom = 1;  // of its distance
  // The picture depends on nothing else but the stage.
};

// What the command line can change about single demos.
struct Settings {
  int particles = 5000;  // particles: how many
  bool quads = false;    // particles: drawn as quads made by the program, instead of points
  // water: "waves", sines and cosines, or "springs", a sheet of masses that drops fall on
  std::string water = "waves";
  std::string integrator = "semi-implicit";  // water, springs: "explicit", "semi-implicit" or "implicit"
  double stiffness = 180;                    // water, springs: over a mass, 1/s^2
  bool culled = false;                       // reflect: tells over the picture what each face leaves out
  // skinning: who adds up a vertex's bones, the GL's matrix "palette", the program ("cpu"), or "any": the
  // palette where there is one
  std::string skin = "any";
};

class Demo {
 public:
  virtual ~Demo() = default;
  // Once, before setup(); no context is needed.
  virtual void configure(const Settings&) {}
  // What --stage accepts; the last one is the finished picture. The names live as long as the program.
  virtual std::span<const std::string_view> stages() const = 0;
  // Makes textures and meshes. A context is current, here and whenever anything else of the demo runs.
  virtual void setup() = 0;
  // Draws one frame into the current surface; stage is one of stages().
  virtual void frame(const View& view, std::string_view stage) = 0;
};

struct DemoEntry {
  std::string_view name;
  std::string_view summary;
  std::function<std::unique_ptr<Demo>()> make;
};

}  // namespace room
