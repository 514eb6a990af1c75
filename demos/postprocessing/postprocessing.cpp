#include "postprocessing.h"

#include <GLES/gl.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>
#include <string>

#include "bloom.h"
#include "room/context.h"
#include "room/passes.h"
#include "set/draw_chapel.h"

namespace postprocessing {
namespace {

constexpr std::array<std::string_view, 8> kStages = {"scene", "mask", "128",   "64",
                                                     "32",    "16",   "glare", "final"};
constexpr glm::dvec3 kGlareColor(0.92, 0.84, 0.66);

// Goes to and fro across the nave, so that columns, lamp and cross pass before the windows.
room::Camera cameraFor(const room::View& view) {
  const double turn = glm::two_pi<double>() * view.time;
  const glm::dvec3 eye(2.55 * std::sin(turn / 48.0 - 0.35), 1.78 + 0.12 * std::sin(turn / 19.0),
                       4.55 + 0.35 * std::cos(turn / 24.0));
  return room::cameraAt(view, eye, {0.16 * eye.x, 2.05, -6.0}, 46, 0.2, 20.0);
}

class Postprocessing final : public room::Demo {
 public:
  std::span<const std::string_view> stages() const override { return kStages; }
  void setup() override;
  void frame(const room::View& view, std::string_view stage) override;

 private:
  const room::RenderTarget* pictureOf(std::string_view stage) const;

  std::optional<room::FramebufferFunctions> gl_;  // outlives what is made of it
  std::optional<Bloom> bloom_;
  std::optional<Chapel> chapel_;
};

void Postprocessing::setup() {
  gl_.emplace("postprocessing");
  room::requireTextureUnits(kUnits, "postprocessing");
  bloom_.emplace(*gl_);
  chapel_.emplace();
}

void Postprocessing::frame(const room::View& view, std::string_view stage) {
  const room::Camera camera = cameraFor(view);
  const glm::dmat4 lamp = Chapel::lampAt(view.time);
  const bool finished = stage == kStages.back();
  if (stage != "scene") bloom_->render([&] { drawMask(*chapel_, camera, lamp); });
  glViewport(0, 0, view.width, view.height);
  if (finished || stage == "scene") drawScene(*chapel_, camera, lamp);
  if (finished) bloom_->addGlare(kGlareColor);
  if (const room::RenderTarget* picture = pictureOf(stage)) showPicture(*picture);
  room::resetPasses(kUnits);
}

const room::RenderTarget* Postprocessing::pictureOf(std::string_view stage) const {
  if (stage == "mask") return &bloom_->mask();
  if (stage == "glare") return &bloom_->glare();
  for (std::size_t i = 0; i < kReductions.size(); ++i) {
    if (stage == std::to_string(kReductions[i].size)) return &bloom_->reduction(i);
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<room::Demo> makePostprocessing() {
  return std::make_unique<Postprocessing>();
}

}  // namespace postprocessing
