// Random texture and buffer commands with arguments from the edges, in two contexts that share, with a
// renderer that runs out of memory: no crash, no memory error (run it with the address sanitizer), nothing
// but GL's errors.
#include <chrono>

#include "layer/gl/textures/compressed.h"
#include "textures_fixture.h"

namespace anteroom::test {
namespace {

class RandomTextures : public TexturesTest {
 protected:
  unsigned next() { return static_cast<unsigned>(random_()); }
  template <size_t N>
  GLenum pick(const GLenum (&values)[N]) {
    return values[next() % N];
  }
  bool chance(unsigned percent) { return next() % 100 < percent; }

  // Client memory is as large as the largest legal image of these sizes.
  GLint size() {
    constexpr GLint kEdges[] = {0, 1, 2, 3, 4, 7, 8, 16, 17, 32, -1, 1024, 1025, INT32_MAX, INT32_MIN};
    return chance(97) ? kEdges[next() % 10] : kEdges[next() % std::size(kEdges)];
  }
  GLint offset() {
    constexpr GLint kEdges[] = {0, 1, 2, 3, 5, -1, -3, 30, 1000, INT32_MAX, INT32_MIN};
    return chance(90) ? kEdges[next() % 5] : kEdges[next() % std::size(kEdges)];
  }
  GLint level() {
    constexpr GLint kEdges[] = {0, 1, 2, 3, 4, 10, 11, -1, INT32_MAX, INT32_MIN};
    return chance(92) ? static_cast<GLint>(next() % 4) : kEdges[next() % std::size(kEdges)];
  }
  GLenum target() {
    constexpr GLenum kTargets[] = {GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP_OES};
    return chance(96) ? pick(kTargets) : next();
  }
  GLenum imageTarget() {
    if (chance(4)) return next() % 2 ? next() : GLenum{GL_TEXTURE_CUBE_MAP_OES};
    return chance(50) ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + next() % 6;
  }
  const Pair& pair() { return kPairs[next() % std::size(kPairs)]; }
  GLuint name() { return next() % (chance(95) ? 6 : 0xffffffffu); }
  const void* data() { return chance(5) ? nullptr : memory_.data() + next() % 3; }

  void texImage() {
    const Pair& p = pair();
    const GLint width = size();
    const GLint height = chance(60) ? width : size();
    const GLenum format = chance(97) ? p.format : next();
    // Nothing larger than client memory.
    const void* pixels = int64_t{width} * height > 64 * 64 ? nullptr : data();
    glTexImage2D(imageTarget(), level(), static_cast<GLint>(format), width, height, chance(98) ? 0 : 1,
                 p.format, chance(97) ? p.type : GLenum{GL_FLOAT}, pixels);
  }

  void compressed() {
    const GLenum format = chance(95) ? 0x8B90 + next() % 10 : next();
    const GLint width = size(), levels = static_cast<GLint>(next() % 4);
    GLint bytes = static_cast<GLint>(next() % 5000);
    if (format - 0x8B90 < 10 && width >= 0 && width <= 64) {
      const bool wide = format >= 0x8B95;
      constexpr GLint kEntry[] = {3, 4, 2, 2, 2};
      bytes = (wide ? 256 : 16) * kEntry[(format - 0x8B90) % 5];
      for (GLint l = 0; l <= levels; ++l) {
        const GLint w = width ? std::max(width >> l, 1) : 0;
        bytes += wide ? w * w : (w * w + 1) / 2;
      }
    }
    const std::vector<uint8_t> exact = noise(static_cast<size_t>(std::max(bytes, 0)), next());
    if (chance(80)) {
      glCompressedTexImage2D(imageTarget(), -levels, format, width, width, 0, bytes, exact.data());
    } else {
      glCompressedTexSubImage2D(imageTarget(), -levels, offset(), offset(), width, width, format, bytes,
                                exact.data());
    }
  }

  // Formats of extensions, and images that cannot be specified anew.
  void blocks() {
    const auto formats = gl::compressedFormats();
    const gl::CompressedFormat& format = formats[next() % formats.size()];
    const GLint width = size(), height = chance(60) ? width : size();
    const bool large = width < 0 || height < 0 || width > 64 || height > 64;
    const int64_t bytes = large ? 64 : gl::compressedSize(format, width, height);
    const std::vector<uint8_t> exact = noise(static_cast<size_t>(bytes), next());
    const GLsizei given = static_cast<GLsizei>(bytes) + (chance(3) ? 1 : 0);
    if (chance(60)) {
      glCompressedTexImage2D(imageTarget(), level(), format.name, width, height, chance(98) ? 0 : 1, given,
                             chance(95) ? exact.data() : nullptr);
    } else {
      glCompressedTexSubImage2D(imageTarget(), level(), offset() & ~3, offset() & ~3, width, height,
                                format.name, given, exact.data());
    }
  }

