// What a libGLESv1_CM of a later version would hand out.
static const struct { unsigned version, size; } table = {999, sizeof(table)};

const void* glAnteroomEglTable(void) {
  return &table;
}
