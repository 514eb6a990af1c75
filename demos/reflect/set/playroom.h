// The playroom: walls, furniture and toys that stand still, and the train that does not.
#pragma once

#include <vector>

#include "thing.h"

namespace reflect {

inline constexpr glm::dvec3 kRoomMin{-2.4, 0.0, -2.5};
inline constexpr glm::dvec3 kRoomMax{2.4, 2.55, 3.7};
inline constexpr glm::dvec3 kBallCenter{0.0, 0.60, 0.0};
inline constexpr double kBallRadius = 0.50;

class Playroom {
 public:
  Playroom();
  // Moves the train.
  void animate(double time);
  // All but the ball and what it stands on.
  const std::vector<Thing>& things() const { return things_; }
  // Hidden from the ball by the ball.
  const Thing& stand() const { return stand_; }

 private:
  using Build = Painted (*)(const Detail&);

  void makeTextures();
  void addLight();
  void addShell();
  void addWindow();
  void addFurniture();
  void addToys();
  void addTrain();
  // Built twice, as it is and for its reflection.
  template <typename Maker>
  Thing make(const room::Texture& texture, const Maker& maker, bool vertexLit = false) const;
  template <typename Maker>
  void add(const room::Texture& texture, const Maker& maker);
  void addAt(const room::Texture& texture, Build build, const glm::dmat4& where);

  room::LightBake light_;
  room::Texture wallpaper_, boards_, wood_, paint_, rug_, picture_, dusk_, shadow_;
  std::vector<Thing> things_;
  Thing stand_;
  std::size_t firstShadow_ = 0;  // of the vehicles, as many as they
  std::size_t firstVehicle_ = 0;
};

}  // namespace reflect