  void storage() {
    constexpr GLenum kInternal[] = {GL_RGBA8_OES, GL_RGB565_OES,    GL_ALPHA8_EXT,
                                    GL_BGRA8_EXT, GL_ETC1_RGB8_OES, GL_COMPRESSED_RGBA_PVRTC_2BPPV1_IMG,
                                    GL_RGBA4_OES, GL_3DC_XY_AMD};
    if (chance(50)) {
      return glTexStorage2DEXT(target(), static_cast<GLsizei>(next() % 6),
                               chance(97) ? pick(kInternal) : next(), size(), size());
    }
    glCopyTextureLevelsAPPLE(name(), name(), level(), static_cast<GLsizei>(next() % 4));
  }

  void otherTexels() {
    constexpr GLenum kFormats[] = {GL_BGRA_EXT, GL_SRGB_EXT, GL_SRGB_ALPHA_EXT, GL_RGBA, GL_RGB};
    constexpr GLenum kInternal[] = {GL_BGRA_EXT,  GL_SRGB_EXT,   GL_SRGB_ALPHA_EXT, GL_RGBA8_OES,
                                    GL_RGBA4_OES, GL_RGB565_OES, GL_RGB5_A1_OES,    GL_RGBA};
    const GLint width = size(), height = size();
    const void* pixels = int64_t{width} * height > 64 * 64 ? nullptr : data();
    if (chance(50)) {
      return glTexImage2D(imageTarget(), level(), static_cast<GLint>(pick(kInternal)), width, height, 0,
                          pick(kFormats), GL_UNSIGNED_BYTE, pixels);
    }
    glTexSubImage2D(imageTarget(), level(), offset(), offset(), width & 63, height & 63, pick(kFormats),
                    GL_UNSIGNED_BYTE, data());
  }

  void parameters() {
    constexpr GLenum kNames[] = {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S,
                                 GL_TEXTURE_WRAP_T,     GL_GENERATE_MIPMAP,    GL_TEXTURE_CROP_RECT_OES};
    constexpr GLenum kValues[] = {
        GL_NEAREST, GL_LINEAR,        GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR,
        GL_REPEAT,  GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT_OES,    0,
        1};
    const GLenum pname = chance(97) ? pick(kNames) : next();
    GLint values[4];
    GLfloat floats[4];
    for (size_t i = 0; i < 4; ++i) {
      values[i] = static_cast<GLint>(chance(95) ? pick(kValues) : next());
      floats[i] = chance(95) ? static_cast<GLfloat>(values[i]) : chance(50) ? NAN : INFINITY;
    }
    switch (next() % 9) {
      case 0:
        return glTexParameterf(target(), pname, floats[0]);
      case 1:
        return glTexParameterx(target(), pname, values[0]);
      case 2:
        return glTexParameteri(target(), pname, values[0]);
      case 3:
        return glTexParameterfv(target(), pname, chance(3) ? nullptr : floats);
      case 4:
        return glTexParameterxv(target(), pname, values);
      case 5:
        return glTexParameteriv(target(), pname, chance(3) ? nullptr : values);
      case 6:
        return glGetTexParameterfv(target(), pname, floats);
      case 7:
        return glGetTexParameterxv(target(), pname, values);
      default:
        return glGetTexParameteriv(target(), pname, values);
    }
  }

  void objects() {
    GLuint names[3] = {name(), name(), name()};
    const GLsizei n = chance(97) ? static_cast<GLsizei>(next() % 4) : -1;
    switch (next() % 7) {
      case 0:
        return glGenTextures(n, names);
      case 1:
        return chance(20) ? glDeleteTextures(n, names) : void();
      case 2:
        return (void)glIsTexture(names[0]);
      case 3:
        return glGenBuffers(n, names);
      case 4:
        return chance(20) ? glDeleteBuffers(n, names) : void();
      case 5:
        return (void)glIsBuffer(names[0]);
      default:
        return glActiveTexture(GL_TEXTURE0 + next() % 9);
    }
  }

