import { ChordalError } from "./error.js";
import type { Answer, Question } from "./question.js";

/** What the module offers. */
interface Exports {
  memory: WebAssembly.Memory;
  chordal_input(length: number): number;
  chordal_ask(): number;
  chordal_parts(): number;
  chordal_part(index: number): number;
  chordal_part_length(index: number): number;
  chordal_forget(): void;
}

/** Where the module comes from: its bytes, its address, a response, or itself. */
export type Source = BufferSource | URL | string | Response | WebAssembly.Module;

/** Memory never gets smaller: a module that has more after an answer is not used again. */
const KEPT_BYTES = 256 * 1024 * 1024;

let module: Promise<WebAssembly.Module> | undefined;
let instance: Exports | undefined;
/** The words of the panic that ended the module. */
let panic: string | undefined;

/** Loads the module; without a source it is `chordal.wasm` next to this file. Later calls change nothing. */
export function init(source?: Source): Promise<void> {
  module ??= load(source ?? new URL("./chordal.wasm", import.meta.url)).catch((error: unknown) => {
    // The next call may have more luck.
    module = undefined;
    throw error;
  });
  return module.then(() => undefined);
}

/** Answers a question in this thread. */
export async function ask(question: Question): Promise<Answer> {
  await init();
  const compiled = await module;
  if (compiled === undefined) throw new ChordalError("inside", "the module was not loaded");
  instance ??= await start(compiled);
  const used = instance;
  try {
    const answer = askOf(used, question);
    if (used.memory.buffer.byteLength > KEPT_BYTES) instance = undefined;
    return answer;
  } catch (error) {
    if (error instanceof ChordalError) throw error;
    // Whatever ended it, its memory cannot be trusted: the next question gets a new one.
    instance = undefined;
    throw ended(error);
  }
}

async function load(source: Source): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  if (typeof Response !== "undefined" && source instanceof Response) return compile(source);
  const url = new URL(String(source), import.meta.url);
  const node = typeof process !== "undefined" && typeof process.getBuiltinModule === "function";
  if (node && url.protocol === "file:") {
    return WebAssembly.compile(await process.getBuiltinModule("node:fs/promises").readFile(url));
  }
  return compile(await fetch(url));
}

async function compile(response: Response): Promise<WebAssembly.Module> {
  if (!response.ok) {
    throw new ChordalError("file", `cannot read ${response.url}: ${response.status} ${response.statusText}`);
  }
  // Only a response of its own type can be compiled while it comes.
  const type = response.headers.get("content-type")?.split(";")[0]?.trim();
  if (type === "application/wasm") return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

async function start(compiled: WebAssembly.Module): Promise<Exports> {
  let memory: WebAssembly.Memory | undefined;
  const panicked = (pointer: number, length: number): void => {
    if (memory !== undefined) panic = textAt(memory, pointer, length);
  };
  const made = await WebAssembly.instantiate(compiled, { chordal: { panicked } });
  const exports = made.exports as unknown as Exports;
  memory = exports.memory;
  return exports;
}

function askOf(used: Exports, question: Question): Answer {
  panic = undefined;
  const length = question.reduce((sum, bytes) => sum + bytes.length, 0);
  const pointer = length < 2 ** 31 ? used.chordal_input(length) >>> 0 : 0;
  if (pointer === 0) {
    throw new ChordalError("use", `a request of ${length} bytes has no room in memory`, "split the program");
  }
  let at = pointer;
  for (const bytes of question) {
    new Uint8Array(used.memory.buffer, at, bytes.length).set(bytes);
    at += bytes.length;
  }
  const failed = used.chordal_ask() !== 0;
  const text = textAt(used.memory, used.chordal_part(0) >>> 0, used.chordal_part_length(0) >>> 0);
  const parts: ArrayBuffer[] = [];
  for (let index = 1; index < used.chordal_parts(); index++) {
    const start = used.chordal_part(index) >>> 0;
    // The one copy: what lies in the module is gone with the next question.
    parts.push((used.memory.buffer as ArrayBuffer).slice(start, start + (used.chordal_part_length(index) >>> 0)));
  }
  used.chordal_forget();
  if (failed) throw failure(text);
  return { text, parts };
}

function textAt(memory: WebAssembly.Memory, pointer: number, length: number): string {
  return new TextDecoder().decode(new Uint8Array(memory.buffer, pointer >>> 0, length >>> 0));
}

function failure(text: string): ChordalError {
  const { kind, message, help } = JSON.parse(text) as {
    kind: "use" | "file" | "machine";
    message: string;
    help: string | null;
  };
  return new ChordalError(kind, message, help ?? undefined);
}

/** The module ended: a panic, no memory, or too little stack. */
function ended(error: unknown): ChordalError {
  const why = panic ?? `it ended without a word (${String(error)}); it may have had too little memory`;
  panic = undefined;
  return new ChordalError("inside", `Chordal failed: ${why}`, "please report it with the program; the next call works");
}

/** The memory of the module at work, for tests. */
export function memoryInUse(): WebAssembly.Memory | undefined {
  return instance?.memory;
}
