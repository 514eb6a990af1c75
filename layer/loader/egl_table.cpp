#include "layer/loader/egl_table.h"

#include "layer/egl/table.h"

extern "C" __attribute__((visibility("default"))) const anteroom::egl::CommandTable* glAnteroomEglTable() {
  return &anteroom::egl::kCommandTable;
}
