import { expect, test } from "vitest";
import type { Problem } from "../protocol/messages";
import { problemGroups } from "./problems";

const problem = (severity: Problem["severity"], code: string, line: number): Problem => ({
  code,
  name: code,
  severity,
  message: "",
  place: { file: "part.nc", own: true, line, column: 1, end_line: line, end_column: 2 },
  label: "",
  secondary: [],
  alarm: null,
  notes: [],
  help: null,
  explanation: "",
  fix: null,
  other_fixes: [],
});

test("problems of one code stand together, errors first", () => {
  const found = problemGroups([
    problem("note", "CH603", 2),
    problem("warning", "CH414", 5),
    problem("warning", "CH602", 6),
    problem("warning", "CH414", 7),
    problem("error", "CH401", 9),
    problem("warning", "CH414", 11),
  ]);
  const summary = found.map(({ severity, code, problems }) => [severity, code, problems.map(({ place }) => place!.line)]);
  expect(summary).toEqual([
    ["error", "CH401", [9]],
    ["warning", "CH414", [5, 7, 11]],
    ["warning", "CH602", [6]],
    ["note", "CH603", [2]],
  ]);
});
