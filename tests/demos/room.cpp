// What the demos share and can be tested without a picture: culling, cube map cameras, baked light, contact
// sheets.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "room/bounds.h"
#include "room/font.h"
#include "room/framebuffer.h"
#include "room/noise.h"
#include "room/picture.h"
#include "room/set/light_bake.h"
#include "room/texture.h"

namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

double random(int i, unsigned seed) {
  return room::hash(i, 7, seed);
}

dvec3 randomPoint(int i, unsigned seed) {
  return {random(3 * i, seed) * 2 - 1, random(3 * i + 1, seed) * 2 - 1, random(3 * i + 2, seed) * 2 - 1};
}

bool isSeen(const dvec3& point, const glm::dmat4& clip) {
  const dvec4 c = clip * dvec4(point, 1.0);
  return std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && std::abs(c.z) <= c.w;
}

// Whatever is seen of a box must not be culled, by any face.
TEST(Bounds, NothingThatIsSeenIsOutside) {
  int outside = 0;
  for (int i = 0; i < 400; ++i) {
    const dvec3 center = randomPoint(i, 1) * 4.0;
    const dvec3 half = glm::abs(randomPoint(i, 2)) * 0.8;
    const room::Box box{center - half, center + half};
    for (int face = 0; face < 6; ++face) {
      const glm::dmat4 clip =
          room::cubeFaceProjection(0.1, 5) * room::cubeFaceCamera(face, randomPoint(i, 3));
      if (!room::isOutside(box, clip)) continue;
      ++outside;
      for (int k = 0; k < 50; ++k) EXPECT_FALSE(isSeen(center + half * randomPoint(50 * i + k, 4), clip));
    }
  }
  EXPECT_GT(outside, 400 * 3) << "a box lies in few faces' views";
}

TEST(Bounds, WhatIsBehindIsOutsideAndWhatIsAroundIsNot) {
  const glm::dmat4 clip = room::cubeFaceProjection(0.1, 5) * room::cubeFaceCamera(5, dvec3(0));  // along -z
  EXPECT_TRUE(room::isOutside({{-1, -1, 0.5}, {1, 1, 2}}, clip));
  EXPECT_TRUE(room::isOutside({{3, -1, -2}, {4, 1, -1}}, clip));
  EXPECT_TRUE(room::isOutside({{-1, -1, -9}, {1, 1, -6}}, clip));
  EXPECT_FALSE(room::isOutside({{-9, -9, -9}, {9, 9, 9}}, clip));
  EXPECT_FALSE(room::isOutside({{-1, -1, -3}, {1, 1, -2}}, clip));
}

// Table 3.21: what a face's camera sees at (s, t) lies where the cube map is looked up for it.
TEST(CubeFaces, CamerasLookWhereFacesAreLookedUp) {
  for (int face = 0; face < 6; ++face) {
    const dvec3 eye(0.3, -0.2, 0.7);
    const glm::dmat4 clip = room::cubeFaceProjection(0.1, 50) * room::cubeFaceCamera(face, eye);
    for (const dvec2& st : {dvec2(0.5, 0.5), dvec2(0.1, 0.3), dvec2(0.9, 0.8)}) {
      const dvec4 c = clip * dvec4(eye + 3.0 * room::cubeDirection(face, st.x, st.y), 1.0);
      EXPECT_NEAR(c.x / c.w * 0.5 + 0.5, st.x, 1e-9) << face;
      EXPECT_NEAR(c.y / c.w * 0.5 + 0.5, st.y, 1e-9) << face;
    }
  }
}

