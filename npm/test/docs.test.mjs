// The programs of docs/npm.md print what the page shows. DOCUMENTS_PAGE=write writes it again.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { ROOT } from "./native.mjs";

test("docs/npm.md shows what its programs print", () => {
  const path = join(ROOT, "docs/npm.md");
  const page = readFileSync(path, "utf8");
  const folder = mkdtempSync(join(tmpdir(), "chordal-npm-docs-"));
  let count = 0;
  const shown = page.replace(/```js\n([^]*?)```\n\n```text\n[^]*?```/g, (_, program) => {
    count += 1;
    const dist = (file) => JSON.stringify(new URL(`../dist/${file}`, import.meta.url).href);
    const whole = program.replace('"@chordal/core/worker"', dist("worker.js")).replace('"@chordal/core"', dist("index.js"));
    const file = join(folder, `${count}.mjs`);
    writeFileSync(file, whole);
    const printed = execFileSync(process.execPath, [file], { encoding: "utf8", cwd: folder });
    return `\`\`\`js\n${program}\`\`\`\n\n\`\`\`text\n${printed}\`\`\``;
  });
  rmSync(folder, { recursive: true });
  assert.ok(count >= 6, "the programs are there");
  assert.equal(page.match(/```js/g).length, count, "every program shows what it prints");
  if (process.env.DOCUMENTS_PAGE === "write") writeFileSync(path, shown);
  else assert.equal(shown, page);
});
