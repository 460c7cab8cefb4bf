// The stock in space. Its picture is reused: while a program plays only what changes is drawn again. While the view
// turns, and while too much changes at once, a coarser surface replaces it.

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
import type { PictureBelow } from "../view/painter";
import { CoarseSurface } from "./coarse-surface";
import { FixtureMesh } from "./fixtures";
import { GapMesh } from "./gap-mesh";
import type { Gaps } from "./gaps";
import { PartMesh } from "./part-mesh";
import { FRAGMENT, VERTEX } from "./stock-shader";
import type { StockBefore } from "./stock-timeline";
import { type TouchedBox, StockSurface } from "./surface";
import { TILE_CELLS } from "./tile";
import { TileMeshes } from "./tile-meshes";

export type StockColor = "tool" | "depth" | "deviation" | "plain";

/** Where the stock is cut open, mm in the frame of the run: what lies beyond is left out. */
export interface StockCut {
  axis: "x" | "y" | "z";
  at: number;
}

/** Triangles and tiles that are drawn in one go, in a fraction of a frame: with a graphics card and without. */
const MAX_PER_DRAW = { card: { triangles: 4_000_000, tiles: 256 }, software: { triangles: 12_000, tiles: 64 } };
/** Columns of the surface that replaces the stock while the view turns. */
const COARSE_COLUMNS = { card: 250_000, software: 9_000 };
/** Triangles of a part that are drawn in every frame while the view turns. */
const PART_TRIANGLES = { card: 400_000, software: 60_000 };
/** How long the view must be still before all of it is drawn again, ms; and how long at most where too much changes at once. */
const STILL_MS = 120;
const MAX_STILL_MS = 2_000;
/** Colours that a material has room for: that of the stock, and tools. */
const COLOR_SLOTS = 24;
/** Around what has changed so many pixels are drawn again. */
const MARGIN_PIXELS = 3;
/** Deviations beyond so many tolerances have one colour. */
export const MAX_TOLERANCES = 10;

export class StockLayer {
  surface: StockSurface | undefined;
  /** Triangles of the last frame: for tests and measurements. */
  drawnTriangles = 0;
  private shown = true;
  private tiles: TileMeshes | undefined;
  private coarse: { surface: CoarseSurface; tiles: TileMeshes; isStale: boolean } | undefined;
  private material = material();
  private coarseMaterial = sibling(this.material);
  private whole: WebGLRenderTarget | undefined;
  private state: "stale" | "drawing" | "complete" = "stale";
  private viewKey = "";
  private movedAt = 0;
  private stillMs = STILL_MS;
  private timer = 0;
  private number = 0;
  private origin: Vec3 = [0, 0, 0];
  private cut: StockCut | undefined;
  private by: StockColor = "tool";
  private own: TouchedBox | undefined;
  private fixtures = new FixtureMesh();
  /** The part at the end, where heights do not show all of it; `isEnd` says whether it is shown. */
  private part: PartMesh | undefined;
  private isEnd = false;
  private gaps: GapMesh | undefined;

  constructor(
    private palette: Palette,
    private isSoftware: boolean,
    private requestFrame: () => void,
  ) {}

  private get atOnce() {
    return this.isSoftware ? MAX_PER_DRAW.software : MAX_PER_DRAW.card;
  }

  /** Another stock, or none. */
  begin(stock: StockBefore | undefined, origin: Vec3): void {
    this.tiles?.dispose();
    this.coarse?.tiles.dispose();
    this.tiles = undefined;
    this.coarse = undefined;
    this.own = undefined;
    this.part?.dispose();
    this.part = undefined;
    this.gaps?.dispose();
    this.gaps = undefined;
    this.surface = stock && new StockSurface(stock);
    if (this.surface) this.build(this.surface);
    this.fixtures.set(stock?.fixtures, this.palette);
    this.place(origin);
    this.updateMaterial();
    this.changed();
  }

  private build(surface: StockSurface): void {
    this.tiles = new TileMeshes(surface, this.material);
    const coarse = new CoarseSurface(surface, this.isSoftware ? COARSE_COLUMNS.software : COARSE_COLUMNS.card);
    this.coarse = { surface: coarse, tiles: new TileMeshes(coarse.surface, this.coarseMaterial), isStale: true };
  }

