// The decoders of compressed formats with random bytes and sizes, between pages that cannot be touched: a
// read or write beyond either end of an image ends the test.
#include "layer/gl/textures/compressed.h"

#include <sys/mman.h>
#include <unistd.h>

#include "textures_fixture.h"

namespace anteroom::test {
namespace {

using gl::CompressedFormat;

// Bytes that end, or begin, at a page that cannot be touched.
class Guarded {
 public:
  Guarded(size_t size, bool atEnd) : page_(static_cast<size_t>(sysconf(_SC_PAGESIZE))) {
    const size_t inner = (size + page_ - 1) / page_ * page_;
    length_ = inner + 2 * page_;
    void* mapped = mmap(nullptr, length_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    base_ = static_cast<uint8_t*>(mapped);
    mprotect(base_ + page_, inner, PROT_READ | PROT_WRITE);
    data_ = base_ + page_ + (atEnd ? inner - size : 0);
  }
  ~Guarded() { munmap(base_, length_); }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;
  uint8_t* data() const { return data_; }

 private:
  size_t page_, length_ = 0;
  uint8_t* base_ = nullptr;
  uint8_t* data_ = nullptr;
};

TEST(CompressedTextures, DecodersStayInside) {
  std::minstd_rand random(5);
  for (const CompressedFormat& format : gl::compressedFormats()) {
    for (int round = 0; round < 200; ++round) {
      int width = static_cast<int>(random() % 70 + 1), height = static_cast<int>(random() % 70 + 1);
      if (!format.decodeBlock) {  // PVRTC
        width = 1 << random() % 7;
        height = 1 << random() % 7;
      }
      SCOPED_TRACE(testing::Message()
                   << std::hex << format.name << std::dec << " " << width << "x" << height);
      const auto size = static_cast<size_t>(gl::compressedSize(format, width, height));
      const size_t texels = static_cast<size_t>(width) * static_cast<size_t>(height);
      const size_t bytes = texels * render::info(format.decoded).bytes;
      std::vector<uint8_t> former;
      for (const bool atEnd : {false, true}) {
        const Guarded in(size, atEnd), out(bytes, atEnd);
        const std::vector<uint8_t> data = noise(size, static_cast<unsigned>(round));
        std::memcpy(in.data(), data.data(), size);
        gl::decodeCompressed(format, in.data(), width, height, out.data());
        const std::vector<uint8_t> decoded(out.data(), out.data() + bytes);
        EXPECT_TRUE(!atEnd || decoded == former) << "bytes from elsewhere";
        former = decoded;
      }
    }
  }
}

// Every pattern of a block in the places that choose between modes.
TEST(CompressedTextures, EveryModeOfABlock) {
  std::minstd_rand random(6);
  for (const CompressedFormat& format : gl::compressedFormats()) {
    if (!format.decodeBlock) continue;
    for (int mode = 0; mode < 256; ++mode) {
      for (const size_t at : {size_t{0}, size_t{1}, size_t{3}}) {
        const Guarded block(format.blockBytes, mode % 2 == 0);
        for (size_t i = 0; i < format.blockBytes; ++i) block.data()[i] = static_cast<uint8_t>(random() >> 7);
        block.data()[at] = static_cast<uint8_t>(mode);
        const gl::TexelBlock texels = format.decodeBlock(block.data());
        if (format.base != GL_RGB) continue;
        const bool punched = format.name == GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
        for (const auto& texel : texels) EXPECT_TRUE(punched || texel[3] == 255);
      }
    }
  }
}

// Issue 6 of IMG_texture_compression_pvrtc, and the sizes of the other texts.
TEST(CompressedTextures, Sizes) {
  for (const CompressedFormat& format : gl::compressedFormats()) {
    for (const int width : {1, 2, 4, 8, 16, 64, 1024}) {
      for (const int height : {1, 2, 4, 8, 16, 64, 1024}) {
        int64_t expected = int64_t{(width + 3) / 4} * ((height + 3) / 4) * format.blockBytes;
        if (!format.decodeBlock) {
          expected = format.blockWidth == 4 ? (std::max(width, 8) * std::max(height, 8) * 4 + 7) / 8
                                            : (std::max(width, 16) * std::max(height, 8) * 2 + 7) / 8;
        }
        EXPECT_EQ(gl::compressedSize(format, width, height), expected) << width << "x" << height;
      }
    }
  }
}

}  // namespace
}  // namespace anteroom::test
