import { expect, test } from "vitest";
import { type ColumnGrid, Gaps, gapSurfaces } from "./gaps";

/** Changes of one column, each at a row with its gaps. */
function add(gaps: Gaps, column: number, changes: [number, number[]][]): void {
  for (const [row, bands] of changes) {
    gaps.add(Uint32Array.of(column), Uint32Array.of(row), Float32Array.of(0.5), Uint32Array.of(bands.length / 2), Float32Array.from(bands));
  }
}

/** 5 × 4 columns of 1 mm and 10 high. */
const grid = (heightAt: ColumnGrid["heightAt"] = () => 0): ColumnGrid => ({ columns: [5, 4], pitch: 1, size: [5, 4], bottom: -10, overlap: 0, heightAt });

/** The area of triangles that look along an axis: of floors and roofs, of walls. */
function areas(corners: Float32Array): [number, number, number] {
  const sums: [number, number, number] = [0, 0, 0];
  for (let at = 0; at < corners.length; at += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = corners.subarray(at, at + 9);
    const [ux, uy, uz, vx, vy, vz] = [bx! - ax!, by! - ay!, bz! - az!, cx! - ax!, cy! - ay!, cz! - az!];
    sums[0] += Math.abs(uy * vz - uz * vy) / 2;
    sums[1] += Math.abs(uz * vx - ux * vz) / 2;
    sums[2] += Math.abs(ux * vy - uy * vx) / 2;
  }
  return sums;
}

test("any moment is reached, forward and backward", () => {
  const gaps = new Gaps();
  add(gaps, 7, [[1, [-8, -5]], [3, [-8, -4]], [6, []]]);
  const columns: number[] = [];
  const at = (rows: number) => {
    gaps.seek(rows, (column) => columns.push(column));
    return gaps.of(7);
  };
  expect(at(1)).toEqual([]);
  expect(columns).toEqual([]);
  expect(at(1.5)).toEqual([-8, -5]);
  expect(at(4)).toEqual([-8, -4]);
  expect(at(7)).toEqual([]);
  expect(at(2)).toEqual([-8, -5]);
  expect(at(0)).toEqual([]);
  expect(new Set(columns)).toEqual(new Set([7]));
  expect(at(Infinity)).toEqual([]);
});

test("a gap in the middle is a closed box", () => {
  const gaps = new Gaps();
  for (const column of [6, 7, 11, 12]) add(gaps, column, [[0, [-8, -5]]]);
  gaps.seek(1, () => {});
  const made = gapSurfaces(gaps, grid());
  // 2 × 2 wide and 3 high; floors and roofs are one rectangle a row.
  expect(areas(made)).toEqual([12, 12, 8]);
  expect(made.length / 9).toBe(2 * (2 + 2 + 2 + 2 * 2));
});

test("where it is open nothing stands", () => {
  const gaps = new Gaps();
  for (const column of [5, 6, 7]) add(gaps, column, [[0, [-8, -5]]]);
  gaps.seek(1, () => {});
  // Open to the side of the box at X 0, and to a slot at X 3 that is as deep as its floor: no wall across X.
  const slot = (x: number) => (x === 3 ? -8 : 0);
  expect(areas(gapSurfaces(gaps, grid(slot)))).toEqual([0, 18, 7]);
  // A slot that is less deep leaves a wall of 2 below it.
  expect(areas(gapSurfaces(gaps, grid((x) => (x === 3 ? -6 : 0))))).toEqual([2, 18, 6.5]);
  // What the tops have come down to is none; through to the bottom there is no floor.
  expect(gapSurfaces(gaps, grid(() => -8)).length).toBe(0);
  const hollow = new Gaps();
  add(hollow, 6, [[0, [-10, -5]]]);
  hollow.seek(1, () => {});
  expect(areas(gapSurfaces(hollow, grid()))[2]).toBe(1);
});
