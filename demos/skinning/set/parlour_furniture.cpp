// What stands in the parlour and lies on its table.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "parlour.h"
#include "room/noise.h"
#include "room/set/furniture.h"
#include "room/set/materials.h"

namespace skinning {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using room::board;
using room::MeshData;
using room::placed;

}  // namespace

// The cloth lies on the table and falls over its edge in folds; its texture is seen from above.
void Parlour::addTable() {
  constexpr double kDrop = 0.52, kRound = 0.025;
  const double length = kTableRadius + kDrop;
  MeshData cloth = room::surface(216, 110, [=](double u, double v) {
    const double along = (1 - v) * length;  // from the middle
    const double angle = -u * glm::two_pi<double>();
    const double over = std::max(along - (kTableRadius - kRound), 0.0);
    const double bend = std::min(over / kRound, glm::half_pi<double>());
    const double down = std::max(over - kRound * glm::half_pi<double>(), 0.0);
    const double fold = std::min(down / 0.20, 1.0);
    double radius = std::min(along, kTableRadius - kRound) + kRound * std::sin(bend);
    radius += fold * (0.030 * std::sin(13 * angle + 0.6 * std::sin(3 * angle)) + 0.05 * down);
    const double y = kTableTop - kRound * (1 - std::cos(bend)) - down;
    return dvec3(radius * std::cos(angle), y, radius * std::sin(angle));
  });
  for (room::Vertex& v : cloth.vertices) {
    const dvec2 unrolled = (1 - v.uv.y) * dvec2(std::cos(v.uv.x * glm::two_pi<double>()),
                                                std::sin(v.uv.x * glm::two_pi<double>()));
    v.uv = 0.5 + 0.5 * unrolled;
    if (v.position.y > kTableTop - 0.002) v.normal = {0, 1, 0};
  }
  light_.add(room::UprightCylinder{{0, 0.20, 0}, kTableRadius - 0.03, kTableTop - 0.215});
  tableCloth_ = std::move(cloth);
}

// Turned wood with two brass rings, which the hand grows out of.
void Parlour::addPlinth() {
  const std::vector<dvec2> profile = {{0.118, 0.0},   {0.128, 0.006}, {0.128, 0.016}, {0.116, 0.024},
                                      {0.100, 0.030}, {0.094, 0.040}, {0.096, 0.052}, {0.106, 0.062},
                                      {0.108, 0.070}, {0.102, 0.080}, {0.090, 0.085}, {0.0, 0.085}};
  MeshData wood = room::lathe(profile, 64, 60, {3, 0.4});
  for (room::Vertex& v : wood.vertices) v.uv = {v.uv.y * 2, v.uv.x};
  timber_.append(wood, placed({0, kTableTop, 0}));
  for (const dvec2 ring : {dvec2(0.0975, 0.036), dvec2(0.072, 0.083)}) {
    const std::vector<dvec2> band = {{ring.x - 0.006, ring.y},
                                     {ring.x + 0.003, ring.y + 0.001},
                                     {ring.x + 0.004, ring.y + 0.008},
                                     {ring.x - 0.006, ring.y + 0.010}};
    metal_.append(room::lathe(band, 64, 12, {6, 0.3}), placed({0, kTableTop, 0}));
  }
  light_.add(room::UprightCylinder{{0, kTableTop, 0}, 0.10, kPlinthHeight - 0.01});
  light_.add(room::UprightCylinder{{0, kTableTop + kPlinthHeight, 0}, 0.035, 0.16});
}

void Parlour::addCandle(dvec3 foot, double stick, double wax) {
  const std::vector<dvec2> profile = {{0.050, 0.0},           {0.053, 0.004},        {0.046, 0.012},
                                      {0.020, 0.020},         {0.011, 0.032},        {0.009, 0.4 * stick},
                                      {0.015, 0.46 * stick},  {0.009, 0.52 * stick}, {0.010, stick - 0.022},
                                      {0.024, stick - 0.014}, {0.026, stick},        {0.014, stick - 0.002},
                                      {0.0, stick - 0.002}};
  metal_.append(room::lathe(profile, 32, 70, {2, 1}), placed(foot));
  const std::vector<dvec2> candle = {
      {0.0122, 0.0}, {0.0120, 0.5 * wax}, {0.0122, wax - 0.004}, {0.0100, wax}, {0.0, wax - 0.004}};
  candleWax_.append(room::lathe(candle, 20, 40), placed(foot + dvec3(0, stick - 0.004, 0)));
  candles_.push_back(foot + dvec3(0, stick + wax + 0.012, 0));
  light_.add(room::UprightCylinder{foot, 0.038, 0.014});
  light_.add(room::UprightCylinder{foot, 0.008, stick + wax - 0.03});
}

