// The half section of a lathe's stock, drawn into a picture that lies under the path: a plane of lines and
// arcs is drawn exactly, from the direction of the camera.

import { type OrthographicCamera, type WebGLRenderer, CanvasTexture, DepthTexture, LinearFilter, Mesh, OrthographicCamera as Flat, PlaneGeometry, ShaderMaterial, UnsignedIntType, Vector2, Vector3, WebGLRenderTarget } from "three";
import type { Bounds, Vec3 } from "../path/batch";
import { type Palette, toolColor } from "../view/colors";
import { type HalfSections, type Loops, type SectionPoint, type TurnedTool, corners, draw, edges, hull, silhouette, trace } from "./half-sections";

/** A bar that is longer than the path is drawn so far beyond it, as a fraction of the path's size. */
const BAR_ROOM_FRACTION = 0.25;
/** Where the plane is seen almost from its edge it is not drawn: below this fraction of its area. */
const EDGE_ON_FRACTION = 1e-3;
/** Marks of problems with their line; more would lie over each other. */
const MAX_MARKS = 40;

/** A problem: its line, and where it is. */
export interface ProblemMark {
  line: number;
  at: SectionPoint;
}

/** Where the program is. */
export interface SectionMoment {
  /** Which section there is. */
  number: number;
  /** The pieces of path that are done. */
  done: number;
  /** The positions of the tool on the move that is being cut, from its start. */
  cutting: SectionPoint[];
}

/** To the other side of the axis. */
const MIRROR_MATRIX = new DOMMatrix([1, 0, 0, -1, 0, 0]);

interface Shown {
  stock: boolean;
  fixtures: boolean;
  target: boolean;
}

/** What is drawn of a section, until there is another. */
interface SectionOutline {
  number: number;
  whole: Path2D;
  outside: Path2D;
  edges: Path2D;
  loose: Path2D;
  /** By the tool that made them; 0 is the stock. */
  surfaces: Map<number, Path2D>;
}

export class HalfSectionLayer {
  sections: HalfSections | undefined;
  shown: Shown = { stock: true, fixtures: true, target: true };
  private origin: Vec3 = [0, 0, 0];
  private moment: SectionMoment = { number: 0, done: Infinity, cutting: [] };
  private tool: { shape: TurnedTool; at: SectionPoint | undefined; color: string } | undefined;
  private marks: ProblemMark[] = [];
  private slot: (tool: number) => number = () => 0;
  private outline: SectionOutline | undefined;
  private canvas = document.createElement("canvas");
  private part = document.createElement("canvas");
  /** Over the path: the tool, and where problems are. */
  readonly over = document.createElement("canvas");
  private texture: CanvasTexture | undefined;
  private target: WebGLRenderTarget | undefined;
  private plane = new Mesh(new PlaneGeometry(2, 2), picture());
  private flat = new Flat(-1, 1, 1, -1, 0, 1);
  private viewKey = "";
  private isStale = true;

  constructor(
    private palette: Palette,
    private requestFrame: () => void,
  ) {
    this.plane.frustumCulled = false;
    this.over.className = "over-path";
    this.over.setAttribute("aria-hidden", "true");
  }

  /** Other sections, or none; `slot` gives the number of a tool among those that cut. */
  begin(sections: HalfSections | undefined, origin: Vec3, slot: (tool: number) => number): void {
    this.sections = sections;
    this.origin = origin;
    this.slot = slot;
    this.outline = undefined;
    this.marks = [];
    this.tool = undefined;
    if (sections) this.goTo({ number: sections.count, done: Infinity, cutting: [] });
    this.changed();
  }

  goTo(moment: SectionMoment): void {
    this.moment = moment;
    this.changed();
  }

  /** The tool at a position of the plane, where it is to be seen; whether it has a shape. */
  place(number: number, at: SectionPoint | undefined): boolean {
    const shape = this.sections?.tools.get(number);
    this.tool = shape && { shape, at, color: toolColor(this.palette, this.slot(number)) };
    this.changed();
    return shape !== undefined;
  }

  mark(marks: ProblemMark[]): void {
    this.marks = marks.slice(0, MAX_MARKS);
    this.changed();
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.changed();
  }

