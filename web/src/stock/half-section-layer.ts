// The half section of a lathe's stock, drawn on a canvas that lies under the path. The section is a plane, so its lines and arcs
// are drawn exactly, as seen from the camera.

import { type WebGLRenderer, CanvasTexture, DepthTexture, LinearFilter, Mesh, OrthographicCamera, PlaneGeometry, ShaderMaterial, UnsignedIntType, Vector2, Vector3, WebGLRenderTarget } from "three";
import type { Bounds, Vec3 } from "../path/batch";
import { type Palette, toolColor } from "../view/colors";
import { type HalfSections, type Loops, type SectionPoint, type TurnedTool, SEGMENT_NUMBERS, corners, draw, edges, hull, silhouette, trace } from "./half-sections";

/** How far a bar that is longer than the path is shown beyond it, as a fraction of the path's size. */
const BAR_ROOM_FRACTION = 0.25;
/** The plane is not drawn when it is seen from its edge: when its apparent area is less than this fraction of the true one. */
const EDGE_ON_FRACTION = 1e-3;
/** Problems that are marked with their line at most; more would cover each other. */
const MAX_MARKS = 40;
/** A point nearer to the axis is on it, mm. */
const ON_AXIS_MM = 1e-6;

/** The line and the position of a problem. */
export interface ProblemMark {
  line: number;
  at: SectionPoint;
}

/** A moment of the run. */
export interface SectionMoment {
  /** The number of the section. */
  number: number;
  /** Rows of the path that are done. */
  done: number;
  /** Positions of the tool on the row that is being cut, from its start to now. */
  cutting: SectionPoint[];
}

/** Mirrors at the axis of the spindle. */
const MIRROR_MATRIX = new DOMMatrix([1, 0, 0, -1, 0, 0]);

interface VisibleParts {
  stock: boolean;
  fixtures: boolean;
  target: boolean;
}

/** The paths of a section, which are kept until another is drawn. */
interface SectionOutline {
  number: number;
  /** The sectioned part. */
  section: Path2D;
  /** The outside of the part, drawn on the other side of the axis. */
  outside: Path2D;
  /** The edges of the outside. */
  edges: Path2D;
  /** Parts that were cut off. */
  loose: Path2D;
  /** Surfaces by the tool that made them; 0 is the stock. */
  surfaces: Map<number, Path2D>;
}

export class HalfSectionLayer {
  sections: HalfSections | undefined;
  shown: VisibleParts = { stock: true, fixtures: true, target: true };
  private origin: Vec3 = [0, 0, 0];
  private moment: SectionMoment = { number: 0, done: Infinity, cutting: [] };
  private tool: { shape: TurnedTool; at: SectionPoint | undefined; color: string } | undefined;
  private marks: ProblemMark[] = [];
  private slot: (tool: number) => number = () => 0;
  private outline: SectionOutline | undefined;
  private canvas = document.createElement("canvas");
  /** The part alone, from which the sweep of the tool is removed. */
  private part = document.createElement("canvas");
  /** Over the path: the tool and the marks of problems. */
  readonly over = document.createElement("canvas");
  private texture: CanvasTexture | undefined;
  private target: WebGLRenderTarget | undefined;
  private plane = new Mesh(new PlaneGeometry(2, 2), planeMaterial());
  private planeCamera = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
  /** Matrices of the camera for which it was drawn last. */
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

  /** Sets the sections, or none; `slot` gives the colour index of a tool. */
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

