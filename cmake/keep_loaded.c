/* Linked into every program of a sanitizer build: a driver that has been unloaded cannot be named in a
   report, and so neither be told from us nor be suppressed. */
__attribute__((visibility("default"))) int dlclose(void* handle) {
  (void)handle;
  return 0;
}
