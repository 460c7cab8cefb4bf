import { describe, expect, it } from "vitest";
import { arcIndex, arcChordCount, arcPoint } from "./arcs";
import { type Batch, KNOWN_BIT } from "./batch";
import { Path } from "./path";

const quarter = new Float32Array([
  // Centre (0, 0), start towards X, axis Z, radius 10, a quarter turn that rises by 2.
  0, 0, 0, 1, 0, 0, 0, 0, 1, 10, 10, Math.PI / 2, 2,
]);

function batch(first: number, lines: number[], points: number[], extra: Partial<Batch> = {}): Batch {
  const rows = lines.length;
  return {
    first,
    rows,
    points: new Float32Array(points),
    kind: new Uint8Array(rows).fill(1 | KNOWN_BIT),
    tool: new Uint32Array(rows).fill(1),
    line: new Uint32Array(lines),
    file: new Uint8Array(rows),
    feed: new Float32Array(rows).fill(100),
    arcRows: new Uint32Array(),
    arcs: new Float32Array(),
    ...extra,
  };
}

describe("the scale of depths", () => {
  it("leaves out the feed down where cuts across are at several heights", () => {
    const path = new Path();
    path.add(batch(0, [1, 2, 3], [0, 0, 50, 0, 0, -1, 0, 0, -1, 10, 0, -1, 10, 0, -1, 20, 0, -3]), [0, 0, 0]);
    expect(path.depths).toEqual([-3, -1]);
  });

  it("is that of all cuts in a drilling program", () => {
    const path = new Path();
    path.add(batch(0, [1, 2], [0, 0, 2, 0, 0, -9, 5, 0, 2, 5, 0, -7]), [0, 0, 0]);
    expect(path.depths).toEqual([-9, 2]);
  });
});

it("the axes that are known are those of the end where the tool is", () => {
  const path = new Path();
  // From nowhere to X and Z, then along X.
  const known = Uint8Array.of(0b101_000, 0b101_101);
  path.add(batch(0, [1, 2], new Array(12).fill(0), { known, kind: Uint8Array.of(1, 1 | KNOWN_BIT) }), [0, 0, 0]);
  expect([0, 0.5, 1].map((fraction) => path.knownOn(0, fraction))).toEqual([0, 0, 0b101]);
  expect([0, 0.5, 1].map((fraction) => path.knownOn(1, fraction))).toEqual([0b101, 0b101, 0b101]);
  expect(path.knownOn(2, 0)).toBe(0);
  expect([0, 1].map((fraction) => path.isDrawable(1, fraction))).toEqual([false, false]);
  // Y is never named.
  path.notNamed = 0b010;
  expect([0, 0.5, 1].map((fraction) => path.isDrawable(1, fraction))).toEqual([true, true, true]);
  expect([0, 0.5, 1].map((fraction) => path.isDrawable(0, fraction))).toEqual([false, false, true]);
});

describe("arcs", () => {
  it("have places on the exact curve", () => {
    const middle = arcPoint(quarter, 0, 0.5);
    expect(middle[0]).toBeCloseTo(10 * Math.SQRT1_2, 5);
    expect(middle[1]).toBeCloseTo(10 * Math.SQRT1_2, 5);
    expect(middle[2]).toBeCloseTo(1, 6);
    expect(arcPoint(quarter, 0, 1)[1]).toBeCloseTo(10, 5);
  });

  it("take as many pieces as the tolerance asks, and no piece is further off", () => {
    for (const tolerance of [1, 0.1, 0.01, 0.001]) {
      const pieces = arcChordCount(quarter, 0, tolerance);
      const sagitta = 10 * (1 - Math.cos(Math.PI / 2 / pieces / 2));
      expect(sagitta).toBeLessThanOrEqual(tolerance);
    }
    expect(arcChordCount(quarter, 0, 0.001)).toBeGreaterThan(arcChordCount(quarter, 0, 0.1));
    expect(arcChordCount(quarter, 0, 0)).toBeLessThanOrEqual(4096);
    expect(arcChordCount(new Float32Array(13), 0, 0.1)).toBe(1);
  });
});

describe("a path", () => {
  it("has a box that holds spirals of many turns", () => {
    // Four turns and a quarter from radius 10 to 27: the widest places are in the last turn.
    const turns = 4.25;
    const arcs = new Float32Array([0, 0, 0, 1, 0, 0, 0, 0, 1, 10, 27, 2 * Math.PI * turns, 0]);
    const path = new Path();
    path.add(batch(0, [1], [10, 0, 0, 0, 27, 0], { arcRows: new Uint32Array([0]), arcs }), [0, 0, 0]);
    const { low, high } = path.bounds!;
    const radius = (turn: number) => 10 + (17 * turn) / turns;
    expect(high[0]).toBeCloseTo(radius(4), 1);
    expect(low[0]).toBeCloseTo(-radius(3.5), 1);
    expect(high[1]).toBeCloseTo(27, 4);
    expect(low[1]).toBeCloseTo(-radius(3.75), 1);
  });

  it("knows the rows of a line and the line of a row, across batches", () => {
    const path = new Path();
    path.add(batch(0, [1, 3], [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 5, 0]), [0, 0, 0]);
    path.add(batch(2, [3, 4], [1, 5, 0, 1, 6, 0, 1, 6, 0, 0, 0, -2]), [0, 0, 0]);
    expect(path.rowsOfLine(3)).toEqual([1, 2]);
    expect(path.rowsOfLine(2)).toBeUndefined();
    expect(path.doneAfterLine(2)).toBe(1);
    expect(path.doneAfterLine(99)).toBe(4);
    expect(path.doneAfterLine(0)).toBe(0);
    expect(path.lineOf(2)).toEqual({ line: 3, own: true });
    expect(path.lineOf(4)).toBeUndefined();
    expect(path.bounds).toEqual({ low: [0, 0, -2], high: [1, 6, 0] });
    expect(path.pointOn(3, 0.5)).toEqual([0.5, 3, -1]);
  });

  it("grows with the lines", () => {
    const path = new Path();
    path.add(batch(0, [5_000], [0, 0, 0, 1, 1, 1]), [0, 0, 0]);
    expect(path.rowsOfLine(5_000)).toEqual([0, 0]);
    expect(path.rowsOfLine(100_000)).toBeUndefined();
  });

  it("leaves unknown places out of its box", () => {
    const path = new Path();
    const far = batch(0, [1], [0, 0, 0, 900, 0, 0], { kind: new Uint8Array([0]) });
    path.add(far, [0, 0, 0]);
    expect(path.bounds).toBeUndefined();
  });

  it("finds the arc of a row", () => {
    const arcs = batch(0, [1, 2, 3], new Array(18).fill(0), {
      arcRows: new Uint32Array([0, 2]),
      arcs: new Float32Array([...quarter, ...quarter]),
    });
    expect([0, 1, 2].map((row) => arcIndex(arcs, row))).toEqual([0, -1, 1]);
    const path = new Path();
    path.add(arcs, [0, 0, 0]);
    expect(path.pointOn(2, 0.5)![2]).toBeCloseTo(1, 6);
    // The bulge of the arc belongs to the box.
    expect(path.bounds!.high[0]).toBeGreaterThan(9);
  });
});
