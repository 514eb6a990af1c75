// EXT_debug_marker. Markers are for tools that see the commands themselves: the layer keeps none.
#include <GLES/gl.h>
#include <GLES/glext.h>

GL_API void GL_APIENTRY glInsertEventMarkerEXT(GLsizei, const GLchar*) {}
GL_API void GL_APIENTRY glPushGroupMarkerEXT(GLsizei, const GLchar*) {}
GL_API void GL_APIENTRY glPopGroupMarkerEXT(void) {}
