// Draws the path and the objects over it. A path that is too long for one frame is drawn in slices into a render target, the
// picture, that is reused until the camera or the path changes: the tool over it then costs no more to move than with a short
// path, and the page handles input between two slices.

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

/** Lines that any computer can draw in a frame. */
const MIN_SLICE_LINES = 8_000;
/** The picture is antialiased where a slice has at least this number of lines. */
const ANTIALIASED_FROM_LINES = 100_000;
/** While frames follow each other, the picture is drawn between them: in slices of a quarter of the usual size, with a pause after each, ms. */
const BUSY_DIVISOR = 4;
const BUSY_PAUSE_MS = 40;
/** Shortest time between two frames that show an incomplete picture, ms. */
const SHOW_INTERVAL_MS = 150;
/** Frames at shorter intervals, ms, mean that something moves. */
const BUSY_MS = 200;

/** What is drawn under the path: a render target with depth, or a function that draws in each frame. */
export type Underlay = WebGLRenderTarget | ((renderer: WebGLRenderer, camera: Camera) => void);

const STILL_QUALITY: FrameQuality = { level: -1, samples: 4, scale: 1 };

export class Painter {
  readonly renderer: WebGLRenderer;
  /** Whether the processor draws, without a graphics card. */
  readonly isSoftware: boolean;
  /** Drawn once for each position of the camera. */
  readonly path = new Group();
  /** The part of `path` that is the program's own path, which may be hidden. */
  readonly own = new Group();
  /** The rapids in `own`; the levels of detail have some of them on their own. */
  readonly rapids = new Group();
  /** The part of `path` that may be left out while the view turns. */
  readonly extras = new Group();
  /** Drawn again in each frame, over the path. */
  readonly over = new Group();
  readonly pace: FramePace;
  /** The stock, which is drawn under everything; undefined where there is none. */
  underlay: () => Underlay | undefined = () => undefined;
  /** Whether faces are drawn in `over` that may fill the picture. */
  hasFaces: () => boolean = () => false;
  /** Lines of the last frame, including those of the picture. */
  drawnLines = 0;
  /** Whether an incomplete picture is shown. */
  showsIncomplete = true;
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
  private wasComplete = false;
  private queue: DrawGroup[] = [];
  /** Lines whose colour has changed since they were drawn into the picture. */
  private recolored: DrawGroup[] = [];
  /** Number of the present picture: the drawing of an older one stops. */
  private pictureNumber = 0;
  /** When the picture was shown last, ms. */
  private shownAt = 0;
  /** When the last frame was drawn, ms. */
  private paintedAt = -Infinity;
  /** The last frame came soon after the one before. */
  private isBusy = false;
  /** Timer of the frame that is antialiased once nothing moves. */
  private antialiasTimer = 0;

