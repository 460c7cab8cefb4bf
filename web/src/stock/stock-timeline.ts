// The simulation of a stock as a list of drops, each the lowering of one column: any moment is reached forward or backward, with
// work in proportion to the drops in between or, from a keyframe, to the number of columns.

/** The stock before the first cut. */
export interface StockBefore {
  /** Lowest and highest corner of its box, in the frame of the run, mm. */
  low: [number, number, number];
  high: [number, number, number];
  /** The side of a column, mm. */
  pitch: number;
  /** Columns along X and Y. */
  columns: [number, number];
  /** The heights of columns, mm from the top of the box: row by row from the lowest Y, in each row by X. */
  heights: Float32Array;
  /** The heights of the target, mm from the top of the box; undefined where there is none. */
  target?: Float32Array | undefined;
  /** How far a cut surface may deviate from the target. */
  toleranceMm: number;
  /** Triangles of fixtures, in the frame of the run, mm: nine numbers each. */
  fixtures?: Float32Array | undefined;
}

/** Drops between two keyframes, at least: this number takes a few milliseconds. */
const MIN_KEYFRAME_DROPS = 1 << 17;

/** A moment is far away if there are more drops to it than the number of columns divided by this. */
const FAR_DIVISOR = 16;

interface Keyframe {
  /** How many drops come before it. */
  at: number;
  heights: Float32Array;
  slots: Uint8Array;
}

/** An array that doubles when it is full. */
class GrowingArray<A extends Uint32Array | Float32Array | Uint8Array> {
  constructor(public all: A) {}

  /** Makes room for `count` elements. */
  reserve(count: number): void {
    if (count <= this.all.length) return;
    const grown = new (this.all.constructor as new (length: number) => A)(Math.max(count, 2 * this.all.length));
    grown.set(this.all);
    this.all = grown;
  }
}

export class StockTimeline {
  /** The present heights, mm from the top of the box. */
  readonly heights: Float32Array;
  /** The colour slot of the tool that cut each column last; 0 where none did. */
  readonly slots: Uint8Array;
  count = 0;
  /** How many drops have been carried out. */
  at = 0;
  private column = new GrowingArray(new Uint32Array(1024));
  private row = new GrowingArray(new Uint32Array(1024));
  private fraction = new GrowingArray(new Float32Array(1024));
  private height = new GrowingArray(new Float32Array(1024));
  private heightBefore = new GrowingArray(new Float32Array(1024));
  private slot = new GrowingArray(new Uint8Array(1024));
  private slotBefore = new GrowingArray(new Uint8Array(1024));
  /** The heights after the last drop. */
  private last: Keyframe;
  private keyframes: Keyframe[];

  constructor(heights: Float32Array, private keyframeInterval = Math.max(MIN_KEYFRAME_DROPS, heights.length)) {
    this.heights = heights.slice();
    this.slots = new Uint8Array(heights.length);
    this.last = { at: 0, heights: heights.slice(), slots: new Uint8Array(heights.length) };
    this.keyframes = [copy(this.last)];
  }

  /** Adds drops in the order of the run: after a row and a fraction a column has a height. Columns that do not exist are left out. */
  add(columns: Uint32Array, rows: Uint32Array, fractions: Float32Array, heights: Float32Array, slotOf: (row: number) => number): void {
    const total = this.count + columns.length;
    for (const array of [this.column, this.row, this.fraction, this.height, this.heightBefore, this.slot, this.slotBefore]) array.reserve(total);
    const { last } = this;
    let slotRow = -1;
    let slot = 0;
    for (let n = 0; n < columns.length; n++) {
      const column = columns[n]!;
      if (column >= last.heights.length) continue;
      if (rows[n] !== slotRow) {
        slotRow = rows[n]!;
        slot = slotOf(slotRow);
      }
      const drop = this.count++;
      this.column.all[drop] = column;
      this.row.all[drop] = slotRow;
      this.fraction.all[drop] = fractions[n]!;
      this.height.all[drop] = heights[n]!;
      this.heightBefore.all[drop] = last.heights[column]!;
      this.slot.all[drop] = slot;
      this.slotBefore.all[drop] = last.slots[column]!;
      last.heights[column] = heights[n]!;
      last.slots[column] = slot;
      last.at = this.count;
      if (this.count - this.keyframes.at(-1)!.at >= this.keyframeInterval) this.keyframes.push(copy(last));
    }
  }

  /** How many drops are done after `rows` rows of the path, with a fraction of the present one. */
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

  /** Goes to the moment when `rows` rows of the path are done, and calls `changed` for each column that is set; returns the work: how many columns were set or compared. */
  seek(rows: number, changed: (column: number) => void): number {
    const to = this.doneAt(rows);
    const nearest = this.nearestKeyframe(to);
    // A keyframe is read sequentially, drops are not: four columns of a keyframe cost as much as one drop.
    const keyframeCost = this.heights.length / 4 + Math.abs(to - nearest.at);
    let work = 0;
    if (keyframeCost < Math.abs(to - this.at)) {
      work += this.heights.length;
      this.restore(nearest, changed);
    }
    work += Math.abs(to - this.at);
    const column = this.column.all;
    const [heights, slots] = [this.height.all, this.slot.all];
    for (; this.at < to; this.at++) this.put(column[this.at]!, heights[this.at]!, slots[this.at]!, changed);
    const [before, slotBefore] = [this.heightBefore.all, this.slotBefore.all];
    while (this.at > to) {
      this.at--;
      this.put(column[this.at]!, before[this.at]!, slotBefore[this.at]!, changed);
    }
    return work;
  }

  /**
   * Goes to a moment that is so far away that the caller should compare all columns; returns false, and does nothing, if the moment
   * is near.
   */
  leap(rows: number): boolean {
    const to = this.doneAt(rows);
    const steps = Math.abs(to - this.at);
    if (steps < this.heights.length / FAR_DIVISOR) return false;
    const nearest = this.nearestKeyframe(to);
    if (Math.abs(to - nearest.at) < steps) {
      this.heights.set(nearest.heights);
      this.slots.set(nearest.slots);
      this.at = nearest.at;
    }
    this.seek(rows, () => {});
    return true;
  }

  /** The keyframe with the fewest drops to a number of drops. */
  private nearestKeyframe(to: number): Keyframe {
    const after = this.keyframes.findIndex(({ at }) => at > to);
    const before = this.keyframes.at(after < 0 ? -1 : after - 1)!;
    const next = after < 0 ? undefined : this.keyframes[after]!;
    return next && next.at - to < to - before.at ? next : before;
  }

  private restore(to: Keyframe, changed: (column: number) => void): void {
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

  /** Bytes of the drops and the keyframes. */
  get bytes(): number {
    const list = [this.column, this.row, this.fraction, this.height, this.heightBefore, this.slot, this.slotBefore];
    const keyframe = (Float32Array.BYTES_PER_ELEMENT + Uint8Array.BYTES_PER_ELEMENT) * this.heights.length;
    return list.reduce((sum, { all }) => sum + all.byteLength, 0) + keyframe * (this.keyframes.length + 2);
  }
}

function copy({ at, heights, slots }: Keyframe): Keyframe {
  return { at, heights: heights.slice(), slots: slots.slice() };
}
