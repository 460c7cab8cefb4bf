// Draws the stock into a render target that is reused: during playback only what has changed is drawn again. While the view turns,
// and while too much changes at once, a coarser surface is drawn instead.

import {
  type Camera,
  Color,
  DepthTexture,
  DoubleSide,
  GLSL3,
  type Group,
  type OrthographicCamera,
  ShaderMaterial,
  UnsignedIntType,
  Vector2,
  Vector3,
  Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from "three";
import type { Bounds, Vec3 } from "../path/batch";
import { type Palette, toolColor } from "../view/colors";
import { yieldToEventLoop } from "../view/event-loop";
import { gpuFinished } from "../view/gpu-fence";
import type { Underlay } from "../view/painter";
import { ShadedMesh } from "../view/shaded-mesh";
import { CoarseSurface } from "./coarse-surface";
import { GapMesh } from "./gap-mesh";
import type { Gaps } from "./gaps";
import { PartMesh } from "./part-mesh";
import { COLOR_SLOTS, FRAGMENT, VERTEX } from "./stock-shader";
import type { StockBefore } from "./stock-timeline";
import { type TouchedBox, StockSurface } from "./surface";
import { TILE_CELLS } from "./tile";
import { TileMeshes } from "./tile-meshes";

export type StockColor = "tool" | "depth" | "deviation" | "plain";

/** Where the stock is cut open, mm in the frame of the run: beyond it nothing is drawn. */
export interface StockCut {
  axis: "x" | "y" | "z";
  at: number;
}

/** Triangles and tiles that are drawn at once, in a fraction of a frame: with a graphics card and without. */
const MAX_PER_DRAW = { card: { triangles: 4_000_000, tiles: 256 }, software: { triangles: 12_000, tiles: 64 } };
/** The largest number of columns of the coarse surface. */
const COARSE_COLUMNS = { card: 250_000, software: 9_000 };
/** A mesh of the part with more triangles is not drawn in every frame while the view turns. */
const MAX_PART_TRIANGLES = { card: 400_000, software: 60_000 };
/** How long the view must rest before the stock is drawn in full detail again, ms; doubled, up to the second, each time too much changes at once. */
const REST_MS = 120;
const MAX_REST_MS = 2_000;
/** The margin around a change that is drawn again, pixels. */
const MARGIN_PIXELS = 3;
/** Deviations of more than this number of tolerances have the last colour of the scale. */
export const MAX_TOLERANCES = 10;

export class StockLayer {
  surface: StockSurface | undefined;
  /** Triangles of the last frame: for tests and measurements. */
  drawnTriangles = 0;
  private shown = true;
  private tiles: TileMeshes | undefined;
  private coarse: { surface: CoarseSurface; tiles: TileMeshes; isStale: boolean } | undefined;
  private material = stockMaterial();
  private coarseMaterial = withOwnGrid(this.material);
  /** The stock in full detail, where `state` is complete. */
  private target: WebGLRenderTarget | undefined;
  private state: "stale" | "drawing" | "complete" = "stale";
  /** Matrices of the camera for which it was drawn last. */
  private viewKey = "";
  /** When the view moved last, ms. */
  private movedAt = 0;
  private restMs = REST_MS;
  private timer = 0;
  /** Number of the present picture: the drawing of an older one stops. */
  private number = 0;
  private origin: Vec3 = [0, 0, 0];
  private cut: StockCut | undefined;
  private by: StockColor = "tool";
  /** What has changed and is not drawn yet. */
  private pending: TouchedBox | undefined;
  private fixtures = new ShadedMesh();
  /** The part at the end of the program, where heights cannot show it. */
  private part: PartMesh | undefined;
  /** The end of the program is shown. */
  private isEnd = false;
  private gaps: GapMesh | undefined;

  constructor(
    private palette: Palette,
    private isSoftware: boolean,
    private requestFrame: () => void,
  ) {}

  private get maxPerDraw() {
    return this.isSoftware ? MAX_PER_DRAW.software : MAX_PER_DRAW.card;
  }

  /** Sets the stock, or none. */
  begin(stock: StockBefore | undefined, origin: Vec3): void {
    this.tiles?.dispose();
    this.coarse?.tiles.dispose();
    this.tiles = undefined;
    this.coarse = undefined;
    this.pending = undefined;
    this.part?.dispose();
    this.part = undefined;
    this.gaps?.dispose();
    this.gaps = undefined;
    this.surface = stock && new StockSurface(stock);
    if (this.surface) this.build(this.surface);
    this.fixtures.set(stock?.fixtures, this.palette.fixture);
    this.setOrigin(origin);
    this.updateMaterial();
    this.changed();
  }

  private build(surface: StockSurface): void {
    this.tiles = new TileMeshes(surface, this.material);
    const coarse = new CoarseSurface(surface, this.isSoftware ? COARSE_COLUMNS.software : COARSE_COLUMNS.card);
    this.coarse = { surface: coarse, tiles: new TileMeshes(coarse.surface, this.coarseMaterial), isStale: true };
  }

  /** Sets the mesh of the part at the end: triangles, nine numbers each, mm in the frame of the run. */
  setPart(corners: Float32Array): void {
    if (!this.surface) return;
    this.part?.dispose();
    this.part = new PartMesh(corners, this.surface, this.material.uniforms);
    this.part.update();
    this.updatePartCut();
    this.setOrigin(this.origin);
  }

  /** Sets the gaps of columns; their mesh is updated whenever a column changes. */
  setGaps(gaps: Gaps): void {
    if (!this.surface || this.gaps) return;
    this.gaps = new GapMesh(this.surface, gaps, this.material.uniforms);
    this.gaps.update();
    this.setOrigin(this.origin);
  }

  /** At the end of the program draws the mesh of the part instead of columns. */
  showPart(isEnd: boolean): void {
    if (isEnd === this.isEnd) return;
    this.isEnd = isEnd;
    if (!this.part) return;
    if (isEnd) this.part.update();
    this.changed();
  }

  /** The mesh of the part, where it is drawn. */
  get shownPart(): PartMesh | undefined {
    return this.isEnd ? this.part : undefined;
  }

  /** Sets the origin of the path, to which positions in the view are relative. */
  setOrigin(origin: Vec3): void {
    this.origin = origin;
    if (!this.surface) return;
    const { low, high } = this.surface.stock;
    for (const group of [this.tiles!.group, this.coarse!.tiles.group, this.gaps?.object]) {
      group?.position.set(low[0] - origin[0], low[1] - origin[1], high[2] - origin[2]);
      group?.updateMatrixWorld(true);
    }
    for (const object of [this.fixtures.object, this.part?.object]) {
      object?.position.set(-origin[0], -origin[1], -origin[2]);
      object?.updateMatrixWorld(true);
    }
    this.changed();
  }

  /** Its box, relative to the origin of the path; undefined where it is not shown. */
  bounds(): Bounds | undefined {
    if (!this.surface || !this.shown) return undefined;
    const { low, high } = this.surface.stock;
    const relative = (at: Vec3) => at.map((value, axis) => value - this.origin[axis]!) as Vec3;
    return { low: relative(low), high: relative(high) };
  }

  show(shown: boolean): void {
    this.shown = shown;
    this.changed();
  }

  showFixtures(shown: boolean): void {
    this.fixtures.object.visible = shown;
    this.changed();
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.fixtures.setColor(palette.fixture);
    this.updateMaterial();
    this.changed();
  }

  setColor(by: StockColor): void {
    this.by = by;
    this.updateMaterial();
    this.changed();
  }

  setCut(cut: StockCut | undefined): void {
    this.cut = cut;
    this.updateMaterial();
    this.changed();
  }

  /** Draws all of it again. */
  changed(): void {
    this.number++;
    this.state = "stale";
    this.requestFrame();
  }

  /** The render target with depth, or, until it is complete, the function that draws the coarse surface. */
  get underlay(): Underlay | undefined {
    if (!this.surface || !this.shown) return undefined;
    return this.state === "complete" ? this.target : this.drawCoarse;
  }

  /** Whether everything is drawn in full detail. */
  get isComplete(): boolean {
    return !this.surface || !this.shown || (this.state === "complete" && !this.pending);
  }

  /** Draws into the render target before a frame, where that is due. */
  prepare(renderer: WebGLRenderer, camera: OrthographicCamera, isTurning: boolean): void {
    const { surface } = this;
    this.drawnTriangles = 0;
    if (!surface || !this.shown) return;
    const touched = surface.takeTouched();
    this.addPending(touched);
    if (touched) this.gaps?.update();
    // The mesh of the part is drawn instead of all columns.
    if (this.shownPart) this.pending = undefined;
    else if (touched && this.isLeap(touched)) void this.leap(renderer);
    const viewKey = `${camera.matrixWorld.elements.join()} ${camera.projectionMatrix.elements.join()}`;
    if (this.resize(renderer) || viewKey !== this.viewKey) {
      this.viewKey = viewKey;
      this.restartRest();
    }
    this.material.uniforms.push!.value = 2 * (depthOffset(camera, renderer) + 0.5 * surface.stock.pitch) / (camera.far - camera.near);
    this.material.uniforms.viewpoint!.value.set(...viewpointOf(camera));
    if (this.state === "complete" && this.pending) this.repaint(renderer, camera, this.pending);
    if (this.state === "complete") return;
    // Full detail is drawn once the view rests.
    window.clearTimeout(this.timer);
    if (this.state === "drawing") return;
    if (isTurning) return;
    if (this.remainingRest <= 0) void this.drawAll(renderer, camera);
    else this.requestFrameAfterRest();
  }

  /** How long the view must still rest, ms. */
  private get remainingRest(): number {
    return this.restMs - (performance.now() - this.movedAt);
  }

  private requestFrameAfterRest(): void {
    this.timer = window.setTimeout(() => (this.remainingRest > 0 ? this.requestFrameAfterRest() : this.requestFrame()), this.remainingRest + 1);
  }

  /** The view has moved: only the coarse surface is drawn until it rests again. */
  private restartRest(): void {
    this.number++;
    this.state = "stale";
    this.movedAt = performance.now();
  }

  /** Too much has changed at once: the rest begins when this frame is drawn. */
  private async leap(renderer: WebGLRenderer): Promise<void> {
    this.restartRest();
    const { number } = this;
    // After the commands of this frame.
    await Promise.resolve();
    await gpuFinished(renderer);
    if (number === this.number) this.movedAt = performance.now();
  }

  /** Whether so much has changed that the time slider is probably being dragged, and more will follow. */
  private isLeap({ columns, rows }: TouchedBox): boolean {
    return (columns[1] - columns[0]) * (rows[1] - rows[0]) > this.maxPerDraw.tiles * TILE_CELLS * TILE_CELLS;
  }

  private addPending(touched: TouchedBox | undefined): void {
    if (!touched) return;
    this.coarse!.isStale = true;
    const { pending } = this;
    const join = (a: [number, number], b: [number, number]): [number, number] => [Math.min(a[0], b[0]), Math.max(a[1], b[1])];
    this.pending = pending
      ? { columns: join(pending.columns, touched.columns), rows: join(pending.rows, touched.rows), heights: join(pending.heights, touched.heights) }
      : touched;
  }

  /** Adapts to the size of the renderer; returns whether that has changed. */
  private resize(renderer: WebGLRenderer): boolean {
    const ratio = Math.min(2, window.devicePixelRatio);
    const size = renderer.getSize(new Vector2()).multiplyScalar(ratio).floor().max(new Vector2(1, 1));
    if (this.target?.width === size.x && this.target.height === size.y) return false;
    this.target?.dispose();
    this.target = new WebGLRenderTarget(size.x, size.y, { depthTexture: new DepthTexture(size.x, size.y, UnsignedIntType) });
    return true;
  }

  /** Draws again what has changed, where that is fast enough for one frame. */
  private repaint(renderer: WebGLRenderer, camera: Camera, changed: TouchedBox): void {
    const surface = this.surface!;
    const tiles = this.tiles!;
    const { x, y, width, height } = this.rectangle(surface, camera, [
      [changed.columns[0], changed.rows[0]], [changed.columns[1] + 2, changed.rows[1] + 2],
    ], changed.heights, MARGIN_PIXELS);
    if (width <= 0 || height <= 0) {
      this.pending = undefined;
      return;
    }
    const chosen: number[] = [];
    let sum = 0;
    for (let tile = 0; tile < tiles.count; tile++) {
      tiles.update(tile);
      const [x0, y0] = surface.firstCorner(tile);
      const area = this.rectangle(surface, camera, [[x0, y0], [x0 + TILE_CELLS, y0 + TILE_CELLS]], tiles.heights(tile), 1);
      if (area.x > x + width || area.x + area.width < x || area.y > y + height || area.y + area.height < y) continue;
      chosen.push(tile);
      sum += tiles.triangles(tile);
      if (sum > this.maxPerDraw.triangles || chosen.length > this.maxPerDraw.tiles) {
        // Too much for one frame: the coarse surface is drawn until nothing changes.
        this.restartRest();
        this.restMs = Math.min(MAX_REST_MS, 2 * this.restMs);
        return;
      }
    }
    const target = this.target!;
    target.scissor.set(x, y, width, height);
    target.scissorTest = true;
    renderer.setRenderTarget(target);
    renderer.clear();
    this.drawTiles(renderer, camera, chosen);
    this.drawGaps(renderer, camera);
    this.drawFixtures(renderer, camera);
    target.scissorTest = false;
    renderer.setRenderTarget(null);
    this.restMs = REST_MS;
    this.pending = undefined;
  }

  /** The rectangle of the render target that covers a box between two corners and two heights, pixels from the lower left. */
  private rectangle(surface: StockSurface, camera: Camera, [low, high]: [[number, number], [number, number]], heights: [number, number], margin: number) {
    const m = camera.matrixWorldInverse.elements;
    const p = camera.projectionMatrix.elements;
    const { position } = this.tiles!.group;
    const { width, height } = this.target!;
    let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let bits = 0; bits < 8; bits++) {
      const at = this.corner(surface, (bits & 1 ? high : low)[0], (bits & 2 ? high : low)[1]);
      const [wx, wy, wz] = [at[0] + position.x, at[1] + position.y, heights[bits & 4 ? 1 : 0] + position.z];
      const vx = m[0]! * wx + m[4]! * wy + m[8]! * wz + m[12]!;
      const vy = m[1]! * wx + m[5]! * wy + m[9]! * wz + m[13]!;
      const [sx, sy] = [((p[0]! * vx + p[12]! + 1) / 2) * width, ((p[5]! * vy + p[13]! + 1) / 2) * height];
      [left, right] = [Math.min(left, sx), Math.max(right, sx)];
      [bottom, top] = [Math.min(bottom, sy), Math.max(top, sy)];
    }
    const x = Math.max(0, Math.floor(left) - margin);
    const y = Math.max(0, Math.floor(bottom) - margin);
    return { x, y, width: Math.min(width, Math.ceil(right) + margin) - x, height: Math.min(height, Math.ceil(top) + margin) - y };
  }

  /** X and Y of a corner as it is drawn, from the lowest corner of the stock, mm. */
  private corner({ stock }: StockSurface, x: number, y: number): [number, number] {
    const coordinate = (axis: 0 | 1, index: number) => {
      const size = stock.high[axis] - stock.low[axis];
      return index <= 1 ? 0 : index >= stock.columns[axis] ? size : (index - 0.5) * stock.pitch;
    };
    return [coordinate(0, x), coordinate(1, y)];
  }

  private drawTiles(renderer: WebGLRenderer, camera: Camera, chosen: number[]): void {
    this.drawnTriangles += this.tiles!.choose(chosen);
    this.render(renderer, camera, this.tiles!.group);
  }

  private drawFixtures(renderer: WebGLRenderer, camera: Camera): void {
    if (!this.fixtures.isEmpty) renderer.render(this.fixtures.object, camera);
  }

  private drawGaps(renderer: WebGLRenderer, camera: Camera): void {
    if (!this.gaps?.triangles) return;
    renderer.render(this.gaps.object, camera);
    this.drawnTriangles += this.gaps.triangles;
  }

  private render(renderer: WebGLRenderer, camera: Camera, group: Group): void {
    renderer.render(group, camera);
    if (this.material.uniforms.viewpoint!.value.z >= 0) return;
    // Seen from below, the underside is drawn as well.
    this.material.uniforms.isFlat!.value = true;
    renderer.render(group, camera);
    this.material.uniforms.isFlat!.value = false;
  }

  private drawPart(renderer: WebGLRenderer, camera: Camera, part: PartMesh): void {
    renderer.render(part.object, camera);
    this.drawnTriangles += part.triangles;
    this.drawFixtures(renderer, camera);
  }

  private drawCoarse = (renderer: WebGLRenderer, camera: Camera): void => {
    const part = this.shownPart;
    if (part && part.triangles <= MAX_PART_TRIANGLES[this.isSoftware ? "software" : "card"]) return this.drawPart(renderer, camera, part);
    const { surface, tiles, isStale } = this.coarse!;
    if (isStale) surface.update();
    this.coarse!.isStale = false;
    this.drawnTriangles += tiles.choose(tiles.all);
    this.render(renderer, camera, tiles.group);
    this.drawGaps(renderer, camera);
    this.drawFixtures(renderer, camera);
  };

  /** Draws the stock in full detail, some tiles at a time. */
  private async drawAll(renderer: WebGLRenderer, camera: Camera): Promise<void> {
    this.state = "drawing";
    const number = ++this.number;
    this.pending = undefined;
    if (this.shownPart) {
      renderer.setRenderTarget(this.target!);
      renderer.clear();
      this.drawPart(renderer, camera, this.shownPart);
      renderer.setRenderTarget(null);
      this.state = "complete";
      this.requestFrame();
      return;
    }
    let isCleared = false;
    const tiles = this.tiles!;
    // All tiles are updated first: each has the corners of the adjacent ones on its edges.
    for (const index of tiles.all) {
      tiles.update(index);
      if ((index + 1) % this.maxPerDraw.tiles > 0) continue;
      await yieldToEventLoop();
      if (number !== this.number) return;
    }
    let tile = 0;
    while (tile < tiles.count) {
      const chosen: number[] = [];
      let sum = 0;
      for (; tile < tiles.count && sum < this.maxPerDraw.triangles && chosen.length < this.maxPerDraw.tiles; tile++) {
        tiles.update(tile);
        chosen.push(tile);
        sum += tiles.triangles(tile);
      }
      renderer.setRenderTarget(this.target!);
      if (!isCleared) {
        renderer.clear();
        this.drawFixtures(renderer, camera);
        this.drawGaps(renderer, camera);
      }
      isCleared = true;
      this.drawTiles(renderer, camera, chosen);
      renderer.setRenderTarget(null);
      if (tile < tiles.count) await gpuFinished(renderer);
      if (number !== this.number) return;
    }
    this.state = "complete";
    this.requestFrame();
  }

  /** Cuts the mesh of the part open. */
  private updatePartCut(): void {
    const { cut, part } = this;
    // X and Z are kept up to the cut, Y from the cut on: so the section faces the isometric view.
    const sign = cut?.axis === "y" ? -1 : 1;
    const along = (axis: StockCut["axis"]) => (cut?.axis === axis ? sign : 0);
    part?.setCut([along("x"), along("y"), along("z")], cut ? sign * cut.at : 1);
  }

  private updateMaterial(): void {
    const { surface, palette, cut, by } = this;
    if (!surface) return;
    const { stock } = surface;
    const size = [stock.high[0] - stock.low[0], stock.high[1] - stock.low[1]] as const;
    const u = this.material.uniforms;
    u.size!.value.set(...size);
    for (const { uniforms, grid } of [
      { uniforms: u, grid: stock },
      { uniforms: this.coarseMaterial.uniforms, grid: this.coarse!.surface.surface.stock },
    ]) {
      uniforms.columns!.value.set(grid.columns[0], grid.columns[1]);
      uniforms.pitch!.value = grid.pitch;
    }
    u.bottom!.value = surface.bottom;
    u.gapPitch!.value = stock.pitch;
    u.gapColumns!.value = stock.columns;
    u.by!.value = ["tool", "depth", "deviation", "plain"].indexOf(by === "deviation" && !surface.target ? "plain" : by);
    u.colors!.value = [palette.stock, ...Array.from({ length: COLOR_SLOTS - 1 }, (_, index) => toolColor(palette, index))].map((color) => new Color(color));
    u.ramp!.value = (by === "deviation" ? palette.deviation : palette.ramp).map((color) => new Color(color));
    u.inside!.value.set(palette.inside);
    u.uncut!.value.set(palette.stock);
    u.tolerance!.value = stock.toleranceMm;
    u.farthest!.value = MAX_TOLERANCES * stock.toleranceMm;
    // In the middle of a column, so that the walls of the section are straight.
    const column = (axis: 0 | 1) => {
      const at = ((cut?.at ?? 0) - stock.low[axis]) / stock.pitch;
      return Math.min(stock.columns[axis] - 1, Math.max(0, Math.round(at - 0.5)));
    };
    const snapped = (axis: 0 | 1) => this.corner(surface, column(0) + 1, column(1) + 1)[axis];
    this.coarse!.isStale = true;
    surface.setOpen(cut?.axis === "x" ? { column: column(0) + 1 } : cut?.axis === "y" ? { row: column(1) + 1 } : {});
    this.updatePartCut();
    u.keep!.value.set(
      cut?.axis === "x" ? snapped(0) : BEYOND_MACHINE_MM,
      cut?.axis === "y" ? snapped(1) : -BEYOND_MACHINE_MM,
      cut?.axis === "z" ? cut.at - stock.high[2] : BEYOND_MACHINE_MM,
      cut ? 1 : 0,
    );
  }
}

