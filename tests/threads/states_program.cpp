// Draws many state mixes in several threads at once, each beside the pipelines that are made ahead, and
// prints a number that their pictures make. states_program [THREADS].
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "fixture.h"

namespace threads {
namespace {

constexpr unsigned kStates = 48;

void choose(unsigned state) {
  const auto set = [&](GLenum what, unsigned bit) { (state >> bit & 1 ? glEnable : glDisable)(what); };
  set(GL_FOG, 0);
  set(GL_TEXTURE_2D, 1);
  set(GL_LIGHTING, 2);
  set(GL_LIGHT0, 2);
  set(GL_ALPHA_TEST, 3);
  set(GL_BLEND, 3);
  glBlendFunc(GL_ONE, state & 8 ? GL_ONE_MINUS_SRC_ALPHA : GL_ZERO);
  glTexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, state & 16 ? GL_ADD : GL_MODULATE);
  glShadeModel(state & 32 ? GL_FLAT : GL_SMOOTH);
}

unsigned pictures(unsigned first) {
  unsigned sum = 0;
  const GLuint texture = makeTexture(colorOf(33));
  for (unsigned i = 0; i < kStates; ++i) {
    const unsigned state = (first + i * 5) % kStates;
    choose(state);
    glBindTexture(GL_TEXTURE_2D, texture);
    const Color got = pictureIn(colorOf(state));
    sum += (got.r + 256u * got.g + 65536u * got.b + got.a) * (state + 1);  // in whatever order
  }
  glDeleteTextures(1, &texture);
  return glGetError() == GL_NO_ERROR ? sum : 0;
}

}  // namespace

int effort() {
  return 1;
}

}  // namespace threads

int main(int argc, char** argv) {
  using namespace threads;
  const int count = argc == 2 ? std::atoi(argv[1]) : 1;
  if (count < 1 || count > 64) return 64;
  const Place root;
  std::vector<unsigned> sums(static_cast<size_t>(count));
  inThreads(count, [&](int number) {
    const Place place(number % 2 ? root.context() : EGL_NO_CONTEXT);
    if (place.enter()) sums[static_cast<size_t>(number)] = pictures(static_cast<unsigned>(number) * 7);
  });
  for (unsigned sum : sums)
    if (sum == 0 || sum != sums[0]) return 1;
  std::printf("%u\n", sums[0]);
  return 0;
}
