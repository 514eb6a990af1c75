#version 450
// Lines of text and a graph on a translucent plate (ANTEROOM_HUD).
layout(set = 2, binding = 0) uniform Hud {
  ivec4 place;   // the plate's upper left corner; pixels of one of its own; height of the picture, 0: row 0 is its top
  ivec4 plate;   // its size in pixels of its own; lines; columns that hold names
  ivec4 graph;   // the line above it, -1: none; columns; y of the mark
  uvec4 font[48];
  uvec4 text[18];
  vec4 samples[36];
};
layout(location = 0) out vec4 color;

const int kPadding = 5, kRow = 12, kColumn = 6, kGraph = 26;
const vec4 kPlate = vec4(0.04, 0.05, 0.07, 0.78), kName = vec4(0.56, 0.69, 0.80, 1), kValue = vec4(0.95, 0.96, 0.97, 1);
const vec4 kMark = vec4(1, 1, 1, 0.35);
const vec4 kGood = vec4(0.40, 0.80, 0.50, 1), kFair = vec4(0.93, 0.75, 0.32, 1), kBad = vec4(0.92, 0.38, 0.33, 1);

uint byteOf(uvec4 words, int i) { return words[i >> 2] >> (8 * (i & 3)) & 0xffu; }

bool inGlyph(uint character, ivec2 at) {
  if (character < 32u || character > 127u || at.x >= 5 || at.y >= 9) return false;
  uvec4 pair = font[(character - 32u) >> 1];
  uvec2 glyph = (character & 1u) == 0u ? pair.xy : pair.zw;
  int bit = at.y * 5 + at.x;
  return ((bit < 32 ? glyph.x >> bit : glyph.y >> (bit - 32)) & 1u) == 1u;
}

// The bar of one sample; its height says how good it is, too.
vec4 graphAt(ivec2 at) {
  float value = samples[at.x >> 2][at.x & 3];
  int y = kGraph - 1 - at.y;
  vec4 under = y == graph.z ? kMark : vec4(kPlate.rgb * 0.5, kPlate.a);
  if (float(y) >= ceil(value * kGraph)) return under;
  float mark = float(graph.z + 1) / kGraph;
  vec4 bar = value <= mark * 1.1 ? kGood : value <= mark * 2.1 ? kFair : kBad;
  return y == graph.z ? mix(bar, vec4(1), 0.4) : bar;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (place.w > 0) pixel.y = place.w - 1 - pixel.y;
  ivec2 at = (pixel - place.xy) / place.z;
  ivec2 edge = min(at, plate.xy - 1 - at);
  if (edge.x + edge.y < 2) discard;  // round corners
  color = kPlate;
  at -= kPadding;
  if (at.x < 0 || at.y < 0 || at.x >= graph.y * kColumn) return;
  if (graph.x >= 0 && at.y >= (graph.x + 1) * kRow) {
    int below = at.y - (graph.x + 1) * kRow;
    if (below < kGraph) {
      color = graphAt(ivec2(at.x, below));
      return;
    }
    at.y -= kGraph + 4;
    if (at.y < (graph.x + 1) * kRow) return;
  }
  ivec2 cell = at / ivec2(kColumn, kRow);
  if (cell.y >= plate.z) return;
  int i = cell.y * graph.y + cell.x;
  if (inGlyph(byteOf(text[i >> 4], i & 15), at - cell * ivec2(kColumn, kRow)))
    color = cell.x < plate.w ? kName : kValue;
}