/** A coordinate outside of any machine, mm. */
const BEYOND_MACHINE_MM = 1e9;

/** How far the stock is pushed back so that a path on it is visible, mm: a pixel and a half. */
function depthOffset(camera: OrthographicCamera, renderer: WebGLRenderer): number {
  return (1.5 * (camera.right - camera.left)) / camera.zoom / Math.max(1, renderer.domElement.width);
}

/** The direction to the camera. */
function viewpointOf(camera: Camera): Vec3 {
  const m = camera.matrixWorld.elements;
  return [m[8]!, m[9]!, m[10]!];
}

function stockMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    uniforms: {
      columns: { value: new Vector2() },
      size: { value: new Vector2() },
      pitch: { value: 1 },
      bottom: { value: 0 },
      keep: { value: new Vector4() },
      by: { value: 0 },
      colors: { value: [] },
      ramp: { value: [] },
      inside: { value: new Color() },
      uncut: { value: new Color() },
      tolerance: { value: 0 },
      farthest: { value: 1 },
      push: { value: 0 },
      viewpoint: { value: new Vector3() },
      isFlat: { value: false },
      gaps: { value: null },
      bands: { value: 0 },
      gapPitch: { value: 1 },
      gapColumns: { value: [1, 1] },
    },
  });
}

/** The same material for another grid of columns; all other uniforms are shared. */
function withOwnGrid(material: ShaderMaterial): ShaderMaterial {
  const clone = material.clone();
  clone.uniforms = { ...material.uniforms, columns: { value: new Vector2() }, pitch: { value: 1 } };
  return clone;
}
