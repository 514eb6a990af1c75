// The two shared libraries as files: what they export, how they are loaded, left and mixed up.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <set>
#include <string>

#include "layer/egl/commands.h"

namespace {

const std::string kEgl = LIBRARIES "/libEGL.so.1";
const std::string kGles = LIBRARIES "/libGLESv1_CM.so.1";

struct Outcome {
  int status;  // exit status; -signal when it died of one
  std::string output;
};

Outcome run(const std::string& command) {
  Outcome outcome{};
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return {-1, "no pipe"};
  char buffer[4096];
  while (const size_t size = fread(buffer, 1, sizeof buffer, pipe)) outcome.output.append(buffer, size);
  const int status = pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return outcome;
}

std::set<std::string> exportsOf(const std::string& library) {
  std::set<std::string> names;
  const Outcome outcome = run(NM " -D --defined-only --format=just-symbols " + library);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (size_t begin = 0, end; (end = outcome.output.find('\n', begin)) != std::string::npos; begin = end + 1)
    names.insert(outcome.output.substr(begin, end - begin));
  return names;
}

TEST(Loader, EglExportsItsCommandsAndNothingElse) {
  const std::set<std::string> commands = {
#define NAME(Result, name, parameters, arguments) #name,
      ANTEROOM_EGL_COMMANDS(NAME)
#undef NAME
  };
  EXPECT_EQ(commands.size(), 44u);
  EXPECT_EQ(exportsOf(kEgl), commands);
}

TEST(Loader, GlesExportsWhatProgramsCanAskFor) {
  void* egl = dlopen(kEgl.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(egl, nullptr) << dlerror();
  const auto getProcAddress = reinterpret_cast<decltype(&eglGetProcAddress)>(dlsym(egl, "eglGetProcAddress"));
  ASSERT_NE(getProcAddress, nullptr);
  size_t found = 0;
  for (const std::string& name : exportsOf(kGles)) {
    EXPECT_EQ(name.rfind("gl", 0), 0u) << name;
    if (name == "glAnteroomEglTable") continue;
    EXPECT_NE(getProcAddress(name.c_str()), nullptr) << name;
    ++found;
  }
  EXPECT_GE(found, 145u) << "the core commands and glPointSizePointerOES";
  dlclose(egl);
}

TEST(Loader, LinkNamesAreWhatIsThere) {
  EXPECT_EQ(exportsOf(LINK_NAMES), exportsOf(LIBRARIES "/libanteroom.so.0"));
}

// By whatever names it is asked for.
TEST(Loader, TheImplementationIsThereOnce) {
  void* byGlesName = dlopen(kGles.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* byItsName = dlopen(LIBRARIES "/libanteroom.so.0", RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(byGlesName, nullptr) << dlerror();
  EXPECT_EQ(byGlesName, byItsName);
  void* egl = dlopen(kEgl.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(egl, nullptr) << dlerror();
  EXPECT_EQ(dlsym(egl, "glClear"), dlsym(byItsName, "glClear"));
  dlclose(egl);
  dlclose(byItsName);
  dlclose(byGlesName);
}

// Beside another vendor that is used, glvnd's programs get no more of us than the vendor library.
TEST(Loader, VendorLoadsTheImplementationLate) {
  if (access(VENDOR_FILE, R_OK) != 0) GTEST_SKIP() << "built without glvnd";
  const Outcome outcome =
      run("LD_LIBRARY_PATH=" SYSTEM_LIBRARIES " __EGL_VENDOR_LIBRARY_FILENAMES=" VENDOR_FILE
          " EGL_PLATFORM=surfaceless " PROGRAM " loads-late");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(outcome.output, "");
}

TEST(Loader, OpensAndClosesAHundredTimes) {
  for (int i = 0; i < 100; ++i) {
    void* egl = dlopen(kEgl.c_str(), RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(egl, nullptr) << dlerror();
    const auto getDisplay = reinterpret_cast<decltype(&eglGetDisplay)>(dlsym(egl, "eglGetDisplay"));
    const auto initialize = reinterpret_cast<decltype(&eglInitialize)>(dlsym(egl, "eglInitialize"));
    const auto terminate = reinterpret_cast<decltype(&eglTerminate)>(dlsym(egl, "eglTerminate"));
    ASSERT_TRUE(getDisplay != nullptr && initialize != nullptr && terminate != nullptr);
    const EGLDisplay display = getDisplay(EGL_DEFAULT_DISPLAY);
    ASSERT_NE(display, EGL_NO_DISPLAY);
    if (i % 10 == 0) {
      ASSERT_TRUE(initialize(display, nullptr, nullptr));
      ASSERT_TRUE(terminate(display));
    }
    ASSERT_EQ(dlclose(egl), 0);
  }
}

class Ending : public testing::TestWithParam<const char*> {};

TEST_P(Ending, LeavesQuietly) {
  const Outcome outcome = run(std::string("timeout 60 " PROGRAM " ") + GetParam());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(outcome.output, "");
}

INSTANTIATE_TEST_SUITE_P(Loader, Ending,
                         testing::Values("return", "atexit", "static-destructor", "exit-in-thread",
                                         "other-thread", "thread-ends"));

TEST(Loader, NoticesACompanionOfAnotherVersion) {
  const Outcome outcome = run("LD_LIBRARY_PATH=" COMPANIONS "/other_version " PROGRAM " no-display");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("(interface 999) are of different versions"), std::string::npos)
      << outcome.output;
}

TEST(Loader, NoticesAForeignCompanion) {
  const Outcome outcome = run("LD_LIBRARY_PATH=" COMPANIONS "/foreign " PROGRAM " no-display");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("is not Anteroom's"), std::string::npos) << outcome.output;
}

}  // namespace
