// The motion in time: setpoints at an even period, as the planner makes them.

import type { Vec3 } from "./batch";
import type { Path } from "./path";

export interface Setpoints {
  /** Relative to `origin`, mm: three numbers each. */
  places: Float32Array;
  /** The same as the program says it, where the part turns. */
  programmed?: Float32Array | undefined;
  /** A, B and C, rad, three numbers each, where one of them is not zero. */
  turns?: Float32Array | undefined;
  /** mm/min. */
  speed: Float32Array;
  /** The row of the path that each is on; rows never fall. */
  row: Uint32Array;
  periodS: number;
  totalS: number;
}

export interface SetpointMoment {
  at: Vec3;
  /** The same as the program says it. */
  programmed: Vec3;
  /** A, B and C, rad. */
  turn: Vec3;
  speed: number;
  row: number;
}

/** What happens at a time; between setpoints evenly. */
export function momentAt(points: Setpoints, seconds: number): SetpointMoment | undefined {
  const last = points.row.length - 1;
  if (last < 0) return undefined;
  const exact = Math.min(last, Math.max(0, seconds / points.periodS));
  const index = Math.min(last, Math.floor(exact));
  const next = Math.min(last, index + 1);
  const share = exact - index;
  const mix = (from: number, to: number) => from + (to - from) * share;
  const turns = points.turns;
  const angle = (axis: number) => (turns ? mix(turns[3 * index + axis]!, turns[3 * next + axis]!) : 0);
  const between = (places: Float32Array, axis: number) => mix(places[3 * index + axis]!, places[3 * next + axis]!);
  const place = (places: Float32Array): Vec3 => [between(places, 0), between(places, 1), between(places, 2)];
  return {
    at: place(points.places),
    programmed: place(points.programmed ?? points.places),
    turn: [angle(0), angle(1), angle(2)],
    speed: mix(points.speed[index]!, points.speed[next]!),
    row: points.row[index]!,
  };
}

/** When a row begins: evenly between the setpoints around it. */
export function timeOfRow(points: Setpoints, row: number): number {
  const { row: rows, periodS, totalS } = points;
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
  const share = after > before ? (row - before) / (after - before) : 0;
  return Math.min(totalS, (low - 1 + share) * periodS);
}

/** When a row is done: the waits after it are not part of it. */
export function timeAfterRow(points: Setpoints, row: number): number {
  const { row: rows, periodS, totalS } = points;
  // The last setpoint on the row or before it.
  let [low, high] = [0, rows.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rows[middle]! <= row) low = middle + 1;
    else high = middle;
  }
  let last = low - 1;
  if (last < 0 || rows[last] !== row) return timeOfRow(points, row + 1);
  const end = last;
  while (last > 0 && rows[last - 1] === row && isSamePlace(points, last - 1, end)) last--;
  return last < end || end === rows.length - 1 ? Math.min(totalS, last * periodS) : timeOfRow(points, row + 1);
}

function isSamePlace({ places, turns }: Setpoints, one: number, other: number): boolean {
  const isSame = (values: Float32Array) => [0, 1, 2].every((axis) => values[3 * one + axis] === values[3 * other + axis]);
  return isSame(places) && (!turns || isSame(turns));
}

/** When a share of a row is done: of its length, or of its time where it has none. */
export function timeOnRow(points: Setpoints, row: number, share: number): number {
  const from = timeOfRow(points, row);
  if (share <= 0) return from;
  const to = timeAfterRow(points, row);
  if (share >= 1 || to <= from) return to;
  const { periodS } = points;
  const times = [from];
  for (let index = Math.floor(from / periodS) + 1; index * periodS < to; index++) times.push(index * periodS);
  times.push(to);
  const places = times.map((seconds) => momentAt(points, seconds)!.programmed);
  const lengths = places.slice(1).map((place, at) =>
    Math.hypot(...place.map((value, axis) => value - places[at]![axis]!)));
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  if (whole === 0) return from + (to - from) * share;
  let left = whole * share;
  for (const [at, length] of lengths.entries()) {
    if (left <= length) return times[at]! + (length > 0 ? left / length : 0) * (times[at + 1]! - times[at]!);
    left -= length;
  }
  return to;
}

/** The rows of the block before or after a row's own: where its line changes. */
export function stepRow(path: Path, row: number, direction: 1 | -1): number {
  const own = path.lineOf(row);
  let at = row;
  while (at + direction >= 0 && at + direction < path.rows) {
    at += direction;
    const line = path.lineOf(at);
    if (line?.line !== own?.line || line?.own !== own?.own) break;
  }
  if (direction === 1) return at;
  // Back to where that block begins.
  const target = path.lineOf(at);
  while (at > 0 && path.lineOf(at - 1)?.line === target?.line && path.lineOf(at - 1)?.own === target?.own) at--;
  return at;
}

/** The largest and smallest speed in each of so many equal parts of the time. */
export function speedBands(points: Setpoints, parts: number, from = 0, to = points.totalS): [Float32Array, Float32Array] {
  const low = new Float32Array(parts).fill(Number.NaN);
  const high = new Float32Array(parts).fill(Number.NaN);
  const count = points.speed.length;
  for (let part = 0; part < parts; part++) {
    const edge = (share: number) => (from + (to - from) * share) / points.periodS;
    const first = Math.max(0, Math.min(count - 1, Math.floor(edge(part / parts))));
    const last = Math.max(first, Math.min(count - 1, Math.ceil(edge((part + 1) / parts))));
    for (let at = first; at <= last; at++) {
      const value = points.speed[at]!;
      if (!(value >= low[part]!)) low[part] = value;
      if (!(value <= high[part]!)) high[part] = value;
    }
  }
  return [low, high];
}
