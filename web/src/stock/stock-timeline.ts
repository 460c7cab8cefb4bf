// The cutting of a stock as a list of which column is lowered when: any moment is reached forward and backward with no more
// work than what is different there.

/** The stock before the first cut. */
export interface StockBefore {
  /** The corners of its box, in the frame of the run, mm. */
  low: [number, number, number];
  high: [number, number, number];
  /** The side of a column, mm. */
  pitch: number;
  /** Columns along X and Y. */
  columns: [number, number];
  /** From the top of the box, mm: row by row from the least Y on, in each by X. */
  heights: Float32Array;
  /** The heights of the target, and the tolerance of cuts, mm. */
  target?: Float32Array | undefined;
  toleranceMm: number;
  /** Triangles of fixtures, in the frame of the run, mm: nine numbers each. */
  fixtures?: Float32Array | undefined;
}

/** Drops between two keyframes, at least: so many are carried out in a few milliseconds. */
const MIN_KEYFRAME_DROPS = 1 << 17;

/** A moment is far if it is more drops away than one in so many columns. */
const FAR_DIVISOR = 16;

interface Keyframe {
  at: number;
  heights: Float32Array;
  slots: Uint8Array;
}

/** An array that doubles when it is full. */
class GrowingArray<A extends Uint32Array | Float32Array | Uint8Array> {
  constructor(public all: A) {}

  room(count: number): void {
    if (count <= this.all.length) return;
    const made = new (this.all.constructor as new (length: number) => A)(Math.max(count, 2 * this.all.length));
    made.set(this.all);
    this.all = made;
  }
}

export class StockTimeline {
  /** The heights now, from the top, mm, and the slot of the tool that cut each column last: 0 where none did. */
  readonly heights: Float32Array;
  readonly slots: Uint8Array;
  count = 0;
  /** How many drops are carried out. */
  at = 0;
  private column = new GrowingArray(new Uint32Array(1024));
  private row = new GrowingArray(new Uint32Array(1024));
  private fraction = new GrowingArray(new Float32Array(1024));
  private height = new GrowingArray(new Float32Array(1024));
  private before = new GrowingArray(new Float32Array(1024));
  private slot = new GrowingArray(new Uint8Array(1024));
  private slotBefore = new GrowingArray(new Uint8Array(1024));
  /** The heights after the last drop. */
  private last: Keyframe;
  private keyframes: Keyframe[];
  private between: number;

  constructor(heights: Float32Array, between = Math.max(MIN_KEYFRAME_DROPS, heights.length)) {
    this.heights = heights.slice();
    this.slots = new Uint8Array(heights.length);
    this.last = { at: 0, heights: heights.slice(), slots: new Uint8Array(heights.length) };
    this.keyframes = [copy(this.last)];
    this.between = between;
  }

  /** Adds drops, in the order of the run; a column that is not there is left out. */
  add(columns: Uint32Array, rows: Uint32Array, fractions: Float32Array, heights: Float32Array, slotOf: (row: number) => number): void {
    const most = this.count + columns.length;
    for (const grown of [this.column, this.row, this.fraction, this.height, this.before, this.slot, this.slotBefore]) grown.room(most);
    const { last } = this;
    let of = -1;
    let slot = 0;
    for (let n = 0; n < columns.length; n++) {
      const column = columns[n]!;
      if (column >= last.heights.length) continue;
      if (rows[n] !== of) {
        of = rows[n]!;
        slot = slotOf(of);
      }
      const at = this.count++;
      this.column.all[at] = column;
      this.row.all[at] = of;
      this.fraction.all[at] = fractions[n]!;
      this.height.all[at] = heights[n]!;
      this.before.all[at] = last.heights[column]!;
      this.slot.all[at] = slot;
      this.slotBefore.all[at] = last.slots[column]!;
      last.heights[column] = heights[n]!;
      last.slots[column] = slot;
      last.at = this.count;
      if (this.count - this.keyframes.at(-1)!.at >= this.between) this.keyframes.push(copy(last));
    }
  }

  /** How many drops are done once so much of the path is: rows, and of the last one a fraction. */
  doneAt(rows: number): number {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.row.all[middle]! + this.fraction.all[middle]! <= rows) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** Goes to the moment when so much of the path is done, and calls `changed` for each column that differs; returns the work: how many columns were set or compared. */
  seek(rows: number, changed: (column: number) => void): number {
    const to = this.doneAt(rows);
    const nearest = this.nearest(to);
    // A keyframe is read in order, drops are not: four of those cost as much as one of these.
    const jump = this.heights.length / 4 + Math.abs(to - nearest.at);
    let work = 0;
    if (jump < Math.abs(to - this.at)) {
      work += this.heights.length;
      this.jump(nearest, changed);
    }
    work += Math.abs(to - this.at);
    const column = this.column.all;
    const [heights, slots] = [this.height.all, this.slot.all];
    for (; this.at < to; this.at++) this.put(column[this.at]!, heights[this.at]!, slots[this.at]!, changed);
    const [before, slotBefore] = [this.before.all, this.slotBefore.all];
    while (this.at > to) {
      this.at--;
      this.put(column[this.at]!, before[this.at]!, slotBefore[this.at]!, changed);
    }
    return work;
  }

  /**
   * Goes to a moment where so many columns differ that the caller should compare all of them; returns whether it went.
   * Does nothing if the moment is near.
   */
  leap(rows: number): boolean {
    const to = this.doneAt(rows);
    const steps = Math.abs(to - this.at);
    if (steps < this.heights.length / FAR_DIVISOR) return false;
    const nearest = this.nearest(to);
    if (Math.abs(to - nearest.at) < steps) {
      this.heights.set(nearest.heights);
      this.slots.set(nearest.slots);
      this.at = nearest.at;
    }
    this.seek(rows, () => {});
    return true;
  }

  private nearest(to: number): Keyframe {
    const after = this.keyframes.findIndex(({ at }) => at > to);
    const before = this.keyframes.at(after < 0 ? -1 : after - 1)!;
    const next = after < 0 ? undefined : this.keyframes[after]!;
    return next && next.at - to < to - before.at ? next : before;
  }

  private jump(to: Keyframe, changed: (column: number) => void): void {
    for (let column = 0; column < this.heights.length; column++) {
      if (this.heights[column] === to.heights[column] && this.slots[column] === to.slots[column]) continue;
      this.put(column, to.heights[column]!, to.slots[column]!, changed);
    }
    this.at = to.at;
  }

  private put(column: number, height: number, slot: number, changed: (column: number) => void): void {
    this.heights[column] = height;
    this.slots[column] = slot;
    changed(column);
  }

  /** Bytes that the list and its keyframes take. */
  get bytes(): number {
    const list = [this.column, this.row, this.fraction, this.height, this.before, this.slot, this.slotBefore];
    const keyframe = 5 * this.heights.length;
    return list.reduce((sum, { all }) => sum + all.byteLength, 0) + keyframe * (this.keyframes.length + 2);
  }
}

function copy({ at, heights, slots }: Keyframe): Keyframe {
  return { at, heights: heights.slice(), slots: slots.slice() };
}
