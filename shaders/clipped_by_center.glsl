// Expects: nothing
// Section 2.11: a point is there when its centre is inside the clip volume, whatever its size. Drivers may keep the part
// of it that is inside; they do clip by depth.
vec4 clippedByCenter(vec4 clip) {
  return all(lessThanEqual(abs(clip.xy), clip.ww)) ? clip : vec4(0.0, 0.0, 2.0, 1.0);
}
