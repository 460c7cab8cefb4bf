import { expect, it } from "vitest";
import { markdownPieces, unwrapParagraphs } from "./syntax-hints";

it("reads code and bold", () => {
  expect(markdownPieces("Word `G18` is the **plane** ZX.")).toEqual([
    ["Word ", false, false],
    ["G18", true, false],
    [" is the ", false, false],
    ["plane", false, true],
    [" ZX.", false, false],
  ]);
  expect(markdownPieces("2 * 3 ` 4")).toEqual([["2 * 3 ` 4", false, false]]);
});

it("joins lines that were broken for a terminal, and no others", () => {
  const long = "Nothing in the block uses the word. The control ignores it or alarms; in either case";
  expect(unwrapParagraphs(`${long}\nit does not do what was meant.\n\nExample:\n  G1 X1.\n  X2.`)).toBe(
    `${long} it does not do what was meant.\n\nExample:\n  G1 X1.\n  X2.`,
  );
});
