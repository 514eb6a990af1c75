#include "layer/egl/config_attributes.h"

#include <algorithm>
#include <climits>

namespace anteroom::egl {
namespace {

constexpr EGLint kApiBits =
    EGL_OPENGL_ES_BIT | EGL_OPENVG_BIT | EGL_OPENGL_ES2_BIT | EGL_OPENGL_BIT | EGL_OPENGL_ES3_BIT;
constexpr EGLint kSurfaceBits = EGL_PBUFFER_BIT | EGL_PIXMAP_BIT | EGL_WINDOW_BIT |
                                EGL_VG_COLORSPACE_LINEAR_BIT | EGL_VG_ALPHA_FORMAT_PRE_BIT |
                                EGL_MULTISAMPLE_RESOLVE_BOX_BIT | EGL_SWAP_BEHAVIOR_PRESERVED_BIT;

// Which values may be asked for.
template <EGLint... allowed>
bool isOneOf(EGLint value) {
  return value == EGL_DONT_CARE || ((value == allowed) || ...);
}
template <EGLint bits>
bool isMaskOf(EGLint value) {
  return value == EGL_DONT_CARE || (value & ~bits) == 0;
}
bool isSize(EGLint value) {
  return value == EGL_DONT_CARE || value >= 0;
}
bool isAny(EGLint) {
  return true;
}
bool isGiven(EGLint value) {
  return value != EGL_DONT_CARE;
}

const render::FormatInfo& bitsOf(const Config& config) {
  return render::info(config.color);
}

EGLint surfaceTypes(const Config& config) {
  return EGL_PBUFFER_BIT | (config.window ? EGL_WINDOW_BIT : 0) | EGL_SWAP_BEHAVIOR_PRESERVED_BIT |
         (config.samples != 0 ? EGL_MULTISAMPLE_RESOLVE_BOX_BIT : 0);
}

using enum Match;

constexpr ConfigAttribute kAttributes[] = {
    // Table 3.4. Rules 1 and 2 have their precedences in the order of the names' numbers; rule 10 is ours to
    // choose, and the first visuals have the lower ids.
    {EGL_BUFFER_SIZE, 0, AtLeast, 4, isSize,
     [](const Config& c) { return bitsOf(c).red + bitsOf(c).green + bitsOf(c).blue + bitsOf(c).alpha; }},
    {EGL_RED_SIZE, 0, AtLeast, kRequestedColorBits, isSize,
     [](const Config& c) -> EGLint { return bitsOf(c).red; }},
    {EGL_GREEN_SIZE, 0, AtLeast, kRequestedColorBits, isSize,
     [](const Config& c) -> EGLint { return bitsOf(c).green; }},
    {EGL_BLUE_SIZE, 0, AtLeast, kRequestedColorBits, isSize,
     [](const Config& c) -> EGLint { return bitsOf(c).blue; }},
    {EGL_LUMINANCE_SIZE, 0, AtLeast, kRequestedColorBits, isSize, [](const Config&) { return 0; }},
    {EGL_ALPHA_SIZE, 0, AtLeast, kRequestedColorBits, isSize,
     [](const Config& c) -> EGLint { return bitsOf(c).alpha; }},
    {EGL_ALPHA_MASK_SIZE, 0, AtLeast, 9, isSize, [](const Config&) { return 0; }},
    {EGL_BIND_TO_TEXTURE_RGB, EGL_DONT_CARE, Exact, kUnsorted, isOneOf<EGL_TRUE, EGL_FALSE>,
     [](const Config& c) -> EGLint { return c.samples == 0; }},
    {EGL_BIND_TO_TEXTURE_RGBA, EGL_DONT_CARE, Exact, kUnsorted, isOneOf<EGL_TRUE, EGL_FALSE>,
     [](const Config& c) -> EGLint { return c.samples == 0 && bitsOf(c).alpha != 0; }},
    {EGL_COLOR_BUFFER_TYPE, EGL_RGB_BUFFER, Exact, 2, isOneOf<EGL_RGB_BUFFER, EGL_LUMINANCE_BUFFER>,
     [](const Config&) { return EGL_RGB_BUFFER; }},
    {EGL_CONFIG_CAVEAT, EGL_DONT_CARE, Exact, 1,
     isOneOf<EGL_NONE, EGL_SLOW_CONFIG, EGL_NON_CONFORMANT_CONFIG>, [](const Config&) { return EGL_NONE; }},
    {EGL_CONFIG_ID, EGL_DONT_CARE, Special, kLastSortRule,
     [](EGLint value) { return value == EGL_DONT_CARE || value > 0; }, [](const Config& c) { return c.id; }},
    {EGL_CONFORMANT, 0, Mask, kUnsorted, isMaskOf<kApiBits>, [](const Config&) { return EGL_OPENGL_ES_BIT; }},
    {EGL_DEPTH_SIZE, 0, AtLeast, 7, isSize, [](const Config& c) { return c.depthBits; }},
    {EGL_LEVEL, 0, Exact, kUnsorted, isGiven, [](const Config&) { return 0; }},
    {EGL_MATCH_NATIVE_PIXMAP, EGL_NONE, Special, kUnsorted, isGiven, nullptr},
    {EGL_MAX_SWAP_INTERVAL, EGL_DONT_CARE, Exact, kUnsorted, isSize, [](const Config&) { return 1; }},
    {EGL_MIN_SWAP_INTERVAL, EGL_DONT_CARE, Exact, kUnsorted, isSize, [](const Config&) { return 0; }},
    {EGL_NATIVE_RENDERABLE, EGL_DONT_CARE, Exact, kUnsorted, isOneOf<EGL_TRUE, EGL_FALSE>,
     [](const Config&) { return EGL_FALSE; }},
    {EGL_NATIVE_VISUAL_TYPE, EGL_DONT_CARE, Special, kUnsorted, isAny,
     [](const Config& c) { return c.visual.type; }},
    {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, Mask, kUnsorted, isMaskOf<kApiBits>,
     [](const Config&) { return EGL_OPENGL_ES_BIT; }},
    {EGL_SAMPLE_BUFFERS, 0, AtLeast, 5, isOneOf<0, 1>,
     [](const Config& c) -> EGLint { return c.samples != 0; }},
    {EGL_SAMPLES, 0, AtLeast, 6, isSize, [](const Config& c) { return c.samples; }},
    {EGL_STENCIL_SIZE, 0, AtLeast, 8, isSize, [](const Config& c) { return c.stencilBits; }},
    {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, Mask, kUnsorted, isMaskOf<kSurfaceBits>, surfaceTypes},
    {EGL_TRANSPARENT_TYPE, EGL_NONE, Exact, kUnsorted, isOneOf<EGL_NONE, EGL_TRANSPARENT_RGB>,
     [](const Config&) { return EGL_NONE; }},
    // Ignored where nothing is transparent.
    {EGL_TRANSPARENT_RED_VALUE, EGL_DONT_CARE, Special, kUnsorted, isSize, [](const Config&) { return 0; }},
    {EGL_TRANSPARENT_GREEN_VALUE, EGL_DONT_CARE, Special, kUnsorted, isSize, [](const Config&) { return 0; }},
    {EGL_TRANSPARENT_BLUE_VALUE, EGL_DONT_CARE, Special, kUnsorted, isSize, [](const Config&) { return 0; }},

    // Accepted and ignored.
    {EGL_MAX_PBUFFER_WIDTH, EGL_DONT_CARE, Special, kUnsorted, isAny,
     [](const Config& c) { return c.maxWidth; }},
    {EGL_MAX_PBUFFER_HEIGHT, EGL_DONT_CARE, Special, kUnsorted, isAny,
     [](const Config& c) { return c.maxHeight; }},
    {EGL_MAX_PBUFFER_PIXELS, EGL_DONT_CARE, Special, kUnsorted, isAny,
     [](const Config& c) {
       return static_cast<EGLint>(std::min<int64_t>(int64_t{c.maxWidth} * c.maxHeight, INT_MAX));
     }},
    {EGL_NATIVE_VISUAL_ID, EGL_DONT_CARE, Special, kUnsorted, isAny,
     [](const Config& c) { return c.visual.id; }},
};

constexpr bool isOnce(const ConfigAttribute& attribute) {
  return std::ranges::count(kAttributes, attribute.name, &ConfigAttribute::name) == 1;
}
static_assert(std::ranges::all_of(kAttributes, isOnce), "a name is there twice");

}  // namespace

std::span<const ConfigAttribute> configAttributes() {
  return kAttributes;
}

const ConfigAttribute* configAttribute(EGLint name) {
  const auto* found = std::ranges::find(kAttributes, name, &ConfigAttribute::name);
  return found != std::end(kAttributes) ? found : nullptr;
}

}  // namespace anteroom::egl
