// Every program of tests/suite and examples gives the same bytes natively and as WebAssembly, in Node and in Chromium.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { before, test } from "node:test";

import * as chordal from "../dist/index.js";
import { removeProfile } from "../../tools/profile.mjs";
import { askAll, digest } from "./ask-all.mjs";
import { QUESTIONS, ROOT, command, difference, each, optionsOf, programs, wordsOf } from "./native.mjs";

const PROGRAMS = programs();
const asked = PROGRAMS.map((program) => ({
  path: program.path,
  folder: program.folder,
  options: optionsOf(program),
  text: program.files[program.path],
  files: program.files,
}));
/** What the command prints: the digest of each answer. */
const native = {};

before(async () => {
  assert.ok(PROGRAMS.length > 300, "the programs are there");
  await each(PROGRAMS, async (program) => {
    for (const [name, format] of QUESTIONS) {
      const { stdout, stderr } = await command(name, "--format", format, ...wordsOf(program));
      assert.notEqual(stdout, "", `${program.path}: ${stderr}`);
      native[`${program.path} ${name}`] = await digest(stdout);
    }
  });
});

function assertSame(answers) {
  const others = Object.keys(native).filter((key) => native[key] !== answers[key]);
  assert.deepEqual(others, []);
  assert.equal(Object.keys(answers).length, PROGRAMS.length * QUESTIONS.length);
}

test("in Node", async () => {
  assertSame(await askAll(chordal, asked, QUESTIONS));
});

test("in Chromium, in a worker of the page", async () => {
  assertSame(await inChromium());
});

test("the other questions, about the examples", async () => {
  const example = (path) => PROGRAMS.find((program) => program.path === path);
  const same = async (words, answer) => {
    const { stdout } = await command(...words);
    assert.notEqual(stdout, "", words.join(" "));
    assert.equal(difference(stdout, await answer), undefined, words.join(" "));
  };
  const options = (program) => ({ ...optionsOf(program), files: program.files });
  const text = (program) => program.files[program.path];
  const housing = example("examples/textbook/switch-housing.nc");
  const plate = example("examples/haas/drilled-plate.nc");
  const bolt = example("examples/fadal/bolt-circle.nc") ?? PROGRAMS.find((program) => program.path.startsWith("examples/fadal/"));
  for (const program of [housing, plate, bolt]) {
    const all = options(program);
    const words = wordsOf(program);
    await same(["run", ...words, "--format", "json"], chordal.run(text(program), { ...all, format: "json" }));
    await same(["commands", ...words, "--format", "csv"], chordal.commands(text(program), { ...all, format: "csv" }));
    await same(["commands", ...words, "--format", "canon"], chordal.commands(text(program), { ...all, format: "canon" }));
    await same(["path", ...words, "--format", "csv"], chordal.path(text(program), { ...all, format: "csv" }));
    await same(["sample", ...words, "--period", "10ms"], chordal.sample(text(program), { ...all, period: 0.01, format: "csv" }));
    await same(
      ["time", ...words, "--level", "best", "--format", "json"],
      chordal.time(text(program), { ...all, level: "best", format: "json" }),
    );
    await same(
      ["convert", ...words, "--to", "fanuc-30i", "--format", "json"],
      chordal.convert(text(program), { ...all, to: "fanuc-30i", format: "json" }),
    );
  }
  await same(
    ["compare", housing.path, plate.path, "--format", "json"],
    chordal.compare(text(housing), text(plate), { a: options(housing), b: options(plate), format: "json" }),
  );
  await same(["explain", "CH401"], chordal.explain("CH401"));
  await same(["explain", "M17", "--machine", "fadal-4020"], chordal.explain("M17", { machine: "fadal-4020" }));
  const { toml } = await chordal.machine("haas-vf2");
  await same(["machines", "haas-vf2", "--toml"], toml);
});

const TYPES = { ".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm", ".html": "text/html" };

const PAGE = `<!doctype html><meta charset="utf-8"><script type="module">
const send = (path, value) => fetch(path, { method: "POST", body: JSON.stringify(value) });
try {
  const { start } = await import("/dist/worker.js");
  const { askAll } = await import("/test/ask-all.mjs");
  const { programs, folders, questions } = await (await fetch("/programs.json")).json();
  const bytes = (text) => Uint8Array.from(atob(text), (char) => char.charCodeAt(0));
  for (const files of Object.values(folders)) {
    for (const path of Object.keys(files)) files[path] = bytes(files[path]);
  }
  const asked = programs.map((program) => {
    const files = folders[program.folder];
    return { ...program, files, text: files[program.path] };
  });
  const worker = await start();
  await send("/answers", await askAll(worker, asked, questions));
  worker.close();
} catch (error) {
  await send("/answers", { failed: String(error.stack ?? error) });
}
</script>`;

/** The answers of a page that asks everything. */
async function inChromium() {
  const folders = {};
  for (const { folder, files } of asked) {
    folders[folder] ??= Object.fromEntries(Object.entries(files).map(([path, text]) => [path, text.toString("base64")]));
  }
  const list = asked.map(({ path, folder, options }) => ({ path, folder, options }));
  let take;
  const answers = new Promise((resolve) => (take = resolve));
  const elsewhere = [];
  const server = createServer((request, response) => {
    if (request.method === "POST") {
      const chunks = [];
      request.on("data", (chunk) => chunks.push(chunk));
      request.on("end", () => {
        response.end();
        take(JSON.parse(Buffer.concat(chunks).toString()));
      });
      return;
    }
    const path = new URL(request.url, "http://localhost").pathname;
    const send = (body) => response.writeHead(200, { "content-type": TYPES[extname(path)] ?? "application/json" }).end(body);
    if (path === "/index.html") send(PAGE);
    else if (path === "/programs.json") send(JSON.stringify({ programs: list, folders, questions: QUESTIONS }));
    else if (/^\/(dist|test)\/[\w.-]+$/.test(path)) send(readFileSync(join(ROOT, "npm", path)));
    else {
      elsewhere.push(path);
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const profile = mkdtempSync(join(tmpdir(), "chordal-npm-"));
  const chromium = spawn(
    process.env.CHROMIUM ?? "/usr/bin/chromium",
    [
      "--headless=new", "--no-sandbox", "--no-first-run", "--disable-gpu", "--disable-quic", "--disable-sync",
      "--disable-background-networking", "--disable-component-update", `--user-data-dir=${profile}`,
      `http://127.0.0.1:${server.address().port}/index.html`,
    ],
    { stdio: "ignore" },
  );
  const ended = new Promise((resolve) => chromium.on("exit", resolve));
  const died = ended.then((code) => assert.fail(`Chromium ended with ${code}`));
  try {
    const found = await Promise.race([answers, died]);
    assert.equal(found.failed, undefined);
    assert.deepEqual(elsewhere.filter((path) => path !== "/favicon.ico"), []);
    return found;
  } finally {
    died.catch(() => {});
    chromium.kill();
    await ended;
    server.close();
    server.closeAllConnections();
    removeProfile(profile);
  }
}
