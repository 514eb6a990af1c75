#include "layer/gl/debug/debug_output.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <new>

#include "layer/gl/debug/enum_names.h"

namespace anteroom::gl {
namespace {

// Numbers that are one of a few names.
template <size_t N>
bool contains(const std::array<GLenum, N>& names, GLenum name) {
  return std::ranges::find(names, name) != names.end();
}

// Tables 5.3 to 5.5.
constexpr std::array<GLenum, 6> kSources = {
    GL_DEBUG_SOURCE_API_KHR,         GL_DEBUG_SOURCE_WINDOW_SYSTEM_KHR, GL_DEBUG_SOURCE_SHADER_COMPILER_KHR,
    GL_DEBUG_SOURCE_THIRD_PARTY_KHR, GL_DEBUG_SOURCE_APPLICATION_KHR,   GL_DEBUG_SOURCE_OTHER_KHR};
constexpr std::array<GLenum, 9> kTypes = {GL_DEBUG_TYPE_ERROR_KHR,
                                          GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR_KHR,
                                          GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR_KHR,
                                          GL_DEBUG_TYPE_PORTABILITY_KHR,
                                          GL_DEBUG_TYPE_PERFORMANCE_KHR,
                                          GL_DEBUG_TYPE_OTHER_KHR,
                                          GL_DEBUG_TYPE_MARKER_KHR,
                                          GL_DEBUG_TYPE_PUSH_GROUP_KHR,
                                          GL_DEBUG_TYPE_POP_GROUP_KHR};
constexpr std::array<GLenum, 4> kSeverities = {GL_DEBUG_SEVERITY_HIGH_KHR, GL_DEBUG_SEVERITY_MEDIUM_KHR,
                                               GL_DEBUG_SEVERITY_LOW_KHR, GL_DEBUG_SEVERITY_NOTIFICATION_KHR};
constexpr std::array<GLenum, 2> kOwnSources = {GL_DEBUG_SOURCE_APPLICATION_KHR,
                                               GL_DEBUG_SOURCE_THIRD_PARTY_KHR};

struct ErrorText {
  GLenum code;
  const char* name;
  const char* meaning;  // where the command says nothing itself
  const char* remedy;
};
constexpr ErrorText kErrors[] = {
    {GL_INVALID_ENUM, "GL_INVALID_ENUM", "an argument is not a name that this command takes",
     "Compare its arguments with the names that the specification lists for it"},
    {GL_INVALID_VALUE, "GL_INVALID_VALUE", "an argument is out of range",
     "Compare sizes, counts and levels with what the command allows and with the limits of glGetIntegerv"},
    {GL_INVALID_OPERATION, "GL_INVALID_OPERATION", "the present state does not allow the command",
     "Look at what is bound, attached and mapped"},
    {GL_STACK_OVERFLOW, "GL_STACK_OVERFLOW", "the stack is full", "Pop as often as you push"},
    {GL_STACK_UNDERFLOW, "GL_STACK_UNDERFLOW", "nothing was pushed", "Push as often as you pop"},
    {GL_OUT_OF_MEMORY, "GL_OUT_OF_MEMORY", "memory ran out, or the device was lost",
     "Delete textures and buffers that are no longer used, or use smaller ones"},
    {GL_INVALID_FRAMEBUFFER_OPERATION_OES, "GL_INVALID_FRAMEBUFFER_OPERATION_OES",
     "the bound framebuffer is not complete, or there is none",
     "Ask glCheckFramebufferStatusOES why, or make a surface current"},
};

const ErrorText& textOf(GLenum code) {
  const auto* found = std::ranges::find(kErrors, code, &ErrorText::code);
  return found != std::end(kErrors) ? *found : kErrors[2];
}

std::string shownValue(const Fault& fault) {
  char text[32];
  if (fault.kind == Fault::Kind::Number) {
    std::snprintf(text, sizeof text, "%.9g", fault.value);
    return text;
  }
  const GLenum value = static_cast<GLenum>(fault.value);
  std::snprintf(text, sizeof text, "0x%04X", value);
  const std::string_view name = fault.kind == Fault::Kind::Enum ? enumName(value) : std::string_view();
  return name.empty() ? text : std::string(name) + " (" + text + ")";
}

}  // namespace

bool DebugOutput::Filter::covers(const Filter& other) const {
  const auto within = [](GLenum mine, GLenum theirs) { return mine == GL_DONT_CARE || mine == theirs; };
  return within(source, other.source) && within(type, other.type) && within(severity, other.severity) &&
         (!hasId || (other.hasId && id == other.id));
}

bool DebugOutput::Filter::matches(const DebugMessage& m) const {
  return covers({m.source, m.type, m.severity, true, m.id});
}

// All messages are enabled at first, but for those of low severity (section 5.5.1).
bool DebugOutput::wanted(const DebugMessage& message) const {
  const std::vector<Rule>& rules = groups_.back().rules;
  const auto found = std::find_if(rules.rbegin(), rules.rend(),
                                  [&](const Rule& rule) { return rule.filter.matches(message); });
  return found != rules.rend() ? found->enabled : message.severity != GL_DEBUG_SEVERITY_LOW_KHR;
}

void DebugOutput::message(DebugMessage m) {
  if (!wanted(m)) return;
  if (m.text.size() >= kMostMessageLength) m.text.resize(kMostMessageLength - 1);
  if (callback)
    callback(m.source, m.type, m.id, m.severity, static_cast<GLsizei>(m.text.size()), m.text.c_str(),
             userParam);
  else if (log.size() < kMostLoggedMessages)
    log.push_back(std::move(m));
}

std::string describeError(GLenum code, const Fault& fault, const char* command) {
  const ErrorText& general = textOf(code);
  // Helpers that pass on no name have none that a program would know.
  std::string text =
      std::string_view(command).starts_with("gl") ? std::string(command) + ": " : std::string();
  text += std::string(general.name) + ": ";
  if (fault.kind == Fault::Kind::Unknown)
    text += general.meaning;
  else if (fault.kind == Fault::Kind::State)
    text += fault.subject;
  else
    text += std::string(fault.subject) + " is " + shownValue(fault);
  return text + ". " + (fault.remedy ? fault.remedy : general.remedy) + ".";
}

void logError(GLenum code, const Fault& fault, const char* command) {
  try {
    std::fprintf(stderr, "anteroom: %s\n", describeError(code, fault, command).c_str());
  } catch (const std::bad_alloc&) {
    // The error itself is recorded.
  }
}

void DebugOutput::error(GLenum code, const Fault& fault, const char* command) {
  try {
    message({GL_DEBUG_SOURCE_API_KHR, GL_DEBUG_TYPE_ERROR_KHR, code, GL_DEBUG_SEVERITY_HIGH_KHR,
             describeError(code, fault, command)});
  } catch (const std::bad_alloc&) {
    // The error itself is recorded.
  }
}

void DebugOutput::slow(std::string_view what) {
  try {
    message({GL_DEBUG_SOURCE_API_KHR, GL_DEBUG_TYPE_PERFORMANCE_KHR, kSlowCommand,
             GL_DEBUG_SEVERITY_MEDIUM_KHR, std::string(what)});
  } catch (const std::bad_alloc&) {
    // A hint is not worth an error.
  }
}

void DebugOutput::control(const Filter& filter, bool enabled) {
  std::vector<Rule>& rules = groups_.back().rules;
  std::erase_if(rules, [&](const Rule& rule) { return filter.covers(rule.filter); });
  rules.push_back({filter, enabled});
}

void DebugOutput::push(DebugMessage message) {
  groups_.push_back({std::move(message), groups_.back().rules});
}

DebugMessage DebugOutput::pop() {
  DebugMessage message = std::move(groups_.back().message);
  groups_.pop_back();
  return message;
}

void updateListener(Context& c) {
  c.renderer->setListener(c.debugOutput ? c.debug.get() : nullptr);
}

std::string_view textOf(const GLchar* text, GLsizei length) {
  if (!text) return {};
  return {text, length < 0 ? std::strlen(text) : static_cast<size_t>(length)};
}

}  // namespace anteroom::gl