// Spine towards -x of `where`, lying.
void Parlour::addBook(const dmat4& where, dvec3 size, dvec3 tint) {
  constexpr double kBoard = 0.004;
  MeshData cover;
  for (double side : {-1.0, 1.0})
    cover.append(room::box({size.x, kBoard, size.z}, 0.03, 3, {0.3, 0.2}),
                 placed({0, side * (size.y - kBoard) / 2, 0}));
  cover.append(room::box({kBoard, size.y, size.z}, 0.03, 3), placed({-(size.x - kBoard) / 2, 0, 0}));
  for (double at : {-0.32, -0.1, 0.12, 0.34})
    cover.append(room::box({kBoard, size.y * 1.04, 0.006}, 0.03, 3), placed({-size.x / 2, 0, at * size.z}));
  MeshData placedCover, block;
  placedCover.append(cover, where);
  finish(leather_, placedCover, Surface::Lit, tint);
  block.append(room::box({size.x - 0.012, size.y - 2 * kBoard, size.z - 0.012}, 0.03, 4), where);
  finish(pages_, block);
}

// A stack with a candle on it.
void Parlour::addBooks() {
  books_ = {{placed({-0.50, kTableTop + 0.024, -0.10}, 0.35), {0.19, 0.048, 0.26}, {0.24, 0.32, 0.22}},
            {placed({-0.49, kTableTop + 0.066, -0.11}, 0.10), {0.17, 0.036, 0.24}, {0.50, 0.17, 0.13}},
            {placed({-0.50, kTableTop + 0.096, -0.09}, 0.62), {0.15, 0.024, 0.21}, {0.30, 0.24, 0.36}}};
  light_.add(room::UprightCylinder{{-0.50, kTableTop, -0.10}, 0.10, 0.10});
  addCandle({-0.51, kTableTop + 0.108, -0.10}, 0.055, 0.10);
}

void Parlour::addCards() {
  const auto lay = [this](int card, dvec3 center, double turn) {
    constexpr double kWidth = 0.082, kLength = 0.142;
    MeshData sheet =
        room::rectangle({-kWidth / 2, 0, kLength / 2}, {kWidth, 0, 0}, {0, 0, -kLength}, 0.02, 1);
    for (room::Vertex& v : sheet.vertices)
      v.uv = {0.25 * (card + 0.5 + v.position.x / kWidth), 0.5 - v.position.z / kLength};
    MeshData there;
    there.append(sheet, placed(center, turn));
    finish(cards_, there);
  };
  lay(3, {-0.29, kTableTop + 0.0015, 0.27}, 0.62);
  lay(0, {-0.21, kTableTop + 0.0030, 0.33}, 0.30);
  lay(1, {-0.12, kTableTop + 0.0045, 0.36}, 0.02);
  lay(2, {0.09, kTableTop + 0.0030, 0.37}, -0.38);
}

void Parlour::addBall() {
  MeshData ball = room::sphere(kBallRadius, 128, 80), there;
  there.append(ball, placed(kBall));
  std::vector<glm::vec3> light = light_.vertexLight(there);
  for (glm::vec3& color : light) color *= 1.6F;
  ball_ = std::make_unique<room::Mesh>(there, light);
  const dvec3 foot(kBall.x, kTableTop, kBall.z);
  const std::vector<dvec2> stand = {{0.060, 0.0},   {0.064, 0.004}, {0.056, 0.012},
                                    {0.028, 0.020}, {0.024, 0.028}, {0.046, 0.042},
                                    {0.060, 0.058}, {0.056, 0.060}, {0.030, 0.046}};
  metal_.append(room::lathe(stand, 40, 40, {3, 1}), placed(foot));
  light_.add(room::UprightCylinder{foot, 0.045, 0.03});
  light_.add(room::UprightCylinder{foot + dvec3(0, 0.06, 0), 0.06, 0.11});
}

void Parlour::addTeacup() {
  const dvec3 foot(0.255, kTableTop, 0.40);
  const std::vector<dvec2> saucer = {{0.028, 0.0},    {0.032, 0.004}, {0.062, 0.011}, {0.070, 0.016},
                                     {0.066, 0.0165}, {0.030, 0.007}, {0.0, 0.006}};
  const std::vector<dvec2> cup = {{0.018, 0.007}, {0.022, 0.012}, {0.036, 0.030}, {0.042, 0.056},
                                  {0.040, 0.057}, {0.034, 0.032}, {0.0, 0.016}};
  china3d_.append(room::lathe(saucer, 40, 30), placed(foot));
  china3d_.append(room::lathe(cup, 40, 30), placed(foot));
  china3d_.append(room::tube({{0.036, 0.046, 0}, {0.062, 0.046, 0}, {0.056, 0.022, 0}, {0.034, 0.026, 0}},
                             0.003, 0.008, 8, 2),
                  placed(foot, -0.7));
  light_.add(room::UprightCylinder{foot, 0.060, 0.012});
  light_.add(room::UprightCylinder{foot, 0.034, 0.05});
}

