#include "window.h"

namespace program {

void show(const room::DemoEntry&, const Options&) {
  throw UsageError(
      "--window: this program was built without GLFW. Install libglfw3-dev, run cmake on the build folder "
      "again and build again; without --window pictures go to files");
}

}  // namespace program
