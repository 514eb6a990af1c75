// Section 3.4.1: selection and sorting.
#include <algorithm>
#include <array>
#include <tuple>

#include "layer/egl/attributes.h"
#include "layer/egl/config.h"
#include "layer/egl/errors.h"

namespace anteroom::egl {
namespace {

enum class Match : uint8_t { AtLeast, Exact, Mask, Special };

constexpr EGLint kApiBits =
    EGL_OPENGL_ES_BIT | EGL_OPENVG_BIT | EGL_OPENGL_ES2_BIT | EGL_OPENGL_BIT | EGL_OPENGL_ES3_BIT;
constexpr EGLint kSurfaceBits = EGL_PBUFFER_BIT | EGL_PIXMAP_BIT | EGL_WINDOW_BIT |
                                EGL_VG_COLORSPACE_LINEAR_BIT | EGL_VG_ALPHA_FORMAT_PRE_BIT |
                                EGL_MULTISAMPLE_RESOLVE_BOX_BIT | EGL_SWAP_BEHAVIOR_PRESERVED_BIT;

struct Criterion {
  EGLint attribute;
  EGLint initial;
  Match match;
};

// Table 3.4, and the attributes that are accepted and ignored.
constexpr std::array kCriteria = {
    Criterion{EGL_BUFFER_SIZE, 0, Match::AtLeast},
    Criterion{EGL_RED_SIZE, 0, Match::AtLeast},
    Criterion{EGL_GREEN_SIZE, 0, Match::AtLeast},
    Criterion{EGL_BLUE_SIZE, 0, Match::AtLeast},
    Criterion{EGL_LUMINANCE_SIZE, 0, Match::AtLeast},
    Criterion{EGL_ALPHA_SIZE, 0, Match::AtLeast},
    Criterion{EGL_ALPHA_MASK_SIZE, 0, Match::AtLeast},
    Criterion{EGL_BIND_TO_TEXTURE_RGB, EGL_DONT_CARE, Match::Exact},
    Criterion{EGL_BIND_TO_TEXTURE_RGBA, EGL_DONT_CARE, Match::Exact},
    Criterion{EGL_COLOR_BUFFER_TYPE, EGL_RGB_BUFFER, Match::Exact},
    Criterion{EGL_CONFIG_CAVEAT, EGL_DONT_CARE, Match::Exact},
    Criterion{EGL_CONFIG_ID, EGL_DONT_CARE, Match::Special},
    Criterion{EGL_CONFORMANT, 0, Match::Mask},
    Criterion{EGL_DEPTH_SIZE, 0, Match::AtLeast},
    Criterion{EGL_LEVEL, 0, Match::Exact},
    Criterion{EGL_MATCH_NATIVE_PIXMAP, EGL_NONE, Match::Special},
    Criterion{EGL_MAX_SWAP_INTERVAL, EGL_DONT_CARE, Match::Exact},
    Criterion{EGL_MIN_SWAP_INTERVAL, EGL_DONT_CARE, Match::Exact},
    Criterion{EGL_NATIVE_RENDERABLE, EGL_DONT_CARE, Match::Exact},
    Criterion{EGL_NATIVE_VISUAL_TYPE, EGL_DONT_CARE, Match::Special},
    Criterion{EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, Match::Mask},
    Criterion{EGL_SAMPLE_BUFFERS, 0, Match::AtLeast},
    Criterion{EGL_SAMPLES, 0, Match::AtLeast},
    Criterion{EGL_STENCIL_SIZE, 0, Match::AtLeast},
    Criterion{EGL_SURFACE_TYPE, EGL_WINDOW_BIT, Match::Mask},
    Criterion{EGL_TRANSPARENT_TYPE, EGL_NONE, Match::Exact},
    Criterion{EGL_TRANSPARENT_RED_VALUE, EGL_DONT_CARE, Match::Special},
    Criterion{EGL_TRANSPARENT_GREEN_VALUE, EGL_DONT_CARE, Match::Special},
    Criterion{EGL_TRANSPARENT_BLUE_VALUE, EGL_DONT_CARE, Match::Special},
    Criterion{EGL_MAX_PBUFFER_WIDTH, EGL_DONT_CARE, Match::Special},
    Criterion{EGL_MAX_PBUFFER_HEIGHT, EGL_DONT_CARE, Match::Special},
    Criterion{EGL_MAX_PBUFFER_PIXELS, EGL_DONT_CARE, Match::Special},
    Criterion{EGL_NATIVE_VISUAL_ID, EGL_DONT_CARE, Match::Special},
};

bool isOneOf(EGLint value, std::initializer_list<EGLint> values) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

// Whether a value can be asked for at all; EGL_DONT_CARE is dealt with before.
bool isValid(EGLint attribute, EGLint value) {
  switch (attribute) {
    case EGL_BIND_TO_TEXTURE_RGB:
    case EGL_BIND_TO_TEXTURE_RGBA:
    case EGL_NATIVE_RENDERABLE:
      return isOneOf(value, {EGL_TRUE, EGL_FALSE});
    case EGL_COLOR_BUFFER_TYPE:
      return isOneOf(value, {EGL_RGB_BUFFER, EGL_LUMINANCE_BUFFER});
    case EGL_CONFIG_CAVEAT:
      return isOneOf(value, {EGL_NONE, EGL_SLOW_CONFIG, EGL_NON_CONFORMANT_CONFIG});
    case EGL_TRANSPARENT_TYPE:
      return isOneOf(value, {EGL_NONE, EGL_TRANSPARENT_RGB});
    case EGL_CONFORMANT:
    case EGL_RENDERABLE_TYPE:
      return (value & ~kApiBits) == 0;
    case EGL_SURFACE_TYPE:
      return (value & ~kSurfaceBits) == 0;
    case EGL_SAMPLE_BUFFERS:
      return isOneOf(value, {0, 1});
    case EGL_CONFIG_ID:
      return value > 0;
    case EGL_LEVEL:
    case EGL_MATCH_NATIVE_PIXMAP:
    case EGL_NATIVE_VISUAL_ID:
    case EGL_NATIVE_VISUAL_TYPE:
    case EGL_MAX_PBUFFER_WIDTH:
    case EGL_MAX_PBUFFER_HEIGHT:
    case EGL_MAX_PBUFFER_PIXELS:
      return true;
    default:
      return value >= 0;
  }
}

class Request {
 public:
  explicit Request(const EGLint* attributes) {
    for (size_t i = 0; i < kCriteria.size(); ++i) values_[i] = kCriteria[i].initial;
    forEachAttribute(attributes, [this](EGLint attribute, EGLAttrib value) {
      set(attribute, static_cast<EGLint>(value));
    });
    // No platform has native pixmaps.
    require(get(EGL_MATCH_NATIVE_PIXMAP) == EGL_NONE, EGL_BAD_NATIVE_PIXMAP);
  }

