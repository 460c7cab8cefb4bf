// What differs between the page that `chordal view` serves and the one that stands alone.

import type { Editor } from "./panels/text-editor";
import type { layout } from "./panels/layout";
import type { Dial, Link } from "./protocol/connection";

/** The parts of the page that a shell may add to. */
export interface Page {
  ui: ReturnType<typeof layout>;
  editor: Editor;
  link: Link;
  /** Shows the path of a line, as if the cursor was put there. */
  cursorAt: (line: number) => void;
}

export interface Shell {
  dial: Dial;
  /** What is said when nothing answers any more. */
  lost: string;
  /** What is said of a text that was saved. */
  saved: string;
  /** How to compare with a program of another file. */
  another: string;
  /** Takes a file that the browser is to keep. */
  keep?: (name: string, bytes: Uint8Array) => void;
  /** Hears of the line that is shown, where the page went there. */
  follow?: (line: number) => void;
  /** Adds what only this page has. */
  furnish?: (page: Page) => void;
}

let own: Shell | undefined;

/** Says which page this is, before the page is put together. */
export function use(shell: Shell): void {
  own = shell;
}

export function shell(): Shell {
  if (!own) throw new Error("nobody said which page this is");
  return own;
}
