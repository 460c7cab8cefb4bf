// Chordal in a worker: the thread that asks stays free, and closing the worker ends what takes too long.
import { chordal, type Chordal } from "./api.js";
import { ChordalError } from "./error.js";
import type { Answer, Question } from "./question.js";

/** What the worker answers. */
export type Reply =
  | { id: number; answer: Answer }
  | { id: number; failed: { kind: ChordalError["kind"]; message: string; help: string | undefined } };

/** A worker of a page or of Node, by what both have. */
interface Either {
  postMessage(message: unknown): void;
  terminate(): unknown;
  /** Node: keeps the process alive, as long as somebody waits. */
  ref?(): void;
  unref?(): void;
}

/** Starts a worker that answers the questions one after the other. */
export async function start(): Promise<Chordal & { close(): void }> {
  const waiting = new Map<number, { resolve: (answer: Answer) => void; reject: (error: Error) => void }>();
  let last = 0;
  let closed: ChordalError | undefined;
  const end = (error: ChordalError): void => {
    closed ??= error;
    for (const { reject } of waiting.values()) reject(error);
    waiting.clear();
  };
  const take = (reply: Reply): void => {
    const asker = waiting.get(reply.id);
    waiting.delete(reply.id);
    if (waiting.size === 0) worker.unref?.();
    if ("answer" in reply) asker?.resolve(reply.answer);
    else asker?.reject(new ChordalError(reply.failed.kind, reply.failed.message, reply.failed.help));
  };
  const worker = await open(take, (why) => end(new ChordalError("inside", `the worker failed: ${why}`, "start another one")));
  const ask = (question: Question): Promise<Answer> => {
    return new Promise((resolve, reject) => {
      if (closed !== undefined) {
        reject(closed);
        return;
      }
      last += 1;
      worker.postMessage({ id: last, question });
      waiting.set(last, { resolve, reject });
      worker.ref?.();
    });
  };
  const close = (): void => {
    end(new ChordalError("closed", "the worker was closed"));
    void worker.terminate();
  };
  return { ...chordal(ask), close };
}

async function open(take: (reply: Reply) => void, failed: (why: string) => void): Promise<Either> {
  if (typeof Worker !== "undefined") {
    const worker = new Worker(new URL("./worker-main.js", import.meta.url), { type: "module" });
    worker.onmessage = (event: MessageEvent<Reply>) => take(event.data);
    worker.onerror = (event) => failed(event.message);
    return worker;
  }
  const threads = process.getBuiltinModule("node:worker_threads");
  const worker = new threads.Worker(new URL("./worker-main.js", import.meta.url));
  worker.on("message", take);
  worker.on("error", (error: unknown) => failed(String(error)));
  worker.unref();
  return worker;
}
