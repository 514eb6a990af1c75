// KHR_debug: the messages of a context, which of them are wanted, and groups.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "layer/gl/context/context.h"

namespace anteroom::gl {

inline constexpr int kMostMessageLength = 1024;  // with the null at its end
inline constexpr int kMostLoggedMessages = 256;
inline constexpr int kDebugGroupDepth = 64;  // with the default group
inline constexpr int kMostLabelLength = 256;

// Ids of DEBUG_SOURCE_API_KHR. Errors have the number of their code.
enum MessageId : GLuint { kSlowCommand = 1 };

struct DebugMessage {
  GLenum source = 0, type = 0;
  GLuint id = 0;
  GLenum severity = 0;
  std::string text;
};

class DebugOutput final : public render::Listener {
 public:
  // A filter of DebugMessageControl; without an id, it concerns all.
  struct Filter {
    GLenum source = GL_DONT_CARE, type = GL_DONT_CARE, severity = GL_DONT_CARE;
    bool hasId = false;
    GLuint id = 0;
    bool covers(const Filter& other) const;
    bool matches(const DebugMessage& message) const;
  };

  DebugOutput() : groups_(1) {}

  // Hands a message on, if it is wanted. The caller has looked whether DEBUG_OUTPUT is enabled.
  void message(DebugMessage message);
  void error(GLenum code, const Fault& fault, const char* command);
  void slow(std::string_view what) override;

  void control(const Filter& filter, bool enabled);
  // May throw std::bad_alloc.
  void push(DebugMessage message);
  DebugMessage pop();
  int depth() const { return static_cast<int>(groups_.size()); }

  GLDEBUGPROCKHR callback = nullptr;
  const void* userParam = nullptr;
  std::deque<DebugMessage> log;

 private:
  struct Rule {
    Filter filter;
    bool enabled;
  };
  struct Group {
    DebugMessage message;
    std::vector<Rule> rules;  // the last one that matches decides
  };
  bool wanted(const DebugMessage& message) const;

  std::vector<Group> groups_;  // the first is the default group
};

// "glLineWidth: GL_INVALID_VALUE: width is -1. Give a width above 0." May throw std::bad_alloc.
std::string describeError(GLenum code, const Fault& fault, const char* command);
void logError(GLenum code, const Fault& fault, const char* command);

// Tells the renderer whether anybody listens: after debugOutput changed.
void updateListener(Context& c);

// The characters of a string that has `length`, or a null at its end where that is negative.
std::string_view textOf(const GLchar* text, GLsizei length);

}  // namespace anteroom::gl
