import { ChordalError } from "./error.js";
import { Ended, Module, NoRoom } from "./memory.js";
import type { Answer, Question } from "./question.js";

/** What the module offers. */
interface Exports {
  chordal_answer(): number;
}

/** Where the module comes from: its bytes, its address, a response, or itself. */
export type Source = BufferSource | URL | string | Response | WebAssembly.Module;

/** Memory never gets smaller: a module that has more after an answer is not used again. */
const KEPT_BYTES = 256 * 1024 * 1024;

let module: Promise<WebAssembly.Module> | undefined;
let instance: Module<Exports> | undefined;

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
  instance ??= await Module.start<Exports>(compiled);
  const used = instance;
  try {
    const answer = askOf(used, question);
    if (used.memory.buffer.byteLength > KEPT_BYTES) instance = undefined;
    return answer;
  } catch (error) {
    if (error instanceof NoRoom) {
      throw new ChordalError("use", `a request of ${error.bytes} bytes has no room in memory`, "split the program");
    }
    if (!(error instanceof Ended)) throw error;
    // The next question gets a new one.
    instance = undefined;
    throw new ChordalError("inside", `Chordal failed: ${error.message}`, "please report it with the program; the next call works");
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

function askOf(used: Module<Exports>, question: Question): Answer {
  const { failed, text, parts } = used.call(question, (own) => {
    const failed = own.chordal_answer() !== 0;
    const parts: ArrayBuffer[] = [];
    for (let index = 1; index < used.parts; index++) parts.push(used.part(index));
    return { failed, text: used.text(0), parts };
  });
  if (failed) throw failure(text);
  return { text, parts };
}

function failure(text: string): ChordalError {
  const { kind, message, help } = JSON.parse(text) as {
    kind: "use" | "file" | "machine";
    message: string;
    help: string | null;
  };
  return new ChordalError(kind, message, help ?? undefined);
}

/** The memory of the module at work, for tests. */
export function memoryInUse(): WebAssembly.Memory | undefined {
  return instance?.memory;
}