  void buffers() {
    constexpr GLenum kTargets[] = {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER};
    const GLenum t = chance(97) ? pick(kTargets) : next();
    const GLsizeiptr bytes = chance(95)   ? static_cast<GLsizeiptr>(next() % 200)
                             : chance(50) ? -1
                                          : PTRDIFF_MAX - static_cast<GLsizeiptr>(next() % 8);
    GLint value;
    switch (next() % 4) {
      case 0:
        return glBindBuffer(t, name());
      case 1:
        return glBufferData(t, bytes, bytes > 200 ? nullptr : data(), chance(90) ? GL_STATIC_DRAW : next());
      case 2:
        return glBufferSubData(t, chance(90) ? offset() : PTRDIFF_MAX, bytes, data());
      default:
        return glGetBufferParameteriv(t, chance(50) ? GL_BUFFER_SIZE : next(), &value);
    }
  }

  void reads() {
    const Pair& p = pair();
    const GLsizei width = size(), height = size();
    const bool fits = width < 64 && height < 64;
    constexpr GLenum kReversed[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT,
                                    GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT};
    if (chance(30)) {
      return glReadPixels(offset(), offset(), width, height, GL_BGRA_EXT, pick(kReversed),
                          fits ? out_.data() : nullptr);
    }
    glReadPixels(offset(), offset(), width, height, chance(60) ? GL_RGBA : p.format,
                 chance(60) ? GL_UNSIGNED_BYTE : p.type, fits ? out_.data() : nullptr);
  }

  void step() {
    if (chance(1)) device.log.failAfter = static_cast<int>(next() % 6);
    const GLenum capability = chance(50) ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP_OES;
    switch (next() % 19) {
      case 0:
      case 1:
      case 2:
        return texImage();
      case 3:
      case 4: {
        const Pair& p = pair();
        return glTexSubImage2D(imageTarget(), level(), offset(), offset(), size() & 63, size() & 63, p.format,
                               p.type, data());
      }
      case 5:
        return glCopyTexImage2D(imageTarget(), level(), pair().format, offset(), offset(), size(), size(), 0);
      case 6:
        return glCopyTexSubImage2D(imageTarget(), level(), offset(), offset(), offset(), offset(), size(),
                                   size());
      case 7:
        return compressed();
      case 8:
        return parameters();
      case 9:
        return objects();
      case 10:
        return buffers();
      case 11:
        return reads();
      case 12:
        return glPixelStorei(chance(50) ? GL_PACK_ALIGNMENT : GL_UNPACK_ALIGNMENT,
                             static_cast<GLint>(next() % 10));
      case 13:
        return chance(70) ? glEnable(capability) : glDisable(capability);
      case 14:
        return glBindTexture(target(), name());
      case 15:
        return blocks();
      case 16:
        return storage();
      case 17:
        return otherTexels();
      default:
        return glDrawArrays(GL_TRIANGLES, 0, 3);
    }
  }

  std::minstd_rand random_{99};
  std::vector<uint8_t> memory_ = noise(64 * 64 * 8, 1);
  std::vector<uint8_t> out_ = std::vector<uint8_t>(64 * 64 * 8);
};

TEST_F(RandomTextures, NothingBreaks) {
  ContextPtr other = gl::createContext(device, context.get(), {});
  render::Framebuffer framebuffer;
  framebuffer.color.image = color;
  framebuffer.width = kWidth;
  framebuffer.height = kHeight;
  gl::setDefaultFramebuffer(*other, &framebuffer);
  gl::makeCurrent(other.get());
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kPositions);

  const auto pbuffer = device.createImage({.format = render::Format::RGBA8, .width = 16, .height = 16});
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);
  for (int i = 0; i < 400000 && std::chrono::steady_clock::now() < end; ++i) {
    if (i % 64 == 0) {
      gl::Context* c = chance(50) ? context.get() : other.get();
      gl::makeCurrent(c);
      if (chance(20)) gl::bindTexImage(*c, GL_TEXTURE_2D, pbuffer, chance(50));
      if (chance(20)) gl::releaseTexImage(*c, pbuffer);
    }
    step();
    const GLenum error = glGetError();
    ASSERT_TRUE(error == GL_NO_ERROR || (error >= GL_INVALID_ENUM && error <= GL_INVALID_OPERATION) ||
                error == GL_OUT_OF_MEMORY)
        << std::hex << error;
    if (HasFailure()) FAIL() << "step " << i;
  }
  device.log.failAfter = -1;
  gl::makeCurrent(nullptr);
  other.reset();
  context.reset();
  EXPECT_EQ(pbuffer.use_count(), 1);
  EXPECT_EQ(device.log.liveImages, 1);
}

}  // namespace
}  // namespace anteroom::test
