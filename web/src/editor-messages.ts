// What an editor and the view in its panel say to each other.

export interface ShownProgram {
  /** The path of the program, which its files lie next to. */
  name: string;
  text: string;
  /** Path and text. */
  files: Record<string, string>;
  /** A built-in machine, or the path of one of the files. */
  machine?: string;
  /** Where the cursor is, from 1. */
  line: number;
}

export type ToPanel =
  /** What the view is made of: the interpreter, and the text of its worker. */
  | { parts: { module: Uint8Array<ArrayBuffer>; worker: string } }
  | { open: ShownProgram }
  | { text: string }
  | { files: Record<string, string> }
  | { line: number };

export type FromPanel =
  | { ready: true }
  /** The line whose path is shown. */
  | { line: number };
