// Random texture commands, with a plain model of what every texel must be; whatever is sampled must agree.
#include <map>
#include <optional>

#include "textures_fixture.h"

namespace anteroom::test {
namespace {

using Known = std::optional<Texel>;  // nullopt: undefined

// Components are 0 or 255 in textures that mix types: every format holds these exactly.
struct ModelLevel {
  int width = 0, height = 0;
  GLenum internalFormat = 1;
  GLenum base = 1;
  std::vector<Known> texels;

  Known& at(int x, int y) { return texels[static_cast<size_t>(y * width + x)]; }
};

Texel reduce(GLenum base, const Texel& t) {
  switch (base) {
    case GL_ALPHA:
      return {0, 0, 0, t[3]};
    case GL_LUMINANCE:
      return {t[0], t[0], t[0], 255};
    case GL_LUMINANCE_ALPHA:
      return {t[0], t[0], t[0], t[3]};
    case GL_RGB:
      return {t[0], t[1], t[2], 255};
    default:
      return t;
  }
}

struct ModelTexture {
  explicit ModelTexture(bool isCube) : cube(isCube), levels(static_cast<size_t>(isCube ? 6 : 1)) {}

  bool cube;
  bool generate = false;
  GLenum minFilter = GL_NEAREST_MIPMAP_LINEAR;
  int nominalSize[2] = {8, 8};  // what most commands agree on
  GLenum nominalFormat = GL_RGBA;
  std::vector<std::array<ModelLevel, 12>> levels;

  bool mipmapped() const { return minFilter != GL_NEAREST && minFilter != GL_LINEAR; }
  static int chain(const ModelLevel& base) {
    int count = 1;
    for (int size = std::max(base.width, base.height); size > 1; size /= 2) ++count;
    return count;
  }

  bool complete() const {
    const ModelLevel& first = levels[0][0];
    for (const auto& face : levels) {
      const ModelLevel& base = face[0];
      if (base.width <= 0 || base.height <= 0) return false;
      if (base.width != first.width || base.height != first.height) return false;
      if (base.internalFormat != first.internalFormat) return false;
      for (int l = 1; mipmapped() && l < chain(base); ++l) {
        const ModelLevel& level = face[static_cast<size_t>(l)];
        if (level.internalFormat != base.internalFormat) return false;
        if (level.width != std::max(base.width / (1 << l), 1)) return false;
        if (level.height != std::max(base.height / (1 << l), 1)) return false;
      }
    }
    return true;
  }

  void baseChanged(int face) {
    ModelLevel& base = levels[static_cast<size_t>(face)][0];
    if (!generate || base.internalFormat != base.base || base.width == 0 || base.height == 0) return;
    for (int l = 1; l < chain(base); ++l) {
      ModelLevel& above = levels[static_cast<size_t>(face)][static_cast<size_t>(l - 1)];
      ModelLevel level{
          std::max(above.width / 2, 1), std::max(above.height / 2, 1), base.internalFormat, base.base, {}};
      for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x) {
          Known sum = Texel{};
          for (int k = 0; k < 4; ++k) {
            const Known t =
                above.at(std::min(2 * x + k % 2, above.width - 1), std::min(2 * y + k / 2, above.height - 1));
            for (size_t i = 0; sum && t && i < 4; ++i) (*sum)[i] += (*t)[i];
            if (!t) sum.reset();
          }
          for (size_t i = 0; sum && i < 4; ++i) (*sum)[i] /= 4;
          level.texels.push_back(sum ? Known(reduce(base.base, *sum)) : sum);
        }
      }
      levels[static_cast<size_t>(face)][static_cast<size_t>(l)] = std::move(level);
    }
  }
};

class TextureModel : public TexturesTest {
 protected:
  static constexpr GLuint kTextures = 5;  // the last two are cube maps; the even ones generate mipmaps

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool chance(int percent) { return below(100) < percent; }
  Texel randomTexel() { return {below(2) * 255, below(2) * 255, below(2) * 255, below(2) * 255}; }

  GLenum bind(GLuint name) {
    const GLenum target = models_.at(name).cube ? GL_TEXTURE_CUBE_MAP_OES : GL_TEXTURE_2D;
    glBindTexture(target, name);
    return target;
  }

  // Runs a command that may run out of memory; true: it took effect.
  bool attempt(const std::function<void()>& command) {
    if (chance(15)) device.log.failAfter = below(4);
    command();
    device.log.failAfter = -1;
    const GLenum error = glGetError();
    EXPECT_TRUE(error == GL_NO_ERROR || error == GL_OUT_OF_MEMORY) << std::hex << error;
    return error == GL_NO_ERROR;
  }

