import { expect, test } from "vitest";
import { codePieces, plainText } from "./code-spans";

test("what stands between backticks is code", () => {
  expect(codePieces("`G41` needs `D`: none")).toEqual([["G41", true], [" needs ", false], ["D", true], [": none", false]]);
  expect(plainText("set `tools.2.length`")).toBe("set tools.2.length");
});

test("a backtick without a partner stands for itself", () => {
  expect(codePieces("a ` b")).toEqual([["a ` b", false]]);
  expect(codePieces("")).toEqual([]);
});
