// Section 3.11: addresses of commands; and the table of them.
#include <string_view>

#include "layer/egl/commands.h"
#include "layer/egl/errors.h"
#include "layer/egl/table.h"
#include "layer/gl/front_end.h"

namespace anteroom::egl {
namespace {

using Proc = __eglMustCastToProperFunctionPointerType;

struct NamedProc {
  std::string_view name;
  Proc address;
};

const NamedProc kProcs[] = {
#define ANTEROOM_PROC(Result, name, parameters, arguments) {#name, reinterpret_cast<Proc>(&::name)},
#define ANTEROOM_EXTENSION_PROC(name) {#name, reinterpret_cast<Proc>(&::name)},
    ANTEROOM_EGL_COMMANDS(ANTEROOM_PROC) ANTEROOM_EGL_EXTENSION_COMMANDS(ANTEROOM_EXTENSION_PROC)
#undef ANTEROOM_PROC
#undef ANTEROOM_EXTENSION_PROC
};

}  // namespace

const CommandTable kCommandTable = {kTableVersion, sizeof(CommandTable),
#define ANTEROOM_ADDRESS(Result, name, parameters, arguments) &::name,
                                    ANTEROOM_EGL_COMMANDS(ANTEROOM_ADDRESS)
#undef ANTEROOM_ADDRESS
};

}  // namespace anteroom::egl

using namespace anteroom;
using namespace anteroom::egl;

__eglMustCastToProperFunctionPointerType EGLAPIENTRY eglGetProcAddress(const char* procname) {
  setError(EGL_SUCCESS);
  if (procname == nullptr) return nullptr;
  const std::string_view name(procname);
  for (const NamedProc& proc : kProcs) {
    if (proc.name == name) return proc.address;
  }
  return gl::procAddress(name);
}
