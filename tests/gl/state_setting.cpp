// Lighting, color material, conversions, enables: what is stored, what queries give, which groups are marked.
#include <limits>
#include <set>
#include <string>
#include <string_view>

#include "tests/gl/gl_fixture.h"

namespace anteroom::gl::test {

namespace {

class StateSetting : public GlTest {
 protected:
  glm::vec4 material(GLenum pname) {
    glm::vec4 value;
    glGetMaterialfv(GL_FRONT, pname, &value[0]);
    return value;
  }
};

}  // namespace

TEST_F(StateSetting, FixedPointConversions) {
  EXPECT_EQ(toFixed(1.0), 65536);
  EXPECT_EQ(toFixed(0.5 / 65536), 1);
  EXPECT_EQ(toFixed(-0.5 / 65536), -1);
  EXPECT_EQ(toFixed(1e9), std::numeric_limits<GLfixed>::max());
  EXPECT_EQ(toFixed(-1e9), std::numeric_limits<GLfixed>::min());
  EXPECT_EQ(toFixed(std::numeric_limits<double>::infinity()), std::numeric_limits<GLfixed>::max());
  EXPECT_EQ(toFixed(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(fromFixed(-32768), -0.5f);
}

TEST_F(StateSetting, ColorsBecomeTheWholeRangeOfInt) {
  glColor4f(1, -1, 0.5f, 7);
  GLint color[4];
  glGetIntegerv(GL_CURRENT_COLOR, color);
  EXPECT_EQ(color[0], std::numeric_limits<GLint>::max());
  EXPECT_EQ(color[1], std::numeric_limits<GLint>::min());
  EXPECT_EQ(color[2], 1073741823);  // ((2^32 - 1) / 2 - 1) / 2
  GLfloat floats[4];
  glGetFloatv(GL_CURRENT_COLOR, floats);
  EXPECT_EQ(floats[3], 7);  // not clamped
  GLboolean booleans[4];
  glColor4f(0.25f, 0, -1, 0);
  glGetBooleanv(GL_CURRENT_COLOR, booleans);
  EXPECT_EQ(booleans[0], GL_TRUE);
  EXPECT_EQ(booleans[1], GL_FALSE);
  EXPECT_EQ(booleans[2], GL_TRUE);
}

TEST_F(StateSetting, BytesBecomeColorsByTable27) {
  glColor4ub(255, 0, 51, 128);
  const glm::vec4& color = state().fixed.attributes[gen::kColor].current;
  EXPECT_EQ(color, glm::vec4(1, 0, 0.2f, 128 / 255.0f));
}

TEST_F(StateSetting, OtherNumbersAreRounded) {
  glLineWidth(2.5f);
  EXPECT_EQ(integer(GL_LINE_WIDTH), 3);
  glPolygonOffset(-1.4f, 3e10f);
  EXPECT_EQ(integer(GL_POLYGON_OFFSET_FACTOR), -1);
  EXPECT_EQ(integer(GL_POLYGON_OFFSET_UNITS), std::numeric_limits<GLint>::max());
}

TEST_F(StateSetting, GetFixedScalesNumbersButNotEnums) {
  GLfixed value = 0;
  glGetFixedv(GL_FOG_MODE, &value);
  EXPECT_EQ(value, GL_EXP);
  glGetFixedv(GL_MAX_LIGHTS, &value);
  EXPECT_EQ(value, 8 << 16);
  glGetFixedv(GL_DEPTH_WRITEMASK, &value);
  EXPECT_EQ(value, 1 << 16);
  glGetFixedv(GL_MAX_TEXTURE_SIZE, &value);
  EXPECT_EQ(value, 2048 << 16);
}

TEST_F(StateSetting, EnumsOfFixedCommandsAreNotScaled) {
  glFogx(GL_FOG_MODE, GL_LINEAR);
  EXPECT_EQ(integer(GL_FOG_MODE), GL_LINEAR);
  glFogx(GL_FOG_DENSITY, 3 << 15);
  EXPECT_EQ(state().fixed.fog.density, 1.5f);
  glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
  EXPECT_EQ(state().fixed.units[0].env.mode, GLenum{GL_DECAL});
  glTexEnvx(GL_TEXTURE_ENV, GL_RGB_SCALE, 4 << 16);
  EXPECT_EQ(state().fixed.units[0].env.rgbScale, 4);
  glTexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
  EXPECT_EQ(state().fixed.units[0].env.rgbScale, 2);
}

TEST_F(StateSetting, IntegerEnvironmentColorsAreNormalised) {
  const GLint color[4] = {std::numeric_limits<GLint>::max(), 0, std::numeric_limits<GLint>::min(), 1 << 30};
  glTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
  const glm::vec4& stored = state().fixed.units[0].env.color;
  EXPECT_EQ(stored.x, 1);
  EXPECT_NEAR(stored.y, 0, 1e-9);
  EXPECT_EQ(stored.z, 0);
  EXPECT_NEAR(stored.w, 0.5, 1e-6);
}

TEST_F(StateSetting, ClampedValuesAreClampedEvenNan) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  glClearColor(-1, 2, kNan, 0.5f);
  EXPECT_EQ(state().clear.color, glm::vec4(0, 1, 0, 0.5f));
  glDepthRangef(2, kNan);
  EXPECT_EQ(state().depthNear, 1);
  EXPECT_EQ(state().depthFar, 0);
  glAlphaFunc(GL_LESS, 3);
  EXPECT_EQ(state().fixed.alphaRef, 1);
}

TEST_F(StateSetting, LightsAreMovedByTheModelviewOfTheirTime) {
  glTranslatef(1, 2, 3);
  glScalef(2, 2, 2);
  const GLfloat position[4] = {1, 0, 0, 1}, direction[3] = {0, 0, -1};
  glLightfv(GL_LIGHT2, GL_POSITION, position);
  glLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, direction);
  glLoadIdentity();
  GLfloat value[4];
  glGetLightfv(GL_LIGHT2, GL_POSITION, value);
  EXPECT_EQ(glm::vec4(value[0], value[1], value[2], value[3]), glm::vec4(3, 2, 3, 1));
  glGetLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, value);
  EXPECT_EQ(glm::vec3(value[0], value[1], value[2]), glm::vec3(0, 0, -2));
}

