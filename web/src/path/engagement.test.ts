import { expect, test } from "vitest";
import { EngagementCurve, measureText } from "./engagement";

const points = { positions: new Float32Array(), speed: new Float32Array(5), row: new Uint32Array([0, 0, 2, 5, 5]), periodS: 1, totalS: 4 };

function engaged(problems = [0, 2, 3]): EngagementCurve {
  const by = { radial: new Float32Array([2, 5, 3]), chip: new Float32Array([-1, -1, -1]), power: new Float32Array([0.1, -1, 0.4]) };
  return new EngagementCurve(new Uint32Array([0, 1, 4]), by, new Uint8Array(problems));
}

test("each part of the time has the maxima of its moves, short ones without a setpoint among them", () => {
  expect([...engaged().bands("radial", points, 4).maxima]).toEqual([2, 5, 3, 0]);
  expect([...engaged().bands("radial", points, 1).maxima]).toEqual([5]);
});

test("moves that are too much are marked, and above those that rub", () => {
  expect(engaged().bands(undefined, points, 4).faults).toEqual(["none", "rubs", "overload", "none"]);
  expect(engaged().bands("chip", points, 1).faults).toEqual(["overload"]);
});

test("what is known of no move cannot be chosen", () => {
  expect(engaged().known).toEqual(["radial", "power"]);
  expect(measureText({ inch: false }, "power", 0.4)).toBe("0.4 kW");
  expect(measureText({ inch: true }, "radial", 2.54)).toBe("0.1 in");
});
