// EXT_debug_marker: groups and points in the stream of commands. They go on to the device, for tools that
// look there.
#include "layer/gl/debug/debug_output.h"

using namespace anteroom::gl;

namespace {

// A length of 0 means that there is a null at the end.
std::string_view textOfMarker(GLsizei length, const GLchar* marker) {
  return textOf(marker, length == 0 ? -1 : length);
}

}  // namespace

GL_API void GL_APIENTRY glInsertEventMarkerEXT(GLsizei length, const GLchar* marker) {
  if (Context* c = current()) c->renderer->mark(textOfMarker(length, marker));
}
GL_API void GL_APIENTRY glPushGroupMarkerEXT(GLsizei length, const GLchar* marker) {
  if (Context* c = current()) c->renderer->pushGroup(textOfMarker(length, marker));
}
GL_API void GL_APIENTRY glPopGroupMarkerEXT(void) {
  if (Context* c = current()) c->renderer->popGroup();
}
