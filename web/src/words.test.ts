import { expect, it } from "vitest";
import { pieces } from "./words";

it("reads code and bold", () => {
  expect(pieces("Word `G18` is the **plane** ZX.")).toEqual([
    ["Word ", false, false],
    ["G18", true, false],
    [" is the ", false, false],
    ["plane", false, true],
    [" ZX.", false, false],
  ]);
  expect(pieces("2 * 3 ` 4")).toEqual([["2 * 3 ` 4", false, false]]);
});
