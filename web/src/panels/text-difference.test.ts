import { expect, test } from "vitest";
import { textDifference, withUnixEndings } from "./text-difference";

test("the one piece that differs is replaced", () => {
  for (const [from, to] of [["G1 X1.", "G1 X12."], ["", "G0"], ["G0", ""], ["aaa", "aa"], ["aa", "aaa"], ["abab", "ab"], ["G1 X1.\nM30", "G0 X1.\nM2"]]) {
    const { from: at, to: end, insert } = textDifference(from!, to!)!;
    expect(from!.slice(0, at) + insert + from!.slice(end)).toBe(to);
  }
  expect(textDifference("G1 X1. Y2.", "G1 X9. Y2.")).toEqual({ from: 4, to: 5, insert: "9" });
  expect(textDifference("G1", "G1")).toBe(undefined);
  expect(textDifference("G0\nG1\n\nM30", withUnixEndings("G0\r\nG1\r\rM30"))).toBe(undefined);
});
