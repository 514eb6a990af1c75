/* The names that programs are linked to. At run time libGLESv1_CM.so.1 is libanteroom.so.0. */
#define ANTEROOM_COMMAND(name) \
  void name(void);             \
  void name(void) {}
#include "registry/commands.inc"
ANTEROOM_COMMAND(glAnteroomEglTable)
