#include "layer/egl/context_stats.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include "layer/egl/context.h"
#include "layer/egl/display.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {

void logStats(const Context& context) {
  constexpr double kMega = 1 << 20;
  const render::Stats& is = gl::rendererOf(*context.gl).stats();
  std::fprintf(stderr,
               "anteroom: context %p: %" PRIu64 " frames, %" PRIu64 " draws, %" PRIu64 " passes, %" PRIu64
               " submissions, %" PRIu64 " pipelines, %" PRIu64 " shaders compiled, %" PRIu64
               " from the cache, %.1f MiB uploaded, %.1f MiB of device memory\n",
               context.handle, context.frames, is.draws, is.renderPasses, is.submits, is.pipelinesCreated,
               is.shadersCompiled, is.shadersFromCache, static_cast<double>(is.bytesUploaded) / kMega,
               static_cast<double>(is.memoryBytes) / kMega);
}

void logStatsAtExit() {
  static bool once = false;
  if (once) return;
  once = true;
  std::atexit([] {
    const Lock lock(mutex());
    forEachContext([](Context& context) { logStats(context); });
  });
}

}  // namespace anteroom::egl
