// Objects of share groups, used, changed and deleted from several threads at once.
#include <atomic>
#include <barrier>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "fixture.h"

namespace threads {
namespace {

// A context draws without a pause while others join its group and leave it.
TEST(ShareGroups, CompanyComesAndGoes) {
  const Place first;
  ASSERT_TRUE(first.enter());
  std::atomic<bool> done = false;
  const auto work = [](unsigned number) {
    const Color color = colorOf(number);
    const GLuint texture = makeTexture(color);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, 64, nullptr, GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    EXPECT_EQ(pictureOf(texture), color);
    glDeleteTextures(1, &texture);
    glDeleteBuffers(1, &buffer);
  };
  std::thread guest([&] {
    for (int round = 0; round < 60 * effort(); ++round) {
      const Place other(first.context());
      ASSERT_TRUE(other.enter());
      for (unsigned i = 0; i < 3; ++i) work(i + 7);
      EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
    done = true;
  });
  for (unsigned i = 0; !done; ++i) work(i);
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  guest.join();
}

// What one thread of a share group hands to another.
struct Gift {
  enum class Kind { Texture, Rendered, Renderbuffer, Buffer, Image };
  Kind kind = Kind::Texture;
  GLuint name = 0, framebuffer = 0;
  EGLImage image = EGL_NO_IMAGE;
  Color color;
  EGLSync fence = EGL_NO_SYNC;
};

class Mailbox {
 public:
  void put(const Gift& gift) {
    const std::lock_guard lock(mutex_);
    gifts_.push_back(gift);
  }
  std::optional<Gift> take() {
    const std::lock_guard lock(mutex_);
    if (gifts_.empty()) return {};
    const Gift gift = gifts_.front();
    gifts_.pop_front();
    return gift;
  }

 private:
  std::mutex mutex_;
  std::deque<Gift> gifts_;
};

GLuint framebufferOn(GLuint texture, GLuint renderbuffer) {
  GLuint name = 0;
  gl().genFramebuffers(1, &name);
  gl().bindFramebuffer(GL_FRAMEBUFFER_OES, name);
  if (texture != 0)
    gl().framebufferTexture2D(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, texture, 0);
  else
    gl().framebufferRenderbuffer(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_RENDERBUFFER_OES,
                                 renderbuffer);
  EXPECT_EQ(gl().checkFramebufferStatus(GL_FRAMEBUFFER_OES), GLenum{GL_FRAMEBUFFER_COMPLETE_OES});
  return name;
}

// Four corners, and the color of each.
struct Corner {
  GLbyte x, y, unused[2];
  Color color;
};
std::array<Corner, 4> cornersIn(Color color) {
  return {{{-1, -1, {}, color}, {1, -1, {}, color}, {-1, 1, {}, color}, {1, 1, {}, color}}};
}

void make(Gift& gift) {
  switch (gift.kind) {
    case Gift::Kind::Texture:
      gift.name = makeTexture(gift.color);
      break;
    case Gift::Kind::Rendered:
      gift.name = makeTexture({}, kSize);
      gift.framebuffer = framebufferOn(gift.name, 0);
      pictureIn(gift.color);
      gl().bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
      break;
    case Gift::Kind::Renderbuffer:
      gl().genRenderbuffers(1, &gift.name);
      gl().bindRenderbuffer(GL_RENDERBUFFER_OES, gift.name);
      gl().renderbufferStorage(GL_RENDERBUFFER_OES, GL_RGBA8_OES, kSize, kSize);
      gift.framebuffer = framebufferOn(0, gift.name);
      clear(gift.color);
      gl().bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
      break;
    case Gift::Kind::Buffer: {
      const auto corners = cornersIn(gift.color);
      glGenBuffers(1, &gift.name);
      glBindBuffer(GL_ARRAY_BUFFER, gift.name);
      glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
      glBindBuffer(GL_ARRAY_BUFFER, 0);
      break;
    }
    case Gift::Kind::Image: {
      const GLuint texture = makeTexture(gift.color);
      gift.image =
          eglCreateImage(display(), eglGetCurrentContext(), EGL_GL_TEXTURE_2D,
                         reinterpret_cast<EGLClientBuffer>(static_cast<uintptr_t>(texture)), nullptr);
      EXPECT_NE(gift.image, EGL_NO_IMAGE);
      glDeleteTextures(1, &texture);
      break;
    }
  }
  gift.fence = eglCreateSync(display(), EGL_SYNC_FENCE, nullptr);
  EXPECT_NE(gift.fence, EGL_NO_SYNC);
}

Color pictureFromBuffer(GLuint name) {
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(2, GL_BYTE, sizeof(Corner), nullptr);
  glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Corner), reinterpret_cast<void*>(offsetof(Corner, color)));
  clear({});
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDisableClientState(GL_COLOR_ARRAY);
  return pixel();
}

// Looks at it; with `change` gives it another color, too.
void use(Gift& gift, bool change) {
  EXPECT_EQ(eglClientWaitSync(display(), gift.fence, 0, EGL_FOREVER), EGL_CONDITION_SATISFIED);
  EXPECT_TRUE(eglDestroySync(display(), gift.fence));
  const Color next = colorOf(gift.color.r + gift.color.g + 3u);
  switch (gift.kind) {
    case Gift::Kind::Texture:
      EXPECT_EQ(pictureOf(gift.name), gift.color);
      if (change) specify(next, 8);
      break;
    case Gift::Kind::Rendered:
      EXPECT_EQ(pictureOf(gift.name), gift.color);
      glBindTexture(GL_TEXTURE_2D, 0);
      if (!change) break;
      gl().bindFramebuffer(GL_FRAMEBUFFER_OES, gift.framebuffer);
      EXPECT_EQ(pictureIn(next), next);
      gl().bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
      break;
    case Gift::Kind::Renderbuffer:
      gl().bindFramebuffer(GL_FRAMEBUFFER_OES, gift.framebuffer);
      EXPECT_EQ(pixel(), gift.color);
      if (change) {
        EXPECT_EQ(pictureIn(next), next);
      }
      gl().bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
      break;
    case Gift::Kind::Buffer:
      EXPECT_EQ(pictureFromBuffer(gift.name), gift.color);
      if (change) {
        const auto corners = cornersIn(next);
        glBindBuffer(GL_ARRAY_BUFFER, gift.name);
        glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof corners, corners.data());
        glBindBuffer(GL_ARRAY_BUFFER, 0);
      }
      break;
    case Gift::Kind::Image: {
      GLuint texture = 0;
      glGenTextures(1, &texture);
      glBindTexture(GL_TEXTURE_2D, texture);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      gl().imageTargetTexture2D(GL_TEXTURE_2D, gift.image);
      EXPECT_EQ(pictureOf(texture), gift.color);
      if (change) {
        const std::vector<Color> texels(16, next);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
      }
      glDeleteTextures(1, &texture);
      break;
    }
  }
  if (!change) return;
  gift.color = next;
  gift.fence = eglCreateSync(display(), EGL_SYNC_FENCE, nullptr);
}

