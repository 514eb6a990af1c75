// Labels for tools that look at the device, when ANTEROOM_DEBUG=markers asks for them: names of objects,
// and groups in the stream of commands that say which command of GL made them.
#pragma once

#include <string>

#include "layer/gl/context/context.h"

namespace anteroom::gl {

// "brick (texture 5)", or "texture 5" without a label.
std::string nameOf(const char* kind, GLuint name, const std::string& label);

// Hands the name on, or the label alone where names are not wanted.
void nameImage(const Context& c, render::Image& image, const char* kind, GLuint name,
               const std::string& label);

// The group of one command while this lives. Made only where c.groupsCommands says so.
class CommandGroup {
 public:
  // "glDrawArrays(GL_TRIANGLES, 0, 36): texture0 brick (texture 5); position in buffer 3; framebuffer 2".
  CommandGroup(Context& c, const char* command, const render::DrawCall& call);
  // "glClear(GL_COLOR_BUFFER_BIT)".
  CommandGroup(Context& c, const char* command, GLbitfield mask);
  ~CommandGroup();
  CommandGroup(const CommandGroup&) = delete;
  CommandGroup& operator=(const CommandGroup&) = delete;

 private:
  void open(const std::string& text);

  render::Context& renderer_;
  bool open_ = false;
};

}  // namespace anteroom::gl
