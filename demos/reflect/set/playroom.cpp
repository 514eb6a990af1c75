#include "playroom.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "playroom_materials.h"
#include "room/set/furniture.h"
#include "room/set/materials.h"
#include "toys.h"
#include "train.h"

namespace reflect {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using room::placed;

constexpr double kScatteredAngle = -0.4;
constexpr dvec3 kLampCenter(2.02, 1.50, -2.02);
constexpr dvec2 kWindowLow(-0.35, 1.18);
constexpr dvec2 kWindowHigh(0.85, 2.18);

dmat4 scatteredAt() {
  return placed({1.55, 0, 1.25}, kScatteredAngle);
}

}  // namespace

Playroom::Playroom() {
  makeTextures();
  addLight();
  addShell();
  addWindow();
  addFurniture();
  addToys();
  addTrain();
}

void Playroom::makeTextures() {
  wallpaper_ = room::materialTexture(512, wallpaperTexel);
  boards_ = room::materialTexture(512, boardsTexel);
  wood_ = room::materialTexture(256, room::wood);
  paint_ = room::materialTexture(128, paintTexel);
  rug_ = room::materialTexture(512, rugTexel);
  picture_ = room::materialTexture(256, room::poster, GL_CLAMP_TO_EDGE);
  dusk_ = room::materialTexture(256, duskTexel, GL_CLAMP_TO_EDGE);
  shadow_ = room::materialTexture(64, vehicleShadowTexel, GL_CLAMP_TO_EDGE);
}

// The lamp, the window, what light the walls throw back, and what stands in its way.
void Playroom::addLight() {
  light_.addAmbient({0.30, 0.27, 0.26});
  light_.add(room::Lamp{kLampCenter, 0.10, {2.2, 1.42, 0.70}});
  light_.add(room::Lamp{{-1.0, 2.2, 1.6}, 0.5, {0.55, 0.45, 0.34}, false});
  light_.add(room::Opening{{kWindowLow.x, kWindowLow.y, kRoomMin.z},
                           {kWindowHigh.x - kWindowLow.x, 0, 0},
                           {0, kWindowHigh.y - kWindowLow.y, 0},
                           {0.7, 1.05, 2.0}});
  // The ball as a pile of cylinders.
  for (int i = 0; i < 5; ++i) {
    const double low = kBallRadius * (-0.9 + 0.36 * i);
    const double middle = low + 0.18 * kBallRadius;
    const double radius = std::sqrt(kBallRadius * kBallRadius - middle * middle) * 0.96;
    light_.add(room::UprightCylinder{kBallCenter + dvec3(0, low, 0), radius, 0.36 * kBallRadius});
  }
  light_.add(room::UprightCylinder{{0, 0.01, 0}, 0.18, 0.10});
  const auto block = [this](const dvec3& low, const dvec3& high) {
    light_.add(room::Block{(low + high) * 0.5, (high - low) * 0.5});
  };
  for (double y : {0.04, 0.48, 0.94}) block({-2.14, y - 0.01, -2.46}, {-0.86, y + 0.01, -2.17});
  block({0.92, 0.02, -2.32}, {1.76, 0.45, -1.92});    // chest
  block({-1.86, 0.01, -1.00}, {-1.68, 0.30, -0.90});  // tower
  light_.add(room::UprightCylinder{{1.72, 0.01, -0.75}, 0.18, 0.20});
  light_.add(room::UprightCylinder{{-1.80, 0.01, 0.75}, 0.09, 0.26});
  light_.add(room::UprightCylinder{{1.95, 0.05, 0.30}, 0.12, 0.20});
  light_.add(room::UprightCylinder{{1.34, 0.50, -2.10}, 0.11, 0.42});
  for (std::size_t i = 0; i < kScatteredBlocks.size(); ++i) {
    const dvec3 middle(scatteredAt() * glm::dvec4(kScatteredBlocks[i], 1.0));
    light_.add(room::Block{middle, dvec3(0.05), kScatteredAngle + scatteredTurn(i)});
  }
}

template <typename Maker>
Thing Playroom::make(const room::Texture& texture, const Maker& maker, bool vertexLit) const {
  const auto colorsOf = [&](const Painted& painted) {
    return vertexLit ? plainColors(painted) : litColors(painted, light_);
  };
  const Painted fine = maker(kFine);
  const Painted coarse = maker(kProxy);
  Thing thing;
  thing.mesh = std::make_unique<room::Mesh>(fine.mesh, colorsOf(fine));
  thing.proxy = std::make_unique<room::Mesh>(coarse.mesh, colorsOf(coarse));
  thing.texture = &texture;
  thing.bounds = room::boundsOf(fine.mesh);
  thing.vertexLit = vertexLit;
  thing.scale = vertexLit ? 1.0F : 2.0F;
  return thing;
}

