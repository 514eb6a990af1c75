#include "parlour.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "parlour_materials.h"
#include "room/set/furniture.h"
#include "room/set/materials.h"

namespace skinning {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using room::MeshData;
using room::placed;

room::Texture solid(dvec3 color, double alpha) {
  return room::makeTexture(room::generate(4, 4, 4,
                                          [=](double, double, float* out) {
                                            for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(color[i]);
                                            out[3] = static_cast<float>(alpha);
                                          }),
                           room::Filter::Linear, GL_REPEAT);
}

}  // namespace

Parlour::Parlour() : light_(candlelightBake(kRoomMin, kRoomMax)) {
  makeMaterials();
  addTable();
  addPlinth();
  addBooks();
  addCandle({0.56, kTableTop, -0.20}, 0.16, 0.13);
  addCandle({0.44, kTableTop, -0.38}, 0.10, 0.17);
  addTeacup();
  placeLights();
  addCards();
  addBall();
  addBookcase();
  addChair();
  addWalls();
  addWainscot();
  addWindow();
  addPictures();
  for (const Book& book : books_) addBook(book.where, book.size, book.tint);
  finish(cloth_, tableCloth_, Surface::Table);
  finish(china_, china3d_);
  finish(wood_, timber_);
  finish(brass_, metal_);
  finish(wax_, candleWax_);
  addFlames();
}

void Parlour::makeMaterials() {
  damask_ = room::materialTexture(512, damask);
  wood_ = room::materialTexture(256, [](double u, double v) {
    room::Texel t = room::wood(u, v);
    t.color *= dvec3(0.62, 0.52, 0.46);
    return t;
  });
  boards_ = room::materialTexture(256, floorboards);
  velvet_ = room::materialTexture(256, velvet);
  cloth_ = room::materialTexture(1024, zodiacCloth, GL_CLAMP_TO_EDGE);
  brass_ = room::materialTexture(128, brass);
  wax_ = room::materialTexture(64, [](double u, double v) {
    room::Texel t = room::paper(u, v);
    t.color = dvec3(0.90, 0.82, 0.66);
    return t;
  });
  leather_ = room::materialTexture(128, leather);
  pages_ = room::materialTexture(64, pages);
  cards_ = room::materialTexture(512, cards, GL_CLAMP_TO_EDGE);
  chart_ = room::materialTexture(512, starChart, GL_CLAMP_TO_EDGE);
  china_ = room::materialTexture(128, china);
  ceiling_ = room::materialTexture(256, [](double u, double v) {
    room::Texel t = room::plaster(u, v);
    t.color *= dvec3(0.55, 0.47, 0.42);
    return t;
  });
  sky_ = room::materialTexture(256, nightSky, GL_CLAMP_TO_EDGE);
  ballBase_ = solid({0.30, 0.38, 0.55}, 1.0);
}

// The lamp, the candles that stand by now, and the moon as a soft patch in the window.
void Parlour::placeLights() {
  light_.add(lightOf({kLamp, dvec3(2.35, 1.50, 0.75), 0.05}));
  for (const dvec3& candle : candles_) light_.add(lightOf({candle, dvec3(0.36, 0.205, 0.085), 0.012}));
  light_.add(lightOf({kWindowCorner + dvec3(kWindowSize * 0.5, 0.10), dvec3(0.10, 0.15, 0.27), 0.30}));
}

void Parlour::finish(const room::Texture& base, const MeshData& data, Surface surface, dvec3 tint) {
  std::vector<glm::vec3> light = light_.vertexLight(data);
  for (glm::vec3& color : light) color *= glm::vec3(tint);
  parts_.push_back({surface, &base, std::make_unique<room::Mesh>(data, light)});
}

void Parlour::addGlowing(const room::Texture& base, const MeshData& data,
                         const std::vector<glm::vec3>& colors) {
  parts_.push_back({Surface::Glowing, &base, std::make_unique<room::Mesh>(data, colors)});
}

