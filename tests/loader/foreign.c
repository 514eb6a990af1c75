// A libGLESv1_CM of somebody else.
void glFinish(void) {}
