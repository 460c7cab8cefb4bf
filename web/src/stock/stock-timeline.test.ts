import { expect, test } from "vitest";
import { StockTimeline } from "./stock-timeline";

/** Numbers from 0 to 1, the same each time. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

const COLUMNS = 300;

/** A run of so many drops of random columns, in order, in batches; and the heights after each moment, by a plain loop. */
function made(count: number, between: number) {
  const next = random(7);
  const drops = new StockTimeline(new Float32Array(COLUMNS).fill(0), between);
  const events: { column: number; row: number; fraction: number; height: number }[] = [];
  const now = new Float32Array(COLUMNS);
  for (let n = 0; n < count; n++) {
    const column = Math.floor(next() * COLUMNS);
    now[column] = Math.fround(now[column]! - 0.01 - next());
    events.push({ column, row: Math.floor(n / 5), fraction: Math.fround((n % 5) / 5), height: now[column]! });
  }
  for (let from = 0; from < count; from += 97) {
    const some = events.slice(from, from + 97);
    drops.add(
      Uint32Array.from(some, ({ column }) => column),
      Uint32Array.from(some, ({ row }) => row),
      Float32Array.from(some, ({ fraction }) => fraction),
      Float32Array.from(some, ({ height }) => height),
      (row) => 1 + (Math.floor(row / 40) % 3),
    );
  }
  const at = (rows: number) => {
    const heights = new Float32Array(COLUMNS);
    const slots = new Uint8Array(COLUMNS);
    for (const { column, row, fraction, height } of events) {
      if (row + fraction > rows) break;
      heights[column] = height;
      slots[column] = 1 + (Math.floor(row / 40) % 3);
    }
    return { heights, slots };
  };
  return { drops, at, rows: count / 5 };
}

test("any moment has the heights and owners of a run up to it, whatever was shown before", () => {
  const { drops, at, rows } = made(4000, 500);
  const next = random(3);
  const followed = new Float32Array(COLUMNS);
  for (let round = 0; round < 400; round++) {
    // Near and far, to places within a row, before the beginning and after the end.
    const to = round % 3 === 0 ? rows * (1.2 * next() - 0.1) : Math.min(rows, round * 0.7 + next());
    if (drops.leap(to)) followed.set(drops.heights);
    else drops.seek(to, (column) => (followed[column] = drops.heights[column]!));
    const { heights, slots } = at(to);
    expect(drops.heights).toEqual(heights);
    expect(drops.slots).toEqual(slots);
    // Following the changes alone gives the same.
    expect(followed).toEqual(heights);
  }
});

test("a step costs what changes on it, and a jump no more than a keyframe and half the drops between two", () => {
  const between = 500;
  const { drops, rows } = made(20_000, between);
  const none = () => {};
  drops.seek(10, none);
  expect(drops.seek(11, none)).toBe(5);
  expect(drops.seek(10, none)).toBe(5);
  const next = random(11);
  for (let round = 0; round < 200; round++) {
    expect(drops.seek(rows * next(), none)).toBeLessThanOrEqual(COLUMNS + COLUMNS / 4 + between);
  }
  expect(drops.seek(Infinity, none)).toBeGreaterThan(0);
  expect(drops.at).toBe(drops.count);
});

test("what comes while the end is shown is seen, and a column that is not there is left out", () => {
  const drops = new StockTimeline(new Float32Array(4));
  const add = (column: number, row: number, height: number) =>
    drops.add(Uint32Array.of(column), Uint32Array.of(row), Float32Array.of(0.5), Float32Array.of(height), () => 2);
  add(1, 0, -1);
  drops.seek(Infinity, () => {});
  add(3, 1, -2);
  add(4, 1, -9);
  drops.seek(Infinity, () => {});
  expect([...drops.heights]).toEqual([0, -1, 0, -2]);
  expect([...drops.slots]).toEqual([0, 2, 0, 2]);
  drops.seek(0.4, () => {});
  expect([...drops.heights]).toEqual([0, 0, 0, 0]);
  expect(drops.count).toBe(2);
});
