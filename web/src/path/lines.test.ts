import { describe, expect, it } from "vitest";
import { type Batch, KNOWN_BIT } from "./batch";
import { linesOf, nearestSegment, segmentsOfRows } from "./lines";

const CUT = 1 | KNOWN_BIT;
const RAPID = 0 | KNOWN_BIT;
const ARC = 2 | KNOWN_BIT;

function batch(kinds: number[], points: number[], arcs: [number, number[]][] = []): Batch {
  const rows = kinds.length;
  return {
    first: 0,
    rows,
    points: new Float32Array(points),
    kind: new Uint8Array(kinds),
    tool: new Uint32Array(rows),
    line: new Uint32Array(rows),
    file: new Uint8Array(rows),
    feed: new Float32Array(rows),
    arcRows: new Uint32Array(arcs.map(([row]) => row)),
    arcs: new Float32Array(arcs.flatMap(([, record]) => record)),
  };
}

const half = [0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1, Math.PI, 0];

describe("what is drawn", () => {
  it("is the server's own array where everything is straight", () => {
    const straight = batch([CUT, CUT], [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0]);
    const { cuts, rapids } = linesOf(straight, () => 0.01);
    expect(cuts.points).toBe(straight.points);
    expect([cuts.count, rapids.count]).toEqual([2, 0]);
  });

  it("parts cuts from rapids, cuts arcs and leaves unknown places out", () => {
    const mixed = batch(
      [RAPID, ARC, 1, CUT],
      [0, 0, 5, 1, 0, 0, 1, 0, 0, -1, 0, 0, 9, 9, 9, 9, 9, 9, -1, 0, 0, -1, 5, 0],
      [[1, half]],
    );
    const { cuts, rapids } = linesOf(mixed, () => 0.01);
    expect(rapids.count).toBe(1);
    expect([...rapids.rows!]).toEqual([0]);
    expect(cuts.count).toBeGreaterThan(10);
    expect(cuts.rows![0]).toBe(1);
    expect(cuts.rows![cuts.count - 1]).toBe(3);
    expect([...cuts.points].includes(9)).toBe(false);
    // Every point of the arc is on it, and it ends where the program says.
    for (let at = 0; at < cuts.count - 1; at++) {
      const [x, y] = [cuts.points[6 * at]!, cuts.points[6 * at + 1]!];
      expect(Math.hypot(x, y)).toBeCloseTo(1, 5);
      expect(y).toBeGreaterThanOrEqual(0);
    }
    expect([...cuts.points.slice(6 * (cuts.count - 2) + 3, 6 * (cuts.count - 1))]).toEqual([-1, 0, 0]);
    expect(segmentsOfRows(mixed, 1, 2, () => 0.01).length / 6).toBe(cuts.count - 1);
  });
});

describe("the nearest line", () => {
  // A view from above: 100 pixels for two units.
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const two = linesOf(batch([CUT, CUT], [-1, 0, 0, 1, 0, 0, 0.5, 0.5, 7, 0.5, 1, -7]), () => 1).cuts;

  it("is told with how far away it is and where on it", () => {
    expect(nearestSegment(two, identity, 100, 100, 25, 52, 5)).toEqual({ index: 0, distance: 2, fraction: 0.25 });
    expect(nearestSegment(two, identity, 100, 100, 76, 10, 5)!.index).toBe(1);
  });

  it("is none beyond the reach", () => {
    expect(nearestSegment(two, identity, 100, 100, 20, 90, 5)).toBeUndefined();
  });
});
