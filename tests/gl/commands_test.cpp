// Every core command, by name (spec: the 144 of OpenGL ES 1.1, and the required extensions).
#include <cstring>
#include <sstream>
#include <string>

#include "layer/gl/front_end.h"
#include "tests/gl/core_commands.h"
#include "tests/gl/fake_renderer.h"

namespace anteroom::gl::test {

TEST(CommandsTest, EveryCoreCommandResolves) {
  std::istringstream names(kCoreCommands);
  int count = 0;
  for (std::string name; names >> name; ++count) EXPECT_NE(procAddress(name), nullptr) << name;
  EXPECT_EQ(count, 144);
}

TEST(CommandsTest, RequiredExtensionsResolve) {
  for (const char* name : {"glPointSizePointerOES", "glQueryMatrixxOES", "glRotatexOES", "glFrustumfOES",
                           "glGetClipPlanefOES", "glTexEnvxvOES"}) {
    EXPECT_NE(procAddress(name), nullptr) << name;
  }
}

TEST(CommandsTest, OtherNamesDoNot) {
  for (const char* name : {"", "gl", "glBegin", "glViewporu", "glZ", "eglInitialize"}) {
    EXPECT_EQ(procAddress(name), nullptr) << name;
  }
}

TEST(CommandsTest, AnAddressIsTheCommand) {
  EXPECT_EQ(procAddress("glLineWidth"), reinterpret_cast<Proc>(glLineWidth));
}

}  // namespace anteroom::gl::test
