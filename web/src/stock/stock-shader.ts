// The shaders of the stock: corners are lifted to their heights, and light comes from the upper left.

/** GLSL: a colour of the five of `ramp`, for a fraction from 0 to 1. */
export const ON_RAMP = `vec3 onRamp(float fraction) {
  float scaled = clamp(fraction, 0.0, 1.0) * 4.0;
  int index = min(3, int(scaled));
  return mix(ramp[index], ramp[index + 1], scaled - float(index));
}
`;

/** The largest number of gaps of a column that open walls. */
export const MAX_BANDS = 8;
/** Colours of a surface: that of the stock, and those of tools. */
export const COLOR_SLOTS = 24;

export const VERTEX = `
in vec2 at;
in float z;
in float slot;
in float target;
/** The downhill direction of the surface. */
in vec2 lean;
/** Offset of the corner, in columns; zero where the attribute is missing. */
in vec2 shift;
uniform vec2 columns;
uniform vec2 size;
uniform float pitch;
uniform float bottom;
/** Highest X, lowest Y and highest Z that are kept, from the lowest corner and the top, mm; w: 1 where the stock is cut open. */
uniform vec4 keep;
uniform int by;
uniform vec3 colors[${COLOR_SLOTS}];
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
  // The first and the last column reach to the edge of the stock, and so does the ring around them.
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
  // Pushed back a little, so that a path that lies on it is visible.
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
/** Floor and roof of the gaps of each column, with several rows of texels (bands) for each row of columns; side and number of these columns. */
uniform sampler2D gaps;
uniform int bands;
uniform float gapPitch;
uniform ivec2 gapColumns;
out vec4 drawn;

/** Whether a column on either side of a wall has a gap at a height: a wall reaches from the middle of a column to that of the next. */
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
  // The sides of the stock were cut by no tool.
  if (isWall && (place.x < 1e-3 || place.y < 1e-3 || place.x > size.x - 1e-3 || place.y > size.y - 1e-3)) own = uncut;
  if (keep.w > 0.5 && (place.x >= keep.x - 1e-3 || place.y <= keep.y + 1e-3 || place.z >= keep.z - 1e-3)) own = inside;
  // Columns make steps of a round wall: its light is computed from the downhill direction.
  else if (abs(normal.z) < 0.35 && dot(falls, falls) > 0.2) normal = vec3(normalize(falls) * sqrt(1.0 - normal.z * normal.z), normal.z);
  float light = 0.6 + 0.4 * max(0.0, dot(normal, normalize(vec3(-0.35, -0.55, 0.9))));
  // Walls that face +X are darker than those that face -Y.
  light -= 0.12 * max(0.0, normal.x);
  drawn = vec4(own * light, 1.0);
}
`;
