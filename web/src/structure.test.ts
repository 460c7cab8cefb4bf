// How the sources of the page are built: imports go one way, files stay short, and names are words of the field.

import { readFileSync, readdirSync } from "node:fs";
import { dirname, join, normalize, relative } from "node:path";
import { parseAst } from "vite";
import { expect, test } from "vitest";

const ROOT = import.meta.dirname;
const MAX_LINES = 600;

/** Words of the project's own, for which the field has others: `message`, `send`, `query`, `WorkOrder`. */
const GLOSSARY = new Set([
  "told", "tell", "tells", "telling", "behind", "beside", "stretch", "stretches", "way", "ways", "asked", "ask", "asks", "asking",
  "given", "held", "wanted", "elsewhere", "apart", "said", "stand", "standing", "stands", "believed", "looked", "looks", "laid", "lay",
  "seen", "ran", "hand", "handed", "hands", "eye", "patience",
]);
/** In the name of a constant, which says its unit or what it counts: `MAX_PIECES`, `COINCIDENT_MM`. */
const CONSTANT_GLOSSARY = new Set(["most", "near", "same", "rounding", "enough", "few", "many", "rounds", "kept"]);
/** A file is named by what it holds, not by a verb form or an adverb. */
const FILE_GLOSSARY = new Set([
  ...GLOSSARY, "against", "alone", "later", "marked", "measured", "measuring", "turned", "replaced", "served", "works", "opens", "rich", "drops",
]);

interface Identifier {
  name: string;
  line: number;
}

const FILES = (readdirSync(ROOT, { recursive: true }) as string[]).filter((name) => name.endsWith(".ts")).map((name) => join(ROOT, name)).sort();
/** The tests in the browser, which are no modules of the page. */
const BROWSER_TESTS = readdirSync(join(ROOT, "../tests")).map((name) => join(ROOT, "../tests", name)).sort();
const text = (file: string) => readFileSync(file, "utf8");
const shown = (file: string) => relative(ROOT, file);

function importsOf(file: string): string[] {
  const specifiers = [...text(file).matchAll(/(?:from|import)\s*\(?\s*"(\.[^"]+)"/g)].map(([, specifier]) => specifier!);
  const paths = specifiers.map((specifier) => normalize(join(dirname(file), specifier)));
  return paths.map((path) => (path.endsWith(".ts") ? path : `${path}.ts`)).filter((path) => FILES.includes(path));
}

/** The first circle that imports make from a file on, as the files on it. */
function circleFrom(file: string, done: Set<string>, path: string[] = []): string[] | undefined {
  if (path.includes(file)) return path.slice(path.indexOf(file));
  if (done.has(file)) return undefined;
  for (const next of importsOf(file)) {
    const circle = circleFrom(next, done, [...path, file]);
    if (circle) return circle;
  }
  done.add(file);
  return undefined;
}

/** `MAX_PIECES` and `maxPieces` as their words. */
function wordsOf(name: string): string[] {
  return name.replace(/([a-z0-9])([A-Z])/g, "$1 $2").replace(/([A-Z]+)([A-Z][a-z])/g, "$1 $2").toLowerCase().split(/[^a-z]+/);
}

/** Every identifier of a file, declared or used. */
function identifiersOf(file: string): Identifier[] {
  const source = text(file);
  const found: Identifier[] = [];
  const visit = (node: unknown): void => {
    if (Array.isArray(node)) return node.forEach(visit);
    if (!node || typeof node !== "object") return;
    const { type, name, start } = node as { type?: string; name?: unknown; start?: number };
    if (type === "Identifier" && typeof name === "string") found.push({ name, line: source.slice(0, start).split("\n").length });
    Object.values(node).forEach(visit);
  };
  visit(parseAst(source, { lang: "ts" }));
  return found;
}

function isOwnWord(name: string): boolean {
  const words = wordsOf(name);
  const isConstant = /^[A-Z][A-Z0-9_]*$/.test(name);
  return words.some((word) => GLOSSARY.has(word) || (isConstant && CONSTANT_GLOSSARY.has(word)));
}

test("imports go one way", () => {
  const done = new Set<string>();
  const circles = FILES.map((file) => circleFrom(file, done)).filter((circle) => circle !== undefined);
  expect(circles.map((circle) => circle.map(shown))).toEqual([]);
});

test("no file is long", () => {
  const long = FILES.filter((file) => text(file).split("\n").length > MAX_LINES);
  expect(long.map(shown)).toEqual([]);
});

test("identifiers are words of the field", () => {
  const own = [...FILES, ...BROWSER_TESTS].flatMap((file) => identifiersOf(file).filter(({ name }) => isOwnWord(name)).map(({ name, line }) => `${shown(file)}:${line} ${name}`));
  expect(own).toEqual([]);
});

test("files are named by what they hold", () => {
  const own = [...FILES, ...BROWSER_TESTS].filter((file) => wordsOf(shown(file)).some((word) => FILE_GLOSSARY.has(word)));
  expect(own.map(shown)).toEqual([]);
});
