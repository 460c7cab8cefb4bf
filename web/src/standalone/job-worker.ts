// A worker that does what takes long, for the one that answers. It is ended when what it does is not wanted any more.

import { Engine, type Job, type Opened } from "./engine";
import type { Port } from "./worker-port";

export type ToWork =
  | { module: WebAssembly.Module }
  | { serve: Omit<Opened, "program"> }
  | { job: Job }
  | { ask: string; id: number }
  | { fail: true };

export type FromWork =
  | { out: string | ArrayBuffer }
  /** A job is done; of a run with what the view that answers is to be told. */
  | { done: string }
  | { answered: number }
  | { failed: string };

export function works(port: Port): void {
  const post = (message: FromWork, transfer: Transferable[] = []) => port.postMessage(message, transfer);
  let engine: Promise<Engine> | undefined;

  async function take(message: ToWork): Promise<void> {
    if ("module" in message) {
      engine = Engine.start(message.module, {
        send: (out) => post({ out }, typeof out === "string" ? [] : [out]),
        // What follows is the business of the view that answers.
        want: () => {},
      });
      return;
    }
    const own = await engine!;
    if ("serve" in message) own.serve(message.serve);
    else if ("job" in message) post({ done: own.takeOver(message.job) });
    else if ("ask" in message) {
      own.ask(message.ask);
      post({ answered: message.id });
    } else own.fail();
  }

  // One after the other: the module has one memory.
  let before: Promise<void> = Promise.resolve();
  port.onmessage = (event: MessageEvent<ToWork>) => {
    before = before.then(() => take(event.data)).catch((error: unknown) => {
      post({ failed: error instanceof Error ? error.message : String(error) });
    });
  };
}