  /** What is left at the end as triangles, nine numbers each, mm in the frame of the run. */
  setPart(corners: Float32Array): void {
    if (!this.surface) return;
    this.part?.dispose();
    this.part = new PartMesh(corners, this.surface, this.material.uniforms);
    this.part.take();
    this.openPart();
    this.place(this.origin);
  }

  /** The gaps of columns; they are drawn as they are whenever a column is touched. */
  setGaps(gaps: Gaps): void {
    if (!this.surface || this.gaps) return;
    this.gaps = new GapMesh(this.surface, gaps, this.material.uniforms);
    this.gaps.take();
    this.place(this.origin);
  }

  /** At the end the part is drawn instead of its columns. */
  showPart(isEnd: boolean): void {
    if (isEnd === this.isEnd) return;
    this.isEnd = isEnd;
    if (!this.part) return;
    if (isEnd) this.part.take();
    this.changed();
  }

  /** The part, where it is drawn. */
  get shownPart(): PartMesh | undefined {
    return this.isEnd ? this.part : undefined;
  }

  /** The origin of the path is the zero of the picture. */
  place(origin: Vec3): void {
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

  /** Its box, relative to the origin of the path. */
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
    this.fixtures.setPalette(palette);
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

  /** Everything of it is to be drawn again. */
  changed(): void {
    this.number++;
    this.state = "stale";
    this.requestFrame();
  }

  /** The picture with depth, or, until there is one, what draws the coarse surface. */
  get under(): PictureBelow | undefined {
    if (!this.surface || !this.shown) return undefined;
    return this.state === "complete" ? this.whole : this.drawCoarse;
  }

  /** The picture shows every column. */
  get isComplete(): boolean {
    return !this.surface || !this.shown || (this.state === "complete" && !this.own);
  }

  /** Draws what is due before a frame. */
  prepare(renderer: WebGLRenderer, camera: OrthographicCamera, isTurning: boolean): void {
    const { surface } = this;
    this.drawnTriangles = 0;
    if (!surface || !this.shown) return;
    const touched = surface.takeTouched();
    this.note(touched);
    if (touched) this.gaps?.take();
    // The mesh of the part replaces all columns.
    if (this.shownPart) this.own = undefined;
    else if (touched && this.isLeap(touched)) void this.leap(renderer);
    const from = `${camera.matrixWorld.elements.join()} ${camera.projectionMatrix.elements.join()}`;
    if (this.resize(renderer) || from !== this.viewKey) {
      this.viewKey = from;
      this.wait();
    }
    this.material.uniforms.push!.value = 2 * (pushOf(camera, renderer) + 0.5 * surface.stock.pitch) / (camera.far - camera.near);
    this.material.uniforms.viewpoint!.value.set(...viewpointOf(camera));
    if (this.state === "complete" && this.own) this.repaint(renderer, camera, this.own);
    if (this.state === "complete") return;
    // Everything is drawn once the view is at rest.
    window.clearTimeout(this.timer);
    if (this.state === "drawing") return;
    if (isTurning) return;
    if (this.rest <= 0) void this.drawAll(renderer, camera);
    else this.settle();
  }

  /** How long the view must still be at rest, ms. */
  private get rest(): number {
    return this.stillMs - (performance.now() - this.movedAt);
  }

  private settle(): void {
    this.timer = window.setTimeout(() => (this.rest > 0 ? this.settle() : this.requestFrame()), this.rest + 1);
  }

  /** Until the view is at rest only the coarse surface is drawn. */
  private wait(): void {
    this.number++;
    this.state = "stale";
    this.movedAt = performance.now();
  }

  /** Goes to another moment: the waiting time begins when that one is drawn. */
  private async leap(renderer: WebGLRenderer): Promise<void> {
    this.wait();
    const { number } = this;
    // What is drawn in this frame is counted.
    await Promise.resolve();
    await gpuFinished(renderer);
    if (number === this.number) this.movedAt = performance.now();
  }

  /** So much changes at once only while the time is dragged: more of it is likely to come. */
  private isLeap({ columns, rows }: TouchedBox): boolean {
    return (columns[1] - columns[0]) * (rows[1] - rows[0]) > this.atOnce.tiles * TILE_CELLS * TILE_CELLS;
  }

  private note(touched: TouchedBox | undefined): void {
    if (!touched) return;
    this.coarse!.isStale = true;
    const { own } = this;
    const join = (a: [number, number], b: [number, number]): [number, number] => [Math.min(a[0], b[0]), Math.max(a[1], b[1])];
    this.own = own
      ? { columns: join(own.columns, touched.columns), rows: join(own.rows, touched.rows), heights: join(own.heights, touched.heights) }
      : touched;
  }

  private resize(renderer: WebGLRenderer): boolean {
    const ratio = Math.min(2, window.devicePixelRatio);
    const size = renderer.getSize(new Vector2()).multiplyScalar(ratio).floor().max(new Vector2(1, 1));
    if (this.whole?.width === size.x && this.whole.height === size.y) return false;
    this.whole?.dispose();
    this.whole = new WebGLRenderTarget(size.x, size.y, { depthTexture: new DepthTexture(size.x, size.y, UnsignedIntType) });
    return true;
  }

  /** Draws again what has changed, where that is soon done. */
  private repaint(renderer: WebGLRenderer, camera: Camera, own: TouchedBox): void {
    const surface = this.surface!;
    const tiles = this.tiles!;
    const { x, y, width, height } = this.rectangle(surface, camera, [
      [own.columns[0], own.rows[0]], [own.columns[1] + 2, own.rows[1] + 2],
    ], own.heights, MARGIN_PIXELS);
    if (width <= 0 || height <= 0) {
      this.own = undefined;
      return;
    }
    const chosen: number[] = [];
    let sum = 0;
    for (let tile = 0; tile < tiles.count; tile++) {
      tiles.take(tile);
      const [x0, y0] = surface.firstCorner(tile);
      const own = this.rectangle(surface, camera, [[x0, y0], [x0 + TILE_CELLS, y0 + TILE_CELLS]], tiles.ends(tile), 1);
      if (own.x > x + width || own.x + own.width < x || own.y > y + height || own.y + own.height < y) continue;
      chosen.push(tile);
      sum += tiles.triangles(tile);
      if (sum > this.atOnce.triangles || chosen.length > this.atOnce.tiles) {
        // Too much for one frame: the coarse surface until it is still.
        this.wait();
        this.stillMs = Math.min(MAX_STILL_MS, 2 * this.stillMs);
        return;
      }
    }
    const target = this.whole!;
    target.scissor.set(x, y, width, height);
    target.scissorTest = true;
    renderer.setRenderTarget(target);
    renderer.clear();
    this.draw(renderer, camera, chosen);
    this.drawGaps(renderer, camera);
    this.drawFixtures(renderer, camera);
    target.scissorTest = false;
    renderer.setRenderTarget(null);
    this.stillMs = STILL_MS;
    this.own = undefined;
  }

  /** The part of the picture between two corners and two heights: pixels from the lower left. */
  private rectangle(surface: StockSurface, camera: Camera, [low, high]: [[number, number], [number, number]], heights: [number, number], margin: number) {
    const m = camera.matrixWorldInverse.elements;
    const p = camera.projectionMatrix.elements;
    const { position } = this.tiles!.group;
    const { width, height } = this.whole!;
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

  /** Where a corner is drawn, from the least corner of the stock, mm. */
  private corner({ stock }: StockSurface, x: number, y: number): [number, number] {
    const place = (axis: 0 | 1, at: number) => {
      const size = stock.high[axis] - stock.low[axis];
      return at <= 1 ? 0 : at >= stock.columns[axis] ? size : (at - 0.5) * stock.pitch;
    };
    return [place(0, x), place(1, y)];
  }

  private draw(renderer: WebGLRenderer, camera: Camera, chosen: number[]): void {
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
    // From below the underside is visible.
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
    if (part && part.triangles <= PART_TRIANGLES[this.isSoftware ? "software" : "card"]) return this.drawPart(renderer, camera, part);
    const { surface, tiles, isStale } = this.coarse!;
    if (isStale) surface.take();
    this.coarse!.isStale = false;
    this.drawnTriangles += tiles.choose(tiles.all);
    this.render(renderer, camera, tiles.group);
    this.drawGaps(renderer, camera);
    this.drawFixtures(renderer, camera);
  };

  /** Draws all of it, some tiles at a time. */
  private async drawAll(renderer: WebGLRenderer, camera: Camera): Promise<void> {
    this.state = "drawing";
    const number = ++this.number;
    this.own = undefined;
    if (this.shownPart) {
      renderer.setRenderTarget(this.whole!);
      renderer.clear();
      this.drawPart(renderer, camera, this.shownPart);
      renderer.setRenderTarget(null);
      this.state = "complete";
      this.requestFrame();
      return;
    }
    let cleared = false;
    const tiles = this.tiles!;
    // All corners first: a tile has on its edges those of the adjacent tiles.
    for (const at of tiles.all) {
      tiles.take(at);
      if ((at + 1) % this.atOnce.tiles > 0) continue;
      await yieldToEventLoop();
      if (number !== this.number) return;
    }
    let tile = 0;
    while (tile < tiles.count) {
      const some: number[] = [];
      let sum = 0;
      for (; tile < tiles.count && sum < this.atOnce.triangles && some.length < this.atOnce.tiles; tile++) {
        tiles.take(tile);
        some.push(tile);
        sum += tiles.triangles(tile);
      }
      renderer.setRenderTarget(this.whole!);
      if (!cleared) {
        renderer.clear();
        this.drawFixtures(renderer, camera);
        this.drawGaps(renderer, camera);
      }
      cleared = true;
      this.draw(renderer, camera, some);
      renderer.setRenderTarget(null);
      if (tile < tiles.count) await gpuFinished(renderer);
      if (number !== this.number) return;
    }
    this.state = "complete";
    this.requestFrame();
  }

  /** Where the part is cut open. */
  private openPart(): void {
    const { cut, part } = this;
    // Largest X and Z are kept, and least Y.
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
    for (const { uniforms, own } of [
      { uniforms: u, own: stock },
      { uniforms: this.coarseMaterial.uniforms, own: this.coarse!.surface.surface.stock },
    ]) {
      uniforms.columns!.value.set(own.columns[0], own.columns[1]);
      uniforms.pitch!.value = own.pitch;
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
    // At the middle of a column, so that the walls of the cut are straight.
    const column = (axis: 0 | 1) => {
      const at = ((cut?.at ?? 0) - stock.low[axis]) / stock.pitch;
      return Math.min(stock.columns[axis] - 1, Math.max(0, Math.round(at - 0.5)));
    };
    const snapped = (axis: 0 | 1) => this.corner(surface, column(0) + 1, column(1) + 1)[axis];
    this.coarse!.isStale = true;
    surface.setOpen(cut?.axis === "x" ? { column: column(0) + 1 } : cut?.axis === "y" ? { row: column(1) + 1 } : {});
    this.openPart();
    u.keep!.value.set(
      cut?.axis === "x" ? snapped(0) : BEYOND_MACHINE_MM,
      cut?.axis === "y" ? snapped(1) : -BEYOND_MACHINE_MM,
      cut?.axis === "z" ? cut.at - stock.high[2] : BEYOND_MACHINE_MM,
      cut ? 1 : 0,
    );
  }
}

/** Beyond every machine, mm. */
const BEYOND_MACHINE_MM = 1e9;

/** How far the stock is pushed back so that a path on it is visible, mm: a pixel and a half. */
function pushOf(camera: OrthographicCamera, renderer: WebGLRenderer): number {
  return (1.5 * (camera.right - camera.left)) / camera.zoom / Math.max(1, renderer.domElement.width);
}

function viewpointOf(camera: Camera): Vec3 {
  const m = camera.matrixWorld.elements;
  return [m[8]!, m[9]!, m[10]!];
}

function material(): ShaderMaterial {
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

/** The same material for another grid of columns: all else is that of the first. */
function sibling(of: ShaderMaterial): ShaderMaterial {
  const made = of.clone();
  made.uniforms = { ...of.uniforms, columns: { value: new Vector2() }, pitch: { value: 1 } };
  return made;
}