using namespace anteroom::gl;

namespace {

constexpr const char* kOwnSourcesOnly = "Use DEBUG_SOURCE_APPLICATION_KHR or DEBUG_SOURCE_THIRD_PARTY_KHR";
constexpr const char* kKnownSource = "Use DONT_CARE or one of DEBUG_SOURCE_..._KHR";
constexpr const char* kKnownType = "Use one of DEBUG_TYPE_..._KHR";
constexpr const char* kKnownSeverity = "Use one of DEBUG_SEVERITY_..._KHR";
constexpr const char* kShorter = "Give fewer characters than the value of MAX_DEBUG_MESSAGE_LENGTH_KHR";

template <size_t N>
bool isFilter(const std::array<GLenum, N>& names, GLenum name) {
  return name == GL_DONT_CARE || contains(names, name);
}

}  // namespace

GL_API void GL_APIENTRY glDebugMessageControlKHR(GLenum source, GLenum type, GLenum severity, GLsizei count,
                                                 const GLuint* ids, GLboolean enabled) {
  Context* c = current();
  if (!c) return;
  if (!isFilter(kSources, source))
    return c->setError(GL_INVALID_ENUM, wrongEnum("source", source, kKnownSource));
  if (!isFilter(kTypes, type)) return c->setError(GL_INVALID_ENUM, wrongEnum("type", type, kKnownType));
  if (!isFilter(kSeverities, severity))
    return c->setError(GL_INVALID_ENUM, wrongEnum("severity", severity, kKnownSeverity));
  if (count < 0) return c->setError(GL_INVALID_VALUE, wrongNumber("count", count, "Give a count from 0 on"));
  if (count > 0 && (source == GL_DONT_CARE || type == GL_DONT_CARE || severity != GL_DONT_CARE))
    return c->setError(GL_INVALID_OPERATION,
                       wrongState("Ids are given without what they belong to",
                                  "Name a source and a type with them, and DONT_CARE as the severity"));
  try {
    if (count == 0) c->debug->control({source, type, severity}, enabled);
    for (GLsizei i = 0; ids && i < count; ++i)
      c->debug->control({source, type, severity, true, ids[i]}, enabled);
  } catch (const std::bad_alloc&) {
    c->setError(GL_OUT_OF_MEMORY);
  }
}

