import { ChordalError } from "./error.js";
import { messageOf } from "./memory.js";

/** A text as JavaScript has it. A string is sent as UTF-8. */
export type Text = string | Uint8Array | ArrayBuffer;

/** A program of a question: what is said of it, and its text. */
export interface Program {
  options: object;
  text: Uint8Array;
}

/** A file of a question. */
export interface File {
  path: string;
  text: Uint8Array;
}

/** What is asked: the request as the module reads it, in pieces that a worker takes as well. */
export type Question = Uint8Array[];

/** A text, and columns of plain numbers that it describes. */
export interface Answer {
  text: string;
  parts: ArrayBuffer[];
}

/** Answers questions: in this thread, or in a worker. */
export type Ask = (question: Question) => Promise<Answer>;

/** The bytes of a text. */
export function bytesOf(text: unknown, what: string): Uint8Array {
  if (typeof text === "string") {
    return new TextEncoder().encode(text);
  }
  if (ArrayBuffer.isView(text)) {
    return new Uint8Array(text.buffer, text.byteOffset, text.byteLength);
  }
  if (text instanceof ArrayBuffer) {
    return new Uint8Array(text);
  }
  const is = text === null ? "null" : Array.isArray(text) ? "an array" : typeof text;
  throw new ChordalError("use", `${what} is ${is}`, "give a string, a Uint8Array or an ArrayBuffer");
}

/** A question: a message whose object names the texts. */
export function questionOf(ask: string, programs: Program[], files: File[], options: object): Question {
  const head = {
    ask,
    programs: programs.map((program) => ({ options: program.options, bytes: program.text.length })),
    files: files.map((file) => ({ path: file.path, bytes: file.text.length })),
    options,
  };
  return messageOf(jsonOf(head), [...programs.map((program) => program.text), ...files.map((file) => file.text)]);
}

/** JSON of options; what cannot be written so is refused and not left out. */
function jsonOf(head: object): string {
  try {
    return JSON.stringify(head, (key, value: unknown) => {
      if (typeof value === "function" || typeof value === "symbol") throw new TypeError(`\`${key}\` is a ${typeof value}`);
      return value;
    });
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    throw new ChordalError("use", `the options cannot be sent: ${why}`, "give strings, numbers, booleans and lists");
  }
}
