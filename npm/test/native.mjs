// The programs of tests/suite and examples, what is asked about each, and what the command answers.

import { execFile } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
export const CHORDAL = process.env.CHORDAL ?? join(ROOT, "target/debug/chordal");

/** Every program, with the files of its folder and what its head says: `(machine: haas-vf2)`, `(set: KEY=VALUE)`. */
export function programs() {
  const found = [];
  for (const folder of ["tests/suite", "examples"]) collect(folder, found);
  return found;
}

function collect(folder, found) {
  const entries = readdirSync(join(ROOT, folder), { withFileTypes: true });
  entries.sort((a, b) => (a.name < b.name ? -1 : 1));
  const files = {};
  for (const entry of entries) {
    const path = `${folder}/${entry.name}`;
    if (entry.isFile()) files[path] = readFileSync(join(ROOT, path));
  }
  for (const entry of entries) {
    const path = `${folder}/${entry.name}`;
    if (entry.isDirectory()) collect(path, found);
    else if (/\.(nc|ngc)$/.test(path)) found.push({ path, folder, files, ...head(files[path].toString("latin1")) });
  }
}

function head(text) {
  const said = (key) => [...text.matchAll(new RegExp(`^\\(${key}: (.*)\\)\\s*$`, "gm"))].map((match) => match[1]);
  return { machine: said("machine")[0], set: said("set"), blockDelete: said("block-delete")[0] === "on" };
}

/** The questions about every program: what the command is given, and the function with its format. */
export const QUESTIONS = [
  ["check", "json"],
  ["commands", "jsonl"],
  ["path", "jsonl"],
  ["time", "json"],
];

/** What the command answers, and how it ended. */
export function command(...words) {
  return new Promise((answer) => {
    execFile(CHORDAL, words, { cwd: ROOT, maxBuffer: 1 << 30, encoding: "utf8" }, (error, stdout, stderr) => {
      answer({ code: error?.code ?? 0, stdout, stderr });
    });
  });
}

/** The arguments of the command for a program. */
export function wordsOf(program) {
  return [
    program.path,
    ...(program.machine === undefined ? [] : ["--machine", program.machine]),
    ...program.set.flatMap((assignment) => ["--set", assignment]),
    ...(program.blockDelete ? ["--block-delete"] : []),
  ];
}

/** Its options for the package. */
export function optionsOf(program) {
  const { path: name, machine, set, blockDelete } = program;
  return { name, ...(machine === undefined ? {} : { machine }), set, blockDelete };
}

/** Does something with each, two at a time. */
export async function each(items, work) {
  const left = items.values();
  const worker = async () => {
    for (const item of left) await work(item);
  };
  await Promise.all([worker(), worker()]);
}

/** The first line in which two texts differ. */
export function difference(one, other) {
  if (one === other) return undefined;
  const [a, b] = [one.split("\n"), other.split("\n")];
  const at = a.findIndex((line, index) => line !== b[index]);
  return `line ${at + 1}: ${a[at]} | ${b[at]}`;
}
