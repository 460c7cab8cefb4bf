// How the stock is drawn: corners are lifted to their heights, light comes from the upper left.

/** A colour of `ramp`. */
export const ON_RAMP = `vec3 onRamp(float fraction) {
  float scaled = clamp(fraction, 0.0, 1.0) * 4.0;
  int index = min(3, int(scaled));
  return mix(ramp[index], ramp[index + 1], scaled - float(index));
}
`;

/** Gaps of a column by which walls are open, at most. */
export const MAX_BANDS = 8;

export const VERTEX = `
in vec2 at;
in float z;
in float slot;
in float target;
/** The direction in which the surface falls there. */
in vec2 lean;
/** How far the corner is moved, in columns; zero where there is no such attribute. */
in vec2 shift;
uniform vec2 columns;
uniform vec2 size;
uniform float pitch;
uniform float bottom;
/** Largest X, least Y and largest Z that are kept, from the least corner and the top; whether there are any. */
uniform vec4 keep;
uniform int by;
uniform vec3 colors[24];
uniform vec3 ramp[5];
uniform float tolerance;
uniform float farthest;
uniform float push;
uniform bool isFlat;
out vec3 place;
out vec3 color;
out vec2 falls;

${ON_RAMP}
void main() {
  // The first and the last column reach to the edge, the ring around them is there, too.
  float x = at.x <= 1.0 ? 0.0 : at.x >= columns.x ? size.x : (at.x - 0.5 + shift.x) * pitch;
  float y = at.y <= 1.0 ? 0.0 : at.y >= columns.y ? size.y : (at.y - 0.5 + shift.y) * pitch;
  float h = z;
  if (x > keep.x) { x = keep.x; h = bottom; }
  if (y < keep.y) { y = keep.y; h = bottom; }
  h = min(h, keep.z);
  color = colors[int(slot + 0.5)];
  if (slot > 0.5) color = mix(colors[0], color, 0.62);
  if (by == 1 && slot > 0.5) color = onRamp(1.0 - z / bottom);
  if (by == 1 && slot <= 0.5) color = colors[0];
  if (by == 2) {
    float off = z - target;
    color = abs(off) <= tolerance * 1.001 ? ramp[2] : onRamp(0.5 + 0.5 * off / farthest);
  }
  if (by == 3) color = colors[0];
  falls = lean;
  place = vec3(x, y, h);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(x, y, isFlat ? bottom : h, 1.0);
  // A little back, so that a path that lies on it is seen.
  gl_Position.z += push;
}
`;

export const FRAGMENT = `
precision highp float;
in vec3 place;
in vec3 color;
in vec2 falls;
uniform vec2 size;
uniform vec3 uncut;
uniform vec4 keep;
uniform vec3 inside;
uniform vec3 viewpoint;
uniform bool isFlat;
uniform float bottom;
/** Floor and top of the gaps of each column, so many of each below each other, and the side of their columns. */
uniform sampler2D gaps;
uniform int bands;
uniform float gapPitch;
uniform ivec2 gapColumns;
out vec4 drawn;

/** Whether a column on either side of a wall has a gap at a height: a wall lies between the middles of two columns. */
bool isOpen(vec2 at, float z, vec2 across) {
  float most = max(abs(across.x), abs(across.y));
  vec2 off = most > 0.0 ? 0.49 * across / most : vec2(0.0);
  for (int side = -1; side < 2; side += 2) {
    ivec2 column = clamp(ivec2(floor(at / gapPitch + float(side) * off)), ivec2(0), gapColumns - 1);
    for (int band = 0; band < ${MAX_BANDS}; band++) {
      if (band >= bands) break;
      vec2 gap = texelFetch(gaps, ivec2(column.x, column.y * bands + band), 0).rg;
      if (z > gap.x && z < gap.y) return true;
    }
  }
  return false;
}

void main() {
  vec3 normal = isFlat ? vec3(0.0, 0.0, -1.0) : normalize(cross(dFdx(place), dFdy(place)));
  if (bands > 0 && (isFlat || abs(normal.z) < 0.7) && isOpen(place.xy, isFlat ? bottom + 1e-3 : place.z, normal.xy)) discard;
  if (dot(normal, viewpoint) < 0.0) normal = -normal;
  vec3 own = color;
  bool isWall = abs(normal.z) < 0.02;
  // The walls of the box were cut by no tool.
  if (isWall && (place.x < 1e-3 || place.y < 1e-3 || place.x > size.x - 1e-3 || place.y > size.y - 1e-3)) own = uncut;
  if (keep.w > 0.5 && (place.x >= keep.x - 1e-3 || place.y <= keep.y + 1e-3 || place.z >= keep.z - 1e-3)) own = inside;
  // Columns make stairs of a round wall: it is lit by the direction in which the surface falls.
  else if (abs(normal.z) < 0.35 && dot(falls, falls) > 0.2) normal = vec3(normalize(falls) * sqrt(1.0 - normal.z * normal.z), normal.z);
  float light = 0.6 + 0.4 * max(0.0, dot(normal, normalize(vec3(-0.35, -0.55, 0.9))));
  // Walls that look right are darker than those that look forward.
  light -= 0.12 * max(0.0, normal.x);
  drawn = vec4(own * light, 1.0);
}
`;
