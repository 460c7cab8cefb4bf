// The half sections of a lathe's stock: each line and arc of the contour exists from one pass to another.

import { type Frame, f32, u32, u8 } from "../protocol/frame";

/** Numbers of a line or an arc: Z and radius of start, end and centre, mm, and the direction: 0 straight, 1 turning from +Z to +radius, -1 the other way. */
export const SEGMENT_NUMBERS = 7;

/** Loops, each as the numbers of its lines and arcs. */
export type Loops = ArrayLike<number>[];

export interface TurnedTool {
  number: number;
  /** The cutting edges: convex loops about the programmed point. */
  edges: number[][];
  /** Shank and holder. */
  body: number[][];
}

/** The methods of `Path2D` that loops are drawn with. */
export type Pen = Pick<Path2D, "moveTo" | "lineTo" | "arc" | "closePath">;

/** A point of the half plane: Z and radius, mm. */
export type SectionPoint = [number, number];

export class HalfSections {
  readonly before: Loops;
  readonly target: Loops | undefined;
  readonly fixtures: { name: string; loops: Loops }[];
  readonly threads: { row: number; loops: Loops }[];
  readonly tools: Map<number, TurnedTool>;
  /** Whether there is a section for every pass, and not only one after each tool. */
  readonly isWhole: boolean;
  private lines: Float32Array;
  /** By line or arc: its first section, and the one from which on it does not exist. */
  private from: Uint32Array;
  private until: Uint32Array;
  private tool: Uint32Array;
  /** By line or arc: 1 where it belongs to a part that was cut off. */
  private loose: Uint8Array;
  /** By section after the first: the row of the path that made it. */
  private rows: Uint32Array;

  constructor(frame: Frame) {
    const { header } = frame;
    this.before = header.before as Loops;
    this.target = (header.target as Loops | null) ?? undefined;
    this.fixtures = header.fixtures as HalfSections["fixtures"];
    this.threads = header.threads as HalfSections["threads"];
    this.tools = new Map((header.tools as TurnedTool[]).map((tool) => [tool.number, tool]));
    this.isWhole = header.whole === true;
    this.lines = f32(frame, "lines");
    this.from = u32(frame, "from");
    this.until = u32(frame, "until");
    this.tool = u32(frame, "tool");
    this.loose = u8(frame, "loose");
    this.rows = u32(frame, "rows");
  }

  /** Number of sections after the first one. */
  get count(): number {
    return this.rows.length;
  }