  /** Puts a tool at a position of the plane, or hides it; returns whether it has a shape. */
  placeTool(number: number, at: SectionPoint | undefined): boolean {
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

  /** Whether the present moment is drawn. */
  get isComplete(): boolean {
    return !this.sections || !this.isStale;
  }

  /** The render target with the section; undefined where there is none. */
  get underlay(): WebGLRenderTarget | undefined {
    return this.sections && this.target;
  }

  /** The box of the stock, relative to the origin of the path, mm; the part of a long bar that is far from the path is left out. */
  bounds(path: Bounds | undefined): Bounds | undefined {
    if (!this.sections || !this.shown.stock) return undefined;
    const numbers = this.sections.before.flatMap((loop) => Array.from(loop));
    /** Both ends of all lines and arcs: Z (0) or radius (1). */
    const ends = (component: number) => numbers.filter((_, index) => [component, component + 2].includes(index % SEGMENT_NUMBERS));
    const [x, y, z] = this.origin;
    const radius = Math.max(...ends(1));
    let [low, high] = [Math.min(...ends(0)) - z, Math.max(...ends(0)) - z];
    if (path) {
      const margin = BAR_ROOM_FRACTION * Math.max(path.high[2] - path.low[2], path.high[0] - path.low[0], 1);
      [low, high] = [Math.max(low, path.low[2] - margin), Math.min(high, path.high[2] + margin)];
    }
    return { low: [-radius - x, -y, low], high: [radius - x, -y, high] };
  }

  /** Draws the section before a frame, where it or the camera has changed. */
  prepare(renderer: WebGLRenderer, camera: OrthographicCamera): void {
    this.over.hidden = !this.sections;
    if (!this.sections) return;
    const viewKey = `${camera.matrixWorld.elements.join()} ${camera.projectionMatrix.elements.join()}`;
    if (!this.resize(renderer) && !this.isStale && viewKey === this.viewKey) return;
    this.viewKey = viewKey;
    this.isStale = false;
    const matrix = this.matrix(camera);
    this.paint(matrix);
    this.paintOver(matrix);
    this.texture!.needsUpdate = true;
    renderer.setRenderTarget(this.target!);
    renderer.clear();
    renderer.render(this.plane, this.planeCamera);
    renderer.setRenderTarget(null);
  }

  /** Adapts to the size of the renderer; returns whether that has changed. */
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

  /** Takes Z and radius to pixels; undefined where the plane is seen from its edge. */
  private matrix(camera: OrthographicCamera): DOMMatrix | undefined {
    const { width, height } = this.canvas;
    const [x, y, z] = this.origin;
    const toPixels = (at: SectionPoint): SectionPoint => {
      const p = new Vector3(at[1] - x, -y, at[0] - z).project(camera);
      return [((p.x + 1) / 2) * width, ((1 - p.y) / 2) * height];
    };
    const [zero, alongZ, alongRadius] = [toPixels([0, 0]), toPixels([1, 0]), toPixels([0, 1])];
    const [a, b, c, d] = [alongZ[0] - zero[0], alongZ[1] - zero[1], alongRadius[0] - zero[0], alongRadius[1] - zero[1]];
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
    const brush = new Brush(context, ratio);
    if (shown.stock) {
      const outline = this.outlineAt(moment.number);
      brush.fill(outline.outside, mirrored, palette.stock, 0.55);
      brush.stroke(outline.edges, mirrored, palette.rapid, 0.8);
      brush.fill(outline.loose, matrix, palette.inside, 0.35);
      this.paintPart(outline.section, matrix, ratio);
      for (const [tool, surfaces] of outline.surfaces) {
        brush.stroke(surfaces, matrix, tool === 0 ? palette.text : toolColor(palette, this.slot(tool)), tool === 0 ? 1 : 1.6);
      }
      brush.stroke(pathOf(sections.before), matrix, palette.rapid, 1, [5, 4]);
      for (const thread of sections.threads) {
        if (thread.row < moment.done) brush.stroke(pathOf(thread.loops), matrix, palette.text, 0.8);
      }
    }
    if (shown.target && sections.target) brush.stroke(pathOf(sections.target), matrix, palette.contour, 1.4, [8, 3]);
    if (shown.fixtures) {
      for (const { loops } of sections.fixtures) {
        for (const side of [matrix, mirrored]) {
          brush.fill(pathOf(loops), side, palette.fixture, 0.9);
          brush.stroke(pathOf(loops), side, palette.text, 0.8);
        }
      }
    }
    brush.axis(matrix, palette.rapid, canvas);
  }

  private paintOver(matrix: DOMMatrix | undefined): void {
    const { over, palette } = this;
    const context = over.getContext("2d")!;
    context.clearRect(0, 0, over.width, over.height);
    if (!matrix) return;
    const brush = new Brush(context, Math.min(2, window.devicePixelRatio));
    this.paintTool(brush, matrix, matrix.multiply(MIRROR_MATRIX));
    for (const { line, at } of this.shown.stock ? this.marks : []) brush.mark(matrix, at, `line ${line}`, palette.deviation[0]!, palette.background);
  }

  /** Draws the part without what the tool has removed on the row that is being cut. */
  private paintPart(section: Path2D, matrix: DOMMatrix, ratio: number): void {
    const { part, palette } = this;
    const context = part.getContext("2d")!;
    context.globalCompositeOperation = "source-over";
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, part.width, part.height);
    const brush = new Brush(context, ratio);
    brush.fill(section, matrix, palette.inside, 0.85);
    context.globalCompositeOperation = "destination-out";
    const { cutting } = this.moment;
    for (let index = 1; index < cutting.length; index++) {
      for (const loop of this.tool?.shape.edges ?? []) {
        const swept = new Path2D();
        polygon(swept, hull([...corners(loop, cutting[index - 1]!), ...corners(loop, cutting[index]!)]));
        brush.fill(swept, matrix, "#000000", 1);
      }
    }
    this.canvas.getContext("2d")!.drawImage(part, 0, 0);
  }

