// What differs between the hosts of the page: `chordal view`, the standalone page, and the panel of an editor.

import type { layout } from "./panels/layout";
import type { TextEditor } from "./panels/text-editor";
import type { Connection, TransportDialer } from "./protocol/connection";

/** The parts of the page that a host may use and extend. */
export interface PageParts {
  ui: ReturnType<typeof layout>;
  editor: TextEditor;
  connection: Connection;
  /** Shows the path of a line, as if the user had put the cursor there. */
  cursorAt: (line: number) => void;
}

export interface PageHost {
  dial: TransportDialer;
  /** The message when the connection has ended. */
  lostMessage: string;
  /** The message after saving. */
  savedMessage: string;
  /** The text that explains how to compare with another file. */
  anotherHint: string;
  /** Saves a file through the browser. */
  keepFile?: (name: string, bytes: Uint8Array) => void;
  /** Called with the line of the cursor when the page has moved it. */
  followLine?: (line: number) => void;
  /** Adds the controls that only this host has. */
  addControls?: (page: PageParts) => void;
}