TEST_F(StateSetting, LightZeroIsWhite) {
  EXPECT_EQ(state().fixed.lighting.lights[0].diffuse, glm::vec4(1));
  EXPECT_EQ(state().fixed.lighting.lights[1].diffuse, glm::vec4(0, 0, 0, 1));
}

TEST_F(StateSetting, ColorMaterialFollowsAndStays) {
  const GLfloat red[4] = {1, 0, 0, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, red);
  glColor4f(0, 1, 0, 1);
  EXPECT_EQ(material(GL_DIFFUSE), glm::vec4(1, 0, 0, 1));
  glEnable(GL_COLOR_MATERIAL);
  EXPECT_EQ(material(GL_DIFFUSE), glm::vec4(0, 1, 0, 1));
  glColor4f(0, 0, 1, 1);
  EXPECT_EQ(material(GL_AMBIENT), glm::vec4(0, 0, 1, 1));
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, red);  // follows the color, not this
  EXPECT_EQ(material(GL_AMBIENT), glm::vec4(0, 0, 1, 1));
  glDisable(GL_COLOR_MATERIAL);
  glColor4f(1, 1, 1, 1);
  EXPECT_EQ(material(GL_AMBIENT), glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(material(GL_DIFFUSE), glm::vec4(0, 0, 1, 1));
}

TEST_F(StateSetting, ClipPlanesAreInEyeCoordinates) {
  glTranslatef(0, 0, -5);
  const GLfloat plane[4] = {0, 0, 1, 0};
  glClipPlanef(GL_CLIP_PLANE1, plane);
  GLfloat value[4];
  glGetClipPlanef(GL_CLIP_PLANE1, value);
  EXPECT_EQ(glm::vec4(value[0], value[1], value[2], value[3]), glm::vec4(0, 0, 1, 5));
  glScalef(0, 0, 0);
  glClipPlanef(GL_CLIP_PLANE1, plane);
  glGetClipPlanef(GL_CLIP_PLANE1, value);
  for (float v : value) EXPECT_EQ(v, 0);
}

TEST_F(StateSetting, EveryCapabilitySwitches) {
  const GLenum capabilities[] = {GL_LIGHTING,     GL_COLOR_MATERIAL,
                                 GL_NORMALIZE,    GL_RESCALE_NORMAL,
                                 GL_TEXTURE_2D,   GL_FOG,
                                 GL_POINT_SMOOTH, GL_POINT_SPRITE_OES,
                                 GL_LINE_SMOOTH,  GL_CULL_FACE,
                                 GL_ALPHA_TEST,   GL_POLYGON_OFFSET_FILL,
                                 GL_SCISSOR_TEST, GL_STENCIL_TEST,
                                 GL_DEPTH_TEST,   GL_BLEND,
                                 GL_DITHER,       GL_COLOR_LOGIC_OP,
                                 GL_MULTISAMPLE,  GL_SAMPLE_ALPHA_TO_COVERAGE,
                                 GL_LIGHT0,       GL_LIGHT7,
                                 GL_CLIP_PLANE0,  GL_SAMPLE_ALPHA_TO_ONE,
                                 GL_CLIP_PLANE5,  GL_SAMPLE_COVERAGE};
  const std::set<GLenum> onAtFirst{GL_DITHER, GL_MULTISAMPLE};
  for (GLenum capability : capabilities) {
    SCOPED_TRACE(capability);
    EXPECT_EQ(glIsEnabled(capability), onAtFirst.count(capability) ? GL_TRUE : GL_FALSE);
    EXPECT_EQ(integer(capability), onAtFirst.count(capability) ? 1 : 0);
    glDisable(capability);
    EXPECT_FALSE(glIsEnabled(capability));
    changed() = 0;
    glEnable(capability);
    EXPECT_TRUE(glIsEnabled(capability));
    EXPECT_NE(changed(), 0u);
    changed() = 0;
    glEnable(capability);
    EXPECT_EQ(changed(), 0u);
  }
}

