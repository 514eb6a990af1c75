// --effort N: how often the usual work is done.
#include <cstdlib>
#include <cstring>

#include "fixture.h"

namespace threads {
namespace {

int chosenEffort = 1;

}  // namespace

int effort() {
  return chosenEffort;
}

}  // namespace threads

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc == 3 && !std::strcmp(argv[1], "--effort")) threads::chosenEffort = std::atoi(argv[2]);
  if (threads::chosenEffort < 1) return 64;
  return RUN_ALL_TESTS();
}