  /** The number of the section after `rowsDone` rows of the path. */
  numberAt(rowsDone: number): number {
    let [low, high] = [0, this.rows.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.rows[middle]! + 1 <= rowsDone) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** The row that is being cut; undefined between two rows, and where it does not cut. */
  rowInProgress(rowsDone: number): number | undefined {
    const row = Math.floor(rowsDone);
    return rowsDone > row && this.rows[this.numberAt(rowsDone)] === row ? row : undefined;
  }

  /** Indices of the lines and arcs of a section: those of parts that were cut off, or the others. */
  piecesOf(number: number, loose = false): number[] {
    const pieces: number[] = [];
    for (let piece = 0; piece < this.from.length; piece++) {
      if (this.from[piece]! <= number && number < this.until[piece]! && (this.loose[piece] === 1) === loose) pieces.push(piece);
    }
    return pieces;
  }

  /** The tool that made a line or an arc; 0 is the stock. */
  toolOf(piece: number): number {
    return this.tool[piece]!;
  }

  /** The numbers of a line or an arc. */
  numbers(piece: number): Float32Array {
    return this.lines.subarray(SEGMENT_NUMBERS * piece, SEGMENT_NUMBERS * (piece + 1));
  }

  /** Chains lines and arcs to loops: each starts where the one before ends. */
  loops(pieces: number[]): Loops {
    /** The start (0) or the end (2) of a line or an arc. */
    const key = (piece: number, offset: number) => `${this.lines[SEGMENT_NUMBERS * piece + offset]} ${this.lines[SEGMENT_NUMBERS * piece + offset + 1]}`;
    const starts = new Map<string, number[]>();
    for (const piece of pieces) {
      const sameStart = starts.get(key(piece, 0));
      if (sameStart) sameStart.push(piece);
      else starts.set(key(piece, 0), [piece]);
    }
    const used = new Set<number>();
    const loops: Loops = [];
    for (const first of pieces) {
      if (used.has(first)) continue;
      const loop: number[] = [];
      // Where several start at the same point, any may follow: together the loops enclose the same area.
      for (let next: number | undefined = first; next !== undefined; ) {
        used.add(next);
        loop.push(...this.numbers(next));
        next = starts.get(key(next, 2))?.find((piece) => !used.has(piece));
      }
      loops.push(loop);
    }
    return loops;
  }
}

/** Draws the line or arc whose numbers begin at `offset`; the pen is at its start. */
export function draw(pen: Pen, n: ArrayLike<number>, offset = 0): void {
  const [z0, r0, z1, r1, zc, rc, turn] = [n[offset]!, n[offset + 1]!, n[offset + 2]!, n[offset + 3]!, n[offset + 4]!, n[offset + 5]!, n[offset + 6]!];
  if (turn !== 0) {
    const [from, to] = [Math.atan2(r0 - rc, z0 - zc), Math.atan2(r1 - rc, z1 - zc)];
    const isWhole = z0 === z1 && r0 === r1;
    pen.arc(zc, rc, Math.hypot(z0 - zc, r0 - rc), from, isWhole ? from + turn * 2 * Math.PI : to, turn < 0);
  }
  pen.lineTo(z1, r1);
}

/** Draws closed loops. */
export function trace(pen: Pen, loops: Loops): void {
  for (const loop of loops) {
    pen.moveTo(loop[0]!, loop[1]!);
    for (let offset = 0; offset < loop.length; offset += SEGMENT_NUMBERS) draw(pen, loop, offset);
    pen.closePath();
  }
}

/** A line or an arc in the other direction. */
function reversed(n: ArrayLike<number>): number[] {
  return [n[2]!, n[3]!, n[0]!, n[1]!, n[4]!, n[5]!, -n[6]!];
}

/** Draws the area between lines or arcs and the axis: the part as seen from outside. */
export function silhouette(pen: Pen, pieces: ArrayLike<number>[]): void {
  for (const piece of pieces) {
    // All in the same direction, so that overlapping areas do not cancel in the nonzero fill rule.
    const n = piece[0]! <= piece[2]! ? piece : reversed(piece);
    pen.moveTo(n[0]!, 0);
    pen.lineTo(n[0]!, n[1]!);
    draw(pen, n);
    pen.lineTo(n[2]!, 0);
    pen.closePath();
  }
}

/** The radius of a line or an arc at a Z; undefined where it does not reach that Z. */
function radiusAt(n: ArrayLike<number>, z: number): number | undefined {
  const [low, high] = [Math.min(n[0]!, n[2]!), Math.max(n[0]!, n[2]!)];
  if (z < low || z > high || low === high) return undefined;
  const straight = n[1]! + ((n[3]! - n[1]!) * (z - n[0]!)) / (n[2]! - n[0]!);
  if (n[6] === 0) return straight;
  const arcRadius = Math.hypot(n[0]! - n[4]!, n[1]! - n[5]!);
  const height = Math.sqrt(Math.max(0, arcRadius ** 2 - (z - n[4]!) ** 2));
  // The half of the circle on the side of the chord.
  return n[5]! + (straight >= n[5]! ? height : -height);
}

/** A section of more lines and arcs is drawn without visible edges: finding them takes quadratic time. */
const MAX_EDGE_SEGMENTS = 600;
/** A line or an arc is covered by one that is further out by more than this, mm. */
const COVERED_MM = 1e-4;

/** The points of a section from which an edge is visible from outside; it reaches to the axis. */
export function edges(pieces: ArrayLike<number>[]): SectionPoint[] {
  if (pieces.length > MAX_EDGE_SEGMENTS) return [];
  const points: SectionPoint[] = [];
  for (const n of pieces) {
    const middle = (n[0]! + n[2]!) / 2;
    const radius = radiusAt(n, middle);
    if (radius === undefined || pieces.some((other) => (radiusAt(other, middle) ?? 0) > radius + COVERED_MM)) continue;
    points.push([n[0]!, n[1]!], [n[2]!, n[3]!]);
  }
  return points;
}

/** The largest angle of a chord of an arc of a tool, rad. */
const TOOL_CHORD_RAD = Math.PI / 24;

/** The corners of a convex loop, with arcs as chords, moved to a point. */
export function corners(loop: ArrayLike<number>, [z, r]: SectionPoint): SectionPoint[] {
  const points: SectionPoint[] = [];
  for (let offset = 0; offset < loop.length; offset += SEGMENT_NUMBERS) {
    points.push([loop[offset]! + z, loop[offset + 1]! + r]);
    if (loop[offset + 6] === 0) continue;
    const [zc, rc] = [loop[offset + 4]!, loop[offset + 5]!];
    const from = Math.atan2(loop[offset + 1]! - rc, loop[offset]! - zc);
    const turned = Math.atan2(loop[offset + 3]! - rc, loop[offset + 2]! - zc) - from;
    const sweep = turned > 0 ? turned : turned + 2 * Math.PI;
    const radius = Math.hypot(loop[offset]! - zc, loop[offset + 1]! - rc);
    const steps = Math.ceil(sweep / TOOL_CHORD_RAD);
    for (let step = 1; step < steps; step++) {
      const angle = from + (sweep * step) / steps;
      points.push([zc + radius * Math.cos(angle) + z, rc + radius * Math.sin(angle) + r]);
    }
  }
  return points;
}

/** The convex hull of points. */
export function hull(points: SectionPoint[]): SectionPoint[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (ordered: SectionPoint[]) => {
    const chain: SectionPoint[] = [];
    for (const point of ordered) {
      while (chain.length > 1) {
        const [a, b] = [chain[chain.length - 2]!, chain[chain.length - 1]!];
        if ((b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]) > 0) break;
        chain.pop();
      }
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}
