// What the program does with its command line: exit statuses and files.
#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/measure/process.h"

namespace {

process::Outcome rooms(const std::vector<std::string>& arguments) {
  return process::run(ROOMS_PROGRAM, arguments, {});
}

// Status 2 and one sentence that is not scrolled away by the help.
TEST(RoomsProgram, RefusesWhatItDoesNotKnow) {
  const std::vector<std::vector<std::string>> wrong = {{},
                                                       {"nosuch"},
                                                       {"particles", "--nosuch"},
                                                       {"particles", "--stage", "nosuch"},
                                                       {"particles", "--format", "nosuch"},
                                                       {"particles", "--size", "12"},
                                                       {"particles", "--size", "0x12"},
                                                       {"particles", "--frames", "9-3"},
                                                       {"particles", "--frames", "x"},
                                                       {"particles", "--time", "1e309"},
                                                       {"particles", "--contact-sheet", "--format", "gif"},
                                                       {"particles", "--contact-sheet", "--frames", "100000"},
                                                       {"water", "--water", "nosuch"},
                                                       {"water", "--integrator", "nosuch"},
                                                       {"all", "--window"},
                                                       {"particles", "--window", "--stats"},
                                                       {"particles", "--window", "--supersample", "2"},
                                                       {"bench", "nosuch"},
                                                       {"bench", "--frames", "0"},
                                                       {"study"},
                                                       {"study", "nosuch"},
                                                       {"particles", "--fps", "0"},
                                                       {"particles", "--out", "/proc/nosuch"}};
  for (const auto& arguments : wrong) {
    EXPECT_EQ(rooms(arguments).status, 2) << testing::PrintToString(arguments);
  }
}

TEST(RoomsProgram, RefusesWindowsWithoutAWindowSystem) {
  const process::Environment none = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"XDG_RUNTIME_DIR", ""}};
  EXPECT_EQ(process::run(ROOMS_PROGRAM, {"particles", "--window"}, none).status, 2);
}

TEST(RoomsProgram, ListsDemosAndStages) {
  const process::Outcome outcome = rooms({"--list"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* word :
       {"lighting", "particles", "postprocessing", "reflect", "water", "refraction", "faces"}) {
    EXPECT_NE(outcome.output.find(word), std::string::npos) << word;
  }
}

TEST(RoomsProgram, PutsFramesSideBySide) {
  const process::TemporaryDirectory folder;
  const process::Outcome outcome = rooms({"particles", "--particles", "50", "--size", "24x16", "--frames",
                                          "3-7", "--contact-sheet", "--stats", "--out", folder.path()});
  ASSERT_EQ(outcome.status, 0);
  OIIO::ImageBuf sheet(folder.path() + "/particles-sheet.png");
  ASSERT_TRUE(sheet.read(0, 0)) << sheet.geterror();
  // Five frames in rows of three, 4 pixels about each.
  EXPECT_EQ(sheet.spec().width, 3 * 28 + 4);
  EXPECT_EQ(sheet.spec().height, 2 * 20 + 4);
  // Draws, as the program and the implementation count them, are in the table.
  EXPECT_NE(outcome.output.find("particles, setup"), std::string::npos);
  EXPECT_NE(outcome.output.find("pipelines"), std::string::npos);
}

TEST(RoomsProgram, WritesEveryFormat) {
  const process::TemporaryDirectory folder;
  for (const char* format : {"png", "exr", "gif"}) {
    ASSERT_EQ(rooms({"particles", "--particles", "50", "--size", "20x10", "--frames", "0-1", "--format",
                     format, "--out", folder.path()})
                  .status,
              0);
  }
  const std::array names = {"particles-0000.png", "particles-0001.png", "particles-0000.exr",
                            "particles-0001.exr", "particles.gif"};
  for (const char* name : names) {
    OIIO::ImageBuf image(folder.path() + "/" + name);
    ASSERT_TRUE(image.read(0, 0)) << image.geterror();
    EXPECT_EQ(image.spec().width, 20);
    EXPECT_EQ(image.spec().height, 10);
  }
}

// Over the upper left corner of the picture, and nowhere else.
TEST(RoomsProgram, TellsWhatReflectLeavesOutWhenAsked) {
  const process::TemporaryDirectory folder;
  const auto draw = [&](const char* name, std::vector<std::string> options) {
    const std::string out = folder.path() + "/" + name;
    options.insert(options.end(), {"reflect", "--size", "64x48", "--samples", "0", "--out", out});
    EXPECT_EQ(rooms(options).status, 0);
    return OIIO::ImageBuf(out + "/reflect.png");
  };
  OIIO::ImageBuf plain = draw("plain", {});
  OIIO::ImageBuf told = draw("told", {"--culled"});
  ASSERT_TRUE(plain.read(0, 0) && told.read(0, 0));
  const auto differs = [&](int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        for (int i = 0; i < 3; ++i) {
          if (plain.getchannel(x, y, 0, i) != told.getchannel(x, y, 0, i)) return true;
        }
      }
    }
    return false;
  };
  EXPECT_TRUE(differs(2, 2, 12, 8));
  EXPECT_FALSE(differs(32, 0, 64, 48));
  EXPECT_FALSE(differs(0, 24, 64, 48));
}

TEST(RoomsProgram, MeasuresWhatItFinds) {
  const process::Outcome outcome = rooms({"bench", "particles", "--particles", "50", "--found", "--frames",
                                          "4", "--size", "64x48", "--error-size", "32x24", "--json"});
  ASSERT_EQ(outcome.status, 0);
  const nlohmann::json rows = nlohmann::json::parse(outcome.output);
  ASSERT_EQ(rows.size(), 1U);
  const nlohmann::json& row = rows[0];
  EXPECT_EQ(row["demo"], "particles");
  EXPECT_GT(row["median_ms"], 0.0);
  EXPECT_LE(row["1st_percentile_ms"], row["median_ms"]);
  EXPECT_LE(row["median_ms"], row["99th_percentile_ms"]);
  EXPECT_LE(row["99th_percentile_ms"], row["worst_ms"]);
  EXPECT_GT(row["draws"], 5.0);
  EXPECT_LT(row["error_rms_255"], 2.0);
}

}  // namespace