template <typename Maker>
void Playroom::add(const room::Texture& texture, const Maker& maker) {
  things_.push_back(make(texture, maker));
}

void Playroom::addAt(const room::Texture& texture, Build build, const dmat4& where) {
  add(texture, [=](const Detail& detail) {
    const Painted piece = build(detail);
    Painted p;
    p.mesh.append(piece.mesh, where);
    p.paint = piece.paint;
    return p;
  });
}

void Playroom::addShell() {
  const dvec3 low = kRoomMin;
  const dvec3 size = kRoomMax - kRoomMin;
  // Cut finely enough for light in the vertices: the floor, for shadows of what stands on it.
  const auto side = [this](const room::Texture& texture, const dvec3& origin, const dvec3& a, const dvec3& b,
                           const dvec2& repeat, double finest = 0.13) {
    add(texture, [=](const Detail& detail) {
      const double cell = finest / detail.share;
      const int columns = std::max(2, static_cast<int>(glm::length(a) / cell));
      const int rows = std::max(2, static_cast<int>(glm::length(b) / cell));
      Painted p;
      p.add(room::surface(
                columns, rows, [&](double u, double v) { return origin + a * u + b * v; }, repeat),
            dvec3(1));
      return p;
    });
  };
  const dvec3 x(size.x, 0, 0);
  const dvec3 y(0, size.y, 0);
  const dvec3 z(0, 0, size.z);
  side(boards_, {low.x, 0, kRoomMax.z}, x, -z, {size.x / 1.4, size.z / 1.4}, 0.045);
  side(paint_, {low.x, size.y, low.z}, x, z, {2, 2});
  side(wallpaper_, low, x, y, {size.x / kPaperWidth, 1});
  side(wallpaper_, {low.x, 0, kRoomMax.z}, -z, y, {size.z / kPaperWidth, 1});
  side(wallpaper_, {kRoomMax.x, 0, low.z}, z, y, {size.z / kPaperWidth, 1});
  side(wallpaper_, {kRoomMax.x, 0, kRoomMax.z}, -x, y, {size.x / kPaperWidth, 1});
  add(rug_, [](const Detail& detail) {
    constexpr double kRadius = 1.72;
    Painted p;
    p.add(room::surface(detail.cells(144, 40), detail.cells(56, 16),
                        [](double u, double v) {
                          const double angle = -u * glm::two_pi<double>();
                          return dvec3(kRadius * v * std::sin(angle), 0.006, kRadius * v * std::cos(angle));
                        }),
          dvec3(1));
    for (room::Vertex& v : p.mesh.vertices) v.normal = v.side = {0, 1, 0};
    return p;
  });
}

void Playroom::addWindow() {
  const dvec2 size = kWindowHigh - kWindowLow;
  const dvec2 middle = (kWindowHigh + kWindowLow) * 0.5;
  const double z = kRoomMin.z;
  const auto glass = [&](const Detail&) {
    Painted p;
    p.add(room::surface(1, 1,
                        [&](double u, double v) { return dvec3(kWindowLow + size * dvec2(u, v), z + 0.01); }),
          dvec3(1));
    return p;
  };
  Thing pane = make(dusk_, glass, true);
  pane.vertexLit = false;
  pane.scale = 1;
  things_.push_back(std::move(pane));
  add(paint_, [&](const Detail&) {
    constexpr dvec3 kWhite(0.95, 0.93, 0.88);
    Painted p;
    const auto bar = [&](const dvec3& center, const dvec3& extent) {
      p.add(room::box(extent, 0.3, 1), kWhite, placed(center));
    };
    for (double side : {-1.0, 1.0}) {
      bar({middle.x + side * (size.x / 2 + 0.03), middle.y, z + 0.03}, {0.08, size.y + 0.14, 0.06});
      bar({middle.x, middle.y + side * (size.y / 2 + 0.03), z + 0.03}, {size.x + 0.1, 0.08, 0.06});
    }
    bar({middle.x, middle.y, z + 0.02}, {0.035, size.y, 0.03});
    bar({middle.x, middle.y + 0.10, z + 0.02}, {size.x, 0.035, 0.03});
    bar({middle.x, kWindowLow.y - 0.07, z + 0.07}, {size.x + 0.26, 0.03, 0.15});
    return p;
  });
  // Curtains in folds.
  add(paint_, [&](const Detail& detail) {
    Painted p;
    for (double side : {-1.0, 1.0}) {
      p.add(room::surface(detail.cells(64, 24), detail.cells(20, 8),
                          [&](double u, double v) {
                            const double fold = 0.035 * std::sin(u * 9 * glm::two_pi<double>());
                            const double gather = 1 - 0.30 * std::exp(-std::pow((v - 0.42) / 0.16, 2));
                            const double outer = middle.x + side * (size.x / 2 + 0.36);
                            const double width = 0.44 * gather;
                            const double along = side > 0 ? 1 - u : u;
                            return dvec3(outer - side * width * along,
                                         glm::mix(kWindowLow.y - 0.22, kWindowHigh.y + 0.14, v),
                                         z + 0.10 + fold * gather);
                          }),
            dvec3(0.72, 0.22, 0.20));
    }
    p.add(room::tube({{kWindowLow.x - 0.45, kWindowHigh.y + 0.15, z + 0.10},
                      {kWindowHigh.x + 0.45, kWindowHigh.y + 0.15, z + 0.10}},
                     0.014, 0.01, detail.cells(12, 5), 1),
          dvec3(0.75, 0.55, 0.30));
    return p;
  });
}

