// The part at the end of the program as triangles, where the heights of columns cannot show it: undercuts, cavities, cuts from
// other sides.

import { BufferAttribute, BufferGeometry, DataTexture, DoubleSide, FloatType, GLSL3, Mesh, RedFormat, ShaderMaterial, UnsignedByteType, Vector3, Vector4 } from "three";
import { COLOR_SLOTS, ON_RAMP } from "./stock-shader";
import type { StockSurface } from "./surface";

const VERTEX = `
uniform float push;
out vec3 at;
out vec3 seen;
void main() {
  at = position;
  vec4 place = modelMatrix * vec4(position, 1.0);
  seen = place.xyz;
  gl_Position = projectionMatrix * viewMatrix * place;
  gl_Position.z += push;
}`;

// Back faces are where the part is cut open: they have one colour, without light. The top of a column has the colour of the
// column; gaps and other sides have that of the stock.
const FRAGMENT = `
precision highp float;
uniform vec4 keep;
uniform vec3 inside;
uniform vec3 low;
uniform float pitch;
uniform float bottom;
uniform ivec2 columns;
uniform int by;
uniform vec3 colors[${COLOR_SLOTS}];
uniform vec3 ramp[5];
uniform sampler2D slots;
uniform sampler2D heights;
in vec3 at;
in vec3 seen;
out vec4 drawn;

${ON_RAMP}
void main() {
  if (dot(keep.xyz, at) > keep.w) discard;
  if (!gl_FrontFacing) {
    drawn = vec4(inside, 1.0);
    return;
  }
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  // The grid has a ring around the columns.
  ivec2 column = clamp(ivec2(floor((at.xy - low.xy) / pitch)), ivec2(0), columns - 1) + 1;
  int slot = int(texelFetch(slots, column, 0).r * 255.0 + 0.5);
  float z = at.z - low.z;
  bool isTop = slot > 0 && normal.z > 0.5 && abs(texelFetch(heights, column, 0).r - z) < pitch;
  vec3 own = colors[0];
  if (isTop && by == 0) own = mix(colors[0], colors[slot], 0.62);
  if (isTop && by == 1) own = onRamp(1.0 - z / bottom);
  float light = 0.6 + 0.4 * max(0.0, dot(normal, normalize(vec3(-0.35, -0.55, 0.9)))) - 0.12 * max(0.0, normal.x);
  drawn = vec4(own * light, 1.0);
}`;

export class PartMesh {
  readonly object: Mesh<BufferGeometry, ShaderMaterial>;
  private slots: DataTexture;
  private heights: DataTexture;

  /** `corners` are triangles, nine numbers each, mm in the frame of the run; `columns` are the uniforms of the stock shader. */
  constructor(readonly corners: Float32Array, surface: StockSurface, columns: ShaderMaterial["uniforms"]) {
    const { stock, width, height } = surface;
    this.slots = new DataTexture(surface.slot, width, height, RedFormat, UnsignedByteType);
    this.slots.unpackAlignment = 1;
    this.heights = new DataTexture(surface.z, width, height, RedFormat, FloatType);
    const { by, colors, ramp, bottom, push, inside } = columns;
    const material = new ShaderMaterial({ glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, side: DoubleSide });
    material.uniforms = {
      by: by!, colors: colors!, ramp: ramp!, bottom: bottom!, push: push!, inside: inside!,
      keep: { value: new Vector4(0, 0, 0, 1) },
      // Heights are from the top.
      low: { value: new Vector3(stock.low[0], stock.low[1], stock.high[2]) },
      pitch: { value: stock.pitch },
      columns: { value: stock.columns },
      slots: { value: this.slots },
      heights: { value: this.heights },
    };
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
  }

  get triangles(): number {
    return this.corners.length / 9;
  }

  /** Uploads the present heights and slots of the columns. */
  update(): void {
    this.slots.needsUpdate = true;
    this.heights.needsUpdate = true;
  }

  /** Keeps the part up to a plane: its normal, and its distance from the zero of the run along it, mm. */
  setCut(normal: [number, number, number], distance: number): void {
    this.object.material.uniforms.keep!.value.set(...normal, distance);
  }

  dispose(): void {
    this.slots.dispose();
    this.heights.dispose();
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
