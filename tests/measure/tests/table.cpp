#include "tests/measure/table.h"

#include <gtest/gtest.h>

namespace measure {
namespace {

Table times() {
  Table table({{"scene"},
               {"implementation"},
               {"median", "ms", 2},
               {"error", "1/255"},
               {.name = "fault", .detail = true}});
  table.add({"a", "ours", 1.5, 0.0, {}});
  table.add({"a", "mesa", 12.25, 1.0, {}});
  table.add({"long, \"b\"", "mesa", "WRONG", {}, "no picture"});
  return table;
}

TEST(Table, ShowsEveryColumnWithItsUnit) {
  EXPECT_EQ(times().text(),
            "scene      implementation  median    error\n"
            "                             [ms]  [1/255]\n"
            "a          ours              1.50        0\n"
            "a          mesa             12.25        1\n"
            "long, \"b\"  mesa             WRONG        -\n");
}

TEST(Table, PutsImplementationsSideBySide) {
  EXPECT_EQ(times().sideBySide(1),
            "          |   ours          |   mesa\n"
            "scene     | median    error | median    error\n"
            "          |   [ms]  [1/255] |   [ms]  [1/255]\n"
            "a         |   1.50        0 |  12.25        1\n"
            "long, \"b\" |      -        - |  WRONG        -\n");
}

TEST(Table, NamesUnitsForPrograms) {
  EXPECT_EQ(times().csv(),
            "scene,implementation,median_ms,error_255,fault\n"
            "a,ours,1.5,0,\n"
            "a,mesa,12.25,1,\n"
            "\"long, \"\"b\"\"\",mesa,WRONG,,no picture\n");
  const nlohmann::json rows = times().json();
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1]["median_ms"], 12.25);
  EXPECT_FALSE(rows[1].contains("fault"));
  EXPECT_FALSE(rows[2].contains("error_255"));
}

TEST(Table, RefusesRowsOfAnotherLength) {
  EXPECT_THROW(times().add({"a"}), std::logic_error);
}

}  // namespace
}  // namespace measure
