import { expect, it } from "vitest";
import { coordinate, countText, duration, length, positionText, programmed, speed } from "./units";

const inch = { inch: true };
const metric = { inch: false };

it("speaks the program's units", () => {
  expect(length(inch, 25.4)).toBe("1 in");
  expect(length(inch, 76.01712)).toBe("2.9928 in");
  expect(length(metric, 12.3456)).toBe("12.346 mm");
  expect(length(metric, -0.0001)).toBe("0 mm");
  expect(coordinate(metric, -0.0001)).toBe("0.000");
  expect(coordinate(inch, -25.4)).toBe("-1.0000");
  expect(speed(inch, 254)).toBe("10 in/min");
  expect(speed(metric, 254)).toBe("254 mm/min");
});

it("says a diameter where one is programmed", () => {
  expect(programmed({ inch: false, factors: [2, 1, 1] }, [15, 0, -40])).toEqual([30, 0, -40]);
  expect(programmed(metric, [15, 0, -40])).toEqual([15, 0, -40]);
});

it("tells times as a clock does", () => {
  expect(duration(9.444)).toBe("9.44 s");
  expect(duration(59.94)).toBe("59.9 s");
  expect(duration(187.52)).toBe("3:07.5");
  expect(duration(119.97)).toBe("2:00.0");
  expect(duration(3723)).toBe("1:02:03");
});

it("counts", () => {
  expect(countText(1, "error")).toBe("1 error");
  expect(countText(1200, "error")).toBe("1,200 errors");
});

it("says a dash for a coordinate that is not known", () => {
  expect(positionText(metric, [10, undefined, -5])).toBe("X 10.000  Y –  Z -5.000 mm");
  expect(positionText({ inch: false, has: [true, false, true] }, [10, 0, undefined])).toBe("X 10.000  Z – mm");
  expect(positionText({ inch: true, factors: [2, 1, 1] }, [25.4, 0, undefined])).toBe("X 2.0000  Y 0.0000  Z – in");
});
