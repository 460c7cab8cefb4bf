// The planned motion: setpoints at a constant period.

import type { Vec3 } from "./batch";
import type { Path } from "./path";

export interface Setpoints {
  /** Positions of the tool on the part in the frame of the run, mm: three numbers each. */
  positions: Float32Array;
  /** The programmed positions; undefined where no rotary axis turns the part: then they are `positions`. */
  programmed?: Float32Array | undefined;
  /** A, B and C, rad, three numbers each; undefined where all of them are zero. */
  rotaryAngles?: Float32Array | undefined;
  /** The positions of all axes on the machine, mm and rad, six numbers each; undefined where the machine has no bodies. */
  machineAxes?: Float32Array | undefined;
  /** mm/min. */
  speed: Float32Array;
  /** The row of the path that each setpoint is on, ascending. */
  row: Uint32Array;
  periodS: number;
  totalS: number;
}

export interface SetpointMoment {
  /** On the part, in the frame of the run, mm. */
  position: Vec3;
  /** The programmed position. */
  programmed: Vec3;
  /** A, B and C, rad. */
  rotaryAngles: Vec3;
  /** mm/min. */
  speed: number;
  row: number;
}

/** The setpoints before and after a time, and how far it is between them; undefined where there are none. */
function between(setpoints: Setpoints, seconds: number): { index: number; next: number; fraction: number } | undefined {
  const last = setpoints.row.length - 1;
  if (last < 0) return undefined;
  const exact = Math.min(last, Math.max(0, seconds / setpoints.periodS));
  const index = Math.min(last, Math.floor(exact));
  return { index, next: Math.min(last, index + 1), fraction: exact - index };
}

/** The positions of all axes on the machine at a time, mm and rad; undefined where they are not sent. */
export function machineAxesAt(setpoints: Setpoints, seconds: number): number[] | undefined {
  const [axes, found] = [setpoints.machineAxes, between(setpoints, seconds)];
  if (!axes || !found) return undefined;
  const [from, to] = [found.index, found.next].map((index) => axes.subarray(6 * index, 6 * index + 6));
  return Array.from(from!, (value, axis) => value + (to![axis]! - value) * found.fraction);
}

/** The motion at a time, interpolated linearly between setpoints; undefined where there are none. */
export function momentAt(setpoints: Setpoints, seconds: number): SetpointMoment | undefined {
  const found = between(setpoints, seconds);
  if (!found) return undefined;
  const { index, next, fraction } = found;
  const lerp = (from: number, to: number) => from + (to - from) * fraction;
  const component = (values: Float32Array, axis: number) => lerp(values[3 * index + axis]!, values[3 * next + axis]!);
  const vector = (values: Float32Array): Vec3 => [component(values, 0), component(values, 1), component(values, 2)];
  return {
    position: vector(setpoints.positions),
    programmed: vector(setpoints.programmed ?? setpoints.positions),
    rotaryAngles: setpoints.rotaryAngles ? vector(setpoints.rotaryAngles) : [0, 0, 0],
    speed: lerp(setpoints.speed[index]!, setpoints.speed[next]!),
    row: setpoints.row[index]!,
  };
}

/** When a row begins, s; rows between two setpoints begin at equal intervals. */
export function timeOfRow(setpoints: Setpoints, row: number): number {
  const { row: rows, periodS, totalS } = setpoints;
  let low = 0;
  let high = rows.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rows[middle]! < row) low = middle + 1;
    else high = middle;
  }
  if (low === rows.length) return totalS;
  if (low === 0) return 0;
  const [before, after] = [rows[low - 1]!, rows[low]!];
  const fraction = after > before ? (row - before) / (after - before) : 0;
  return Math.min(totalS, (low - 1 + fraction) * periodS);
}

/** When a row is done, s; a dwell after it is not part of it. */
export function timeAfterRow(setpoints: Setpoints, row: number): number {
  const { row: rows, periodS, totalS } = setpoints;
  // The last setpoint on the row or before it.
  let [low, high] = [0, rows.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rows[middle]! <= row) low = middle + 1;
    else high = middle;
  }
  let last = low - 1;
  if (last < 0 || rows[last] !== row) return timeOfRow(setpoints, row + 1);
  const end = last;
  while (last > 0 && rows[last - 1] === row && isSamePosition(setpoints, last - 1, end)) last--;
  return last < end || end === rows.length - 1 ? Math.min(totalS, last * periodS) : timeOfRow(setpoints, row + 1);
}

function isSamePosition({ positions, rotaryAngles }: Setpoints, one: number, other: number): boolean {
  const isSame = (values: Float32Array) => [0, 1, 2].every((axis) => values[3 * one + axis] === values[3 * other + axis]);
  return isSame(positions) && (!rotaryAngles || isSame(rotaryAngles));
}

/** When a fraction of a row is done, s: of its length, or of its time where it has no length. */
export function timeOnRow(setpoints: Setpoints, row: number, fraction: number): number {
  const from = timeOfRow(setpoints, row);
  if (fraction <= 0) return from;
  const to = timeAfterRow(setpoints, row);
  if (fraction >= 1 || to <= from) return to;
  const { periodS } = setpoints;
  const times = [from];
  for (let index = Math.floor(from / periodS) + 1; index * periodS < to; index++) times.push(index * periodS);
  times.push(to);
  const positions = times.map((seconds) => momentAt(setpoints, seconds)!.programmed);
  const lengths = positions.slice(1).map((position, index) =>
    Math.hypot(...position.map((value, axis) => value - positions[index]![axis]!)));
  const total = lengths.reduce((sum, length) => sum + length, 0);
  if (total === 0) return from + (to - from) * fraction;
  let left = total * fraction;
  for (const [index, length] of lengths.entries()) {
    if (left <= length) return times[index]! + (length > 0 ? left / length : 0) * (times[index + 1]! - times[index]!);
    left -= length;
  }
  return to;
}

/** The first row of the block before or after that of a row; at an end of the path the last row in that direction. */
export function stepRow(path: Path, row: number, direction: 1 | -1): number {
  const current = path.lineOf(row);
  let next = row;
  while (next + direction >= 0 && next + direction < path.rows) {
    next += direction;
    const line = path.lineOf(next);
    if (line?.line !== current?.line || line?.own !== current?.own) break;
  }
  if (direction === 1) return next;
  // Back to the first row of that block.
  const block = path.lineOf(next);
  while (next > 0 && path.lineOf(next - 1)?.line === block?.line && path.lineOf(next - 1)?.own === block?.own) next--;
  return next;
}

/** The lowest and the highest speed, mm/min, in each of `intervals` equal intervals of the time from `from` to `to`, s; NaN where there are no setpoints. */
export function speedBands(setpoints: Setpoints, intervals: number, from = 0, to = setpoints.totalS): [Float32Array, Float32Array] {
  const low = new Float32Array(intervals).fill(Number.NaN);
  const high = new Float32Array(intervals).fill(Number.NaN);
  const count = setpoints.speed.length;
  for (let interval = 0; interval < intervals; interval++) {
    const indexAt = (fraction: number) => (from + (to - from) * fraction) / setpoints.periodS;
    const first = Math.max(0, Math.min(count - 1, Math.floor(indexAt(interval / intervals))));
    const last = Math.max(first, Math.min(count - 1, Math.ceil(indexAt((interval + 1) / intervals))));
    for (let index = first; index <= last; index++) {
      const value = setpoints.speed[index]!;
      if (!(value >= low[interval]!)) low[interval] = value;
      if (!(value <= high[interval]!)) high[interval] = value;
    }
  }
  return [low, high];
}
