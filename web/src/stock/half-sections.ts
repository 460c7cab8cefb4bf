// The half sections of a lathe's stock: lines and arcs that bound it from one pass to another.

import { type Frame, f32, u32, u8 } from "../protocol/frame";

/** Numbers of a line or an arc: z and radius of its ends and its centre, mm, and how it turns: 0 straight, 1 from z to the radius, -1 back. */
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

/** What draws a loop: a `Path2D`. */
export type Pen = Pick<Path2D, "moveTo" | "lineTo" | "arc" | "closePath">;

/** A point of the half plane: z and radius, mm. */
export type SectionPoint = [number, number];

export class HalfSections {
  readonly before: Loops;
  readonly target: Loops | undefined;
  readonly fixtures: { name: string; loops: Loops }[];
  readonly threads: { row: number; loops: Loops }[];
  readonly tools: Map<number, TurnedTool>;
  /** There is a section for every pass. */
  readonly isWhole: boolean;
  private lines: Float32Array;
  private from: Uint32Array;
  private until: Uint32Array;
  private tool: Uint32Array;
  private loose: Uint8Array;
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

  /** Sections after the first one. */
  get count(): number {
    return this.rows.length;
  }

  /** The number of the section when so many pieces of path are done. */
  numberAt(done: number): number {
    let [low, high] = [0, this.rows.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.rows[middle]! + 1 <= done) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** The row that is being cut; undefined between two rows. */
  rowInProgress(done: number): number | undefined {
    const row = Math.floor(done);
    return done > row && this.rows[this.numberAt(done)] === row ? row : undefined;
  }

  /** The lines and arcs of a section, those of parts that were cut off or the others. */
  alive(number: number, loose = false): number[] {
    const found: number[] = [];
    for (let at = 0; at < this.from.length; at++) {
      if (this.from[at]! <= number && number < this.until[at]! && (this.loose[at] === 1) === loose) found.push(at);
    }
    return found;
  }

  /** The tool that made a line or an arc; 0 is the stock. */
  toolOf(piece: number): number {
    return this.tool[piece]!;
  }

  numbers(piece: number): Float32Array {
    return this.lines.subarray(SEGMENT_NUMBERS * piece, SEGMENT_NUMBERS * (piece + 1));
  }

  /** The loops of some lines and arcs: each goes on where the one before ends. */
  loops(pieces: number[]): Loops {
    const key = (piece: number, at: number) => `${this.lines[SEGMENT_NUMBERS * piece + at]} ${this.lines[SEGMENT_NUMBERS * piece + at + 1]}`;
    const starts = new Map<string, number[]>();
    for (const piece of pieces) {
      const here = starts.get(key(piece, 0));
      if (here) here.push(piece);
      else starts.set(key(piece, 0), [piece]);
    }
    const used = new Set<number>();
    const found: Loops = [];
    for (const first of pieces) {
      if (used.has(first)) continue;
      const loop: number[] = [];
      // Which of several goes on does not matter: what they enclose together is the same.
      for (let next: number | undefined = first; next !== undefined; ) {
        used.add(next);
        loop.push(...this.numbers(next));
        next = starts.get(key(next, 2))?.find((piece) => !used.has(piece));
      }
      found.push(loop);
    }
    return found;
  }
}

/** Draws a line or an arc from where the pen is. */
export function draw(pen: Pen, n: ArrayLike<number>, at = 0): void {
  const [z0, r0, z1, r1, zc, rc, turn] = [n[at]!, n[at + 1]!, n[at + 2]!, n[at + 3]!, n[at + 4]!, n[at + 5]!, n[at + 6]!];
  if (turn !== 0) {
    const [from, to] = [Math.atan2(r0 - rc, z0 - zc), Math.atan2(r1 - rc, z1 - zc)];
    const isWhole = z0 === z1 && r0 === r1;
    pen.arc(zc, rc, Math.hypot(z0 - zc, r0 - rc), from, isWhole ? from + turn * 2 * Math.PI : to, turn < 0);
  }
  pen.lineTo(z1, r1);
}

export function trace(pen: Pen, loops: Loops): void {
  for (const loop of loops) {
    pen.moveTo(loop[0]!, loop[1]!);
    for (let at = 0; at < loop.length; at += SEGMENT_NUMBERS) draw(pen, loop, at);
    pen.closePath();
  }
}

/** A line or an arc in the other direction. */
function back(n: ArrayLike<number>): number[] {
  return [n[2]!, n[3]!, n[0]!, n[1]!, n[4]!, n[5]!, -n[6]!];
}

/** What is below lines and arcs, down to the axis: the part as it is seen from outside. */
export function silhouette(pen: Pen, pieces: ArrayLike<number>[]): void {
  for (const piece of pieces) {
    // All in the same direction, so that overlapping areas add up.
    const n = piece[0]! <= piece[2]! ? piece : back(piece);
    pen.moveTo(n[0]!, 0);
    pen.lineTo(n[0]!, n[1]!);
    draw(pen, n);
    pen.lineTo(n[2]!, 0);
    pen.closePath();
  }
}

/** The radius of a line or an arc at a z; none where it is not there. */
function radiusAt(n: ArrayLike<number>, z: number): number | undefined {
  const [low, high] = [Math.min(n[0]!, n[2]!), Math.max(n[0]!, n[2]!)];
  if (z < low || z > high || low === high) return undefined;
  const straight = n[1]! + ((n[3]! - n[1]!) * (z - n[0]!)) / (n[2]! - n[0]!);
  if (n[6] === 0) return straight;
  const reach = Math.hypot(n[0]! - n[4]!, n[1]! - n[5]!);
  const half = Math.sqrt(Math.max(0, reach ** 2 - (z - n[4]!) ** 2));
  // With the material to the left, what goes from z to the radius bends out where it is on top.
  return n[5]! + (straight >= n[5]! ? half : -half);
}

/** More lines and arcs than that are drawn without the edges of the outside. */
const MAX_EDGE_SEGMENTS = 600;

/** The edges of a part that are seen from outside: from the radius at a z to the axis. */
export function edges(pieces: ArrayLike<number>[]): SectionPoint[] {
  if (pieces.length > MAX_EDGE_SEGMENTS) return [];
  const found: SectionPoint[] = [];
  for (const n of pieces) {
    const middle = (n[0]! + n[2]!) / 2;
    const own = radiusAt(n, middle);
    if (own === undefined || pieces.some((other) => (radiusAt(other, middle) ?? 0) > own + 1e-4)) continue;
    found.push([n[0]!, n[1]!], [n[2]!, n[3]!]);
  }
  return found;
}

/** Chords of an arc of a tool turn by so much at most, rad. */
const TOOL_STEP_RAD = Math.PI / 24;

/** The corners of a convex loop, arcs as chords, moved to a point. */
export function corners(loop: ArrayLike<number>, [z, r]: SectionPoint): SectionPoint[] {
  const found: SectionPoint[] = [];
  for (let at = 0; at < loop.length; at += SEGMENT_NUMBERS) {
    found.push([loop[at]! + z, loop[at + 1]! + r]);
    if (loop[at + 6] === 0) continue;
    const [zc, rc] = [loop[at + 4]!, loop[at + 5]!];
    const from = Math.atan2(loop[at + 1]! - rc, loop[at]! - zc);
    const turned = Math.atan2(loop[at + 3]! - rc, loop[at + 2]! - zc) - from;
    const sweep = turned > 0 ? turned : turned + 2 * Math.PI;
    const radius = Math.hypot(loop[at]! - zc, loop[at + 1]! - rc);
    const steps = Math.ceil(sweep / TOOL_STEP_RAD);
    for (let step = 1; step < steps; step++) {
      const angle = from + (sweep * step) / steps;
      found.push([zc + radius * Math.cos(angle) + z, rc + radius * Math.sin(angle) + r]);
    }
  }
  return found;
}

/** The convex hull of points. */
export function hull(spots: SectionPoint[]): SectionPoint[] {
  const sorted = [...spots].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (from: SectionPoint[]) => {
    const made: SectionPoint[] = [];
    for (const spot of from) {
      while (made.length > 1) {
        const [a, b] = [made[made.length - 2]!, made[made.length - 1]!];
        if ((b[0] - a[0]) * (spot[1] - a[1]) - (b[1] - a[1]) * (spot[0] - a[0]) > 0) break;
        made.pop();
      }
      made.push(spot);
    }
    return made.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}
