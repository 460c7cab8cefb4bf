// What differs between the pages: the one that `chordal view` serves, the standalone page, and an editor's panel.

import type { layout } from "./panels/layout";
import type { TextEditor } from "./panels/text-editor";
import type { Connection, TransportDialer } from "./protocol/connection";

/** The parts of the page that a host may add to. */
export interface PageParts {
  ui: ReturnType<typeof layout>;
  editor: TextEditor;
  connection: Connection;
  /** Shows the path of a line, as if the cursor was put there. */
  cursorAt: (line: number) => void;
}

export interface PageHost {
  dial: TransportDialer;
  /** The message when the connection has ended. */
  lostMessage: string;
  /** The message when a text was saved. */
  savedMessage: string;
  /** How to compare with a program of another file. */
  anotherHint: string;
  /** Takes a file that the browser is to keep. */
  keepFile?: (name: string, bytes: Uint8Array) => void;
  /** Is called with the line that is shown, where the page went there. */
  followLine?: (line: number) => void;
  /** Adds what only this page has. */
  addControls?: (page: PageParts) => void;
}