  changed(): void {
    this.isStale = true;
    this.requestFrame();
  }

  /** The picture shows this moment. */
  get isComplete(): boolean {
    return !this.sections || !this.isStale;
  }

  /** The picture as it was drawn last. */
  get under(): WebGLRenderTarget | undefined {
    return this.sections && this.target;
  }

  /** The box of the stock, relative to the origin of the path; what of a long bar is far from the path is left out. */
  bounds(path: Bounds | undefined): Bounds | undefined {
    if (!this.sections || !this.shown.stock) return undefined;
    const numbers = this.sections.before.flatMap((loop) => Array.from(loop));
    const of = (at: number) => numbers.filter((_, index) => index % 7 === at || index % 7 === at + 2);
    const [x, y, z] = this.origin;
    const [ends, radius] = [of(0), Math.max(...of(1))];
    let [low, high] = [Math.min(...ends) - z, Math.max(...ends) - z];
    if (path) {
      const room = BAR_ROOM_FRACTION * Math.max(path.high[2] - path.low[2], path.high[0] - path.low[0], 1);
      [low, high] = [Math.max(low, path.low[2] - room), Math.min(high, path.high[2] + room)];
    }
    return { low: [-radius - x, -y, low], high: [radius - x, -y, high] };
  }

  /** Draws what is due before a frame. */
  prepare(renderer: WebGLRenderer, camera: OrthographicCamera): void {
    this.over.hidden = !this.sections;
    if (!this.sections) return;
    const from = `${camera.matrixWorld.elements.join()} ${camera.projectionMatrix.elements.join()}`;
    if (!this.resize(renderer) && !this.isStale && from === this.viewKey) return;
    this.viewKey = from;
    this.isStale = false;
    const matrix = this.matrix(camera);
    this.paint(matrix);
    this.paintOver(matrix);
    this.texture!.needsUpdate = true;
    renderer.setRenderTarget(this.target!);
    renderer.clear();
    renderer.render(this.plane, this.flat);
    renderer.setRenderTarget(null);
  }

  private resize(renderer: WebGLRenderer): boolean {
    const ratio = Math.min(2, window.devicePixelRatio);
    const { x, y } = renderer.getSize(new Vector2()).multiplyScalar(ratio).floor().max(new Vector2(1, 1));
    if (this.target?.width === x && this.target.height === y) return false;
    this.target?.dispose();
    this.texture?.dispose();
    for (const canvas of [this.canvas, this.part, this.over]) Object.assign(canvas, { width: x, height: y });
    this.target = new WebGLRenderTarget(x, y, { depthTexture: new DepthTexture(x, y, UnsignedIntType) });
    this.texture = new CanvasTexture(this.canvas);
    this.texture.minFilter = LinearFilter;
    this.texture.generateMipmaps = false;
    this.plane.material.uniforms.picture!.value = this.texture;
    return true;
  }

  /** Takes z and radius to pixels; none where the plane is seen from its edge. */
  private matrix(camera: OrthographicCamera): DOMMatrix | undefined {
    const { width, height } = this.canvas;
    const [x, y, z] = this.origin;
    const to = (at: SectionPoint): SectionPoint => {
      const p = new Vector3(at[1] - x, -y, at[0] - z).project(camera);
      return [((p.x + 1) / 2) * width, ((1 - p.y) / 2) * height];
    };
    const [zero, along, out] = [to([0, 0]), to([1, 0]), to([0, 1])];
    const [a, b, c, d] = [along[0] - zero[0], along[1] - zero[1], out[0] - zero[0], out[1] - zero[1]];
    const isVisible = Math.abs(a * d - b * c) > EDGE_ON_FRACTION * Math.max(Math.hypot(a, b), Math.hypot(c, d)) ** 2;
    return isVisible ? new DOMMatrix([a, b, c, d, ...zero]) : undefined;
  }

