import { describe, expect, test } from "vitest";
import type { AxisMotion, RotaryAxis, ToolRotation } from "../protocol/messages";
import { curvePoint } from "./arcs";
import { bodyPose, toolDirection, unknownRotaryHint } from "./rotation";

const none = (letter: string): RotaryAxis => ({ letter, turns: null });
const near = (found: ArrayLike<number>, expected: number[]) =>
  expected.forEach((value, axis) => expect(found[axis], `${Array.from(found)}`).toBeCloseTo(value, 6));

const A: ToolRotation = { axis: 0, about: [1, 0, 0] };
const C: ToolRotation = { axis: 2, about: [0, 0, 1] };
const QUARTER = Math.PI / 2;

test("the tool turns about each axis by the right-hand rule", () => {
  // The tool above the part at A0 is on its side at A90: a positive angle turns it from Z to -Y.
  near(toolDirection([A], [0, 0, 1], [QUARTER, 0, 0]), [0, -1, 0]);
  near(toolDirection([{ ...A, about: [-1, 0, 0] }], [0, 0, 1], [QUARTER, 0, 0]), [0, 1, 0]);
  near(toolDirection([], [0, 0, 1], [QUARTER, 0, 0]), [0, 0, 1]);
});

test("of a trunnion A carries C: a hole of the side face comes up by A, where C has turned it", () => {
  // Upright on the machine; on the part first turned by A, then about the part's own Z.
  near(toolDirection([A, C], [0, 0, 1], [QUARTER, 0, QUARTER]), [1, 0, 0]);
});

test("a fraction of a curve lies between its points", () => {
  near(curvePoint(new Float32Array([0, 0, 0, 2, 0, 0, 2, 4, 0]), 0.75), [2, 2, 0]);
});

test("an axis of which nothing is known is reported where the program moves it", () => {
  const rotary = [none("A"), { ...none("B"), turns: "head" as const }, none("C")];
  const moved = (letter: string) => ({ letter, range: [0, 90] as [number, number] });
  expect(unknownRotaryHint([moved("X"), moved("A"), moved("B")], rotary)).toMatch(/^What A turns is not known/);
  expect(unknownRotaryHint([moved("B"), { letter: "C", range: [0, 0] }], rotary)).toBe("");
});

describe("a body that axes move", () => {
  const at = (motions: AxisMotion[], axes: number[], [x, y, z]: [number, number, number]) => {
    const pose = bodyPose(motions, axes);
    return [0, 1, 2].map((row) => pose[row]! * x + pose[4 + row]! * y + pose[8 + row]! * z + pose[12 + row]!);
  };

  test("stands where no axis moves it", () => near(at([], [], [1, 2, 3]), [1, 2, 3]));

  test("turns about lines in the order of its motions", () => {
    // A spindle over a trunnion: shifted by X, Y and Z, then turned by A about a line 50 below zero, then by C.
    const motions: AxisMotion[] = [
      { axis: 0, along: [1, 0, 0] },
      { axis: 1, along: [0, 1, 0] },
      { axis: 2, along: [0, 0, 1] },
      { axis: 3, about: [1, 0, 0], through: [0, 0, -50] },
      { axis: 5, about: [0, 0, 1], through: [0, 0, 0] },
    ];
    near(at(motions, [50, 20, 150, QUARTER, 0, QUARTER], [0, 0, 0]), [200, 50, -30]);
    near(at(motions, [50, 20, 150, QUARTER, 0, QUARTER], [0, 0, 100]), [300, 50, -30]);
  });

  test("moves against an axis that moves the part", () => {
    near(at([{ axis: 1, along: [0, -1, 0] }, { axis: 5, about: [0, 0, -1], through: [10, 0, 0] }], [0, 4, 0, 0, 0, QUARTER], [10, 0, 0]), [6, 0, 0]);
  });
});
