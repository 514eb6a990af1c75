// programs_on_screen PICTURE SHOT: waits until the picture can be seen on the screen, every pixel of it, at
// some place. SHOT is then what is at that place, or the whole screen if that did not happen.
#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <optional>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "native.h"
#include "picture_file.h"

namespace {

using Place = std::pair<int, int>;

// A few pixels of a picture tell most places at once that it is not there.
class Finder {
 public:
  explicit Finder(const windows::Image& picture) : picture_(picture) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> x(0, picture.width - 1), y(0, picture.height - 1);
    for (int i = 0; i < 256; ++i) samples_.emplace_back(x(random), y(random));
  }

  std::optional<Place> in(const windows::Image& screen) const {
    for (int y = 0; y + picture_.height <= screen.height; ++y)
      for (int x = 0; x + picture_.width <= screen.width; ++x)
        if (isAt(screen, x, y)) return Place(x, y);
    return std::nullopt;
  }

 private:
  bool isAt(const windows::Image& screen, int x, int y) const {
    for (const auto& [i, j] : samples_)
      if (screen.at(x + i, y + j) != picture_.at(i, j)) return false;
    return screen.part(x, y, picture_.width, picture_.height).pixels == picture_.pixels;
  }

  const windows::Image& picture_;
  std::vector<Place> samples_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: programs_on_screen PICTURE SHOT\n");
    return 2;
  }
  try {
    const auto platforms = windows::platforms();
    if (platforms.empty()) throw std::runtime_error("neither DISPLAY nor WAYLAND_DISPLAY is set");
    const auto display = windows::NativeDisplay::open(platforms.back());
    const windows::Image picture = programs::readPicture(argv[1]);
    const Finder finder(picture);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (true) {
      const windows::Image screen = display->screen();
      if (const auto place = finder.in(screen)) {
        programs::writePicture(argv[2],
                               screen.part(place->first, place->second, picture.width, picture.height));
        return 0;
      }
      if (std::chrono::steady_clock::now() > end) {
        programs::writePicture(argv[2], screen);
        fmt::print(stderr, "{} is not on the screen, which {} shows\n", argv[1], argv[2]);
        return 1;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "programs_on_screen: {}\n", error.what());
    return 2;
  }
}
