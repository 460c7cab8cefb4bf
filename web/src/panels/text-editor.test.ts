import { EditorState, Text } from "@codemirror/state";
import { expect, it } from "vitest";
import { appendPiece, changesOf, rangeOf } from "./text-editor";

it("puts a text together from pieces, cut anywhere", () => {
  const lines = Array.from({ length: 5_000 }, (_, at) => `N${at} X${at % 97}`);
  for (const text of ["", "\n", "one", "a\nb\n", lines.join("\n"), `${lines.join("\n")}\n`]) {
    for (const size of [1, 7, 4096]) {
      if (text.length / size > 10_000) continue;
      let made = Text.empty;
      for (let at = 0; at < text.length; at += size) made = appendPiece(made, text.slice(at, at + size));
      expect(made.lines).toBe(text.split("\n").length);
      expect(made.toString() === text).toBe(true);
    }
  }
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