void Parlour::addWalls() {
  const dvec3 size = kRoomMax - kRoomMin;
  const dvec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  constexpr double kCell = 0.07;
  finish(damask_, room::rectangle(kRoomMin, x, y, kCell, 1 / kDamaskExtent), Surface::Wall);
  finish(damask_, room::rectangle({kRoomMin.x, kRoomMin.y, kRoomMax.z}, -z, y, kCell, 1 / kDamaskExtent));
  finish(damask_, room::rectangle({kRoomMax.x, kRoomMin.y, kRoomMin.z}, z, y, kCell, 1 / kDamaskExtent));
  finish(boards_, room::rectangle({kRoomMin.x, kRoomMin.y, kRoomMax.z}, x, -z, kCell, 0.8));
  finish(ceiling_,
         room::rectangle({kRoomMin.x, kRoomMax.y, kRoomMin.z}, x, z, 2 * kCell, 1 / room::kPlasterExtent));
}

// Panels up to the window's sill, a rail for pictures and a cornice, on the walls that can be seen.
void Parlour::addWainscot() {
  constexpr double kHeight = 0.86;
  int number = 500;
  const auto along = [&](const dmat4& wall, double length) {
    const auto put = [&](dvec3 center, dvec3 size) {
      timber_.append(room::box(size, 0.09, 1 / room::kWoodExtent, {0.31 * number, 0.17 * number}),
                     wall * glm::translate(dmat4(1.0), center));
      ++number;
    };
    put({length / 2, 0.07, 0.015}, {length, 0.14, 0.03});
    put({length / 2, kHeight, 0.02}, {length, 0.045, 0.05});
    put({length / 2, kHeight - 0.08, 0.010}, {length, 0.11, 0.02});
    put({length / 2, 0.19, 0.010}, {length, 0.10, 0.02});
    put({length / 2, 0.48, 0.002}, {length, 0.66, 0.006});
    put({length / 2, 2.28, 0.012}, {length, 0.035, 0.024});
    put({length / 2, kRoomMax.y - 0.05, 0.03}, {length, 0.10, 0.06});
    const int panels = static_cast<int>(length / 0.5);
    for (int i = 0; i <= panels; ++i) {
      put({length * i / panels, 0.48, 0.011}, {0.10, 0.50, 0.022});
      if (i == panels) break;
      const double middle = length * (i + 0.5) / panels;
      put({middle, 0.48, 0.008}, {length / panels - 0.20, 0.38, 0.014});
    }
  };
  const dvec3 size = kRoomMax - kRoomMin;
  along(glm::translate(dmat4(1.0), kRoomMin), size.x);
  along(placed({kRoomMin.x, 0, kRoomMax.z}, glm::half_pi<double>()), size.z);
  along(placed({kRoomMax.x, 0, kRoomMin.z}, -glm::half_pi<double>()), size.z);
}

void Parlour::addWindow() {
  const dvec3 right(kWindowSize.x, 0, 0), up(0, kWindowSize.y, 0);
  MeshData pane = room::rectangle(kWindowCorner, right, up, 0.2, 1);
  for (room::Vertex& v : pane.vertices) v.uv = (dvec2(v.position) - dvec2(kWindowCorner)) / kWindowSize;
  addGlowing(sky_, pane, std::vector<glm::vec3>(pane.vertices.size(), glm::vec3(0.62)));
  MeshData frame;
  const auto bar = [&](dvec3 center, dvec3 size) { frame.append(room::board(size, 540), placed(center)); };
  const dvec3 middle = kWindowCorner + 0.5 * (right + up);
  for (double side : {-1.0, 1.0}) {
    bar(middle + side * 0.5 * right + dvec3(side * 0.03, 0, 0.01), {0.075, kWindowSize.y + 0.14, 0.07});
    bar(middle + side * 0.5 * up + dvec3(0, side * 0.03, 0.01), {kWindowSize.x + 0.13, 0.075, 0.07});
  }
  bar(middle + dvec3(0, 0, 0.01), {0.035, kWindowSize.y, 0.035});
  bar(middle + dvec3(0, 0.12, 0.01), {kWindowSize.x, 0.035, 0.035});
  bar(middle - 0.5 * up + dvec3(0, -0.075, 0.06), {kWindowSize.x + 0.26, 0.035, 0.17});
  finish(wood_, frame);
  // Curtains on a rod.
  const double rod = kWindowCorner.y + kWindowSize.y + 0.17;
  metal_.append(
      room::tube({{middle.x - 0.72, rod, kRoomMin.z + 0.12}, {middle.x + 0.72, rod, kRoomMin.z + 0.12}},
                 0.014, 0.01, 10, 4));
  for (double side : {-1.0, 1.0}) {
    metal_.append(room::sphere(0.030, 16, 12), placed({middle.x + side * 0.73, rod, kRoomMin.z + 0.12}));
    addCurtain(middle.x + side * 0.66, kRoomMin.z + 0.12, side);
  }
}