TEST(LightBake, BlocksCastShadows) {
  const dvec3 up(0, 1, 0);
  room::LightBake light;
  light.add(room::Sun{{0, 1, 0}, 0.01, dvec3(1)});
  EXPECT_NEAR(light.light({0, 0, 0}, up).x, 1, 1e-9);
  EXPECT_EQ(light.light({0, 0, 0}, -up).x, 0);
  light.add(room::Block{{0, 2, 0}, {0.5, 0.1, 0.2}, glm::radians(90.0)});
  EXPECT_EQ(light.light({0, 0, 0.4}, up).x, 0);  // the turned block reaches along z
  EXPECT_NEAR(light.light({0.4, 0, 0}, up).x, 1, 1e-9);
  light.add(room::UprightCylinder{{2, 1, 0}, 0.3, 0.5});
  EXPECT_EQ(light.light({2.2, 0, 0}, up).x, 0);
  EXPECT_NEAR(light.light({2.4, 0, 0}, up).x, 1, 1e-9);
}

// 1 / r^2, by the cosine, and less than the ambient light in a corner.
TEST(LightBake, LampsAndCorners) {
  const dvec3 up(0, 1, 0);
  room::LightBake light;
  light.add(room::Lamp{{0, 2, 0}, 1e-3, dvec3(1)});
  EXPECT_NEAR(light.light({0, 0, 0}, up).x, 0.25, 2e-3);
  EXPECT_NEAR(light.light({2, 0, 0}, up).x, 0.125 * std::sqrt(0.5), 2e-3);
  room::LightBake corner;
  corner.addAmbient(dvec3(1));
  EXPECT_NEAR(corner.light({0, 0, 0}, up).x, 1, 1e-9);
  corner.add(room::Block{{1.01, 1, 0}, {1, 1, 3}});
  EXPECT_LT(corner.light({0, 0, 0}, up).x, 0.6);
  EXPECT_GT(corner.light({-0.5, 0, 0}, up).x, corner.light({0, 0, 0}, up).x);
}

TEST(LightBake, RectangleCoordinates) {
  const dvec3 origin(1, 2, 3);
  const dvec3 a(4, 0, 0);
  const dvec3 b(0, 0, -2);
  const glm::dmat4 m = room::rectangleCoordinates(origin, a, b);
  const dvec4 st = m * dvec4(origin + a * 0.25 + b * 0.75, 1.0);
  EXPECT_NEAR(st.x, 0.25, 1e-12);
  EXPECT_NEAR(st.y, 0.75, 1e-12);
}

TEST(Font, EveryCharacterLooksDifferent) {
  for (char a = '!'; a <= '_'; ++a) {
    for (char b = '!'; b < a; ++b) {
      double apart = 0;
      for (double y = 0; y <= 6; y += 0.5) {
        for (double x = 0; x <= 4; x += 0.5) {
          apart = std::max(apart, std::abs(room::glyphDistance(a, {x, y}) - room::glyphDistance(b, {x, y})));
        }
      }
      EXPECT_GT(apart, 0.6) << a << " and " << b;
    }
  }
  EXPECT_EQ(room::glyphDistance('q', {1, 1}), room::glyphDistance('Q', {1, 1}));
  EXPECT_GT(room::glyphDistance(' ', {2, 3}), 1e6);
}

TEST(ContactSheet, PutsPicturesInRows) {
  const auto picture = [](std::uint8_t value) {
    return room::Picture{2, 1, std::vector<std::uint8_t>(6, value)};
  };
  room::ContactSheet sheet(3);
  for (std::uint8_t value : {50, 60, 70}) sheet.add(picture(value));
  const room::Picture& p = sheet.picture();
  ASSERT_EQ(p.width, 2 * 6 + 4);
  ASSERT_EQ(p.height, 2 * 5 + 4);
  const auto at = [&](int x, int y) { return p.rgb[static_cast<std::size_t>(y * p.width + x) * 3]; };
  EXPECT_EQ(at(4, 4), 50);
  EXPECT_EQ(at(11, 4), 60);
  EXPECT_EQ(at(5, 9), 70);
  EXPECT_NE(at(7, 4), 50);
  sheet.add(picture(80));
  EXPECT_THROW(sheet.add(picture(90)), std::invalid_argument);
  room::ContactSheet other(2);
  other.add(picture(1));
  EXPECT_THROW(other.add(room::Picture{1, 1, {0, 0, 0}}), std::invalid_argument);
}

}  // namespace
