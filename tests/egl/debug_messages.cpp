// EGL_KHR_debug: messages of every error, which of them are wanted, labels.
#include <functional>

#include "egl_fixture.h"

namespace egl_conformance {
namespace {

struct Message {
  EGLenum error;
  std::string command;
  EGLint type;
  EGLLabelKHR thread, object;
  std::string text;
};
std::vector<Message> heard;

void EGLAPIENTRY hear(EGLenum error, const char* command, EGLint type, EGLLabelKHR thread, EGLLabelKHR object,
                      const char* text) {
  heard.push_back({error, command, type, thread, object, text != nullptr ? text : ""});
}

class DebugMessages : public EglTest {
 protected:
  void SetUp() override {
    EglTest::SetUp();
    ASSERT_TRUE(names(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_KHR_debug"));
    load(control, "eglDebugMessageControlKHR");
    load(query, "eglQueryDebugKHR");
    load(label, "eglLabelObjectKHR");
    heard.clear();
    control(nullptr, nullptr);
  }
  void TearDown() override {
    label(EGL_NO_DISPLAY, EGL_OBJECT_THREAD_KHR, nullptr, nullptr);
    label(display_, EGL_OBJECT_DISPLAY_KHR, display_, nullptr);
    control(nullptr, nullptr);
    EglTest::TearDown();
  }
  template <class Command>
  static void load(Command& to, const char* name) {
    to = reinterpret_cast<Command>(eglGetProcAddress(name));
    ASSERT_NE(to, nullptr) << name;
  }
  EGLAttrib get(EGLint attribute) const {
    EGLAttrib value = -1;
    EXPECT_TRUE(query(attribute, &value));
    return value;
  }

  PFNEGLDEBUGMESSAGECONTROLKHRPROC control = nullptr;
  PFNEGLQUERYDEBUGKHRPROC query = nullptr;
  PFNEGLLABELOBJECTKHRPROC label = nullptr;
};

constexpr EGLint kTypes[] = {EGL_DEBUG_MSG_CRITICAL_KHR, EGL_DEBUG_MSG_ERROR_KHR, EGL_DEBUG_MSG_WARN_KHR,
                             EGL_DEBUG_MSG_INFO_KHR};

// Table 13.1; null resets.
TEST_F(DebugMessages, Control) {
  const auto expectTypes = [&](std::vector<EGLAttrib> expected) {
    for (size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(get(kTypes[i]), expected[i]) << i;
  };
  EXPECT_EQ(get(EGL_DEBUG_CALLBACK_KHR), 0);
  expectTypes({EGL_TRUE, EGL_TRUE, EGL_FALSE, EGL_FALSE});
  const EGLAttrib some[] = {EGL_DEBUG_MSG_WARN_KHR, EGL_TRUE, EGL_DEBUG_MSG_ERROR_KHR, EGL_FALSE, EGL_NONE};
  EXPECT_EQ(control(hear, some), EGL_SUCCESS);
  EXPECT_EQ(get(EGL_DEBUG_CALLBACK_KHR), reinterpret_cast<EGLAttrib>(&hear));
  expectTypes({EGL_TRUE, EGL_FALSE, EGL_TRUE, EGL_FALSE});
  EXPECT_EQ(control(hear, nullptr), EGL_SUCCESS) << "the rest stays";
  expectTypes({EGL_TRUE, EGL_FALSE, EGL_TRUE, EGL_FALSE});
  EXPECT_EQ(eglGetDisplay(reinterpret_cast<EGLNativeDisplayType>(1)), EGL_NO_DISPLAY);
  eglInitialize(nullptr, nullptr, nullptr);
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  EXPECT_TRUE(heard.empty()) << "errors are off";
  EXPECT_EQ(control(nullptr, nullptr), EGL_SUCCESS);
  expectTypes({EGL_TRUE, EGL_TRUE, EGL_FALSE, EGL_FALSE});
  for (const EGLAttrib& bad : {EGLAttrib{EGL_WIDTH}, EGLAttrib{EGL_DEBUG_CALLBACK_KHR}}) {
    const EGLAttrib list[] = {EGL_DEBUG_MSG_INFO_KHR, EGL_TRUE, bad, EGL_TRUE, EGL_NONE};
    EXPECT_EQ(control(hear, list), EGL_BAD_ATTRIBUTE);
  }
  const EGLAttrib value[] = {EGL_DEBUG_MSG_INFO_KHR, 2, EGL_NONE};
  EXPECT_EQ(control(hear, value), EGL_BAD_ATTRIBUTE);
  EXPECT_EQ(get(EGL_DEBUG_CALLBACK_KHR), 0) << "an error changes nothing";
  expectTypes({EGL_TRUE, EGL_TRUE, EGL_FALSE, EGL_FALSE});
  EGLAttrib out = 0;
  EXPECT_FALSE(query(EGL_WIDTH, &out));
  EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
}

// The command that was called, the error that eglGetError then has, and a text that says more.
TEST_F(DebugMessages, EveryErrorMakesOne) {
  control(hear, nullptr);
  const EGLConfig config = choose();
  const EGLint badList[] = {EGL_WIDTH, 5, EGL_NONE};
  const EGLAttrib badAttribs[] = {EGL_WIDTH, 5, EGL_NONE};
  const struct {
    const char* command;
    EGLint error;
    std::function<void()> call;
  } rows[] = {
      {"eglCreateContext", EGL_BAD_CONFIG,
       [&] { eglCreateContext(display_, reinterpret_cast<EGLConfig>(0x7fff), EGL_NO_CONTEXT, nullptr); }},
      {"eglCreateContext", EGL_BAD_ATTRIBUTE,
       [&] { eglCreateContext(display_, config, EGL_NO_CONTEXT, badList); }},
      {"eglDestroyContext", EGL_BAD_CONTEXT, [&] { eglDestroyContext(display_, display_); }},
      {"eglDestroySurface", EGL_BAD_SURFACE, [&] { eglDestroySurface(display_, display_); }},
      {"eglQuerySurface", EGL_BAD_SURFACE, [&] { eglQuerySurface(display_, display_, EGL_WIDTH, nullptr); }},
      {"eglMakeCurrent", EGL_BAD_DISPLAY,
       [&] { eglMakeCurrent(&heard, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }},
      {"eglBindAPI", EGL_BAD_PARAMETER, [] { eglBindAPI(EGL_OPENGL_API); }},
      {"eglCreateSync", EGL_BAD_ATTRIBUTE, [&] { eglCreateSync(display_, EGL_SYNC_FENCE, badAttribs); }},
      {"eglCreateSyncKHR", EGL_BAD_ATTRIBUTE,
       [&] {
         reinterpret_cast<PFNEGLCREATESYNCKHRPROC>(eglGetProcAddress("eglCreateSyncKHR"))(display_, 0,
                                                                                          nullptr);
       }},
      {"eglGetSyncAttrib", EGL_BAD_PARAMETER,
       [&] { eglGetSyncAttrib(display_, display_, EGL_SYNC_TYPE, nullptr); }},
      {"eglCreateImage", EGL_BAD_PARAMETER,
       [&] { eglCreateImage(display_, EGL_NO_CONTEXT, EGL_WIDTH, nullptr, nullptr); }},
      {"eglQueryDebugKHR", EGL_BAD_ATTRIBUTE, [&] { query(EGL_WIDTH, nullptr); }},
      {"eglLabelObjectKHR", EGL_BAD_PARAMETER,
       [&] { label(display_, EGL_OBJECT_STREAM_KHR, display_, nullptr); }},
  };
  for (const auto& row : rows) {
    heard.clear();
    row.call();
    EXPECT_EGL_ERROR(row.error);
    ASSERT_EQ(heard.size(), 1u) << row.command;
    EXPECT_EQ(heard[0].command, row.command);
    EXPECT_EQ(heard[0].error, static_cast<EGLenum>(row.error));
    EXPECT_EQ(heard[0].type, EGL_DEBUG_MSG_ERROR_KHR);
    EXPECT_EQ(heard[0].text.find(row.command), 0u) << heard[0].text;
    EXPECT_NE(heard[0].text.find(errorName(row.error)), std::string::npos) << heard[0].text;
  }
  heard.clear();
  EXPECT_TRUE(eglBindAPI(EGL_OPENGL_ES_API));
  EXPECT_TRUE(heard.empty());
}

TEST_F(DebugMessages, Labels) {
  control(hear, nullptr);
  int thread = 0, ofDisplay = 0, ofSurface = 0, ofContext = 0;
  const EGLConfig config = choose();
  const EGLSurface surface = createPbuffer(config);
  const EGLContext context = createContext(config);
  EXPECT_EQ(label(EGL_NO_DISPLAY, EGL_OBJECT_THREAD_KHR, nullptr, &thread), EGL_SUCCESS);
  EXPECT_EQ(label(display_, EGL_OBJECT_DISPLAY_KHR, display_, &ofDisplay), EGL_SUCCESS);
  EXPECT_EQ(label(display_, EGL_OBJECT_SURFACE_KHR, surface, &ofSurface), EGL_SUCCESS);
  EXPECT_EQ(label(display_, EGL_OBJECT_CONTEXT_KHR, context, &ofContext), EGL_SUCCESS);
  EXPECT_TRUE(heard.empty());
  const auto last = [] { return heard.empty() ? nullptr : heard.back().object; };
  eglBindAPI(EGL_OPENGL_API);
  EXPECT_EQ(last(), &thread);
  EXPECT_EQ(heard.back().thread, &thread);
  eglGetConfigs(display_, nullptr, 0, nullptr);
  EXPECT_EQ(last(), &ofDisplay);
  EGLint value = 0;
  eglQuerySurface(display_, surface, EGL_SAMPLES, &value);
  EXPECT_EQ(last(), &ofSurface);
  eglQueryContext(display_, context, EGL_WIDTH, &value);
  EXPECT_EQ(last(), &ofContext);
  // Without a label there is none.
  EXPECT_EQ(label(display_, EGL_OBJECT_SURFACE_KHR, surface, nullptr), EGL_SUCCESS);
  eglQuerySurface(display_, surface, EGL_SAMPLES, &value);
  EXPECT_EQ(last(), nullptr);

  for (const EGLenum type : {EGL_OBJECT_CONTEXT_KHR, EGL_OBJECT_SURFACE_KHR, EGL_OBJECT_IMAGE_KHR,
                             EGL_OBJECT_SYNC_KHR, EGL_OBJECT_STREAM_KHR, EGL_WIDTH}) {
    EXPECT_EQ(label(display_, type, nullptr, &thread), EGL_BAD_PARAMETER);
    EXPECT_EQ(label(display_, type, display_, &thread), EGL_BAD_PARAMETER);
  }
  EXPECT_EQ(label(display_, EGL_OBJECT_CONTEXT_KHR, surface, &thread), EGL_BAD_PARAMETER);
  EXPECT_EQ(label(display_, EGL_OBJECT_DISPLAY_KHR, surface, &thread), EGL_BAD_PARAMETER);
  EXPECT_EQ(label(EGL_NO_DISPLAY, EGL_OBJECT_SURFACE_KHR, surface, &thread), EGL_BAD_DISPLAY);
  EXPECT_TRUE(eglDestroySurface(display_, surface));
  EXPECT_EQ(label(display_, EGL_OBJECT_SURFACE_KHR, surface, &thread), EGL_BAD_PARAMETER);
  EXPECT_TRUE(eglDestroyContext(display_, context));
  eglGetError();
}

}  // namespace
}  // namespace egl_conformance