void Playroom::addFurniture() {
  addAt(paint_, shelf, placed({-1.50, 0, -2.32}));
  addAt(paint_, books, placed({-1.50, 0, -2.32}));
  addAt(paint_, chest, placed({1.34, 0, -2.12}));
  addAt(paint_, floorLamp, placed({kLampCenter.x, 0, kLampCenter.z}));
  Thing shade = make(
      paint_,
      [](const Detail& detail) {
        Painted p;
        p.add(lampShade(detail).mesh, dvec3(1), placed({kLampCenter.x, 0, kLampCenter.z}));
        p.paint = lampShade(detail).paint;
        return p;
      },
      true);
  shade.vertexLit = false;
  shade.scale = 1;
  things_.push_back(std::move(shade));

  // A picture on the left wall.
  add(picture_, [](const Detail&) {
    Painted p;
    p.add(room::surface(
              4, 6,
              [](double u, double v) { return dvec3(kRoomMin.x + 0.02, 1.15 + 0.95 * v, -1.15 - 0.66 * u); }),
          dvec3(1));
    return p;
  });
  add(wood_, [](const Detail&) {
    Painted p;
    for (double end : {-1.0, 1.0}) {
      p.add(room::box({0.04, 0.05, 0.74}, 0.3, 1), dvec3(0.9),
            placed({kRoomMin.x + 0.02, 1.625 + end * 0.50, -1.48}));
      p.add(room::box({0.04, 0.95, 0.05}, 0.3, 1), dvec3(0.9),
            placed({kRoomMin.x + 0.02, 1.625, -1.48 + end * 0.355}));
    }
    return p;
  });
  addAt(
      wood_,
      [](const Detail&) {
        Painted p;
        p.add(room::crate(0.5), dvec3(1), placed({0, 0.25, 0}));
        return p;
      },
      placed({-1.85, 0, 2.3}, 0.3));
}

void Playroom::addToys() {
  addAt(paint_, bear, placed({1.34, 0.49, -2.08}, -0.25));
  addAt(paint_, ringTower, placed({-1.80, 0, 0.75}));
  addAt(paint_, drum, placed({1.72, 0, -0.75}, 0.6));
  addAt(paint_, spinningTop, placed({-0.62, 0.006, 1.52}));
  addAt(paint_, blockTower, placed({-1.77, 0, -0.95}, 0.35));
  addAt(paint_, scatteredBlocks, scatteredAt());
  addAt(paint_, beachBall, placed({1.98, 0, 0.30}));
  addAt(paint_, rocket, placed({-1.92, 0.955, -2.30}));
  stand_ = make(wood_, ballStand);
}

void Playroom::addTrain() {
  add(wood_, track);
  firstShadow_ = things_.size();
  for (int i = 0; i < kVehicles; ++i) {
    Thing shadow = make(
        shadow_,
        [](const Detail&) {
          Painted p;
          p.add(room::rectangle({-0.20, 0.010 - kRailTop, 0.11}, {0.40, 0, 0}, {0, 0, -0.22}, 1, 1),
                dvec3(1));
          for (room::Vertex& v : p.mesh.vertices)
            v.uv = {v.position.x / 0.40 + 0.5, v.position.z / 0.22 + 0.5};
          return p;
        },
        true);
    shadow.vertexLit = false;
    shadow.shadow = true;
    things_.push_back(std::move(shadow));
  }
  firstVehicle_ = things_.size();
  for (int i = 0; i < kVehicles; ++i) {
    things_.push_back(make(
        paint_, [i](const Detail& detail) { return vehicle(i, detail); }, true));
  }
}

void Playroom::animate(double time) {
  for (std::size_t i = 0; i < kVehicles; ++i) {
    const dmat4 where = vehicleAt(static_cast<int>(i), time);
    things_[firstShadow_ + i].model = things_[firstVehicle_ + i].model = where;
  }
}

}  // namespace reflect
