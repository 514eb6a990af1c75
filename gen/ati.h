// Enumerants of desktop extensions that Khronos' ES headers lack, by the numbers of the GL registry; those of
// ATIX_texture_env_route, which is not in it, as drivers had them.
#pragma once

#include <GLES/gl.h>

namespace anteroom::gen {

// ATI_texture_env_combine3, and the same under ATIX's name: combiner functions. ZERO and ONE are sources.
inline constexpr GLenum kModulateAdd = 0x8744;        // Arg0 * Arg2 + Arg1
inline constexpr GLenum kModulateSignedAdd = 0x8745;  // Arg0 * Arg2 + Arg1 - 0.5
inline constexpr GLenum kModulateSubtract = 0x8746;   // Arg0 * Arg2 - Arg1

// EXT_texture_env_dot3: functions that RGB_SCALE and ALPHA_SCALE do not reach.
inline constexpr GLenum kDot3RgbExt = 0x8740;
inline constexpr GLenum kDot3RgbaExt = 0x8741;

// ATIX_texture_env_route. Its rules are known in part; where they are not, these hold:
// - A unit's outputs are set by TexEnv, color and alpha apart: TEXTUREn, at first the unit's own, which means
//   that nothing is routed. Any other value than a TEXTUREn that exists is INVALID_ENUM.
// - From the next unit on, SRC = TEXTUREn, and TEXTURE on unit n, is the routed result, not the texture; of
//   several units that route to n, the last one before the reader counts. Units before it read the texture.
// - The result is PREVIOUS for the next unit as ever; fixed environment modes read the texture as ever.
// - A unit that is off routes nothing; a routed result may stand for a unit without a texture.
// - SECONDARY_COLOR is a source of color whose every component is 0: ES 1.1 has no secondary color.
// - FOG is a source of alpha: the fog factor, by the fog's mode and values, whether or not FOG is enabled.
inline constexpr GLenum kSecondaryColor = 0x8747;
inline constexpr GLenum kTextureOutputRgb = 0x8748;
inline constexpr GLenum kTextureOutputAlpha = 0x8749;

// ATI_texture_mirror_once, EXT_texture_mirror_clamp: wrap modes.
inline constexpr GLenum kMirrorClamp = 0x8742;
inline constexpr GLenum kMirrorClampToEdge = 0x8743;
inline constexpr GLenum kMirrorClampToBorder = 0x8912;

}  // namespace anteroom::gen
