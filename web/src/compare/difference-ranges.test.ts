import { expect, it } from "vitest";
import { type Vec3, ARC, KNOWN_BIT } from "../path/batch";
import { Path } from "../path/path";
import type { Difference, DifferenceSide } from "../protocol/messages";
import { boxAround, boxOf, boxUnion, differingLines, linesText, rowsOf, rowsOfLines, step } from "./difference-ranges";

function path(origin: Vec3, lines: number[], points: number[], files = lines.map(() => 0)): Path {
  const made = new Path();
  const rows = lines.length;
  made.add({
    first: 0,
    rows,
    points: new Float32Array(points),
    kind: new Uint8Array(rows).fill(1 | KNOWN_BIT),
    tool: new Uint32Array(rows),
    line: new Uint32Array(lines),
    file: new Uint8Array(files),
    feed: new Float32Array(rows),
    arcRows: new Uint32Array(),
    arcs: new Float32Array(),
  }, origin);
  return made;
}

function side(from: number, to: number, file = 0, lacks = false): DifferenceSide {
  return { blocks: { file, from, to }, steps: lacks ? 0 : 1, value: null, words: "", lacks };
}

function of(a: DifferenceSide, b: DifferenceSide): Difference {
  return { category: "path", head: "path", distance_mm: 1, at_mm: null, sides: [a, b] };
}

it("marks the lines of what differs, each once, and none where something is missing", () => {
  const differences = [
    of(side(8, 10), side(1, 2)),
    of(side(9, 11), side(1, 2)),
    of(side(20, 20, 0, true), side(5, 5)),
    of(side(3, 3, 1), side(7, 7)),
  ];
  expect(differingLines(differences, 0)).toEqual([8, 9, 10, 11]);
  expect(differingLines(differences, 1)).toEqual([1, 2, 5, 7]);
});

it("finds the rows of blocks in every turn of a loop, of their own file alone", () => {
  const points = Array.from({ length: 36 }, (_, at) => at);
  const looped = path([0, 0, 0], [1, 2, 3, 2, 3, 2], points, [0, 0, 0, 0, 0, 1]);
  expect(rowsOf(looped, { file: 0, from: 2, to: 2 })).toEqual([[1, 1], [3, 3]]);
  expect(rowsOf(looped, { file: 0, from: 2, to: 3 })).toEqual([[1, 4]]);
  expect(rowsOf(looped, { file: 1, from: 1, to: 9 })).toEqual([[5, 5]]);
  expect(rowsOf(looped, { file: 0, from: 7, to: 9 })).toEqual([]);
  expect(rowsOfLines(looped, [1, 3])).toEqual([[0, 0], [2, 2], [4, 4]]);
  expect(rowsOfLines(looped, [])).toEqual([]);
});

it("boxes rows in the frame of the run, the bulge of an arc included", () => {
  // A half circle about the origin from (1, 0) over (0, 1) to (-1, 0), its origin at X10.
  const arc = path([10, 0, 0], [1], [1, 0, 0, -1, 0, 0]);
  const batch = arc.batches[0]!;
  batch.kind[0] = ARC | KNOWN_BIT;
  batch.arcRows = new Uint32Array([0]);
  batch.arcs = new Float32Array([0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1, Math.PI, 0]);
  const box = boxOf(arc, [[0, 0]])!;
  expect(box.low).toEqual([9, 0, 0]);
  expect(box.high[0]).toBe(11);
  expect(box.high[1]).toBeCloseTo(1, 6);
  expect(boxOf(arc, [])).toBeUndefined();
  batch.kind[0] = ARC;
  expect(boxOf(arc, [[0, 0]])).toBeUndefined();
});

it("shows two places so that they are seen apart, however near they are", () => {
  expect(boxAround([[0, 0, 0], [1, 0, 0]])).toEqual({ low: [-2, -2.5, -2.5], high: [3, 2.5, 2.5] });
  const near = boxAround([[5, 5, 5], [5, 5, 5]]);
  expect(near.high[0]! - near.low[0]!).toBeCloseTo(0.04, 12);
});

it("joins boxes, and makes none too small to see", () => {
  const one = { low: [0, 0, 0] as Vec3, high: [1, 0, 0] as Vec3 };
  const other = { low: [2, 1, 0] as Vec3, high: [3, 1, 0] as Vec3 };
  expect(boxUnion([one, undefined, other], 2)).toEqual({ low: [0, -0.5, -1], high: [3, 1.5, 1] });
  expect(boxUnion([undefined], 1)).toBeUndefined();
});

it("goes through the differences round and round", () => {
  expect(step(-1, 1, 3)).toBe(0);
  expect(step(-1, -1, 3)).toBe(2);
  expect(step(2, 1, 3)).toBe(0);
  expect(step(0, -1, 3)).toBe(2);
  expect(step(-1, 1, 0)).toBe(-1);
});

it("names the lines of a side", () => {
  expect(linesText({ file: 0, from: 7, to: 7 })).toBe("line 7");
  expect(linesText({ file: 0, from: 7, to: 9 })).toBe("lines 7–9");
  expect(linesText({ file: 2, from: 7, to: 7 })).toBe("line 7 of another file");
  expect(linesText(null)).toBe("nowhere");
});
