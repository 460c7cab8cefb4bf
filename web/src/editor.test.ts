import { EditorState, Text } from "@codemirror/state";
import { describe, expect, it } from "vitest";
import { changesOf, rangeOf, textOf } from "./editor";

describe("a text", () => {
  it("is the same whether it is taken apart at once or in pieces", async () => {
    const lines = Array.from({ length: 200_000 }, (_, at) => `N${at} X${at % 97}`);
    for (const text of ["", "\n", "one", "a\nb\n", lines.join("\n"), `${lines.join("\n")}\n`]) {
      const made = (await textOf(text, () => true))!;
      expect(made.lines).toBe(text.split("\n").length);
      expect(made.toString() === text).toBe(true);
    }
  });

  it("is left when another one comes", async () => {
    expect(await textOf("G0\n".repeat(1_000_000), () => false)).toBeUndefined();
  });
});

it("tells changes by the places of the text before", () => {
  const state = EditorState.create({ doc: "G0 X1\nG1 Y2\n" });
  const first = state.update({ changes: { from: 3, to: 5, insert: "Z9" } });
  const second = first.state.update({ changes: { from: 0, insert: "N1 " } });
  expect(changesOf(first.changes.compose(second.changes))).toEqual([
    { from: 0, to: 0, insert: "N1 " },
    { from: 3, to: 5, insert: "Z9" },
  ]);
});

it("keeps places within a text that is shorter than it was", () => {
  const doc = Text.of(["G0 X1", "M30"]);
  const place = { file: "part.nc", own: true, line: 1, column: 3, end_line: 1, end_column: 5 };
  expect(rangeOf(doc, place)).toEqual({ from: 3, to: 5 });
  expect(rangeOf(doc, { ...place, line: 9, column: 99, end_line: 9, end_column: 120 })).toEqual({ from: 9, to: 9 });
});