// Hangs from the rod and is gathered by a cord; `side`: where its outer edge is.
void Parlour::addCurtain(double x, double z, double side) {
  constexpr double kTop = 2.40, kCord = 1.18, kBottom = 0.04;
  const MeshData curtain =
      room::surface(120, 90,
                    [=](double u, double v) {
                      const double y = glm::mix(kBottom, kTop, v);
                      const double above = glm::clamp((y - kCord) / (kTop - kCord), 0.0, 1.0);
                      const double below = glm::clamp((kCord - y) / (kCord - kBottom), 0.0, 1.0);
                      const double breadth = 0.13 + 0.34 * std::pow(above, 0.8) + 0.13 * std::sqrt(below);
                      const double across = side > 0 ? 1 - u : u;  // from the outer edge
                      const double sag = 0.06 * (1 - above) * across * (y > kCord ? 1 : 0);
                      const double phase = glm::two_pi<double>() * (7.5 * across + 0.15 * std::sin(3 * y));
                      const double fold = 0.016 + 0.016 * (1 - breadth / 0.5);
                      return dvec3(x - side * breadth * across + 0.006 * std::sin(phase * 0.5), y - sag,
                                   z + 0.02 + fold * std::sin(phase));
                    },
                    {2.0, 4.0});
  finish(velvet_, curtain);
  const double cordX = x - side * 0.07;
  metal_.append(room::tube({{cordX - 0.09, kCord + 0.03, z - 0.02},
                            {cordX - 0.075, kCord, z + 0.07},
                            {cordX + 0.075, kCord, z + 0.07},
                            {cordX + 0.09, kCord + 0.03, z - 0.02}},
                           0.011, 0.03, 8, 6));
}

void Parlour::addPictures() {
  const auto hang = [this](dvec3 center, double size) {
    MeshData sheet = room::rectangle(center - dvec3(size / 2, size / 2, -0.012), {size, 0, 0}, {0, size, 0},
                                     0.1, 1 / size);
    finish(chart_, sheet);
    const double edge = size + 0.05;
    for (double side : {-1.0, 1.0}) {
      timber_.append(room::board({edge + 0.05, 0.05, 0.035}, 560),
                     placed(center + dvec3(0, side * edge / 2, 0.015)));
      timber_.append(room::board({0.05, edge - 0.05, 0.035}, 561),
                     placed(center + dvec3(side * edge / 2, 0, 0.015)));
    }
  };
  hang({1.36, 1.66, kRoomMin.z}, 0.46);
}

void Parlour::addFlames() {
  // Flames: dark at the wick, white in the middle, amber at the tip.
  const std::vector<dvec2> drop = {{0.0, -0.004},   {0.0045, 0.002}, {0.0072, 0.010}, {0.0066, 0.019},
                                   {0.0040, 0.032}, {0.0016, 0.042}, {0.0, 0.048}};
  MeshData flames;
  std::vector<glm::vec3> colors;
  const MeshData one = room::lathe(drop, 16, 24);
  for (const dvec3& candle : candles_) {
    flames.append(one, placed(candle - dvec3(0, 0.014, 0)));
    for (const room::Vertex& v : one.vertices) {
      const double t = glm::clamp((v.position.y + 0.004) / 0.052, 0.0, 1.0);
      const dvec3 hot =
          glm::mix(dvec3(0.35, 0.30, 0.75), dvec3(1.0, 0.93, 0.70), glm::smoothstep(0.0, 0.3, t));
      colors.emplace_back(glm::mix(hot, dvec3(1.0, 0.62, 0.22), glm::smoothstep(0.5, 1.0, t)));
    }
  }
  white_ = solid(dvec3(1), 1);
  addGlowing(white_, flames, colors);
}

}  // namespace skinning
