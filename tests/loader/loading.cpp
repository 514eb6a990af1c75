// The two shared libraries as files: what they export, how they are loaded, left and mixed up.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "layer/egl/commands.h"

namespace {

const std::string kEgl = LIBRARIES "/libEGL.so.1";
const std::string kGles = LIBRARIES "/libGLESv1_CM.so.1";

// The C library's heap breathes; a hundred devices or contexts left behind would be far more.
constexpr long kMostMaps = 20, kMostPages = 2048;

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

// What a process has, proc(5).
struct Possessions {
  long pages = 0, threads = 0, files = 0, maps = 0;
};

Possessions possessions() {
  Possessions all;
  std::ifstream("/proc/self/statm") >> all.pages >> all.pages;  // the second: resident
  const auto entries = [](const char* folder) {
    return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
  };
  all.threads = entries("/proc/self/task");
  all.files = entries("/proc/self/fd");
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) ++all.maps;
  return all;
}

// The way of a program that loads EGL as a plugin; `depth`: how far it goes.
void openAndClose(int depth) {
  void* egl = dlopen(kEgl.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(egl, nullptr) << dlerror();
  const auto get = [&]<typename Function>(Function, const char* name) {
    return reinterpret_cast<Function>(dlsym(egl, name));
  };
#define GET(name) const auto name = get(static_cast<decltype(&::name)>(nullptr), #name)
  GET(eglGetDisplay);
  GET(eglInitialize);
  GET(eglTerminate);
  GET(eglChooseConfig);
  GET(eglCreateContext);
  GET(eglCreatePbufferSurface);
  GET(eglMakeCurrent);
  GET(eglReleaseThread);
  GET(eglGetProcAddress);
#undef GET
  ASSERT_TRUE(eglGetDisplay && eglInitialize && eglTerminate && eglMakeCurrent && eglReleaseThread);
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  ASSERT_NE(display, EGL_NO_DISPLAY);
  if (depth > 0) {
    ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
  }
  if (depth > 1) {
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    ASSERT_TRUE(eglChooseConfig(display, wanted, &config, 1, &count) && count == 1);
    const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 64, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context));
    const auto clear = reinterpret_cast<void (*)(unsigned)>(eglGetProcAddress("glClear"));
    const auto finish = reinterpret_cast<void (*)()>(eglGetProcAddress("glFinish"));
    ASSERT_TRUE(clear && finish);
    clear(0x4000);
    finish();
    ASSERT_TRUE(eglReleaseThread());
  }
  if (depth > 0) {
    ASSERT_TRUE(eglTerminate(display));
  }
  ASSERT_EQ(dlclose(egl), 0);
}

class Loaded : public testing::TestWithParam<int> {};

// Nothing is left behind; the first time counts as the program's own start.
TEST_P(Loaded, AHundredTimes) {
  for (int i = 0; i < 10; ++i) openAndClose(GetParam());
  const Possessions before = possessions();
  for (int i = 0; i < 100 && !HasFatalFailure(); ++i) openAndClose(GetParam());
  const Possessions after = possessions();
  EXPECT_EQ(after.threads, before.threads);
  EXPECT_EQ(after.files, before.files);
#ifndef __SANITIZE_ADDRESS__  // it keeps what is freed
  EXPECT_LE(after.maps, before.maps + kMostMaps);
  EXPECT_LE(after.pages, before.pages + kMostPages);
#endif
}

INSTANTIATE_TEST_SUITE_P(Loader, Loaded, testing::Values(0, 1, 2));

class Ending : public testing::TestWithParam<const char*> {};

TEST_P(Ending, LeavesQuietly) {
  // Where the first thread ends by itself, the C library loses what it keeps for its dlerror.
  const bool loses = std::string(GetParam()) == "first-thread-ends";
  const std::string leaks = loses ? "ASAN_OPTIONS=detect_leaks=0 " : "";
  const Outcome outcome = run(leaks + "timeout 1200 " PROGRAM " " + GetParam());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(outcome.output, "");
}

INSTANTIATE_TEST_SUITE_P(Loader, Ending,
                         testing::Values("return", "_exit", "atexit", "atexit-draws", "atexit-exits",
                                         "atexit-draws-in-thread", "static-destructor",
                                         "static-destructor-draws", "static-destructor-calls",
                                         "exit-in-thread", "other-thread", "thread-ends",
                                         "thread-local-draws", "first-thread-ends"));

// What the driver is just compiling is finished before the compiler goes. Without that every fourth run
// fails.
TEST(Loader, EndsInTheMiddleOfWork) {
  for (const char* where : {"in-the-middle", "in-the-middle-of-a-thread"}) {
    for (int i = 0; i < 10; ++i) {
      const Outcome outcome = run(std::string("ANTEROOM_CACHE=off timeout 1200 " PROGRAM " ") + where);
      ASSERT_EQ(outcome.status, 0) << where << ", " << i << ": " << outcome.output;
    }
  }
}

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