  void step() {
    name_ = 1 + static_cast<GLuint>(below(kTextures));
    texture_ = &models_.at(name_);
    target_ = bind(name_);
    face_ = texture_->cube ? below(6) : 0;
    imageTarget_ =
        texture_->cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + static_cast<GLenum>(face_) : GL_TEXTURE_2D;
    const int kind = below(100);
    if (kind < 30) return specify();
    if (kind < 45) return replace();
    if (kind < 55) return copy();
    if (kind < 65) return copySub();
    if (kind < 70) return paletted();
    if (kind < 76) return parameter();
    if (kind < 78) return remove();
    check();
  }

  GLenum randomFormat() {
    constexpr GLenum kFormats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA};
    return chance(80) ? texture_->nominalFormat : kFormats[below(5)];
  }
  void randomSize(int& level, int& width, int& height) {
    level = chance(40) ? 0 : below(4);
    if (level == 0 && face_ == 0 && chance(10)) {
      texture_->nominalSize[0] = 1 + below(9);
      texture_->nominalSize[1] = texture_->cube ? texture_->nominalSize[0] : 1 + below(9);
    }
    width = std::max(texture_->nominalSize[0] >> level, 1);
    height = std::max(texture_->nominalSize[1] >> level, 1);
    if (chance(8)) width = height = below(10);
  }
  const Pair& randomPair(GLenum format) {
    for (;;) {
      const Pair& pair = kPairs[below(8)];
      if (pair.format == format && (pair.element == 1 || name_ % 2 == 1)) return pair;
    }
  }

  std::vector<uint8_t> randomPixels(const Pair& pair, int width, int height, std::vector<Known>& texels) {
    const size_t bytes = pair.element * pair.perTexel;
    std::vector<uint8_t> pixels(static_cast<size_t>(width * height) * bytes);
    for (size_t i = 0; i < static_cast<size_t>(width * height); ++i) {
      const Texel t = randomTexel();
      encodeTexel(pair.stored, t, &pixels[i * bytes]);
      texels.emplace_back(reduce(pair.format, t));
    }
    return pixels;
  }

  ModelLevel& level(int l) { return texture_->levels[static_cast<size_t>(face_)][static_cast<size_t>(l)]; }
  void store(int l, ModelLevel&& specified) {
    level(l) = std::move(specified);
    if (l == 0) texture_->baseChanged(face_);
  }

  void specify() {
    int l, width, height;
    randomSize(l, width, height);
    const Pair& pair = randomPair(randomFormat());
    ModelLevel specified{width, height, pair.format, pair.format, {}};
    const bool null = chance(15);
    std::vector<uint8_t> pixels = randomPixels(pair, width, height, specified.texels);
    if (null) specified.texels.assign(specified.texels.size(), {});
    // Null pixels leave a level's texels undefined: also those that it had.
    const void* data = null ? nullptr : pixels.data();
    if (attempt([&] {
          glTexImage2D(imageTarget_, l, static_cast<GLint>(pair.format), width, height, 0, pair.format,
                       pair.type, data);
        })) {
      store(l, std::move(specified));
    }
  }

  void replace() {
    const int l = below(4);
    ModelLevel& old = level(l);
    if (old.internalFormat != old.base || old.texels.empty()) return;
    const int width = chance(30) ? old.width : below(old.width + 1);
    const int height = chance(30) ? old.height : below(old.height + 1);
    const int x = below(old.width - width + 1), y = below(old.height - height + 1);
    const Pair& pair = randomPair(old.base);
    std::vector<Known> texels;
    const std::vector<uint8_t> pixels = randomPixels(pair, width, height, texels);
    if (!attempt([&] {
          glTexSubImage2D(imageTarget_, l, x, y, width, height, pair.format, pair.type, pixels.data());
        })) {
      return;
    }
    for (int i = 0; i < width * height; ++i)
      old.at(x + i % width, y + i / width) = texels[static_cast<size_t>(i)];
    if (l == 0 && width * height > 0) texture_->baseChanged(face_);
  }

  Known framebufferAt(int x, int y) {
    if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) return {};
    return color->texel(0, 0, x, y);
  }

  void copy() {
    int l, width, height;
    randomSize(l, width, height);
    const GLenum format = randomFormat();
    const int x = below(kWidth + 4) - 4, y = below(kHeight + 4) - 4;
    if (!attempt([&] { glCopyTexImage2D(imageTarget_, l, format, x, y, width, height, 0); })) return;
    ModelLevel specified{width, height, format, format, {}};
    for (int i = 0; i < width * height; ++i) {
      const Known t = framebufferAt(x + i % width, y + i / width);
      specified.texels.push_back(t ? Known(reduce(format, *t)) : t);
    }
    store(l, std::move(specified));
  }

  void copySub() {
    const int l = below(4);
    ModelLevel& old = level(l);
    if (old.internalFormat != old.base || old.texels.empty()) return;
    const int width = below(old.width + 1), height = below(old.height + 1);
    const int tx = below(old.width - width + 1), ty = below(old.height - height + 1);
    const int x = below(kWidth + 4) - 4, y = below(kHeight + 4) - 4;
    if (!attempt([&] { glCopyTexSubImage2D(imageTarget_, l, tx, ty, x, y, width, height); })) return;
    for (int i = 0; i < width * height; ++i) {
      const Known t = framebufferAt(x + i % width, y + i / width);
      old.at(tx + i % width, ty + i / width) = t ? Known(reduce(old.base, *t)) : t;
    }
    if (l == 0 && width * height > 0) texture_->baseChanged(face_);
  }

  void paletted() {
    const GLenum internalFormat = GL_PALETTE8_RGBA8_OES;
    const int count = 1 + below(3);
    std::vector<Known> palette;
    const Pair& entries = kPairs[0];
    std::vector<uint8_t> data = randomPixels(entries, 256, 1, palette);
    std::vector<ModelLevel> specified;
    for (int l = 0; l < count; ++l) {
      ModelLevel next{std::max(texture_->nominalSize[0] >> l, 1),
                      std::max(texture_->nominalSize[1] >> l, 1),
                      internalFormat,
                      GL_RGBA,
                      {}};
      for (int i = 0; i < next.width * next.height; ++i) {
        const int index = below(256);
        data.push_back(static_cast<uint8_t>(index));
        next.texels.push_back(palette[static_cast<size_t>(index)]);
      }
      specified.push_back(std::move(next));
    }
    if (!attempt([&] {
          glCompressedTexImage2D(imageTarget_, 1 - count, internalFormat, specified[0].width,
                                 specified[0].height, 0, static_cast<GLsizei>(data.size()), data.data());
        })) {
      return;
    }
    for (int l = 0; l < count; ++l) store(l, std::move(specified[static_cast<size_t>(l)]));
  }

  void parameter() {
    if (name_ % 2 == 0 && chance(40)) {
      texture_->generate = chance(60);
      glTexParameteri(target_, GL_GENERATE_MIPMAP, texture_->generate);
      return;
    }
    constexpr GLenum kFilters[] = {GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR};
    texture_->minFilter = kFilters[below(4)];
    filter(target_, texture_->minFilter);
  }

  void remove() {
    glDeleteTextures(1, &name_);
    *texture_ = ModelTexture(texture_->cube);
    texture_->nominalFormat =
        std::array{GL_RGBA, GL_RGB, GL_LUMINANCE_ALPHA, GL_ALPHA}[static_cast<size_t>(below(4))];
    bind(name_);
  }

  void check() {
    glDisable(texture_->cube ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP_OES);
    glEnable(target_);
    FakeImage* image = nullptr;
    const bool drawn = attempt([&] { image = draw(); });
    ++checks;
    ASSERT_EQ(drawn && texture_->complete() ? image != nullptr : true, true);
    if (!image) return;
    ASSERT_TRUE(texture_->complete());
    ++sampled;
    const ModelLevel& base = texture_->levels[0][0];
    EXPECT_EQ(renderer(context).units[0].baseFormat, base.base);
    const int count = texture_->mipmapped() ? ModelTexture::chain(base) : 1;
    ASSERT_GE(image->desc().levels, count);
    ASSERT_EQ(image->desc().width, base.width);
    ASSERT_EQ(image->desc().height, base.height);
    for (int face = 0; face < image->layers(); ++face) {
      for (int l = 0; l < count; ++l) {
        ModelLevel& expected = texture_->levels[static_cast<size_t>(face)][static_cast<size_t>(l)];
        for (int i = 0; i < expected.width * expected.height; ++i) {
          const Known& t = expected.texels[static_cast<size_t>(i)];
          const int x = i % expected.width, y = i / expected.width;
          if (t) {
            ASSERT_EQ(image->texel(l, face, x, y), *t)
                << "texture " << name_ << " face " << face << " level " << l << " at " << x << ", " << y;
          }
        }
      }
    }
  }

  std::minstd_rand random_{20};
  std::map<GLuint, ModelTexture> models_;
  GLuint name_ = 1;
  ModelTexture* texture_ = nullptr;
  GLenum target_ = 0, imageTarget_ = 0;
  int face_ = 0;
  int checks = 0, sampled = 0;
};

TEST_F(TextureModel, SampledTexelsAreTheSpecifiedOnes) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) encodeTexel(render::Format::RGBA8, randomTexel(), color->at(0, 0, x, y));
  }
  for (GLuint name = 1; name <= kTextures; ++name) models_.emplace(name, ModelTexture(name > 3));
  for (int i = 0; i < 60000; ++i) {
    step();
    if (HasFatalFailure() || HasNonfatalFailure()) FAIL() << "step " << i;
  }
  // The walk has to reach what it is for.
  EXPECT_GT(sampled, checks / 10);
  EXPECT_GT(device.log.mipmaps, 500);
  EXPECT_GT(device.log.levelCopies, 500);
  for (GLuint name = 1; name <= kTextures; ++name) glDeleteTextures(1, &name);
  draw();
  EXPECT_EQ(device.log.liveImages, 0);
}

}  // namespace
}  // namespace anteroom::test
