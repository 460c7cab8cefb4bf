import { expect, it } from "vitest";
import type { Frame } from "../protocol/frame";
import { type Loops, type Pen, type SectionPoint, HalfSections, corners, edges, hull, silhouette, trace } from "./half-sections";

/** A bar of radius 10 from z 0 to 20, of which row 3 takes all above radius 8, and row 5 the upper corner. */
const LINES = [
  [0, 0, 20, 0, 0, 0, 0],
  [20, 0, 20, 10, 0, 0, 0],
  [20, 10, 0, 10, 0, 0, 0],
  [0, 10, 0, 0, 0, 0, 0],
  [20, 0, 20, 8, 0, 0, 0],
  [20, 8, 0, 8, 0, 0, 0],
  [0, 8, 0, 0, 0, 0, 0],
  [20, 0, 20, 6, 0, 0, 0],
  [20, 6, 18, 8, 18, 6, 1],
  [18, 8, 0, 8, 0, 0, 0],
];
const FROM = [0, 0, 0, 0, 1, 1, 1, 2, 2, 2];
const UNTIL = [9, 1, 1, 1, 2, 2, 9, 9, 9, 9];

function sections(): HalfSections {
  const frame: Frame = {
    header: { type: "turned", whole: true, before: [], target: null, fixtures: [], threads: [], tools: [{ number: 1, edges: [], body: [] }] },
    columns: {
      lines: Float32Array.from(LINES.flat()),
      from: Uint32Array.from(FROM),
      until: Uint32Array.from(UNTIL),
      tool: Uint32Array.from(FROM),
      loose: new Uint8Array(LINES.length),
      rows: Uint32Array.from([3, 5]),
    },
  };
  return new HalfSections(frame);
}

/** A pen that keeps its corners; an arc is its end. */
function pen(): Pen & { spots: SectionPoint[][] } {
  const spots: SectionPoint[][] = [];
  return {
    spots,
    moveTo: (z, r) => spots.push([[z, r]]),
    lineTo: (z, r) => spots.at(-1)!.push([z, r]),
    arc: () => {},
    closePath: () => {},
  };
}

const area = (spots: SectionPoint[]) => spots.reduce((sum, [z, r], at) => {
  const [zn, rn] = spots[(at + 1) % spots.length]!;
  return sum + (z * rn - zn * r) / 2;
}, 0);

const drawn = (loops: Loops) => {
  const own = pen();
  trace(own, loops);
  return own.spots;
};

it("has the section of every moment, forward and backward", () => {
  const own = sections();
  expect([0, 3, 3.5, 4, 5, 6, Infinity].map((done) => own.numberAt(done))).toEqual([0, 0, 0, 1, 1, 2, 2]);
  const areas = [0, 1, 2, 1, 0].map((number) => {
    const spots = drawn(own.loops(own.piecesOf(number)));
    expect(spots.length).toBe(1);
    return area(spots[0]!);
  });
  // With the chord of the arc the corner is a triangle.
  expect(areas).toEqual([200, 160, 158, 160, 200]);
  expect(own.piecesOf(2).map((piece) => own.toolOf(piece))).toEqual([0, 1, 2, 2, 2]);
});

it("knows what is being cut", () => {
  const own = sections();
  expect(own.rowInProgress(3.5)).toBe(3);
  expect(own.rowInProgress(3)).toBeUndefined();
  // A rapid takes nothing.
  expect(own.rowInProgress(4.5)).toBeUndefined();
  expect(own.rowInProgress(5.1)).toBe(5);
});

it("sees the part from outside down to the axis, with its edges", () => {
  const own = sections();
  const numbers = own.piecesOf(2).map((piece) => own.numbers(piece));
  const outside = pen();
  silhouette(outside, numbers);
  expect(outside.spots.every((spots) => area(spots) <= 0)).toBe(true);
  expect(edges(numbers).map(([z]) => z).sort((a, b) => a - b)).toEqual([0, 18, 18, 20]);
});

it("sweeps a tool along its move", () => {
  const square = [0, 0, 2, 0, 0, 0, 0, 2, 0, 2, 2, 0, 0, 0, 2, 2, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0];
  expect(Math.abs(area(hull([...corners(square, [0, 0]), ...corners(square, [10, 0])])))).toBe(24);
  const circle = [1, 0, -1, 0, 0, 0, 1, -1, 0, 1, 0, 0, 0, 1];
  expect(Math.abs(area(hull(corners(circle, [5, 5]))) - Math.PI)).toBeLessThan(0.02);
});
