#include "rejections.h"

#include <fmt/format.h>

#include <algorithm>

#include "state_snapshot.h"

namespace conformance {

void RejectionTest::reject(const std::vector<Rejected>& rows) {
  for (const Rejected& row : rows) {
    if (onMesa() && row.mesaDeparts) {
      fmt::print("    Mesa departs from section {}, {}: {}\n", row.section, row.text, row.mesaDeparts);
      continue;
    }
    const StateSnapshot before = takeSnapshot();
    ASSERT_GL_ERROR(GL_NO_ERROR);
    row.call();
    const GLenum error = glGetError();
    EXPECT_TRUE(std::find(row.errors.begin(), row.errors.end(), error) != row.errors.end())
        << row.section << ": " << row.text << " gave " << errorName(error) << ", want "
        << errorName(row.errors[0]);
    EXPECT_EQ(difference(before, takeSnapshot()), "") << row.section << ": " << row.text << " changed state";
    while (glGetError() != GL_NO_ERROR) {
    }
  }
}

GLint integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

}  // namespace conformance
