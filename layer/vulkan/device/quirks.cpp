#include "layer/vulkan/device/quirks.h"

#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <vector>

#include "layer/render/word_list.h"

namespace anteroom::vulkan {
namespace {

constexpr Quirk kQuirks[] = {
#define QUIRK(member, ...) {&Quirks::member, __VA_ARGS__},
#include "layer/vulkan/device/quirks.inc"
#undef QUIRK
};

// Part of Vulkan 1.2, and an extension before.
bool tellsItsDriver(VkPhysicalDevice physical, uint32_t apiVersion) {
  if (apiVersion >= VK_API_VERSION_1_2) return true;
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data());
  for (const VkExtensionProperties& extension : extensions)
    if (!std::strcmp(extension.extensionName, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME)) return true;
  return false;
}

render::WordList wordList() {
  render::WordList list{"ANTEROOM_QUIRKS", {}};
  for (const Quirk& quirk : kQuirks)
    list.words.push_back({std::string("+-").append(quirk.name), std::string(quirk.what)});
  list.words.push_back({"-all", "nothing is done about any fault"});
  return list;
}

// False: no row has this name.
bool take(std::string_view word, Quirks& quirks) {
  const bool on = word.starts_with('+');
  if (!on && !word.starts_with('-')) return false;
  const std::string_view name = word.substr(1);
  if (word == "-all") return quirks = {}, true;
  for (const Quirk& quirk : kQuirks)
    if (quirk.name == name) return quirks.*quirk.member = on, true;
  return false;
}

}  // namespace

DriverVersion versionIn(std::string_view text) {
  DriverVersion version;
  const size_t start = text.find_first_of("0123456789");
  if (start == text.npos) return version;
  const char* at = text.data() + start;
  const char* const end = text.data() + text.size();
  for (int* number : {&version.major, &version.minor, &version.patch}) {
    at = std::from_chars(at, end, *number).ptr;
    if (end - at < 2 || *at != '.' || at[1] < '0' || at[1] > '9') break;
    ++at;
  }
  return version;
}

Driver driverOf(VkPhysicalDevice physical) {
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical, &properties);
  // Drivers write the number of their version as they like.
  if (!tellsItsDriver(physical, properties.apiVersion))
    return {{}, {}, "version " + std::to_string(properties.driverVersion)};
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceProperties2 all{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver};
  vkGetPhysicalDeviceProperties2(physical, &all);
  return {driver.driverID, versionIn(driver.driverInfo),
          std::string(driver.driverName) + ", " + driver.driverInfo};
}

bool Quirk::matches(const Driver& of) const {
  if (of.id != driver) return false;
  if (of.version == DriverVersion{}) return first.empty() && fixed.empty();
  return of.version >= versionIn(first) && (fixed.empty() || of.version < versionIn(fixed));
}

std::span<const Quirk> allQuirks() {
  return kQuirks;
}

Quirks quirksOf(const Driver& driver, std::string_view words, std::string& complaint) {
  Quirks quirks;
  for (const Quirk& quirk : kQuirks) quirks.*quirk.member = quirk.matches(driver);
  complaint += wordList().read(words, [&](std::string_view word) { return take(word, quirks); });
  return quirks;
}

Quirks quirksOf(const Driver& driver) {
  static std::atomic_flag complained;
  std::string complaint;
  const Quirks quirks = quirksOf(driver, render::environmentWords("ANTEROOM_QUIRKS"), complaint);
  if (!complaint.empty() && !complained.test_and_set()) std::fputs(complaint.c_str(), stderr);
  return quirks;
}

std::string namesOf(const Quirks& quirks) {
  std::string names;
  for (const Quirk& quirk : kQuirks)
    if (quirks.*quirk.member) names.append(names.empty() ? "" : " ").append(quirk.name);
  return names;
}

}  // namespace anteroom::vulkan
