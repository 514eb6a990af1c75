#include "reflect.h"

#include <GLES/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>

#include "dynamic_cubemap.h"
#include "moving_light.h"
#include "room/overlay.h"
#include "room/passes.h"

namespace reflect {
namespace {

constexpr std::array<std::string_view, 4> kStages = {"scene", "proxy", "faces", "final"};
constexpr std::array<std::string_view, 6> kFaceNames = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};

room::Camera cameraFor(const room::View& view) {
  const double turn = glm::two_pi<double>() * view.time;
  const double angle = glm::radians(4.0 + 16.0 * std::sin(turn / 33.0));
  const glm::dvec3 target(0.0, 0.60, -0.15);
  const glm::dvec3 eye = target + glm::dvec3(3.55 * std::sin(angle), 1.02 + 0.12 * std::sin(turn / 21.0),
                                             3.55 * std::cos(angle));
  return room::cameraAt(view, eye, target, 47, 0.1, 15.0);
}

class Reflect final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void configure(const room::Settings& settings) override { tellsCulled_ = settings.culled; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  void showFaces(const room::View& view);
  void drawRoom(const room::View& view, Version version) const;
  void drawOverlay(const room::View& view);

  std::optional<room::FramebufferFunctions> gl_;  // outlives what is made of it
  std::optional<DynamicCubemap> cubemap_;
  std::optional<room::Overlay> overlay_;
  std::optional<Playroom> playroom_;
  bool tellsCulled_ = false;
};

void Reflect::setup() {
  gl_.emplace("reflect");
  cubemap_.emplace(*gl_);
  overlay_.emplace();
  playroom_.emplace();
}

void Reflect::frame(const room::View& view, std::string_view stage) {
  const bool finished = stage == kStages.back();
  playroom_->animate(view.time);
  glClearColor(0, 0, 0, 1);
  if (finished) cubemap_->render(*playroom_, view.time);
  glViewport(0, 0, view.width, view.height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (stage == "faces") {
    showFaces(view);
  } else {
    drawRoom(view, stage == "proxy" ? Version::Proxy : Version::Fine);
    if (stage != "proxy") cubemap_->drawBall(cameraFor(view), finished);
  }
  if (finished && tellsCulled_) drawOverlay(view);
  room::resetPasses(kUnits);
}

// Two rows of three, each face upright with its name and what it leaves out above it.
void Reflect::showFaces(const room::View& view) {
  const glm::ivec2 cell(view.width / 3, view.height / 2);
  const int side = std::min(cell.x, cell.y * 8 / 9);
  const glm::ivec2 margin((cell.x - side) / 2, (cell.y - side) / 3);
  const auto corner = [&](int face) { return glm::ivec2(face % 3, 1 - face / 3) * cell + margin; };
  std::array<int, 6> culled{};
  for (int face = 0; face < 6; ++face) {
    const glm::ivec2 low = corner(face);
    glViewport(low.x, low.y, side, side);
    culled[static_cast<std::size_t>(face)] = drawFace(*playroom_, face, view.time, true);
  }
  glViewport(0, 0, view.width, view.height);
  room::resetPasses(kUnits);
  const double letter = cell.y / 32.0;
  for (int face = 0; face < 6; ++face) {
    const glm::dvec2 at = corner(face) + glm::ivec2(0, side);
    const auto i = static_cast<std::size_t>(face);
    overlay_->label(view, at + 0.8 * letter, letter,
                    fmt::format("{}: {} of {} culled", kFaceNames[i], culled[i], playroom_->things().size()));
  }
}

void Reflect::drawRoom(const room::View& view, Version version) const {
  const room::Camera camera = cameraFor(view);
  beginLit(camera, view.time);
  for (const Thing& thing : playroom_->things()) drawThing(camera, thing, version);
  drawThing(camera, playroom_->stand(), version);
}

void Reflect::drawOverlay(const room::View& view) {
  room::resetPasses(kUnits);
  const std::size_t all = playroom_->things().size();
  std::vector<std::string> lines;
  for (std::size_t face = 0; face < kFaceNames.size(); ++face) {
    lines.push_back(fmt::format("{}: {:2} of {} culled", kFaceNames[face], cubemap_->culled()[face], all));
  }
  overlay_->draw(view, lines);
}

}  // namespace

std::unique_ptr<room::Demo> makeReflect() {
  return std::make_unique<Reflect>();
}

}  // namespace reflect
