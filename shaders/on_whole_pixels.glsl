// Expects: nothing
// Section 3.3.1: where a point that is neither smooth nor a sprite has its centre: floor(x) + 1/2 when its width is odd,
// floor(x + 1/2) when it is even. Window coordinates have 8 bits below one: else what is meant to lie on a pixel's edge
// would fall to either side of it.
vec4 onWholePixels(vec4 clip, vec4 viewport, float width) {
  vec2 window = clip.xy / clip.w * viewport.zw + viewport.xy;
  float odd = 0.5 * mod(width, 2.0);
  vec2 center = floor(floor(window * 256.0 + 0.5) / 256.0 + 0.5 - odd) + odd;
  return vec4(clamp((center - viewport.xy) / viewport.zw, -1.0, 1.0) * clip.w, clip.zw);
}
