import { expect, test } from "vitest";
import type { RotaryAxis } from "../protocol/messages";
import type { Batch, Vec3 } from "./batch";
import { Kinematics, curvePoint, rotated, unknownTurns } from "./kinematics";

const none = (letter: string): RotaryAxis => ({ letter, turns: null, reversed: false, center_mm: [0, 0, 0] });
const near = (found: ArrayLike<number>, expected: number[]) =>
  expected.forEach((value, axis) => expect(found[axis], `${Array.from(found)}`).toBeCloseTo(value, 4));

test("a right-hand screw", () => {
  near(rotated([0, 1, 0], 0, Math.PI / 2), [0, 0, 1]);
  near(rotated([0, 0, 1], 1, Math.PI / 2), [1, 0, 0]);
  near(rotated([1, 0, 0], 2, Math.PI / 2), [0, 1, 0]);
});

test("a table turns the path about its axis, a head only the tool", () => {
  const quarter = [Math.PI / 2, 0, 0];
  const table = new Kinematics([{ ...none("A"), turns: "table" }, none("B"), none("C")], [0, 0, 0]);
  // The tool above the part at A0 is on its side at A90: a positive angle turns it from Z to -Y.
  near(table.place([5, 0, 10], quarter), [5, -10, 0]);
  near(table.direction([0, 0, 1], quarter), [0, -1, 0]);
  const head = new Kinematics([{ ...none("A"), turns: "head" }, none("B"), none("C")], [0, 0, 0]);
  near(head.place([5, 0, 10], quarter), [5, 0, 10]);
  near(head.direction([0, 0, 1], quarter), [0, -1, 0]);
  const reversed = new Kinematics([{ ...none("A"), turns: "table", reversed: true }, none("B"), none("C")], [0, 0, 0]);
  near(reversed.place([5, 0, 10], quarter), [5, 10, 0]);
});

test("the centre counts in the program's coordinates, places from the origin", () => {
  const axis: RotaryAxis = { letter: "A", turns: "table", reversed: false, center_mm: [0, 0, -20] };
  const table = new Kinematics([axis, none("B"), none("C")], [100, 0, 10]);
  // At the program's Z10, 30 above the axis.
  near(table.place([0, 0, 0], [Math.PI / 2, 0, 0]), [0, -30, -30]);
});

test("of a trunnion A carries C: a hole of the side face comes up by A, where C has turned it", () => {
  const rotary: RotaryAxis[] = [{ ...none("A"), turns: "table" }, none("B"), { ...none("C"), turns: "table" }];
  const trunnion = new Kinematics(rotary, [0, 0, 0]);
  const both = [Math.PI / 2, 0, Math.PI / 2];
  // Upright on the machine; on the part first lain down by A, then turned about the part's own Z.
  near(trunnion.direction([0, 0, 1], both), [1, 0, 0]);
});

const batch = (points: number[], turns: number[]): Batch => ({
  first: 0,
  rows: points.length / 6,
  points: new Float32Array(points),
  turns: new Float32Array(turns),
  kind: new Uint8Array(points.length / 6).fill(0x11),
  tool: new Uint32Array(points.length / 6),
  line: new Uint32Array(points.length / 6),
  file: new Uint8Array(points.length / 6),
  feed: new Float32Array(points.length / 6),
  arcRows: new Uint32Array(0),
  arcs: new Float32Array(0),
});

test("a move that turns is a helix on the part, its ends exact", () => {
  const table = new Kinematics([{ ...none("A"), turns: "table" }, none("B"), none("C")], [0, 0, 0]);
  const made = table.batch(batch([0, 0, 10, 8, 0, 10], [0, 0, 0, Math.PI, 0, 0]));
  const curve = made.curves!.get(0)!;
  // No chord leaves the circle by more than 0.02 % of its radius.
  expect(curve.length / 3).toBeGreaterThan(90);
  for (let at = 0; at < curve.length; at += 3) expect(Math.hypot(curve[at + 1]!, curve[at + 2]!)).toBeCloseTo(10, 4);
  const middle = curvePoint(curve, 0.5);
  expect(middle[0]).toBeCloseTo(4, 4);
  expect(middle[1]).toBeCloseTo(-10, 2);
  near(made.points, [0, 0, 10, 8, 0, -10]);
  const still = batch([0, 0, 10, 8, 0, 10], [0, 0, 0, 0, 0, 0]);
  expect(new Kinematics([none("A"), none("B"), none("C")], [0, 0, 0] as Vec3).batch(still)).toBe(still);
});

test("an axis of which nothing is known is told where the program moves it", () => {
  const rotary = [none("A"), { ...none("B"), turns: "head" as const }, none("C")];
  const moved = (letter: string) => ({ letter, range: [0, 90] as [number, number] });
  expect(unknownTurns([moved("X"), moved("A"), moved("B")], rotary)).toMatch(/^What A turns is not known/);
  expect(unknownTurns([moved("B"), { letter: "C", range: [0, 0] }], rotary)).toBe("");
});
