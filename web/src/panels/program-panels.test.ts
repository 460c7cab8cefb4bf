import { expect, it } from "vitest";
import { leftOutText, notVerified } from "./program-panels";

it("says from which line on the path is not known", () => {
  expect(notVerified({ not_verified_from: null })).toBe("");
  const from = { file: "part.nc", line: 12, own: true, path_known: false };
  expect(notVerified({ not_verified_from: from })).toBe(
    "Not verified from line 12 on: the path after it is not known.",
  );
  expect(notVerified({ not_verified_from: { ...from, path_known: true } })).toContain("the time after it is not known");
  expect(notVerified({ not_verified_from: { ...from, own: false } })).toContain("from line 12 of part.nc on");
});

it("says which moves are left out for their work offset, and what to do", () => {
  expect(leftOutText({ moves_left_out: [] })).toBe("");
  expect(leftOutText({ moves_left_out: ["moves in G55 are left out", "give both"] })).toBe("Moves in G55 are left out. Give both.");
});
