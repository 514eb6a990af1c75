// Faults of drivers: which rows a device gets, and what ANTEROOM_QUIRKS makes of them.
#include "layer/vulkan/device/quirks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace anteroom::vulkan {
namespace {

const Driver kLavapipe{VK_DRIVER_ID_MESA_LLVMPIPE, {22, 3, 6}, "llvmpipe, Mesa 22.3.6 (LLVM 15.0.6)"};

bool same(const Quirks& a, const Quirks& b) {
  return std::ranges::all_of(allQuirks(), [&](const Quirk& q) { return a.*q.member == b.*q.member; });
}

TEST(QuirksTable, NamesAreWordsAndUnique) {
  std::set<std::string_view> names;
  for (const Quirk& quirk : allQuirks()) {
    EXPECT_TRUE(names.insert(quirk.name).second) << quirk.name;
    EXPECT_EQ(quirk.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string_view::npos)
        << quirk.name;
    EXPECT_NE(quirk.name, "all");
    EXPECT_FALSE(quirk.name.empty() || quirk.what.empty() || quirk.why.empty() || quirk.see.empty());
    EXPECT_NE(quirk.driver, VkDriverId{}) << quirk.name;
  }
}

TEST(QuirksTable, VersionsInText) {
  EXPECT_EQ(versionIn("Mesa 22.3.6 (LLVM 15.0.6)"), (DriverVersion{22, 3, 6}));
  EXPECT_EQ(versionIn("Mesa 23.1.0-devel (git-0123abcd)"), (DriverVersion{23, 1, 0}));
  EXPECT_EQ(versionIn("535.129.03"), (DriverVersion{535, 129, 3}));
  EXPECT_EQ(versionIn("24.2."), (DriverVersion{24, 2, 0}));
  EXPECT_EQ(versionIn("v1"), (DriverVersion{1, 0, 0}));
  EXPECT_EQ(versionIn("of no version"), DriverVersion{});
  EXPECT_EQ(versionIn(""), DriverVersion{});
}

TEST(QuirksTable, MatchByDriverAndVersion) {
  Quirk quirk{};
  quirk.driver = VK_DRIVER_ID_MESA_LLVMPIPE;
  EXPECT_TRUE(quirk.matches(kLavapipe));
  EXPECT_TRUE(quirk.matches({VK_DRIVER_ID_MESA_LLVMPIPE, {}, ""}));
  EXPECT_FALSE(quirk.matches({VK_DRIVER_ID_GOOGLE_SWIFTSHADER, {22, 3, 6}, ""}));
  EXPECT_FALSE(quirk.matches({{}, {22, 3, 6}, ""}));
  quirk.first = "22.3.6";
  quirk.fixed = "23.1";
  const auto matches = [&](DriverVersion version) {
    return quirk.matches({VK_DRIVER_ID_MESA_LLVMPIPE, version, ""});
  };
  EXPECT_FALSE(matches({22, 3, 5}));
  EXPECT_TRUE(matches({22, 3, 6}));
  EXPECT_TRUE(matches({23, 0, 9}));
  EXPECT_FALSE(matches({23, 1, 0}));
  EXPECT_FALSE(matches({}));  // of a fault that has an end, one whose version is unknown is not suspected
}

// What these rows were measured with has them all.
TEST(Quirks, LavapipeHasThemAllAndOthersNone) {
  std::string said;
  const Quirks all = quirksOf(kLavapipe, "", said);
  for (const Quirk& quirk : allQuirks()) {
    EXPECT_TRUE(all.*quirk.member) << quirk.name;
    EXPECT_NE(namesOf(all).find(quirk.name), std::string::npos);
  }
  EXPECT_TRUE(same(quirksOf({VK_DRIVER_ID_MESA_RADV, {22, 3, 6}, ""}, "", said), {}));
  EXPECT_EQ(namesOf({}), "");
  EXPECT_EQ(said, "");
}

TEST(Quirks, WordsSwitchThem) {
  std::string said;
  const Quirks without = quirksOf(kLavapipe, "-volume-blits,,-logic-op", said);
  EXPECT_FALSE(without.blitsToFirstSlice || without.logicOpNeedsBlend);
  EXPECT_TRUE(without.losesNineVertices);
  const Quirks only = quirksOf(kLavapipe, "-all,+volume-blits", said);
  EXPECT_EQ(namesOf(only), "volume-blits");
  EXPECT_EQ(namesOf(quirksOf({}, "+logic-op", said)), "logic-op");
  EXPECT_EQ(said, "");
}

TEST(Quirks, UnknownWordsMakeOneLineAndHelpListsAll) {
  std::string said;
  EXPECT_TRUE(same(quirksOf(kLavapipe, "logic-op,-logicop,+all,-", said), quirksOf(kLavapipe, "", said)));
  EXPECT_NE(said.find("ANTEROOM_QUIRKS does not know logic-op, -logicop, +all, -; it knows: "), said.npos)
      << said;
  EXPECT_EQ(std::ranges::count(said, '\n'), 1);
  said.clear();
  quirksOf(kLavapipe, "help", said);
  EXPECT_EQ(std::ranges::count(said, '\n'), static_cast<std::ptrdiff_t>(allQuirks().size()) + 2) << said;
}

}  // namespace
}  // namespace anteroom::vulkan
