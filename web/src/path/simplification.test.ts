import { describe, expect, it } from "vitest";
import type { LineArrays } from "./lines";
import { type PathStrands, someStrands, strands } from "./simplification";

/** Lines from point to point; a gap where a point is missing. */
function chain(places: ([number, number, number] | undefined)[]): LineArrays {
  const points: number[] = [];
  for (let at = 1; at < places.length; at++) {
    const [from, to] = [places[at - 1], places[at]];
    if (from && to) points.push(...from, ...to);
  }
  return { points: new Float32Array(points), rows: undefined, count: points.length / 6 };
}

/** Passes along X over a wave, to and fro, each a step further along Y. */
function raster(passes: number, steps: number): LineArrays {
  const places: [number, number, number][] = [];
  for (let pass = 0; pass < passes; pass++) {
    for (let step = 0; step <= steps; step++) {
      const x = 0.1 * (pass % 2 === 0 ? step : steps - step);
      places.push([x, 0.1 * pass, Math.sin(x)]);
    }
  }
  return chain(places);
}

/** How far a point is from the nearest line. */
function distance(lines: LineArrays, [x, y, z]: number[]): number {
  let best = Infinity;
  for (let line = 0; line < lines.count; line++) {
    const p = lines.points.subarray(6 * line, 6 * line + 6);
    const u = [p[3]! - p[0]!, p[4]! - p[1]!, p[5]! - p[2]!];
    const v = [x! - p[0]!, y! - p[1]!, z! - p[2]!];
    const square = u.reduce((sum, value) => sum + value * value, 0);
    const along = square > 0 ? Math.min(1, Math.max(0, u.reduce((sum, value, axis) => sum + value * v[axis]!, 0) / square)) : 0;
    best = Math.min(best, Math.hypot(...v.map((value, axis) => value - along * u[axis]!)));
  }
  return best;
}

const lengthOf = ({ starts, lines }: PathStrands, strand: number) => (starts[strand + 1] ?? lines.count) - starts[strand]!;

describe("fewer lines for the same path", () => {
  it("are as near to it as the tolerance says, and much fewer", () => {
    const source = raster(6, 200);
    const { lines } = strands(source, 0.02);
    expect(lines.count).toBeLessThan(source.count / 5);
    for (let line = 0; line < source.count; line++) {
      expect(distance(lines, [...source.points.subarray(6 * line, 6 * line + 3)])).toBeLessThan(0.0201);
    }
    // Each tells the first of the rows that it stands for.
    expect(lines.rows![0]).toBe(0);
    expect([...lines.rows!].every((row, at) => at === 0 || row > lines.rows![at - 1]!)).toBe(true);
  });

  it("keep corners, and none goes across a gap", () => {
    const source = chain([[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 1, 0], undefined, [5, 1, 0], [6, 1, 0]]);
    const { lines } = strands(source, 10);
    const ends = Array.from({ length: lines.count }, (_, at) => [...lines.points.subarray(6 * at, 6 * at + 6)]);
    expect(ends).toEqual([[0, 0, 0, 2, 0, 0], [2, 0, 0, 2, 1, 0], [5, 1, 0, 6, 1, 0]]);
  });

  it("fall into strands of a pass each, with its step over", () => {
    const made = strands(raster(6, 200), 0.02);
    expect(made.starts.length).toBe(6);
    const passes = new Set(Array.from(made.starts, (_, strand) => lengthOf(made, strand)));
    expect(Math.max(...passes) - Math.min(...passes)).toBeLessThan(4);
  });

  it("are left out by whole strands, evenly", () => {
    const made = strands(raster(400, 40), 0.02);
    const some = someStrands(made, 0.25, 0);
    const strandNumbers = [...new Set(Array.from({ length: some.count }, (_, at) => Math.round(some.points[6 * at + 4]! / 0.1)))];
    expect(strandNumbers.length).toBeGreaterThan(90);
    expect(strandNumbers.length).toBeLessThan(110);
    expect(Math.max(...strandNumbers.slice(1).map((pass, at) => pass - strandNumbers[at]!))).toBeLessThan(8);
    expect(someStrands(made, 1, 0)).toBe(made.lines);
  });
});