  EGLint get(EGLint attribute) const { return values_[indexOf(attribute)]; }

  bool matches(const Config& config) const {
    // "When EGL_CONFIG_ID is specified, all other attributes are ignored."
    const EGLint id = get(EGL_CONFIG_ID);
    if (id != EGL_DONT_CARE) return config.id == id;
    // "...ignored unless windows are asked for."
    const EGLint type = get(EGL_NATIVE_VISUAL_TYPE);
    const bool windows = (get(EGL_SURFACE_TYPE) & EGL_WINDOW_BIT) != 0;
    if (windows && type != EGL_DONT_CARE && type != config.visual.type) return false;
    for (size_t i = 0; i < kCriteria.size(); ++i) {
      if (values_[i] != EGL_DONT_CARE && !matches(config, kCriteria[i], values_[i])) return false;
    }
    return true;
  }

 private:
  static size_t indexOf(EGLint attribute) {
    const auto found = std::find_if(kCriteria.begin(), kCriteria.end(),
                                    [=](const Criterion& c) { return c.attribute == attribute; });
    require(found != kCriteria.end(), EGL_BAD_ATTRIBUTE);
    return static_cast<size_t>(found - kCriteria.begin());
  }

  void set(EGLint attribute, EGLint value) {
    const size_t index = indexOf(attribute);
    const bool dontCare = value == EGL_DONT_CARE;
    if (attribute == EGL_LEVEL || attribute == EGL_MATCH_NATIVE_PIXMAP) require(!dontCare, EGL_BAD_ATTRIBUTE);
    require(dontCare || isValid(attribute, value), EGL_BAD_ATTRIBUTE);
    values_[index] = value;
  }

  static bool matches(const Config& config, const Criterion& criterion, EGLint wanted) {
    const EGLint value = config.get(criterion.attribute);
    switch (criterion.match) {
      case Match::AtLeast:
        return value >= wanted;
      case Match::Exact:
        return value == wanted;
      case Match::Mask:
        return (value & wanted) == wanted;
      case Match::Special:
        return true;  // seen to elsewhere, or ignored where nothing is transparent
    }
    return false;
  }

  std::array<EGLint, kCriteria.size()> values_;
};

// Rule 3: the bits of those components that were asked for.
EGLint requestedColorBits(const Request& request, const Config& config) {
  EGLint bits = 0;
  for (EGLint component : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE}) {
    const EGLint wanted = request.get(component);
    if (wanted != 0 && wanted != EGL_DONT_CARE) bits += config.get(component);
  }
  return bits;
}

}  // namespace

std::vector<const Config*> chooseConfigs(const std::vector<Config>& configs, const EGLint* attributes) {
  const Request request(attributes);
  std::vector<const Config*> chosen;
  for (const Config& config : configs) {
    if (request.matches(config)) chosen.push_back(&config);
  }
  // Rules 1, 2, 9 and 10 (first visuals have the lower ids) tell none of our configs apart; 5 follows from 6.
  const auto rank = [&](const Config* config) {
    return std::tuple(-requestedColorBits(request, *config), config->get(EGL_BUFFER_SIZE), config->samples,
                      config->depthBits, config->stencilBits, config->id);
  };
  std::sort(chosen.begin(), chosen.end(),
            [&](const Config* left, const Config* right) { return rank(left) < rank(right); });
  return chosen;
}

}  // namespace anteroom::egl
