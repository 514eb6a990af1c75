// Contexts, surfaces, displays and threads that end while others use them.
#include <atomic>
#include <barrier>
#include <chrono>
#include <memory>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

#include "fixture.h"

namespace threads {
namespace {

// One context goes round, with what it has drawn.
TEST(Lives, ContextGoesRound) {
  constexpr int kThreads = 4;
  const Place place;
  GLuint texture = 0;
  ASSERT_TRUE(place.enter());
  texture = makeTexture(colorOf(5));
  clear(colorOf(0));
  place.leave();
  std::mutex mutex;
  unsigned drawn = 0;
  inThreads(kThreads, [&](int number) {
    for (int i = 0; i < 60 * effort(); ++i) {
      const std::lock_guard turn(mutex);
      ASSERT_TRUE(place.enter());
      EXPECT_EQ(pixel(), colorOf(drawn));
      EXPECT_EQ(pictureOf(texture), colorOf(5));
      ++drawn;
      EXPECT_EQ(pictureIn(colorOf(drawn)), colorOf(drawn));
      if ((i + number) % 3)
        place.leave();
      else
        eglReleaseThread();
    }
  });
}

// The same without turns: who cannot have it is told so.
TEST(Lives, ContextIsFoughtFor) {
  const Place place;
  std::atomic<int> had = 0;
  inThreads(4, [&](int number) {
    const Color own = colorOf(static_cast<unsigned>(number) * 7 + 1);
    for (int i = 0; i < 150 * effort(); ++i) {
      if (!place.enter()) {
        EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
        continue;
      }
      ++had;
      EXPECT_EQ(pictureIn(own), own);
      place.leave();
    }
  });
  EXPECT_GT(had, 0);
}

TEST(Lives, ManyContextsAThread) {
  const Place root;
  inThreads(3, [&](int number) {
    std::vector<std::unique_ptr<Place>> places;
    std::minstd_rand random(static_cast<unsigned>(number) + 5);
    std::vector<Color> drawn(6, Color{});
    for (int i = 0; i < 6; ++i) {
      places.push_back(std::make_unique<Place>(i % 2 ? root.context() : EGL_NO_CONTEXT));
      ASSERT_TRUE(places.back()->enter());
      clear({});
    }
    for (int i = 0; i < 80 * effort(); ++i) {
      const size_t which = random() % places.size();
      ASSERT_TRUE(places[which]->enter());
      EXPECT_EQ(pixel(), drawn[which]);
      drawn[which] = colorOf(static_cast<unsigned>(random() % 150));
      const GLuint texture = makeTexture(drawn[which]);
      EXPECT_EQ(pictureOf(texture), drawn[which]);
      glDeleteTextures(1, &texture);
    }
    // In another order than they were made, the current one among them.
    while (!places.empty()) places.erase(places.begin() + static_cast<long>(random() % places.size()));
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  });
}

// What is current somewhere lives on until it no longer is (section 3.7.3), though its handle is gone.
TEST(Lives, DestroyedWhileCurrentElsewhere) {
  const EGLDisplay on = display();
  for (int round = 0; round < 10 * effort(); ++round) {
    const Place root;
    std::atomic<EGLContext> context = EGL_NO_CONTEXT;
    std::atomic<EGLSurface> surface = EGL_NO_SURFACE;
    std::atomic<bool> destroyed = false;
    std::thread drawer([&, round] {
      const Place place(round % 2 ? root.context() : EGL_NO_CONTEXT);
      ASSERT_TRUE(place.enter());
      const GLuint texture = makeTexture(colorOf(9));
      surface = place.surface();
      context = place.context();
      for (int after = 0; after < 5; after += destroyed) EXPECT_EQ(pictureOf(texture), colorOf(9));
      if (round % 3 == 0) return;  // the thread ends with it, and Place finds nothing to destroy
      eglReleaseThread();
      EXPECT_FALSE(place.enter());
      EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
    });
    while (context == EGL_NO_CONTEXT) std::this_thread::yield();
    EXPECT_TRUE(eglDestroyContext(on, context));
    EXPECT_TRUE(eglDestroySurface(on, surface));
    destroyed = true;
    drawer.join();
  }
  EXPECT_EQ(eglGetError(), EGL_SUCCESS);
}

EGLDisplay otherDisplay() {
  const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  if (!query || !query(1, &device, &count) || count == 0) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

// Section 3.2: a display that is terminated takes nothing from who has something of it current.
TEST(Lives, DisplayEndsWhileOthersDraw) {
  const EGLDisplay on = otherDisplay();
  ASSERT_TRUE(eglInitialize(on, nullptr, nullptr));
  std::atomic<bool> done = false;
  std::atomic<int> drawn = 0;
  std::thread ender([&] {
    for (int i = 0; i < 4 * effort(); ++i) {
      const int before = drawn;
      while (drawn < before + 6) std::this_thread::yield();
      EXPECT_TRUE(eglTerminate(on));
      EXPECT_TRUE(eglInitialize(on, nullptr, nullptr));
    }
    done = true;
  });
  inThreads(3, [&](int number) {
    for (unsigned i = 0; !done; ++i) {
      const Place place(EGL_NO_CONTEXT, on);  // may come to nothing
      if (place.enter()) {
        const GLuint texture = makeTexture(colorOf(i));
        for (int j = 0; j < 3; ++j) EXPECT_EQ(pictureOf(texture), colorOf(i));
      }
      ++drawn;
      if (number == 0) eglReleaseThread();
    }
    eglReleaseThread();
  });
  ender.join();
  const Place place(EGL_NO_CONTEXT, on);
  ASSERT_TRUE(place.enter());
  EXPECT_EQ(pictureIn(colorOf(2)), colorOf(2));
  place.leave();
  EXPECT_TRUE(eglTerminate(on));
}

// Everybody initializes and terminates, as programs made of several libraries do. Nothing is promised but
// that it does not crash, and that the display is good in the end.
TEST(Lives, EverybodyInitializes) {
  const EGLDisplay on = otherDisplay();
  inThreads(4, [&](int number) {
    std::minstd_rand random(static_cast<unsigned>(number) + 11);
    for (int i = 0; i < 5 * effort(); ++i) {
      eglInitialize(on, nullptr, nullptr);
      const Place place(EGL_NO_CONTEXT, on);
      if (place.enter()) {
        EXPECT_EQ(pictureIn(colorOf(random() % 99)).a, 255);
        eglQueryString(on, EGL_EXTENSIONS);
      }
      if (random() % 2) eglReleaseThread();
      if (random() % 3 == 0) eglTerminate(on);
    }
    eglReleaseThread();
  });
  ASSERT_TRUE(eglInitialize(on, nullptr, nullptr));
  {
    const Place place(EGL_NO_CONTEXT, on);
    ASSERT_TRUE(place.enter());
    EXPECT_EQ(pictureIn(colorOf(2)), colorOf(2));
  }
  EXPECT_TRUE(eglTerminate(on));
}

// Threads that end with a context, without a word, give it back.
TEST(Lives, ThreadsEndWithTheirContexts) {
  const Place place;
  for (int i = 0; i < 30 * effort(); ++i) {
    std::thread([&] {
      ASSERT_TRUE(place.enter()) << i;
      EXPECT_EQ(pictureIn(colorOf(4)), colorOf(4));
    }).join();
  }
}

// Fences and reusable syncs wait for each other's threads, and are destroyed meanwhile.
TEST(Lives, SyncsBetweenThreads) {
  const EGLDisplay on = display();
  const Place root;
  ASSERT_NE(gl().createSyncKHR, nullptr);
  for (int round = 0; round < 20 * effort(); ++round) {
    const EGLSync gate = gl().createSyncKHR(on, EGL_SYNC_REUSABLE_KHR, nullptr);
    ASSERT_NE(gate, EGL_NO_SYNC);
    std::atomic<EGLSync> fence = EGL_NO_SYNC;
    inThreads(3, [&](int number) {
      if (number == 2) {
        while (fence == EGL_NO_SYNC) std::this_thread::yield();
        const EGLint waited = eglClientWaitSync(on, fence, 0, EGL_FOREVER);
        EXPECT_TRUE(waited == EGL_CONDITION_SATISFIED || eglGetError() == EGL_BAD_PARAMETER);
        if (round % 2)
          EXPECT_TRUE(gl().signalSyncKHR(on, gate, EGL_SIGNALED_KHR));
        else
          EXPECT_TRUE(eglDestroySync(on, gate));
        return;
      }
      const Place place(root.context());
      ASSERT_TRUE(place.enter());
      EXPECT_EQ(pictureIn(colorOf(6)), colorOf(6));
      if (number == 0) {
        fence = eglCreateSync(on, EGL_SYNC_FENCE, nullptr);
        EXPECT_EQ(pictureIn(colorOf(8)), colorOf(8));
      }
      const EGLint passed = eglClientWaitSync(on, gate, 0, EGL_FOREVER);
      EXPECT_TRUE(passed == EGL_CONDITION_SATISFIED || eglGetError() == EGL_BAD_PARAMETER);
      if (number == 0) {
        EXPECT_TRUE(eglDestroySync(on, fence));
      }
    });
    if (round % 2) {
      EXPECT_TRUE(eglDestroySync(on, gate));
    }
  }
}

// Section 3.6: a pbuffer's picture as a texture in another thread.
TEST(Lives, SurfacesAsTextures) {
  const EGLDisplay on = display();
  const EGLConfig config = configOf(on);
  const EGLint attributes[] = {EGL_WIDTH,
                               kSize,
                               EGL_HEIGHT,
                               kSize,  //
                               EGL_TEXTURE_FORMAT,
                               EGL_TEXTURE_RGBA,
                               EGL_TEXTURE_TARGET,
                               EGL_TEXTURE_2D,
                               EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface(on, config, attributes);
  ASSERT_NE(surface, EGL_NO_SURFACE);
  const Place painter, viewer;
  std::barrier meet(2);
  inThreads(2, [&](int number) {
    GLuint texture = 0;
    if (number == 1) {
      ASSERT_TRUE(viewer.enter());
      texture = makeTexture({});
    }
    for (unsigned i = 0; i < 20u * static_cast<unsigned>(effort()); ++i) {
      if (number == 0) {
        ASSERT_TRUE(eglMakeCurrent(on, surface, surface, painter.context()));
        EXPECT_EQ(pictureIn(colorOf(i)), colorOf(i));
        painter.leave();
      }
      meet.arrive_and_wait();
      if (number == 1) {
        glBindTexture(GL_TEXTURE_2D, texture);
        EXPECT_TRUE(eglBindTexImage(on, surface, EGL_BACK_BUFFER));
        EXPECT_EQ(pictureOf(texture), colorOf(i));
        EXPECT_TRUE(eglReleaseTexImage(on, surface, EGL_BACK_BUFFER));
      }
      meet.arrive_and_wait();
    }
    eglReleaseThread();
  });
  // Drawn to and sampled at once: its contents are undefined, nothing else is.
  std::atomic<bool> done = false;
  std::thread thread([&] {
    ASSERT_TRUE(eglMakeCurrent(on, surface, surface, painter.context()));
    for (unsigned i = 0; !done; ++i) pictureIn(colorOf(i));
    eglReleaseThread();
  });
  ASSERT_TRUE(viewer.enter());
  const GLuint texture = makeTexture({});
  for (int i = 0; i < 30 * effort(); ++i) {
    EXPECT_TRUE(eglBindTexImage(on, surface, EGL_BACK_BUFFER));
    pictureOf(texture);
    EXPECT_TRUE(eglReleaseTexImage(on, surface, EGL_BACK_BUFFER));
  }
  done = true;
  thread.join();
  viewer.leave();
  EXPECT_TRUE(eglDestroySurface(on, surface));
}

}  // namespace
}  // namespace threads
