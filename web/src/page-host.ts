// What differs between the pages: the one that `chordal view` serves, the one that stands alone, and an editor's panel.

import type { Editor } from "./panels/text-editor";
import type { layout } from "./panels/layout";
import type { Dial, Link } from "./protocol/connection";

/** The parts of the page that a host may add to. */
export interface Page {
  ui: ReturnType<typeof layout>;
  editor: Editor;
  link: Link;
  /** Shows the path of a line, as if the cursor was put there. */
  cursorAt: (line: number) => void;
}

export interface PageHost {
  dial: Dial;
  /** The message when the connection has ended. */
  lost: string;
  /** The message when a text was saved. */
  saved: string;
  /** How to compare with a program of another file. */
  another: string;
  /** Takes a file that the browser is to keep. */
  keep?: (name: string, bytes: Uint8Array) => void;
  /** Is called with the line that is shown, where the page went there. */
  follow?: (line: number) => void;
  /** Adds what only this page has. */
  furnish?: (page: Page) => void;
}
