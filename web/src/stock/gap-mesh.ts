// The surfaces of gaps in columns, and a texture by which the stock shader opens walls where gaps reach them.

import { BufferAttribute, BufferGeometry, DataTexture, DoubleSide, FloatType, GLSL3, Mesh, RGFormat, ShaderMaterial } from "three";
import { type Gaps, gapSurfaces } from "./gaps";
import { COLOR_SLOTS, MAX_BANDS } from "./stock-shader";
import type { StockSurface } from "./surface";

const VERTEX = `
uniform float push;
out vec3 place;
void main() {
  place = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z += push;
}`;

const FRAGMENT = `
precision highp float;
in vec3 place;
uniform vec4 keep;
uniform vec3 colors[${COLOR_SLOTS}];
uniform vec3 viewpoint;
out vec4 drawn;

void main() {
  if (keep.w > 0.5 && (place.x > keep.x || place.y < keep.y || place.z > keep.z)) discard;
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  if (dot(normal, viewpoint) < 0.0) normal = -normal;
  float light = 0.6 + 0.4 * max(0.0, dot(normal, normalize(vec3(-0.35, -0.55, 0.9)))) - 0.12 * max(0.0, normal.x);
  drawn = vec4(colors[0] * light, 1.0);
}`;

/** Floor and roof of no gap, mm: above the top of the stock, which is 0. */
const NO_GAP_HEIGHT = 1;

export class GapMesh {
  readonly object: Mesh<BufferGeometry, ShaderMaterial>;
  private texture: DataTexture | undefined;
  private bands = 0;
  /** Columns that have gaps in the texture. */
  private writtenColumns: number[] = [];

  /** `columns` are the uniforms of the stock shader, of which `gaps` and `bands` are set here. */
  constructor(private surface: StockSurface, private gaps: Gaps, private columns: ShaderMaterial["uniforms"]) {
    const { keep, colors, viewpoint, push } = columns;
    const material = new ShaderMaterial({ glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, side: DoubleSide });
    material.uniforms = { keep: keep!, colors: colors!, viewpoint: viewpoint!, push: push! };
    this.object = new Mesh(new BufferGeometry(), material);
    this.object.frustumCulled = false;
  }

  get triangles(): number {
    return (this.object.geometry.getAttribute("position")?.count ?? 0) / 3;
  }

  /** Makes the mesh and the texture for the present gaps and heights. */
  update(): void {
    const { surface, gaps, columns: uniforms } = this;
    const { stock, bottom, width, z } = surface;
    const corners = gapSurfaces(gaps, {
      columns: stock.columns,
      pitch: stock.pitch,
      size: [stock.high[0] - stock.low[0], stock.high[1] - stock.low[1]],
      bottom,
      overlap: 0.05 * stock.pitch,
      heightAt: (x, y) => z[(y + 1) * width + x + 1]!,
    });
    this.object.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    this.object.geometry = geometry;
    this.writeTexture();
    uniforms.bands!.value = this.bands;
    uniforms.gaps!.value = this.texture ?? null;
  }

  private writeTexture(): void {
    const { stock: { columns: [nx, ny] } } = this.surface;
    const bands = Math.min(MAX_BANDS, this.gaps.maxPerColumn);
    if (bands > this.bands) {
      this.texture?.dispose();
      this.bands = bands;
      this.texture = new DataTexture(new Float32Array(2 * nx * ny * bands).fill(NO_GAP_HEIGHT), nx, ny * bands, RGFormat, FloatType);
      this.writtenColumns = [];
    }
    const { texture } = this;
    if (!texture) return;
    const data = texture.image.data as Float32Array;
    const offsetOf = (column: number, band: number) => 2 * ((Math.floor(column / nx) * bands + band) * nx + (column % nx));
    for (const column of this.writtenColumns) for (let band = 0; band < bands; band++) data.fill(NO_GAP_HEIGHT, offsetOf(column, band), offsetOf(column, band) + 2);
    this.writtenColumns = [];
    for (const [column, heights] of this.gaps.columns) {
      this.writtenColumns.push(column);
      for (let band = 0; band < Math.min(bands, heights.length / 2); band++) data.set([heights[2 * band]!, heights[2 * band + 1]!], offsetOf(column, band));
    }
    texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture?.dispose();
    this.columns.bands!.value = 0;
    this.columns.gaps!.value = null;
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
