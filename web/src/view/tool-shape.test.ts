import { expect, test } from "vitest";
import { outline } from "./tool-shape";

test("a flat end mill has its diameter from the tip on", () => {
  expect(outline({ shape: "flat", diameter_mm: 10, length_mm: 40 }, 100)).toEqual([[0, 0], [5, 0], [5, 40], [0, 40]]);
});

test("a ball end mill ends in half a ball, whatever the table says of its corner", () => {
  const points = outline({ shape: "ball", diameter_mm: 10, corner_radius_mm: null }, 30);
  for (const [r, z] of points.slice(1, 10)) expect(Math.hypot(r, z - 5)).toBeCloseTo(5, 9);
  expect(points.at(-1)).toEqual([0, 30]);
});

test("a drill has the angle of its point, and 118° where none is known", () => {
  const height = (angle: number | null) => outline({ shape: "drill", diameter_mm: 10, point_angle_rad: angle }, 50)[1]![1];
  expect(height(Math.PI / 2)).toBeCloseTo(5, 9);
  expect(height(null)).toBeCloseTo(5 / Math.tan((59 * Math.PI) / 180), 9);
});

test("shank and holder stand on the edges", () => {
  const points = outline({ shape: "flat", diameter_mm: 10, length_mm: 90, flute_length_mm: 20, shank_mm: [[30, 8, 8]], holder_mm: [[40, 30, 50]] }, 100);
  expect(points.slice(2)).toEqual([[5, 20], [4, 20], [4, 50], [15, 50], [25, 90], [0, 90]]);
});