  private paint(matrix: DOMMatrix | undefined): void {
    const { canvas, palette, shown, moment } = this;
    const context = canvas.getContext("2d")!;
    const sections = this.sections!;
    context.fillStyle = palette.background;
    context.fillRect(0, 0, canvas.width, canvas.height);
    if (!matrix) return;
    const mirrored = matrix.multiply(MIRROR_MATRIX);
    const ratio = Math.min(2, window.devicePixelRatio);
    const pen = new Brush(context, ratio);
    if (shown.stock) {
      const outline = this.outlineAt(moment.number);
      pen.fill(outline.outside, mirrored, palette.stock, 0.55);
      pen.stroke(outline.edges, mirrored, palette.rapid, 0.8);
      pen.fill(outline.loose, matrix, palette.inside, 0.35);
      this.paintPart(outline.whole, matrix, ratio);
      for (const [tool, surfaces] of outline.surfaces) {
        pen.stroke(surfaces, matrix, tool === 0 ? palette.text : toolColor(palette, this.slot(tool)), tool === 0 ? 1 : 1.6);
      }
      pen.stroke(pathOf(sections.before), matrix, palette.rapid, 1, [5, 4]);
      for (const thread of sections.threads) {
        if (thread.row < moment.done) pen.stroke(pathOf(thread.loops), matrix, palette.text, 0.8);
      }
    }
    if (shown.target && sections.target) pen.stroke(pathOf(sections.target), matrix, palette.contour, 1.4, [8, 3]);
    if (shown.fixtures) {
      for (const { loops } of sections.fixtures) {
        for (const side of [matrix, mirrored]) {
          pen.fill(pathOf(loops), side, palette.fixture, 0.9);
          pen.stroke(pathOf(loops), side, palette.text, 0.8);
        }
      }
    }
    pen.axis(matrix, palette.rapid, canvas);
  }

  private paintOver(matrix: DOMMatrix | undefined): void {
    const { over, palette } = this;
    const context = over.getContext("2d")!;
    context.clearRect(0, 0, over.width, over.height);
    if (!matrix) return;
    const pen = new Brush(context, Math.min(2, window.devicePixelRatio));
    this.paintTool(pen, matrix, matrix.multiply(MIRROR_MATRIX));
    for (const { line, at } of this.shown.stock ? this.marks : []) pen.mark(matrix, at, `line ${line}`, palette.deviation[0]!, palette.background);
  }

  /** The part, without what the tool has taken of it on the move that is being cut. */
  private paintPart(whole: Path2D, matrix: DOMMatrix, ratio: number): void {
    const { part, palette } = this;
    const context = part.getContext("2d")!;
    context.globalCompositeOperation = "source-over";
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, part.width, part.height);
    const pen = new Brush(context, ratio);
    pen.fill(whole, matrix, palette.inside, 0.85);
    context.globalCompositeOperation = "destination-out";
    const { cutting } = this.moment;
    for (let at = 1; at < cutting.length; at++) {
      for (const loop of this.tool?.shape.edges ?? []) {
        const swept = new Path2D();
        polygon(swept, hull([...corners(loop, cutting[at - 1]!), ...corners(loop, cutting[at]!)]));
        pen.fill(swept, matrix, "#000000", 1);
      }
    }
    this.canvas.getContext("2d")!.drawImage(part, 0, 0);
  }

  private paintTool(pen: Brush, matrix: DOMMatrix, mirrored: DOMMatrix): void {
    const { tool, palette } = this;
    if (!tool?.at) return;
    const { at } = tool;
    const [z, r] = at;
    const by = new DOMMatrix([1, 0, 0, 1, z, r]);
    // A tool on the axis is drawn with both halves.
    const isOnAxis = tool.shape.edges.every((loop) => corners(loop, at).every((spot) => spot[1] > -1e-6));
    const touches = tool.shape.edges.some((loop) => corners(loop, at).some((spot) => Math.abs(spot[1]) < 1e-6));
    for (const side of isOnAxis && touches && Math.abs(r) < 1e-6 ? [matrix, mirrored] : [matrix]) {
      const to = side.multiply(by);
      pen.fill(pathOf(tool.shape.body), to, palette.toolShape, 0.3);
      pen.fill(pathOf(tool.shape.edges), to, tool.color, 0.6);
      if (tool.shape.edges.length === 1) pen.stroke(pathOf(tool.shape.edges), to, palette.text, 1);
    }
  }

  private outlineAt(number: number): SectionOutline {
    if (this.outline?.number === number) return this.outline;
    const sections = this.sections!;
    const [pieces, loose] = [sections.alive(number), sections.alive(number, true)];
    const segments = [...pieces, ...loose].map((piece) => sections.numbers(piece));
    const outline: SectionOutline = {
      number,
      whole: pathOf(sections.loops(pieces)),
      outside: new Path2D(),
      edges: new Path2D(),
      loose: pathOf(sections.loops(loose)),
      surfaces: new Map(),
    };
    silhouette(outline.outside, segments);
    for (const [z, r] of edges(segments)) {
      outline.edges.moveTo(z, r);
      outline.edges.lineTo(z, 0);
    }
    for (const piece of [...pieces, ...loose]) {
      const tool = sections.toolOf(piece);
      const n = sections.numbers(piece);
      const path = outline.surfaces.get(tool) ?? new Path2D();
      outline.surfaces.set(tool, path);
      path.moveTo(n[0]!, n[1]!);
      draw(path, n);
      outline.edges.moveTo(n[0]!, n[1]!);
      draw(outline.edges, n);
    }
    return (this.outline = outline);
  }
}