  constructor(
    canvas: HTMLCanvasElement,
    private camera: Camera,
    private cuts: Object3D,
    private coarse: PathLevels,
    private requestFrame: () => void,
  ) {
    // Antialiasing is done in multisampled targets, where the computer is fast enough for it.
    this.renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: false });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setPixelRatio(this.pixelRatio);
    this.renderer.localClippingEnabled = true;
    this.renderer.autoClear = false;
    // Objects are drawn in the order in which they were added; sorting would need the bounding sphere of each.
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

  /** Marks the picture as out of date, after a change of the path or the camera. */
  changed(): void {
    this.pictureNumber++;
    this.state = "stale";
    this.queue = [];
    this.recolored = [];
  }

  /** Draws an object that was added to the path into the present picture, too. */
  added(object: LineSegments | LineSegments2): void {
    if (this.state === "stale" || !this.own.visible) return;
    this.queue.push(wholeGroup(object));
    if (this.state === "complete") void this.drawQueue();
  }

  /** Draws lines whose colour has changed into the present picture again. */
  repaint(groups: DrawGroup[]): void {
    if (this.state === "stale" || !this.own.visible || groups.length === 0) return;
    this.recolored.push(...groups);
    // While the picture is being drawn, they are drawn at its end.
    if (this.state !== "complete") return;
    // A new picture is cheaper than that many lines in one frame.
    if (drawWeight(this.recolored) > 2 * Math.max(MIN_SLICE_LINES, this.slices.lines)) return this.changed();
    this.drawRecolored();
  }

  /** Draws them at once: during playback each frame adds some, and the queue would never become empty. */
  private drawRecolored(): void {
    const { pictureLines } = this;
    this.queue = this.recolored;
    this.recolored = [];
    while (this.queue.length > 0) this.drawSlice();
    this.pictureLines = pictureLines;
  }

  /** Whether frames follow each other. */
  private get isBusyNow(): boolean {
    return this.isBusy && performance.now() - this.paintedAt < BUSY_MS;
  }

  /** The last frame showed everything. */
  get isComplete(): boolean {
    return this.wasComplete;
  }

  /** Draws a frame; while the view turns, in a quality that is fast enough. */
  paint(isTurning: boolean): void {
    this.renderer.info.reset();
    const now = performance.now();
    const gap = now - this.paintedAt;
    this.paintedAt = now;
    this.isBusy = gap <= BUSY_MS;
    const lines = drawWeight(drawGroups(this.path));
    const isShort = lines <= this.slices.lines;
    const isAliased = this.skipsAntialiasing();
    this.wasComplete = !isTurning && !isAliased && (isShort || this.state === "complete");
    if (isTurning && (this.coarse.isReady || isShort)) this.draw(this.pace.quality);
    else if (isShort) {
      this.changed();
      const began = performance.now();
      this.draw(isAliased ? { ...STILL_QUALITY, samples: 0 } : STILL_QUALITY);
      void gpuFinished(this.renderer).then(() => this.slices.took(lines, performance.now() - began));
    } else {
      if (this.state === "stale") this.beginPicture();
      // Until the picture is complete, a level of detail shows more of the path.
      if (this.state === "complete" || !this.coarse.isReady) this.showPicture();
      else this.draw({ ...this.pace.quality, samples: 0 });
    }
  }

  /** Without a graphics card, a frame with stock or faces is antialiased only when the stock is complete and nothing moves. */
  private skipsAntialiasing(): boolean {
    window.clearTimeout(this.antialiasTimer);
    const underlay = this.underlay();
    if (!this.isSoftware || !(underlay || this.hasFaces())) return false;
    if (typeof underlay === "function") return true;
    if (!this.isBusy) return false;
    this.antialiasTimer = window.setTimeout(this.requestFrame, BUSY_MS + 1);
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
    // Where the program's own path is hidden, nothing would be left without them.
    extras.visible = !isCoarse || !this.own.visible || drawWeight(drawGroups(extras)) <= LEVEL_LINES[level]!;
    this.setScale(scale);
    const target = samples > 0 ? this.target(samples) : null;
    renderer.setRenderTarget(target);
    renderer.clear();
    this.drawUnderlay();
    renderer.render(scene, camera);
    coarse.show(false, level);
    cuts.visible = extras.visible = true;
    rapids.visible = rapidsShown;
    this.drawnLines = renderer.info.render.lines;
    if (target) this.copyToCanvas(target);
  }

  /** Changes the resolution of the canvas itself, not of a target: enlarging a small target would cost as much again. */
  private setScale(scale: number): void {
    if (scale === this.scale) return;
    this.scale = scale;
    this.renderer.setPixelRatio(this.pixelRatio * scale);
  }

  /** Shows the picture and the objects over it. */
  private showPicture(): void {
    this.shownAt = performance.now();
    this.setScale(1);
    this.renderer.setRenderTarget(null);
    this.renderer.clear();
    this.drawUnderlay();
    // Where the picture is empty, its depth is that of the background, so the stock stays visible.
    if (this.pictureTarget) this.copy.draw(this.renderer, this.pictureTarget, true);
    this.renderer.render(this.over, this.camera);
    this.drawnLines = this.pictureLines;
  }

  private copyToCanvas(target: WebGLRenderTarget): void {
    this.renderer.setRenderTarget(null);
    this.renderer.clear();
    this.copy.draw(this.renderer, target, false);
  }

  private drawUnderlay(): void {
    const underlay = this.underlay();
    if (typeof underlay === "function") underlay(this.renderer, this.camera);
    else if (underlay) this.copy.draw(this.renderer, underlay, true);
  }

  private beginPicture(): void {
    const { renderer } = this;
    this.pictureTarget = this.target(this.slices.lines >= ANTIALIASED_FROM_LINES ? 4 : 0);
    this.pictureLines = 0;
    renderer.setRenderTarget(this.pictureTarget);
    renderer.clear();
    renderer.setRenderTarget(null);
    this.queue = drawGroups(this.path);
    void this.drawQueue();
  }

  /** Draws the queue into the picture, slice by slice. */
  private async drawQueue(): Promise<void> {
    this.state = "drawing";
    const number = ++this.pictureNumber;
    // The frame that has begun the picture is shown first.
    await gpuFinished(this.renderer);
    if (number !== this.pictureNumber) return;
    while (this.queue.length > 0 || drawWeight(this.recolored) > MIN_SLICE_LINES) {
      if (this.queue.length === 0) [this.queue, this.recolored] = [this.recolored, []];
      const began = performance.now();
      const lines = this.drawSlice();
      await gpuFinished(this.renderer);
      this.slices.took(lines, performance.now() - began);
      if (number !== this.pictureNumber) return;
      if (this.isBusyNow) {
        await new Promise((next) => setTimeout(next, BUSY_PAUSE_MS));
        if (number !== this.pictureNumber) return;
      }
      if (this.showsIncomplete && performance.now() - this.shownAt > SHOW_INTERVAL_MS) this.requestFrame();
    }
    this.state = "complete";
    this.drawRecolored();
    this.requestFrame();
  }

  /** Draws a slice of the queue; returns its cost, in lines of one pixel. */
  private drawSlice(): number {
    const { renderer, camera, queue } = this;
    const maxCost = this.isBusyNow ? Math.max(2_000, this.slices.lines / BUSY_DIVISOR) : this.slices.lines;
    let cost = 0;
    renderer.setRenderTarget(this.pictureTarget!);
    while (queue.length > 0 && cost < maxCost) {
      const group = queue[0]!;
      const { object, from } = group;
      // Wide lines are not divided: there are never many.
      const count = isWide(object) ? group.count : Math.min(group.count, maxCost - cost);
      if (!isWide(object)) object.geometry.setDrawRange(2 * from, 2 * count);
      renderer.render(object, camera);
      object.geometry.setDrawRange(0, Infinity);
      cost += count * drawCost(object);
      this.pictureLines += count;
      if (count === group.count) queue.shift();
      else [group.from, group.count] = [from + count, group.count - count];
    }
    renderer.setRenderTarget(null);
    return cost;
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

/** Guesses from the name of the renderer; later the speed is measured. */
function drawsInSoftware(gl: WebGLRenderingContext | WebGL2RenderingContext): boolean {
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** Copies a render target to the canvas, with its depth or without. */
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
