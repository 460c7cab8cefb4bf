// The messages between an editor and the view in its panel.

export interface ShownProgram {
  /** The path of the program; those of its files are relative to its folder. */
  name: string;
  text: string;
  /** Texts by path. */
  files: Record<string, string>;
  /** A built-in machine, or the path of one of the files. */
  machine?: string;
  /** The line of the cursor, from 1. */
  line: number;
}

export type ToPanel =
  /** The WebAssembly module, and the script of its worker. */
  | { parts: { module: Uint8Array<ArrayBuffer>; worker: string } }
  | { open: ShownProgram }
  | { text: string }
  | { files: Record<string, string> }
  | { line: number };

export type FromPanel =
  | { ready: true }
  /** The line whose path is shown. */
  | { line: number };
