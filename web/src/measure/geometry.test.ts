import { expect, test } from "vitest";
import { type Batch, type Vec3, KNOWN_BIT } from "../path/batch";
import { Path } from "../path/path";
import { type PathFeature, distanceText, featureAt, featureText as words, measuredDistance } from "./geometry";

/** A line along X, one along it 10 mm further in Y, and a quarter of a circle of 5 mm about X 30 Y 0. */
function path(): Path {
  const batch: Batch = {
    first: 0,
    rows: 3,
    points: Float32Array.of(0, 0, 0, 20, 0, 0, 20, 10, 0, 0, 10, 0, 35, 0, 0, 30, 5, 0),
    kind: Uint8Array.of(1 | KNOWN_BIT, 1 | KNOWN_BIT, 2 | KNOWN_BIT),
    tool: Uint32Array.of(1, 1, 1),
    line: Uint32Array.of(1, 2, 3),
    file: Uint8Array.of(0, 0, 0),
    feed: Float32Array.of(100, 100, 100),
    arcRows: Uint32Array.of(2),
    arcs: Float32Array.of(30, 0, 0, 1, 0, 0, 0, 0, 1, 5, 5, Math.PI / 2, 0),
  };
  const made = new Path();
  made.add(batch, [100, 0, 0]);
  return made;
}

const hit = (row: number, at: Vec3, snapped = false): PathFeature => featureAt(path(), { row, fraction: 0.5, at, snapped });
const LOWER = hit(0, [4, 0, 0]);
const UPPER = hit(1, [15, 10, 0]);
const ARC = hit(2, [33.5, 3.5, 0]);
const MM = { inch: false };

test("a click on an arc finds its radius, its diameter and its centre in the program's coordinates", () => {
  expect(words(ARC, [100, 0, 0], MM)).toBe("Arc R 5 mm, Ø 10 mm, 90°, centre X 130  Y 0  Z 0 mm");
  expect(words(ARC, [100, 0, 0], { inch: true })).toBe("Arc R 0.1969 in, Ø 0.3937 in, 90°, centre X 5.1181  Y 0  Z 0 in");
});

test("a click near an end finds the end, whatever ends there", () => {
  expect(hit(2, [30, 5, 0], true)).toEqual({ kind: "point", at: [30, 5, 0], of: "end" });
});

test("parallel lines have the distance between them, not between the clicks", () => {
  const found = measuredDistance(LOWER, UPPER);
  expect(found.mm).toBeCloseTo(10, 6);
  expect(distanceText(found, MM)).toBe("10 mm parallel lines   (X 0  Y 10  Z 0 mm)");
});

test("lines that are not parallel have an angle", () => {
  const up: PathFeature = { kind: "line", at: [4, 3, 0], from: [0, 0, 0], to: [8, 8, 0] };
  const found = measuredDistance(LOWER, up);
  expect(found.angle).toBeCloseTo(Math.PI / 4, 6);
  expect(found.mm).toBeCloseTo(3, 6);
  expect(distanceText(found, MM)).toMatch(/not parallel: 45°/);
});

test("from a point to a line the distance is square to the line, beyond its ends, too", () => {
  const point = hit(1, [50, 7, 0], true);
  for (const found of [measuredDistance(point, LOWER), measuredDistance(LOWER, point)]) expect(found.mm).toBeCloseTo(7, 6);
  expect(measuredDistance(point, LOWER).between).toBe("point to line");
});

test("arcs are measured from their centres", () => {
  const other: PathFeature = { kind: "arc", at: [0, 0, 0], center: [30, 40, 0], axis: [0, 0, 1], radius: 3, sweep: 1 };
  expect(measuredDistance(ARC, other)).toMatchObject({ mm: 40, between: "centre to centre" });
  expect(measuredDistance(ARC, UPPER)).toMatchObject({ mm: 10, between: "centre to line" });
});
