#include "layer/gl/debug/enum_names.h"

#include <GLES/glext.h>
#include <gtest/gtest.h>

namespace anteroom::gl::test {

TEST(EnumNames, OurNamesComeFirst) {
  EXPECT_EQ(enumName(GL_TEXTURE_2D), "GL_TEXTURE_2D");
  EXPECT_EQ(enumName(GL_FRAMEBUFFER_OES), "GL_FRAMEBUFFER_OES");  // GL_FRAMEBUFFER elsewhere
  EXPECT_EQ(enumName(GL_CLIP_PLANE0), "GL_CLIP_PLANE0");          // GL_CLIP_DISTANCE0 elsewhere
  EXPECT_EQ(enumName(GL_MIRRORED_REPEAT_OES), "GL_MIRRORED_REPEAT_OES");
}

TEST(EnumNames, NamesOfOtherApisAreKnown) {
  EXPECT_EQ(enumName(0x84F5), "GL_TEXTURE_RECTANGLE");
  EXPECT_EQ(enumName(0x8B31), "GL_VERTEX_SHADER");
}

TEST(EnumNames, SmallAndUnknownNumbersHaveNone) {
  for (const GLenum value :
       {GLenum{0}, GLenum{GL_TRIANGLES}, GLenum{0xFF}, GLenum{0x4009}, GLenum{0x10DE1}}) {
    EXPECT_EQ(enumName(value), "") << value;
  }
}

}  // namespace anteroom::gl::test