void destroy(const Gift& gift) {
  if (gift.framebuffer != 0) gl().deleteFramebuffers(1, &gift.framebuffer);
  switch (gift.kind) {
    case Gift::Kind::Texture:
    case Gift::Kind::Rendered:
      return glDeleteTextures(1, &gift.name);
    case Gift::Kind::Renderbuffer:
      return gl().deleteRenderbuffers(1, &gift.name);
    case Gift::Kind::Buffer:
      return glDeleteBuffers(1, &gift.name);
    case Gift::Kind::Image:
      EXPECT_TRUE(eglDestroyImage(display(), gift.image));
  }
}

// Two groups of three threads, each with two contexts. Objects are made in one thread, looked at and changed
// in another, looked at and deleted in a third; images go from group to group.
TEST(ShareGroups, ObjectsGoFromHandToHand) {
  constexpr int kGroups = 2, kEach = 3;
  const Place roots[kGroups];
  Mailbox made[kGroups], changed[kGroups], images, changedImages;
  inThreads(kGroups * kEach, [&](int number) {
    const int group = number % kGroups;
    const Place places[2] = {Place(roots[group].context()), Place(roots[group].context())};
    std::minstd_rand random(static_cast<unsigned>(number) + 1);
    for (int i = 0; i < 60 * effort(); ++i) {
      ASSERT_TRUE(places[random() % 2].enter());
      Gift gift;
      gift.kind = static_cast<Gift::Kind>(random() % 5);
      gift.color = colorOf(static_cast<unsigned>(random() % 200));
      const bool image = gift.kind == Gift::Kind::Image;
      make(gift);
      (image ? images : made[group]).put(gift);
      const bool anyImage = random() % 2;
      if (auto second = (anyImage ? images : made[group]).take()) {
        use(*second, true);
        (anyImage ? changedImages : changed[group]).put(*second);
      }
      if (auto third = (anyImage ? changedImages : changed[group]).take()) {
        use(*third, false);
        destroy(*third);
      }
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    eglReleaseThread();
  });
  ASSERT_TRUE(roots[0].enter());
  for (Mailbox* left : {&images, &changedImages})
    while (auto gift = left->take()) {
      use(*gift, false);
      destroy(*gift);
    }
  EXPECT_EQ(eglGetError(), EGL_SUCCESS);
}

// Appendix C of the specification of ES 1.1: what is bound lives on, whoever deletes its name.
TEST(ShareGroups, DeletedWhileBoundElsewhere) {
  const Place root;
  std::barrier meet(2);
  GLuint shared = 0;
  const Color kept = colorOf(17);
  inThreads(2, [&](int number) {
    const Place place(root.context());
    ASSERT_TRUE(place.enter());
    for (int round = 0; round < 15 * effort(); ++round) {
      if (number == 0) {
        shared = makeTexture(kept);
        pictureOf(shared);
      }
      meet.arrive_and_wait();
      if (number == 1) {
        glDeleteTextures(1, &shared);
        for (unsigned i = 0; i < 6; ++i) {
          const GLuint another = makeTexture(colorOf(i + 40));  // of the same name, the first time
          EXPECT_EQ(pictureOf(another), colorOf(i + 40));
          glDeleteTextures(1, &another);
        }
      } else {
        glEnable(GL_TEXTURE_2D);
        for (int i = 0; i < 10; ++i) {
          clear({});
          drawQuad();
          EXPECT_EQ(pixel(), kept);
        }
      }
      meet.arrive_and_wait();
    }
  });
}

// Without any order between the threads there is still none but the colors that were given.
TEST(ShareGroups, ChangedWhileInUse) {
  const Place root;
  ASSERT_TRUE(root.enter());
  const Color first = colorOf(1), second = colorOf(29);
  const GLuint texture = makeTexture(first, kSize);
  const GLuint framebuffer = framebufferOn(texture, 0);
  gl().bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
  Gift buffer;
  buffer.kind = Gift::Kind::Buffer;
  buffer.color = first;
  make(buffer);
  eglDestroySync(display(), buffer.fence);
  glFinish();
  root.leave();
  const auto known = [&](Color c) { return c == first || c == second || c == Color{}; };
  inThreads(4, [&](int number) {
    const Place place(root.context());
    ASSERT_TRUE(place.enter());
    for (int i = 0; i < 60 * effort(); ++i) {
      const Color color = i % 2 ? first : second;
      const auto corners = cornersIn(color);
      switch (number) {
        case 0:
          EXPECT_TRUE(known(pictureOf(texture)));
          EXPECT_TRUE(known(pictureFromBuffer(buffer.name)));
          break;
        case 1:
          glBindTexture(GL_TEXTURE_2D, texture);
          specify(color, i % 3 ? kSize : 4);
          glFlush();
          break;
        case 2:
          gl().bindFramebuffer(GL_FRAMEBUFFER_OES, framebuffer);
          if (gl().checkFramebufferStatus(GL_FRAMEBUFFER_OES) == GL_FRAMEBUFFER_COMPLETE_OES) {
            clear(color);
            const Color got = pixel();
            // The texture may be too small to have such a pixel: then nothing was read.
            EXPECT_TRUE(known(got) || got == (Color{0, 0, 0, 0})) << got;
          }
          break;
        default:
          glBindBuffer(GL_ARRAY_BUFFER, buffer.name);
          if (i % 3)
            glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof corners, corners.data());
          else
            glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_DYNAMIC_DRAW);
      }
    }
    EXPECT_TRUE(number == 2 || glGetError() == GL_NO_ERROR);
  });
}