TEST_F(StateSetting, UnchangedStateMarksNothing) {
  const auto again = [this](auto&& command) {
    command();
    changed() = 0;
    command();
    EXPECT_EQ(changed(), 0u);
  };
  again([] { glColor4f(0.5f, 0.5f, 0.5f, 1); });
  again([] { glBlendFunc(GL_SRC_ALPHA, GL_ONE); });
  again([] { glDepthFunc(GL_LEQUAL); });
  again([] { glColorMask(1, 0, 3, 1); });
  again([] { glViewport(1, 2, 3, 4); });
  again([] { glStencilFunc(GL_EQUAL, 300, 0xF); });
  again([] { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE); });
  again([] { glMaterialx(GL_FRONT_AND_BACK, GL_SHININESS, 1 << 20); });
  again([] { glPointSize(4); });
}

TEST_F(StateSetting, StencilReferenceIsClampedToTheBuffer) {
  glStencilFunc(GL_ALWAYS, 300, ~0u);
  EXPECT_EQ(integer(GL_STENCIL_REF), 255);
  EXPECT_EQ(integer(GL_STENCIL_VALUE_MASK), -1);
  glStencilFunc(GL_ALWAYS, -3, ~0u);
  EXPECT_EQ(integer(GL_STENCIL_REF), 0);
}

TEST_F(StateSetting, FramebufferGivesBitsAndFirstViewport) {
  EXPECT_EQ(integer(GL_RED_BITS), 8);
  EXPECT_EQ(integer(GL_ALPHA_BITS), 8);
  EXPECT_EQ(integer(GL_DEPTH_BITS), 24);
  EXPECT_EQ(integer(GL_STENCIL_BITS), 8);
  GLint box[4];
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(box[2], 64);
  EXPECT_EQ(box[3], 48);
  glGetIntegerv(GL_SCISSOR_BOX, box);
  EXPECT_EQ(box[2], 64);

  render::Framebuffer other = framebuffer;
  other.width = other.height = 8;
  other.color.image = image(render::Format::RGB565);
  other.depth = other.stencil = {};
  other.samples = 4;
  setDefaultFramebuffer(*context, &other);
  EXPECT_EQ(integer(GL_GREEN_BITS), 6);
  EXPECT_EQ(integer(GL_ALPHA_BITS), 0);
  EXPECT_EQ(integer(GL_DEPTH_BITS), 0);
  EXPECT_EQ(integer(GL_SAMPLE_BUFFERS), 1);
  EXPECT_EQ(integer(GL_SAMPLES), 4);
  EXPECT_TRUE(state().fixed.multisample);
  EXPECT_EQ(state().fixed.alphaBits, 0);
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(box[2], 64);  // only the first framebuffer sets it
  glDisable(GL_MULTISAMPLE);
  EXPECT_FALSE(state().fixed.multisample);
}

TEST_F(StateSetting, ViewportIsClampedToTheLimit) {
  glViewport(-5, 7, 1 << 20, 9);
  GLint box[4];
  glGetIntegerv(GL_VIEWPORT, box);
  EXPECT_EQ(box[0], -5);
  EXPECT_EQ(box[2], 2048);
  EXPECT_EQ(box[3], 9);
}

TEST_F(StateSetting, PointSizeMaximumIsTheDevices) {
  EXPECT_EQ(integer(GL_POINT_SIZE_MAX), 64);
  GLfloat range[2];
  glGetFloatv(GL_SMOOTH_POINT_SIZE_RANGE, range);
  EXPECT_EQ(range[1], 32);
}

TEST_F(StateSetting, StringsNameTheVersionAndTheRequiredExtensions) {
  EXPECT_TRUE(std::string_view(reinterpret_cast<const char*>(glGetString(GL_VERSION)))
                  .starts_with("OpenGL ES-CM 1.1 Anteroom "));
  EXPECT_STREQ(reinterpret_cast<const char*>(glGetString(GL_RENDERER)), "Anteroom on a fake");
  const std::string extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
  for (const char* required :
       {"GL_OES_byte_coordinates", "GL_OES_fixed_point", "GL_OES_single_precision", "GL_OES_matrix_get",
        "GL_OES_read_format", "GL_OES_compressed_paletted_texture", "GL_OES_point_size_array",
        "GL_OES_point_sprite"}) {
    EXPECT_NE((" " + extensions + " ").find(std::string(" ") + required + " "), std::string::npos)
        << required;
  }
}

TEST_F(StateSetting, ContextsAreApart) {
  ContextPtr other = createContext(device, context.get(), {});
  glLineWidth(5);
  makeCurrent(other.get());
  EXPECT_EQ(device.log.flushes, 1);  // the former context's
  EXPECT_EQ(integer(GL_LINE_WIDTH), 1);
  makeCurrent(context.get());
  EXPECT_EQ(integer(GL_LINE_WIDTH), 5);
}

}  // namespace anteroom::gl::test
