// Expects: nothing
// How much of a pixel the circle covers; the square that is rasterised is a pixel wider than the diameter.
float pointCoverage(vec2 coord, float diameter) {
  float fromCentre = length(coord - 0.5) * (diameter + 1.0);
  return clamp(0.5 * diameter + 0.5 - fromCentre, 0.0, 1.0);
}