// A context reads what it drew itself, although another has used the same texture since.
TEST(ShareGroups, OwnDrawingIsReadBack) {
  const Place root;
  std::barrier meet(2);
  std::atomic<GLuint> shared = 0;
  inThreads(2, [&](int number) {
    const Place place(root.context());
    ASSERT_TRUE(place.enter());
    if (number == 0) {
      const GLuint texture = makeTexture({}, kSize);
      framebufferOn(texture, 0);
      clear(colorOf(3));
      glFinish();
      shared = texture;
    }
    meet.arrive_and_wait();
    for (unsigned i = 0; i < 10; ++i) {
      if (number == 0) {  // recorded, not submitted
        glColor4ub(colorOf(i).r, colorOf(i).g, colorOf(i).b, 255);
        drawQuad();
      }
      meet.arrive_and_wait();
      if (number == 1) {
        glBindTexture(GL_TEXTURE_2D, shared);
        glEnable(GL_TEXTURE_2D);
        drawQuad();
      }
      meet.arrive_and_wait();
      if (number == 0) {
        EXPECT_EQ(pixel(), colorOf(i));
      }
      meet.arrive_and_wait();
    }
  });
}

// Images come and go in one context before any command uses them, while another submits without a pause.
TEST(ShareGroups, ShortLivedImages) {
  const Place first, second;
  std::atomic<bool> done = false;
  std::thread other([&] {
    ASSERT_TRUE(second.enter());
    for (unsigned i = 0; !done; ++i) {
      EXPECT_EQ(pictureIn(colorOf(i)), colorOf(i));
    }
    second.leave();
  });
  ASSERT_TRUE(first.enter());
  glEnable(GL_TEXTURE_2D);
  for (int i = 0; i < 300 * effort(); ++i) {
    GLuint texture = makeTexture(colorOf(static_cast<unsigned>(i)));
    // A framebuffer object asks for an image, and nothing is drawn to it.
    GLuint framebuffer = framebufferOn(texture, 0);
    GLubyte texel[4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    gl().deleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
  }
  done = true;
  other.join();
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace threads
