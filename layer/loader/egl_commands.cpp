// libEGL.so.1: every command is a jump through the table that libGLESv1_CM.so.1 hands out.
#include <dlfcn.h>

#include <cstdio>

#include "layer/loader/egl_table.h"

#define ANTEROOM_EXPORT __attribute__((visibility("default")))

// Weak: a libGLESv1_CM of somebody else gets a message of ours instead of the loader's.
extern "C" __attribute__((weak)) const anteroom::egl::CommandTable* glAnteroomEglTable();

namespace anteroom::egl {
namespace {

const char* pathOf(const void* address) {
  Dl_info info{};
  return dladdr(address, &info) != 0 && info.dli_fname != nullptr ? info.dli_fname : "?";
}

// Null, after a message, when the two files do not belong together.
const CommandTable* findTable() {
  const char* self = pathOf(reinterpret_cast<const void*>(&findTable));
  if (glAnteroomEglTable == nullptr) {
    std::fprintf(
        stderr,
        "anteroom: the libGLESv1_CM.so.1 that was loaded for %s is not Anteroom's. Put the directory of "
        "Anteroom's two libraries before the other one in LD_LIBRARY_PATH.\n",
        self);
    return nullptr;
  }
  const CommandTable* table = glAnteroomEglTable();
  if (table->version != kTableVersion || table->size != sizeof(CommandTable)) {
    std::fprintf(
        stderr,
        "anteroom: %s (interface %u) and %s (interface %u) are of different versions. Install both from "
        "the same build.\n",
        self, kTableVersion, pathOf(reinterpret_cast<const void*>(glAnteroomEglTable)), table->version);
    return nullptr;
  }
  return table;
}

const CommandTable* const table = findTable();

}  // namespace
}  // namespace anteroom::egl

// Without a table every command fails with its null result.
template <typename Result>
static Result failed() {
  return Result{};
}

#define ANTEROOM_JUMP(Result, name, parameters, arguments)                                   \
  ANTEROOM_EXPORT Result EGLAPIENTRY name parameters {                                       \
    const auto* table = anteroom::egl::table;                                                \
    return __builtin_expect(table != nullptr, 1) ? table->name arguments : failed<Result>(); \
  }
extern "C" {
ANTEROOM_EGL_COMMANDS(ANTEROOM_JUMP)
}