GL_API void GL_APIENTRY glDebugMessageInsertKHR(GLenum source, GLenum type, GLuint id, GLenum severity,
                                                GLsizei length, const GLchar* buf) {
  Context* c = current();
  if (!c || !c->debugOutput) return;
  if (!contains(kOwnSources, source))
    return c->setError(GL_INVALID_ENUM, wrongEnum("source", source, kOwnSourcesOnly));
  if (!contains(kTypes, type)) return c->setError(GL_INVALID_ENUM, wrongEnum("type", type, kKnownType));
  if (!contains(kSeverities, severity))
    return c->setError(GL_INVALID_ENUM, wrongEnum("severity", severity, kKnownSeverity));
  const std::string_view text = anteroom::gl::textOf(buf, length);
  if (text.size() >= kMostMessageLength)
    return c->setError(GL_INVALID_VALUE, wrongNumber("length", text.size(), kShorter));
  try {
    if (type == GL_DEBUG_TYPE_MARKER_KHR) c->renderer->mark(text);
    c->debug->message({source, type, id, severity, std::string(text)});
  } catch (const std::bad_alloc&) {
    c->setError(GL_OUT_OF_MEMORY);
  }
}

GL_API void GL_APIENTRY glDebugMessageCallbackKHR(GLDEBUGPROCKHR callback, const void* userParam) {
  Context* c = current();
  if (!c) return;
  c->debug->callback = callback;
  c->debug->userParam = userParam;
}

GL_API GLuint GL_APIENTRY glGetDebugMessageLogKHR(GLuint count, GLsizei bufSize, GLenum* sources,
                                                  GLenum* types, GLuint* ids, GLenum* severities,
                                                  GLsizei* lengths, GLchar* messageLog) {
  Context* c = current();
  if (!c) return 0;
  if (bufSize < 0 && messageLog) {
    c->setError(GL_INVALID_VALUE, wrongNumber("bufSize", bufSize, "Give the size of messageLog in bytes"));
    return 0;
  }
  std::deque<DebugMessage>& log = c->debug->log;
  GLuint fetched = 0;
  for (size_t left = messageLog ? static_cast<size_t>(bufSize) : 0; fetched < count && !log.empty();
       ++fetched) {
    const DebugMessage& message = log.front();
    const size_t size = message.text.size() + 1;
    if (messageLog) {
      if (size > left) break;
      std::memcpy(messageLog, message.text.c_str(), size);
      messageLog += size;
      left -= size;
    }
    if (sources) sources[fetched] = message.source;
    if (types) types[fetched] = message.type;
    if (ids) ids[fetched] = message.id;
    if (severities) severities[fetched] = message.severity;
    if (lengths) lengths[fetched] = static_cast<GLsizei>(size);
    log.pop_front();
  }
  return fetched;
}

GL_API void GL_APIENTRY glPushDebugGroupKHR(GLenum source, GLuint id, GLsizei length, const GLchar* message) {
  Context* c = current();
  if (!c) return;
  if (!contains(kOwnSources, source))
    return c->setError(GL_INVALID_ENUM, wrongEnum("source", source, kOwnSourcesOnly));
  const std::string_view text = anteroom::gl::textOf(message, length);
  if (text.size() >= kMostMessageLength)
    return c->setError(GL_INVALID_VALUE, wrongNumber("length", text.size(), kShorter));
  if (c->debug->depth() == kDebugGroupDepth)
    return c->setError(GL_STACK_OVERFLOW, wrongNumber("the depth of the group stack", c->debug->depth(),
                                                      "Call glPopDebugGroupKHR for every group"));
  try {
    DebugMessage pushed{source, GL_DEBUG_TYPE_PUSH_GROUP_KHR, id, GL_DEBUG_SEVERITY_NOTIFICATION_KHR,
                        std::string(text)};
    c->debug->push(pushed);
    c->renderer->pushGroup(text);
    if (c->debugOutput) c->debug->message(std::move(pushed));
  } catch (const std::bad_alloc&) {
    c->setError(GL_OUT_OF_MEMORY);
  }
}

GL_API void GL_APIENTRY glPopDebugGroupKHR(void) {
  Context* c = current();
  if (!c) return;
  if (c->debug->depth() == 1)
    return c->setError(GL_STACK_UNDERFLOW, wrongState("No group is open", "Call glPushDebugGroupKHR before"));
  DebugMessage popped = c->debug->pop();
  c->renderer->popGroup();
  if (!c->debugOutput) return;
  popped.type = GL_DEBUG_TYPE_POP_GROUP_KHR;
  try {
    c->debug->message(std::move(popped));
  } catch (const std::bad_alloc&) {
    c->setError(GL_OUT_OF_MEMORY);
  }
}
