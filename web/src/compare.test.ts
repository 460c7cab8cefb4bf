import { expect, it } from "vitest";
import { differences, pointsOf } from "./compare";
import { KNOWN, Path } from "./path";

function path(origin: [number, number, number], lines: number[], points: number[]): Path {
  const made = new Path();
  const rows = lines.length;
  made.add({
    first: 0,
    rows,
    points: new Float32Array(points),
    kind: new Uint8Array(rows).fill(1 | KNOWN),
    tool: new Uint32Array(rows),
    line: new Uint32Array(lines),
    file: new Uint8Array(rows),
    feed: new Float32Array(rows),
    arcRows: new Uint32Array(),
    arcs: new Float32Array(),
  }, origin);
  return made;
}

it("finds the lines that move otherwise, whatever the origins", async () => {
  const one = path([0, 0, 0], [1, 2, 3], [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 0, 0, 0]);
  const same = path([1, 0, 0], [1, 2, 3], [-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0]);
  expect((await differences(one, same, () => true))!.lines).toEqual([]);
  const other = path([0, 0, 0], [1, 2, 4], [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 2, 0, 1, 2, 0, 0, 0, 0]);
  expect(await differences(one, other, () => true)).toEqual({ lines: [2, 3, 4], rows: [[1, 1], [2, 2]] });
});

it("draws the rows that differ, across parts of the path", async () => {
  const one = path([0, 0, 0], [1, 2], [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0]);
  one.add({ ...path([0, 0, 0], [3], [1, 1, 0, 5, 5, 5]).batches[0]!, first: 2 }, [0, 0, 0]);
  expect([...(await pointsOf(one, [[1, 2]], 0.1))]).toEqual([1, 0, 0, 1, 1, 0, 1, 1, 0, 5, 5, 5]);
  expect((await pointsOf(one, [], 0.1)).length).toBe(0);
});

it("gives up a comparison that is no longer wanted", async () => {
  const long = path([0, 0, 0], [30_000], [0, 0, 0, 1, 0, 0]);
  expect(await differences(long, long, () => false)).toBeUndefined();
});