function pathOf(loops: Loops): Path2D {
  const path = new Path2D();
  trace(path, loops);
  return path;
}

function polygon(path: Path2D, spots: SectionPoint[]): void {
  spots.forEach(([z, r], at) => (at === 0 ? path.moveTo(z, r) : path.lineTo(z, r)));
  path.closePath();
}

/** Draws paths of the half plane; lines keep their width on the screen. */
class Brush {
  constructor(
    private context: CanvasRenderingContext2D,
    private ratio: number,
  ) {}

  fill(path: Path2D, matrix: DOMMatrix, color: string, opacity: number): void {
    const { context } = this;
    context.globalAlpha = opacity;
    context.fillStyle = color;
    context.fill(moved(path, matrix));
    context.globalAlpha = 1;
  }

  stroke(path: Path2D, matrix: DOMMatrix, color: string, width: number, dash: number[] = []): void {
    const { context, ratio } = this;
    context.strokeStyle = color;
    context.lineWidth = width * ratio;
    context.lineJoin = "round";
    context.setLineDash(dash.map((length) => length * ratio));
    context.stroke(moved(path, matrix));
    context.setLineDash([]);
  }

  /** The axis of the spindle, through all of the picture. */
  axis(matrix: DOMMatrix, color: string, { width, height }: HTMLCanvasElement): void {
    const back = matrix.inverse();
    const ends = [[0, 0], [width, 0], [0, height], [width, height]].map(([x, y]) => back.transformPoint({ x, y }).x);
    const path = new Path2D();
    path.moveTo(Math.min(...ends), 0);
    path.lineTo(Math.max(...ends), 0);
    this.stroke(path, matrix, color, 1, [16, 4, 3, 4]);
  }

  /** A ring with words next to it. */
  mark(matrix: DOMMatrix, [z, r]: SectionPoint, text: string, color: string, halo: string): void {
    const { context, ratio } = this;
    const { x, y } = matrix.transformPoint({ x: z, y: r });
    const ring = new Path2D();
    ring.arc(x, y, 6 * ratio, 0, 2 * Math.PI);
    const still = new DOMMatrix();
    this.stroke(ring, still, halo, 4);
    this.stroke(ring, still, color, 2);
    context.font = `600 ${12 * ratio}px system-ui, sans-serif`;
    context.textBaseline = "middle";
    context.strokeStyle = halo;
    context.lineWidth = 3 * ratio;
    context.strokeText(text, x + 10 * ratio, y - 9 * ratio);
    context.fillStyle = color;
    context.fillText(text, x + 10 * ratio, y - 9 * ratio);
  }
}

function moved(path: Path2D, matrix: DOMMatrix): Path2D {
  const made = new Path2D();
  made.addPath(path, matrix);
  return made;
}

/** Draws the picture with depth: it is behind everything else, and nowhere where it is empty. */
function picture(): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { picture: { value: null } },
    vertexShader: "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",
    fragmentShader: "varying vec2 at; uniform sampler2D picture; void main() { gl_FragColor = texture2D(picture, at); gl_FragDepth = 0.9999; }",
  });
}
