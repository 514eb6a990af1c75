// Section 3.4.1: selection and sorting.
#include <algorithm>
#include <array>

#include "layer/egl/attributes.h"
#include "layer/egl/config_attributes.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {
namespace {

bool matches(const ConfigAttribute& attribute, const Config& config, EGLint wanted) {
  switch (attribute.match) {
    case Match::AtLeast:
      return attribute.value(config) >= wanted;
    case Match::Exact:
      return attribute.value(config) == wanted;
    case Match::Mask:
      return (attribute.value(config) & wanted) == wanted;
    case Match::Special:
      return true;
  }
  return false;
}

class Request {
 public:
  explicit Request(const EGLint* list) {
    for (const ConfigAttribute& attribute : configAttributes()) values_.push_back(attribute.initial);
    forEachAttribute(list, [this](EGLint name, EGLAttrib value) {
      const ConfigAttribute* attribute = configAttribute(name);
      require(attribute != nullptr && attribute->legal(static_cast<EGLint>(value)), EGL_BAD_ATTRIBUTE);
      values_[indexOf(*attribute)] = static_cast<EGLint>(value);
    });
    // No platform has native pixmaps.
    require(wanted(EGL_MATCH_NATIVE_PIXMAP) == EGL_NONE, EGL_BAD_NATIVE_PIXMAP);
  }

  bool accepts(const Config& config) const {
    // "When EGL_CONFIG_ID is specified, all other attributes are ignored."
    const EGLint id = wanted(EGL_CONFIG_ID);
    if (id != EGL_DONT_CARE) return config.id == id;
    // "...ignored unless windows are asked for."
    const EGLint type = wanted(EGL_NATIVE_VISUAL_TYPE);
    const bool windows = (wanted(EGL_SURFACE_TYPE) & EGL_WINDOW_BIT) != 0;
    if (windows && type != EGL_DONT_CARE && type != config.visual.type) return false;
    return std::ranges::all_of(configAttributes(), [&](const ConfigAttribute& attribute) {
      return wanted(attribute) == EGL_DONT_CARE || matches(attribute, config, wanted(attribute));
    });
  }

  // What each rule of section 3.4.1.2 compares; the smaller is first.
  std::array<EGLint, kLastSortRule + 1> rank(const Config& config) const {
    std::array<EGLint, kLastSortRule + 1> rank{};
    for (const ConfigAttribute& attribute : configAttributes()) {
      if (attribute.sortRule == kRequestedColorBits) {
        const bool isRequested = wanted(attribute) != 0 && wanted(attribute) != EGL_DONT_CARE;
        if (isRequested) rank[kRequestedColorBits] -= attribute.value(config);
      } else if (attribute.sortRule != kUnsorted) {
        rank[attribute.sortRule] = attribute.value(config);
      }
    }
    return rank;
  }

 private:
  static size_t indexOf(const ConfigAttribute& attribute) {
    return static_cast<size_t>(&attribute - configAttributes().data());
  }
  EGLint wanted(const ConfigAttribute& attribute) const { return values_[indexOf(attribute)]; }
  EGLint wanted(EGLint name) const { return wanted(*configAttribute(name)); }

  std::vector<EGLint> values_;  // what is asked for, an attribute each
};

}  // namespace

std::vector<const Config*> chooseConfigs(const std::vector<Config>& configs, const EGLint* attributes) {
  const Request request(attributes);
  std::vector<const Config*> chosen;
  for (const Config& config : configs) {
    if (request.accepts(config)) chosen.push_back(&config);
  }
  std::ranges::sort(chosen, {}, [&](const Config* config) { return request.rank(*config); });
  return chosen;
}

}  // namespace anteroom::egl
