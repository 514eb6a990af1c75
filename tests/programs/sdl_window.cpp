// Two windows of SDL, one context that draws in both and another that shares its texture. Frames are shown in
// turns, the first window's first; halfway the second window takes on another size.
#include <GLES/gl.h>
#include <SDL.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string_view>
#include <utility>

#include "scene.h"

namespace {

constexpr int kFrames = 4;

template <class... Arguments>
[[noreturn]] void fail(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::print(stderr, "sdl_window: {}: {}\n", fmt::format(format, std::forward<Arguments>(arguments)...),
             SDL_GetError());
  std::exit(1);
}

void askForContext() {
  for (const auto& [attribute, value] :
       {std::pair{SDL_GL_CONTEXT_PROFILE_MASK, int(SDL_GL_CONTEXT_PROFILE_ES)},
        {SDL_GL_CONTEXT_MAJOR_VERSION, 1},
        {SDL_GL_CONTEXT_MINOR_VERSION, 1},
        {SDL_GL_RED_SIZE, 8},
        {SDL_GL_GREEN_SIZE, 8},
        {SDL_GL_BLUE_SIZE, 8},
        {SDL_GL_DEPTH_SIZE, 24},
        {SDL_GL_STENCIL_SIZE, 8},
        {SDL_GL_SHARE_WITH_CURRENT_CONTEXT, 1}}) {
    if (SDL_GL_SetAttribute(attribute, value) != 0) fail("attribute {}", int(attribute));
  }
}

void expectAttribute(SDL_GLattr attribute, int least) {
  int value = 0;
  if (SDL_GL_GetAttribute(attribute, &value) != 0 || value < least)
    fail("attribute {} is {}", int(attribute), value);
}

SDL_Window* openWindow(int x, int y, int width, int height) {
  SDL_Window* window =
      SDL_CreateWindow("sdl_window", x, y, width, height, SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
  if (!window) fail("no window");
  return window;
}

SDL_GLContext createContext(SDL_Window* window) {
  SDL_GLContext context = SDL_GL_CreateContext(window);
  if (!context) fail("no context");
  return context;
}

enum class Corners { Checked, Unknown };

void draw(SDL_Window* window, SDL_GLContext context, float turn, unsigned texture,
          Corners corners = Corners::Checked) {
  if (SDL_GL_MakeCurrent(window, context) != 0) fail("a context cannot be made current");
  int width = 0, height = 0;
  SDL_GL_GetDrawableSize(window, &width, &height);
  programs::drawScene(width, height, turn, texture);
  if (corners == Corners::Checked && !programs::cornersAreRight(width, height))
    fail("the picture does not fill the window");
  if (const GLenum error = glGetError()) fail("GL error {:#x}", error);
  SDL_GL_SwapWindow(window);
  for (SDL_Event event; SDL_PollEvent(&event);) {
  }
}

}  // namespace

int main(int, char**) {
  if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no window system");
  askForContext();
  SDL_Window* const first = openWindow(20, 20, 320, 240);
  SDL_GLContext const one = createContext(first);
  fmt::print("{}: {}, {}\n", SDL_GetCurrentVideoDriver(),
             reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
             reinterpret_cast<const char*>(glGetString(GL_VERSION)));
  if (!std::string_view(reinterpret_cast<const char*>(glGetString(GL_VERSION)))
           .starts_with("OpenGL ES-CM 1.1"))
    fail("another version");
  expectAttribute(SDL_GL_DEPTH_SIZE, 24);
  expectAttribute(SDL_GL_STENCIL_SIZE, 8);
  const unsigned texture = programs::uploadTexture();

  SDL_Window* const second = openWindow(400, 300, 200, 200);
  SDL_GLContext const other = createContext(second);
  for (int frame = 0; frame < kFrames; ++frame) {
    const float turn = 20.f * static_cast<float>(frame);
    if (SDL_GL_SetSwapInterval(frame % 2) != 0) fail("no swap interval {}", frame % 2);
    draw(first, one, turn, texture);
    draw(second, frame % 2 ? other : one, -turn, texture);
    if (frame != kFrames / 2) continue;
    SDL_SetWindowSize(second, 301, 150);
    SDL_PumpEvents();
    draw(second, other, 0, texture, Corners::Unknown);  // only with it the surface takes on the new size
  }
  SDL_GL_DeleteContext(one);
  draw(second, other, 45, texture);  // what a group shares lives on
  SDL_GL_DeleteContext(other);
  SDL_DestroyWindow(second);
  SDL_DestroyWindow(first);
  SDL_Quit();
}
