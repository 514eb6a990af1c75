// ANTEROOM_DEBUG=stats: what a context has done, in one line when it ends.
#pragma once

namespace anteroom::egl {

struct Context;

void logStats(const Context& context);

// Contexts that live until the process ends are logged then. Under the lock; the first call alone counts.
void logStatsAtExit();

}  // namespace anteroom::egl