  private paintTool(brush: Brush, matrix: DOMMatrix, mirrored: DOMMatrix): void {
    const { tool, palette } = this;
    if (!tool?.at) return;
    const { at } = tool;
    const [z, r] = at;
    const translation = new DOMMatrix([1, 0, 0, 1, z, r]);
    // A drill or tap on the axis is drawn with both halves.
    const isAboveAxis = tool.shape.edges.every((loop) => corners(loop, at).every((corner) => corner[1] > -ON_AXIS_MM));
    const touchesAxis = tool.shape.edges.some((loop) => corners(loop, at).some((corner) => Math.abs(corner[1]) < ON_AXIS_MM));
    for (const side of isAboveAxis && touchesAxis && Math.abs(r) < ON_AXIS_MM ? [matrix, mirrored] : [matrix]) {
      const toCanvas = side.multiply(translation);
      brush.fill(pathOf(tool.shape.body), toCanvas, palette.toolShape, 0.3);
      brush.fill(pathOf(tool.shape.edges), toCanvas, tool.color, 0.6);
      if (tool.shape.edges.length === 1) brush.stroke(pathOf(tool.shape.edges), toCanvas, palette.text, 1);
    }
  }

  private outlineAt(number: number): SectionOutline {
    if (this.outline?.number === number) return this.outline;
    const sections = this.sections!;
    const [pieces, loose] = [sections.piecesOf(number), sections.piecesOf(number, true)];
    const segments = [...pieces, ...loose].map((piece) => sections.numbers(piece));
    const outline: SectionOutline = {
      number,
      section: pathOf(sections.loops(pieces)),
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

function polygon(path: Path2D, points: SectionPoint[]): void {
  points.forEach(([z, r], index) => (index === 0 ? path.moveTo(z, r) : path.lineTo(z, r)));
  path.closePath();
}

/** Draws paths of the half plane; line widths are in CSS pixels. */
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

  /** Draws the axis of the spindle across the canvas. */
  axis(matrix: DOMMatrix, color: string, { width, height }: HTMLCanvasElement): void {
    const toPlane = matrix.inverse();
    const ends = [[0, 0], [width, 0], [0, height], [width, height]].map(([x, y]) => toPlane.transformPoint({ x, y }).x);
    const path = new Path2D();
    path.moveTo(Math.min(...ends), 0);
    path.lineTo(Math.max(...ends), 0);
    this.stroke(path, matrix, color, 1, [16, 4, 3, 4]);
  }

  /** Draws a ring with a text next to it. */
  mark(matrix: DOMMatrix, [z, r]: SectionPoint, text: string, color: string, halo: string): void {
    const { context, ratio } = this;
    const { x, y } = matrix.transformPoint({ x: z, y: r });
    const ring = new Path2D();
    ring.arc(x, y, 6 * ratio, 0, 2 * Math.PI);
    const identity = new DOMMatrix();
    this.stroke(ring, identity, halo, 4);
    this.stroke(ring, identity, color, 2);
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
  const result = new Path2D();
  result.addPath(path, matrix);
  return result;
}

/** Draws the canvas at a depth behind everything else. */
function planeMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { picture: { value: null } },
    vertexShader: "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",
    fragmentShader: "varying vec2 at; uniform sampler2D picture; void main() { gl_FragColor = texture2D(picture, at); gl_FragDepth = 0.9999; }",
  });
}
