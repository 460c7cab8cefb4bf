// What runs in the workers of the page that stands alone: one answers, one for each kind of work does what takes long.

import { answers } from "./answers";
import { works } from "./works";

/** The other side: the page, or the worker that answers. */
export interface Port {
  name: string;
  postMessage(message: unknown, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent) => void) | null;
}

const port = self as unknown as Port;
if (port.name === "answers") answers(port);
else works(port);
