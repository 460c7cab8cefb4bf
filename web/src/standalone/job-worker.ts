// A worker that does long work for the session worker, which terminates it when its result is no longer needed.

import { type OpenedProgram, type WorkOrder, Engine } from "./engine";
import type { WorkerPort } from "./worker-port";

export type ToJobWorker =
  | { module: WebAssembly.Module }
  | { serve: Omit<OpenedProgram, "program"> }
  | { job: WorkOrder }
  | { request: string; id: number }
  | { fail: true };

export type FromJobWorker =
  | { out: string | ArrayBuffer }
  /** A work order is done; after a run with the report for the session's module. */
  | { done: string }
  | { answered: number }
  | { failed: string };

export function jobWorker(port: WorkerPort): void {
  const post = (message: FromJobWorker, transfer: Transferable[] = []) => port.postMessage(message, transfer);
  let engine: Promise<Engine> | undefined;

  async function take(message: ToJobWorker): Promise<void> {
    if ("module" in message) {
      engine = Engine.start(message.module, {
        send: (out) => post({ out }, typeof out === "string" ? [] : [out]),
        // The session's module decides what follows.
        want: () => {},
      });
      return;
    }
    const ready = await engine!;
    if ("serve" in message) ready.serve(message.serve);
    else if ("job" in message) post({ done: ready.execute(message.job) });
    else if ("request" in message) {
      ready.request(message.request);
      post({ answered: message.id });
    } else ready.fail();
  }

  // One message after the other: the module is not reentrant.
  let previous: Promise<void> = Promise.resolve();
  port.onmessage = (event: MessageEvent<ToJobWorker>) => {
    previous = previous.then(() => take(event.data)).catch((error: unknown) => {
      post({ failed: error instanceof Error ? error.message : String(error) });
    });
  };
}
