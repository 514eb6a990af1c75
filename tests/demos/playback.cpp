// What the window's keys do to what is shown.
#include "program/playback.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "room/transform.h"

namespace {

using program::Action;
using program::Playback;

constexpr std::array<std::string_view, 3> kStages = {"first", "second", "final"};

TEST(Playback, RunsUntilPaused) {
  Playback playback(kStages, "final", 2, 0.25);
  playback.advance(0.5);
  EXPECT_EQ(playback.time(), 2.5);
  playback.handle(Action::Pause);
  playback.advance(0.5);
  EXPECT_EQ(playback.time(), 2.5);
  playback.handle(Action::Pause);
  playback.advance(0.5);
  EXPECT_EQ(playback.time(), 3.0);
}

TEST(Playback, StepsAFrameAndStaysThere) {
  Playback playback(kStages, "final", 2, 0.25);
  playback.handle(Action::StepForward);
  EXPECT_TRUE(playback.paused());
  EXPECT_EQ(playback.time(), 2.25);
  playback.advance(1);
  playback.handle(Action::StepBack);
  playback.handle(Action::StepBack);
  EXPECT_EQ(playback.time(), 1.75);
}

TEST(Playback, GoesRoundTheStages) {
  Playback playback(kStages, "second", 0, 1);
  EXPECT_EQ(playback.stage(), "second");
  playback.handle(Action::NextStage);
  EXPECT_EQ(playback.stage(), "final");
  playback.handle(Action::NextStage);
  EXPECT_EQ(playback.stage(), "first");
  playback.handle(Action::PreviousStage);
  EXPECT_EQ(playback.stage(), "final");
}

TEST(Playback, AsksForEachPictureOnce) {
  Playback playback(kStages, "final", 0, 1);
  EXPECT_FALSE(playback.takePictureRequest());
  playback.handle(Action::SavePicture);
  EXPECT_TRUE(playback.takePictureRequest());
  EXPECT_FALSE(playback.takePictureRequest());
}

TEST(Playback, MovesTheCameraWithinBoundsAndBack) {
  Playback playback(kStages, "final", 0, 1);
  for (int i = 0; i < 1000; ++i) {
    playback.handle(Action::Nearer);
    playback.handle(Action::TurnRight);
  }
  const room::View moved = playback.view(4, 3);
  EXPECT_GT(moved.zoom, 0.1);
  EXPECT_GT(moved.yaw, 0);
  for (int i = 0; i < 1000; ++i) playback.handle(Action::Farther);
  EXPECT_LT(playback.view(4, 3).zoom, 3);
  playback.handle(Action::ResetCamera);
  EXPECT_EQ(playback.view(4, 3).yaw, 0);
  EXPECT_EQ(playback.view(4, 3).zoom, 1);
}

TEST(Playback, OrbitsAboutTheTarget) {
  const glm::dvec3 target(1, 2, 3);
  const glm::dvec3 eye(1.1, 2.7, 7);
  EXPECT_EQ(room::orbited({}, eye, target), eye);
  // A quarter turn to the right of who looks along -z ends on the +x side, at the same height.
  const glm::dvec3 turned = room::orbited({.yaw = std::numbers::pi / 2, .zoom = 0.5}, eye, target);
  EXPECT_NEAR(turned.x, 3, 1e-12);
  EXPECT_NEAR(turned.y, 2.35, 1e-12);
  EXPECT_NEAR(turned.z, 2.95, 1e-12);
}

}  // namespace