// Against the left wall: shelves of books.
void Parlour::addBookcase() {
  constexpr double kDepth = 0.28, kLow = -1.66, kHigh = -0.56, kHeight = 2.02;
  const double x = kRoomMin.x + kDepth / 2 + 0.01, length = kHigh - kLow, middle = (kLow + kHigh) / 2;
  const auto put = [&](dvec3 center, dvec3 size, int number) {
    timber_.append(room::box(size, 0.07, 1 / room::kWoodExtent, {0.21 * number, 0.13 * number}),
                   placed(center));
  };
  for (double end : {kLow, kHigh}) put({x, kHeight / 2, end}, {kDepth, kHeight, 0.035}, 601);
  put({x - kDepth / 2 + 0.01, kHeight / 2, middle}, {0.015, kHeight, length}, 602);
  put({x + 0.01, kHeight + 0.02, middle}, {kDepth + 0.05, 0.05, length + 0.08}, 603);
  put({x, 0.05, middle}, {kDepth, 0.10, length}, 604);
  constexpr int kShelves = 5;
  for (int shelf = 0; shelf < kShelves; ++shelf) {
    const double y = 0.10 + shelf * 0.385;
    put({x, y, middle}, {kDepth, 0.025, length}, 610 + shelf);
    double at = kLow + 0.03;
    for (int i = 0; at < kHigh - 0.09; ++i) {
      const double thick = 0.022 + 0.034 * room::hash(i, shelf, 621),
                   high = 0.20 + 0.11 * room::hash(i, shelf, 622);
      const double deep = 0.15 + 0.06 * room::hash(i, shelf, 623), shade = room::hash(i, shelf, 624);
      const double kind = room::hash(i, shelf, 625);
      if (room::hash(i, shelf, 626) > 0.93) at += 0.06;  // a gap
      dvec3 tint = kind < 0.3    ? dvec3(0.42, 0.16, 0.12)
                   : kind < 0.55 ? dvec3(0.18, 0.26, 0.20)
                   : kind < 0.8  ? dvec3(0.36, 0.26, 0.15)
                                 : dvec3(0.17, 0.18, 0.30);
      tint *= 0.7 + 0.6 * shade;
      shelved_.push_back({{x - kDepth / 2 + 0.05 + deep / 2, y + 0.0125 + high / 2, at + thick / 2},
                          {deep, high, thick},
                          tint});
      at += thick + 0.0015;
    }
  }
  // All books of a color in one mesh: their tints go into the vertices with the light.
  MeshData bindings;
  std::vector<glm::vec3> colors;
  for (const ShelvedBook& book : shelved_) {
    const MeshData block = room::box(book.size, 0.06, 3, {book.center.z * 7, book.center.y * 3});
    MeshData there;
    there.append(block, placed(book.center));
    for (const room::Vertex& v : there.vertices) {
      // The shelf above shades them.
      const double up = (v.position.y - book.center.y) / book.size.y;
      const double shade = 1 - 0.45 * glm::smoothstep(-0.1, 0.5, up);
      colors.emplace_back(glm::vec3(book.tint * shade) * light_.halfLight(v.position, v.normal));
    }
    bindings.append(there);
  }
  parts_.push_back({Surface::Lit, &leather_, std::make_unique<room::Mesh>(bindings, colors)});
}

// Its back can be seen behind the table.
void Parlour::addChair() {
  const dmat4 here = placed({-0.62, 0, -1.12}, 0.22);
  MeshData wood, cushion;
  for (double side : {-1.0, 1.0}) {
    wood.append(room::tube({{side * 0.23, 0.0, 0}, {side * 0.23, 0.55, 0}, {side * 0.22, 1.16, -0.05}}, 0.019,
                           0.1, 12, 1.5));
    wood.append(room::sphere(0.027, 16, 12), placed({side * 0.22, 1.18, -0.05}));
  }
  wood.append(
      room::tube({{-0.22, 1.08, -0.045}, {-0.1, 1.15, -0.05}, {0.1, 1.15, -0.05}, {0.22, 1.08, -0.045}},
                 0.020, 0.05, 12, 1.5));
  wood.append(board({0.44, 0.045, 0.03}, 631), placed({0, 0.60, -0.005}));
  cushion = room::surface(24, 32,
                          [](double u, double v) {
                            const double x = (u - 0.5) * 0.40, y = glm::mix(0.62, 1.10, v);
                            const double puff =
                                0.03 * std::pow(std::max(16 * u * (1 - u) * v * (1 - v), 0.0), 0.4);
                            return dvec3(x, y, -0.02 - 0.06 * (y - 0.55) / 0.6 + 0.02 + puff);
                          },
                          {1.5, 1.5});
  timber_.append(wood, here);
  MeshData there;
  there.append(cushion, here);
  finish(velvet_, there);
}

}  // namespace skinning
