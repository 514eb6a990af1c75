// The same device without us, and a picture of the same size on it. Prints what is resident, in KiB.
#include "resident.h"
#include "tests/driver/device.h"
#include "value_frag.h"

int main() {
  driver::Device device;
  driver::Draw draw;
  draw.fragmentShader = value_frag;
  draw.vertices = {
      {{-1, -1, 0, 1}, {1, 0, 0, 1}}, {{1, -1, 0, 1}, {0, 1, 0, 1}}, {{0, 1, 0, 1}, {0, 0, 1, 1}}};
  device.render(VK_FORMAT_R8G8B8A8_UNORM, 1024, 768, {draw});
  printResident();
  return 0;
}
