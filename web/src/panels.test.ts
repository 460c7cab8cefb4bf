import { expect, it } from "vitest";
import { notVerified } from "./panels";

it("says from which line on the path is not known", () => {
  expect(notVerified({ not_verified_from: null })).toBe("");
  const from = { file: "part.nc", line: 12, own: true };
  expect(notVerified({ not_verified_from: from })).toBe(
    "Not verified from line 12 on: the path after it is not known.",
  );
  expect(notVerified({ not_verified_from: { ...from, own: false } })).toContain("from line 12 of part.nc on");
});
