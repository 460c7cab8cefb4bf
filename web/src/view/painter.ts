// Draws the path and what lies over it. A path that is too long for one frame is drawn piece by
// piece into a picture that is reused: what lies over it, the tool above all, then costs no more than
// with a short path, and the page answers in between.

import {
  type Camera,
  DepthTexture,
  Group,
  type LineSegments,
  LinearSRGBColorSpace,
  Mesh,
  type Object3D,
  OrthographicCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  UnsignedIntType,
  Vector2,
  WebGLRenderTarget,
  WebGLRenderer,
} from "three";
import type { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { type DrawGroup, drawCost, drawGroups, drawWeight, isWide, wholeGroup } from "./draw-groups";
import { type FrameQuality, DrawSlices, FramePace } from "./frame-budget";
import { gpuFinished } from "./gpu-fence";
import { type PathLevels, LEVEL_LINES } from "./lod";

/** Lines that any machine draws in a frame. */
const MIN_SLICE_LINES = 8_000;
/** Edges in a reused picture are smoothed on machines that draw so many lines in one go. */
const SMOOTH_FROM_LINES = 100_000;
/** While frames follow each other, the picture is drawn in the gaps: a quarter of the usual slice, and a pause after each, ms. */
const BUSY_DIVISOR = 4;
const BUSY_PAUSE_MS = 40;
/** How often a picture that is being drawn is shown, ms. */
const SHOW_INTERVAL_MS = 150;

/** Frames that follow each other faster than this, ms, mean that something moves. */
const BUSY_MS = 200;

/** What is drawn below the path: a picture with depth, or a function that draws it where it changes in each frame. */
export type PictureBelow = WebGLRenderTarget | ((renderer: WebGLRenderer, camera: Camera) => void);

const STILL_QUALITY: FrameQuality = { level: -1, samples: 4, scale: 1 };

export class Painter {
  readonly renderer: WebGLRenderer;
  /** There is no graphics card: the processor draws. */
  readonly isSoftware: boolean;
  /** What is drawn once for each position of the camera. */
  readonly path = new Group();
  /** The part of `path` that is the program's own path, which may be hidden. */
  readonly own = new Group();
  /** The rapids in `own`; while the view turns, the simplified path has some of them. */
  readonly rapids = new Group();
  /** The part of `path` that may be missing while the view turns. */
  readonly extras = new Group();
  /** What is drawn again in each frame, over the path. */
  readonly over = new Group();
  readonly pace: FramePace;
  /** What is drawn below everything: the stock. */
  under: () => PictureBelow | undefined = () => undefined;
  /** Lines of the last frame, those of the reused picture included. */
  drawnLines = 0;
  /** Whether an incomplete picture is shown. */
  showsPart = true;
  private slices: DrawSlices;
  private scene = new Scene();
  private copy = new PictureCopy();
  private pixelRatio = Math.min(2, window.devicePixelRatio);
  private scale = 1;
  private size = new Vector2();
  private targets = new Map<number, WebGLRenderTarget>();
  private pictureTarget: WebGLRenderTarget | undefined;
  private pictureLines = 0;
  private state: "stale" | "drawing" | "complete" = "stale";
  private drewAll = false;
  private queue: DrawGroup[] = [];
  /** What has changed its colour while the picture was drawn. */
  private late: DrawGroup[] = [];
  /** The number of the picture that is being drawn: work for an older one stops. */
  private picture = 0;
  private shownAt = 0;
  private paintedAt = -Infinity;
  /** The last frame came soon after the one before. */
  private isBusy = false;
  private smoothLater = 0;

  constructor(
    canvas: HTMLCanvasElement,
    private camera: Camera,
    private cuts: Object3D,
    private coarse: PathLevels,
    private requestFrame: () => void,
  ) {
    // Edges are smoothed in targets of our own, where the machine is fast enough for that.
    this.renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: false });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setPixelRatio(this.pixelRatio);
    this.renderer.localClippingEnabled = true;
    this.renderer.autoClear = false;
    // Objects are drawn in the order in which they were added; sorting would need the extent of each.
    this.renderer.sortObjects = false;
    this.renderer.info.autoReset = false;
    this.isSoftware = drawsInSoftware(this.renderer.getContext());
    this.pace = new FramePace(this.isSoftware);
    this.slices = new DrawSlices(this.isSoftware);
    this.own.add(cuts, coarse.object, this.rapids);
    this.path.add(this.own, this.extras);
    this.scene.add(this.path, this.over);
  }

  resize(width: number, height: number): void {
    this.renderer.setSize(width, height, false);
    this.size.set(width, height).multiplyScalar(this.pixelRatio).floor();
    this.targets.forEach((target) => target.dispose());
    this.targets.clear();
    this.changed();
  }

  /** The path or the camera has changed: the picture is out of date. */
  changed(): void {
    this.picture++;
    this.state = "stale";
    this.queue = [];
    this.late = [];
  }

  /** An object was added to the path: it is drawn into the present picture, too. */
  added(object: LineSegments | LineSegments2): void {
    if (this.state === "stale" || !this.own.visible) return;
    this.queue.push(wholeGroup(object));
    if (this.state === "complete") void this.drawQueue();
  }

  /** Some of the path has another colour now: it is drawn into the present picture, too. */
  repaint(pieces: DrawGroup[]): void {
    if (this.state === "stale" || !this.own.visible || pieces.length === 0) return;
    this.late.push(...pieces);
    // While the picture is being drawn, they are drawn at its end.
    if (this.state !== "complete") return;
    // With so many lines a new picture is cheaper.
    if (drawWeight(this.late) > 2 * Math.max(MIN_SLICE_LINES, this.slices.lines)) return this.changed();
    this.drawLate();
  }

  /** Draws them at once: during playback each frame adds some, and a queue would never be empty. */
  private drawLate(): void {
    const { pictureLines } = this;
    this.queue = this.late;
    this.late = [];
    while (this.queue.length > 0) this.drawSome();
    this.pictureLines = pictureLines;
  }

  /** Whether frames follow each other. */
  private get isBusyNow(): boolean {
    return this.isBusy && performance.now() - this.paintedAt < BUSY_MS;
  }

  /** The last frame showed everything. */
  get isComplete(): boolean {
    return this.drewAll;
  }

  /** Draws a frame; while the view turns, with a quality that is fast enough. */
  paint(isTurning: boolean): void {
    this.renderer.info.reset();
    const now = performance.now();
    const gap = now - this.paintedAt;
    this.paintedAt = now;
    this.isBusy = gap <= BUSY_MS;
    const lines = drawWeight(drawGroups(this.path));
    const isShort = lines <= this.slices.lines;
    const isRough = this.isRough();
    this.drewAll = !isTurning && !isRough && (isShort || this.state === "complete");
    if (isTurning && (this.coarse.isReady || isShort)) this.draw(this.pace.quality);
    else if (isShort) {
      this.changed();
      const began = performance.now();
      this.draw(isRough ? { ...STILL_QUALITY, samples: 0 } : STILL_QUALITY);
      void gpuFinished(this.renderer).then(() => this.slices.took(lines, performance.now() - began));
    } else {
      if (this.state === "stale") this.begin();
      // Until the picture is complete, the coarse path shows more than a part of the whole one.
      if (this.state === "complete" || !this.coarse.isReady) this.show();
      else this.draw({ ...this.pace.quality, samples: 0 });
    }
  }

  /** Without a graphics card, edges over a stock are smoothed only when the picture is complete and nothing moves. */
  private isRough(): boolean {
    window.clearTimeout(this.smoothLater);
    const under = this.under();
    if (!this.isSoftware || !under) return false;
    if (typeof under === "function") return true;
    if (!this.isBusy) return false;
    this.smoothLater = window.setTimeout(this.requestFrame, BUSY_MS + 1);
    return true;
  }

  /** Draws everything in one frame. */
  private draw({ level, samples, scale }: FrameQuality): void {
    const { renderer, coarse, cuts, rapids, extras, scene, camera } = this;
    const rapidsShown = rapids.visible;
    const isCoarse = level >= 0 && coarse.isReady;
    coarse.show(isCoarse, level);
    cuts.visible = !isCoarse;
    rapids.visible = rapidsShown && !isCoarse;
    // If the program's own path is hidden, nothing else would be visible.
    extras.visible = !isCoarse || !this.own.visible || drawWeight(drawGroups(extras)) <= LEVEL_LINES[level]!;
    this.setScale(scale);
    const target = samples > 0 ? this.target(samples) : null;
    renderer.setRenderTarget(target);
    renderer.clear();
    this.drawUnder();
    renderer.render(scene, camera);
    coarse.show(false, level);
    cuts.visible = extras.visible = true;
    rapids.visible = rapidsShown;
    this.drawnLines = renderer.info.render.lines;
    if (target) this.put(target);
  }

  /** Scales the canvas itself, not a target: enlarging a small picture would cost as much again. */
  private setScale(scale: number): void {
    if (scale === this.scale) return;
    this.scale = scale;
    this.renderer.setPixelRatio(this.pixelRatio * scale);
  }

  /** Shows the reused picture and what lies over it. */
  private show(): void {
    this.shownAt = performance.now();
    this.setScale(1);
    this.renderer.setRenderTarget(null);
    this.renderer.clear();
    this.drawUnder();
    // Where the picture is empty, its depth is that of the background, so that the stock stays visible.
    if (this.pictureTarget) this.copy.draw(this.renderer, this.pictureTarget, true);
    this.renderer.render(this.over, this.camera);
    this.drawnLines = this.pictureLines;
  }

  private put(target: WebGLRenderTarget): void {
    this.renderer.setRenderTarget(null);
    this.renderer.clear();
    this.copy.draw(this.renderer, target, false);
  }

  /** Draws the stock, before what lies on it. */
  private drawUnder(): void {
    const under = this.under();
    if (typeof under === "function") under(this.renderer, this.camera);
    else if (under) this.copy.draw(this.renderer, under, true);
  }

  private begin(): void {
    const { renderer } = this;
    this.pictureTarget = this.target(this.slices.lines >= SMOOTH_FROM_LINES ? 4 : 0);
    this.pictureLines = 0;
    renderer.setRenderTarget(this.pictureTarget);
    renderer.clear();
    renderer.setRenderTarget(null);
    this.queue = drawGroups(this.path);
    void this.drawQueue();
  }

  /** Draws the queue into the reused picture, in slices that are done soon. */
  private async drawQueue(): Promise<void> {
    this.state = "drawing";
    const picture = ++this.picture;
    // The frame that has begun it is shown first.
    await gpuFinished(this.renderer);
    if (picture !== this.picture) return;
    while (this.queue.length > 0 || drawWeight(this.late) > MIN_SLICE_LINES) {
      if (this.queue.length === 0) [this.queue, this.late] = [this.late, []];
      const began = performance.now();
      const lines = this.drawSome();
      await gpuFinished(this.renderer);
      this.slices.took(lines, performance.now() - began);
      if (picture !== this.picture) return;
      if (this.isBusyNow) {
        await new Promise((next) => setTimeout(next, BUSY_PAUSE_MS));
        if (picture !== this.picture) return;
      }
      if (this.showsPart && performance.now() - this.shownAt > SHOW_INTERVAL_MS) this.requestFrame();
    }
    this.state = "complete";
    this.drawLate();
    this.requestFrame();
  }

  private drawSome(): number {
    const { renderer, camera, queue } = this;
    const most = this.isBusyNow ? Math.max(2_000, this.slices.lines / BUSY_DIVISOR) : this.slices.lines;
    let drawn = 0;
    renderer.setRenderTarget(this.pictureTarget!);
    while (queue.length > 0 && drawn < most) {
      const piece = queue[0]!;
      const { object, from } = piece;
      // Wide lines are not divided: there are never many.
      const count = isWide(object) ? piece.count : Math.min(piece.count, most - drawn);
      if (!isWide(object)) object.geometry.setDrawRange(2 * from, 2 * count);
      renderer.render(object, camera);
      object.geometry.setDrawRange(0, Infinity);
      drawn += count * drawCost(object);
      this.pictureLines += count;
      if (count === piece.count) queue.shift();
      else [piece.from, piece.count] = [from + count, piece.count - count];
    }
    renderer.setRenderTarget(null);
    return drawn;
  }

  private target(samples: 0 | 4): WebGLRenderTarget {
    let target = this.targets.get(samples);
    if (!target) {
      const { x, y } = this.size;
      target = new WebGLRenderTarget(x, y, { samples, depthTexture: new DepthTexture(x, y, UnsignedIntType) });
      this.targets.set(samples, target);
    }
    return target;
  }
}

/** Guesses by the name of the renderer; later the speed is measured. */
function drawsInSoftware(gl: WebGLRenderingContext | WebGL2RenderingContext): boolean {
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** Puts a picture onto the canvas, with the depth of what is on it or without. */
class PictureCopy {
  private camera = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
  private plane = new Mesh(new PlaneGeometry(2, 2));
  private plain = material("");
  private deep = material("gl_FragDepth = texture2D(depth, at).r;");

  constructor() {
    this.plane.frustumCulled = false;
  }

  draw(renderer: WebGLRenderer, { texture, depthTexture }: WebGLRenderTarget, withDepth: boolean): void {
    const chosen = withDepth ? this.deep : this.plain;
    chosen.uniforms.picture!.value = texture;
    chosen.uniforms.depth!.value = depthTexture;
    this.plane.material = chosen;
    renderer.render(this.plane, this.camera);
  }
}

function material(depth: string): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { picture: { value: null }, depth: { value: null } },
    vertexShader: "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",
    fragmentShader: `varying vec2 at; uniform sampler2D picture; uniform highp sampler2D depth;
      void main() { gl_FragColor = texture2D(picture, at); ${depth} }`,
    depthTest: depth !== "",
    depthWrite: depth !== "",
  });
}
