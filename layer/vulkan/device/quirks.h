// Which driver a device has, and what is done about its faults: the rows of quirks.inc.
#pragma once

#include <volk.h>

#include <span>
#include <string>
#include <string_view>

namespace anteroom::vulkan {

struct DriverVersion {
  int major = 0, minor = 0, patch = 0;
  auto operator<=>(const DriverVersion&) const = default;
};
// The first numbers with points between them: of "Mesa 22.3.6 (LLVM 15.0.6)" 22.3.6. Zeros: there are none.
DriverVersion versionIn(std::string_view text);

struct Driver {
  VkDriverId id{};        // zero: it does not say
  DriverVersion version;  // zeros: it does not say
  std::string text;       // its name and version, for people
};
Driver driverOf(VkPhysicalDevice physical);

// Those that are in force for a device.
struct Quirks {
#define QUIRK(member, ...) bool member = false;
#include "layer/vulkan/device/quirks.inc"
#undef QUIRK
};

struct Quirk {
  bool Quirks::*member;
  std::string_view name;  // in ANTEROOM_QUIRKS
  VkDriverId driver;
  std::string_view first, fixed;  // versions: from `first` on, before `fixed`; empty: no bound is known
  std::string_view what, why, see;

  // A version that is not known has what any version has.
  bool matches(const Driver& of) const;
};
std::span<const Quirk> allQuirks();

// Those that match. `words` are of ANTEROOM_QUIRKS: `-name` switches one off, `+name` on, `-all` all off,
// from left to right. `complaint`: lines for stderr about words that are not known, or the list that `help`
// asks for.
Quirks quirksOf(const Driver& driver, std::string_view words, std::string& complaint);
// With what ANTEROOM_QUIRKS says; complaints are written once by a process.
Quirks quirksOf(const Driver& driver);

// The names of those in force, with spaces between them.
std::string namesOf(const Quirks& quirks);

}  // namespace anteroom::vulkan
