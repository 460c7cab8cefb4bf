import { expect, test } from "vitest";
import { linesOnRows, rowsAtEndsOf } from "./progress";

/** Rows 0, 2 and 3; the second is an arc of four lines. */
const lines = { rows: Uint32Array.of(0, 2, 2, 2, 2, 3), count: 6 };

test("the lines of an arc share its row", () => {
  expect([...rowsAtEndsOf(10, lines)]).toEqual([10, 11, 12, 12.25, 12.25, 12.5, 12.5, 12.75, 12.75, 13, 13, 14]);
  expect([...rowsAtEndsOf(5, { rows: undefined, count: 2 })]).toEqual([5, 6, 6, 7]);
});

test("lines are found by their rows", () => {
  expect(linesOnRows(lines, 2, 2)).toEqual([1, 5]);
  expect(linesOnRows(lines, 1, 1)).toEqual([1, 1]);
  expect(linesOnRows(lines, -3, 9)).toEqual([0, 6]);
  expect(linesOnRows({ rows: undefined, count: 4 }, 1, 2)).toEqual([1, 3]);
});
