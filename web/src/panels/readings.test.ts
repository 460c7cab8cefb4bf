import { expect, test } from "vitest";
import type { ProgramReadings } from "../protocol/messages";
import { AnsweredReadings, columnRows, introduction } from "./readings";

const INCH = { name: "fadal-4020 in inch", title: "Fadal VMC 4020 in inch" };
const MM = { name: "fadal-4020 in mm", title: "Fadal VMC 4020 in mm" };

const READINGS: ProgramReadings = {
  message: "what this program moves depends on its control, and nothing in the text names it for certain",
  line: 1,
  block: "G0 X0 Y0 Z5",
  shown: [
    { title: "Fadal CNC 88 in inch", size: "508 x 254 x 152.4 mm", motion: "Z 127 mm", machine: INCH },
    { title: "Fadal CNC 88 in mm", size: null, motion: "Z 5 mm", machine: MM },
  ],
  more: 0,
};

test("a program is asked about once, however it is edited", () => {
  const answered = new AnsweredReadings();
  answered.opened();
  expect(answered.next("part.nc", null)).toEqual({ do: "nothing" });
  expect(answered.next("part.nc", READINGS)).toEqual({ do: "ask", readings: READINGS });
  // Without an answer, an edit asks again with the readings of then.
  const edited = { ...READINGS, line: 2 };
  expect(answered.next("part.nc", edited)).toEqual({ do: "ask", readings: edited });
  answered.answer(undefined);
  expect(answered.next("part.nc", edited)).toEqual({ do: "nothing" });
  expect(answered.next("part.nc", READINGS)).toEqual({ do: "nothing" });
});

test("a program that is opened again is read as it was answered", () => {
  const answered = new AnsweredReadings();
  answered.next("part.nc", READINGS);
  answered.answer(MM);
  answered.opened();
  expect(answered.next("part.nc", READINGS)).toEqual({ do: "read", machine: MM });
  // Only once: after that the recognized machine can be chosen.
  expect(answered.next("part.nc", READINGS)).toEqual({ do: "nothing" });
  answered.opened();
  expect(answered.next("other.nc", READINGS).do).toBe("ask");
  answered.answer(undefined);
  answered.opened();
  expect(answered.next("other.nc", READINGS)).toEqual({ do: "nothing" });
});

test("a machine that is chosen before any question answers none", () => {
  const answered = new AnsweredReadings();
  answered.answer(INCH);
  answered.opened();
  expect(answered.next("part.nc", READINGS).do).toBe("ask");
});

test("the words name the block, and a size that is not known", () => {
  expect(introduction(READINGS)).toBe(
    "What this program moves depends on its control, and nothing in the text names it for certain. The first block that differs is line 1, `G0 X0 Y0 Z5`.",
  );
  expect(introduction({ ...READINGS, line: null, more: 2 })).toMatch(/for certain\. 2 more readings not shown\.$/);
  expect(columnRows(READINGS.shown[0]!, 1)).toEqual([["Cuts", "508 x 254 x 152.4 mm"], ["Line 1", "Z 127 mm"]]);
  expect(columnRows(READINGS.shown[1]!, null)).toEqual([["Cuts", "size not known"], ["Moves", "Z 5 mm"]]);
});
