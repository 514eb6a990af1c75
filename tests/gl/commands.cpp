// Every core command, by name (spec: the 144 of OpenGL ES 1.1, and the required extensions).
#include <iterator>

#include "layer/gl/front_end.h"
#include "tests/gl/gl_fixture.h"

namespace anteroom::gl::test {

namespace {

constexpr const char* kCoreCommands[] = {
#define ANTEROOM_COMMAND(name) #name,
#include "registry/core_commands.inc"
#undef ANTEROOM_COMMAND
};

}  // namespace

TEST(Commands, EveryCoreCommandResolves) {
  for (const char* name : kCoreCommands) EXPECT_NE(procAddress(name), nullptr) << name;
  EXPECT_EQ(std::size(kCoreCommands), 144u);
}

TEST(Commands, RequiredExtensionsResolve) {
  for (const char* name : {"glPointSizePointerOES", "glQueryMatrixxOES", "glRotatexOES", "glFrustumfOES",
                           "glGetClipPlanefOES", "glTexEnvxvOES"}) {
    EXPECT_NE(procAddress(name), nullptr) << name;
  }
}

TEST(Commands, OtherNamesDoNot) {
  for (const char* name : {"", "gl", "glBegin", "glViewporu", "glZ", "eglInitialize"}) {
    EXPECT_EQ(procAddress(name), nullptr) << name;
  }
}

TEST(Commands, AnAddressIsTheCommand) {
  EXPECT_EQ(procAddress("glLineWidth"), reinterpret_cast<Proc>(glLineWidth));
}

}  // namespace anteroom::gl::test
