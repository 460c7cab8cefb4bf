// What runs in the worker of worker.ts.
import { ask } from "./engine.js";
import { ChordalError } from "./error.js";
import type { Question } from "./question.js";
import type { Reply } from "./worker.js";

/** The other side, of a page or of Node. */
interface Port {
  postMessage(message: Reply, transfer: ArrayBuffer[]): void;
}

async function answer(port: Port, { id, question }: { id: number; question: Question }): Promise<void> {
  try {
    const answer = await ask(question);
    port.postMessage({ id, answer }, answer.parts);
  } catch (error) {
    const told = error instanceof ChordalError ? error : new ChordalError("inside", String(error));
    port.postMessage({ id, failed: { kind: told.kind, message: told.message, help: told.help } }, []);
  }
}

// One after the other: the module has one memory.
let before: Promise<void> = Promise.resolve();
function listen(port: Port, message: { id: number; question: Question }): void {
  before = before.then(() => answer(port, message));
}

if (typeof self !== "undefined" && typeof (self as { postMessage?: unknown }).postMessage === "function") {
  const port = self as unknown as Port;
  self.onmessage = (event: MessageEvent<{ id: number; question: Question }>) => listen(port, event.data);
} else {
  const port = process.getBuiltinModule("node:worker_threads").parentPort;
  port?.on("message", (message: { id: number; question: Question }) => listen(port, message));
}
