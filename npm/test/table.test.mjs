// Columns: the values of the rows that the command prints, as typed arrays.

import assert from "node:assert/strict";
import { test } from "node:test";

import { commands, curves, path, sample } from "../dist/index.js";

const PART = "%\nO1 (PART)\nT1 M6\nG21 G90 G54 S900 M3\nG0 X0. Y0. Z5.\nG1 Z0. F100.\nX10.\nG2 X20. Y10. I0. J10.\nM30\n%\n";
const OPTIONS = { machine: "haas-vf2", name: "part.nc" };

test("commands have a row each", async () => {
  const table = await commands(PART, OPTIONS);
  const lines = (await commands(PART, { ...OPTIONS, format: "jsonl" })).trim().split("\n").slice(1).map((line) => JSON.parse(line));
  assert.equal(table.rows, lines.length);
  assert.equal(table.machine, "haas-vf2");
  assert.equal(table.report.file, "part.nc");
  assert.ok(table.column("line").values instanceof Uint32Array);
  assert.ok(table.column("kind").values instanceof Int8Array);
  lines.forEach((line, row) => {
    assert.equal(table.column("line").at(row), line.line);
    assert.equal(table.column("kind").at(row), line.kind);
  });
});

test("a column has as many values as there are rows, or a word for each", async () => {
  for (const table of [await commands(PART, OPTIONS), await path(PART, OPTIONS), await curves(PART, OPTIONS), await curves("", OPTIONS)]) {
    for (const column of Object.values(table.columns)) {
      const length = column.kind === "text" ? column.words.length : column.values.length;
      assert.equal(length, table.rows, column.name);
      if (column.valid !== null) assert.equal(column.valid.length, table.rows, column.name);
    }
  }
});

test("curves are exact", async () => {
  const table = await curves(PART, OPTIONS);
  const arc = Array.from({ length: table.rows }, (_, row) => table.row(row)).find((row) => row.kind === "arc");
  assert.deepEqual([arc.x_center_mm, arc.y_center_mm, arc.radius_from_mm, arc.sweep_deg], [10, 10, 10, -270]);
  assert.equal(table.column("radius_from_mm").unit, "mm");
  assert.throws(() => table.column("colour"), /there is no column colour; there are line, /);
});

test("setpoints are columns of doubles", async () => {
  const table = await sample(PART, { ...OPTIONS, period: 0.01 });
  const time = table.column("time_s").values;
  assert.ok(time instanceof Float64Array);
  assert.equal(time[0], 0);
  // The last one is the first at which the run is over.
  assert.ok(time.at(-2) < table.time_s && time.at(-1) >= table.time_s);
  assert.ok(table.chord_mm > 0 && table.chord_line > 0);
});
