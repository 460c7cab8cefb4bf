// The types say what the answers are: real answers, written as literals, are of their types, with nothing left over.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

import * as chordal from "../dist/index.js";
import { optionsOf, programs } from "./native.mjs";

const NPM = fileURLToPath(new URL("..", import.meta.url));

/** Programs with something of each kind: problems with fixes and calls, operations, what if, short lines. */
function chosen() {
  const all = programs().filter((program) => program.files[program.path].length < 20_000);
  return all.filter((program, index) => program.path.startsWith("examples/") || index % 24 === 0);
}

test("answers are of their types", async () => {
  const lines = [`import type * as chordal from ${JSON.stringify(join(NPM, "dist/index.js"))};`];
  const put = (type, value) => lines.push(`export const a${lines.length}: chordal.${type} = ${JSON.stringify(value)};`);
  let last;
  for (const [index, program] of chosen().entries()) {
    const options = { ...optionsOf(program), files: program.files };
    const text = program.files[program.path];
    put("Check", await chordal.check(text, options));
    put("Run", await chordal.run(text, options));
    put("Time", await chordal.time(text, { ...options, operations: "comment" }));
    // Programs that have nothing to do with each other take the longest to compare.
    if (index % 8 === 0) put("Comparison", await chordal.compare(text, last?.text ?? "", { a: options, b: last?.options ?? {} }));
    put("Conversion", await chordal.convert(text, { ...options, to: "fanuc-30i" }));
    last = { text, options };
  }
  put("MachineName[]", await chordal.machines());
  put("Machine", await chordal.machine("haas-vf2"));
  put("Time", await chordal.time("G21 G90 S900 M3\nG1 X10. F100.\nM30\n", { machine: "haas-vf2", bound: true, whatIf: true }));
  const { failed, output } = await compiled(lines.join("\n"));
  assert.equal(failed, false, output.slice(0, 4000));
});

test("overloads follow the format, and options are checked", async () => {
  const { failed, output } = await compiled(`
    import { check, commands, compare, convert, sample, time, type Check, type Table, type Setpoints } from ${JSON.stringify(join(NPM, "dist/index.js"))};
    import { start } from ${JSON.stringify(join(NPM, "dist/worker.js"))};
    export const found: Check = await check("", { machine: "haas-vf2" });
    export const text: string = await check(new Uint8Array(), { format: "sarif" });
    export const table: Table = await commands("", { set: [] });
    export const rows: string = await commands("", { format: "canon" });
    export const setpoints: Setpoints = await sample("", { period: 0.001 });
    export const far: number | null = (await compare("", "", { tolerance: 0.01, ignore: ["feed"] })).max_distance_mm;
    export const worker = await start();
    export const seconds: number = (await worker.time("", { level: "best" })).total_s;
    // @ts-expect-error
    await check("", { machin: "haas-vf2" });
    // @ts-expect-error
    await check("", { format: "csv" });
    // @ts-expect-error
    await convert("", {});
    // @ts-expect-error
    await time("", { level: "good" });
  `);
  assert.equal(failed, false, output);
});

/** Whether a text is TypeScript without a mistake. */
function compiled(text) {
  const folder = mkdtempSync(join(tmpdir(), "chordal-npm-types-"));
  const file = join(folder, "answers.mts");
  writeFileSync(file, text);
  const options = ["--noEmit", "--strict", "--target", "es2022", "--module", "nodenext", "--lib", "es2023,dom", "--types", "", file];
  return new Promise((resolve) => {
    execFile(join(NPM, "node_modules/.bin/tsc"), options, { cwd: folder, maxBuffer: 1 << 26 }, (error, stdout, stderr) => {
      rmSync(folder, { recursive: true });
      resolve({ failed: error !== null, output: stdout + stderr });
    });
  });
}
