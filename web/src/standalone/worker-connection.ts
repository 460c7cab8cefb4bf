// The connection of the standalone page: a worker with the interpreter, which gets the requests as a server would.

import type { Transport } from "../protocol/connection";
import type { OpenedProgram, OtherProgram, ProgramFile, WorkKind } from "./engine";
import type { ClosedMessage, ToSessionWorker } from "./session-worker";

/** How long a page that does not draw lets columns wait, ms. */
const MAX_WITHOUT_FRAME_MS = 100;

/** Counts what was taken, and reports it after the page has drawn and handled its input; in the background it does not draw. */
function counted(report: (count: number) => void): () => void {
  let count = 0;
  const flush = () => {
    if (count > 0) report(count);
    count = 0;
  };
  return () => {
    if (count++ > 0) return;
    requestAnimationFrame(() => setTimeout(flush));
    setTimeout(flush, MAX_WITHOUT_FRAME_MS);
  };
}

export class WorkerConnection {
  private worker: Worker;
  private isUsed = false;
  private take: (data: string | ArrayBuffer) => void = () => {};
  /** Is called when the worker has ended, with the reason. */
  onLost: (why: string) => void = () => {};

  /** `make` starts a worker of `worker-entry.ts` under a name. */
  constructor(
    private compiled: Promise<WebAssembly.Module>,
    private make: (name: string) => Worker,
  ) {
    // Started before a program is there.
    this.worker = this.start();
    this.compiled.catch((error: unknown) => this.onLost(`the page is not complete: ${String(error)}`));
  }

  private start(): Worker {
    const worker = this.make("answers");
    const count = counted((taken) => worker.postMessage({ taken } satisfies ToSessionWorker));
    worker.onmessage = (event: MessageEvent<string | ArrayBuffer | ClosedMessage>) => {
      const { data } = event;
      if (data instanceof ArrayBuffer) {
        count();
        this.take(data);
      } else if (typeof data === "string") this.take(data);
      else this.lose(data.closed);
    };
    worker.onerror = (event) => this.lose(event.message || "a worker of the page could not be started");
    void this.compiled.then((module) => worker.postMessage({ module } satisfies ToSessionWorker), () => {});
    return worker;
  }

  private end(): void {
    this.worker.onmessage = this.worker.onerror = null;
    this.worker.terminate();
    this.isUsed = false;
  }

  private lose(why: string): void {
    this.end();
    this.worker = this.start();
    this.onLost(why);
  }

  dial(take: (data: string | ArrayBuffer) => void): Transport {
    this.take = take;
    const core = this;
    return {
      get isOpen() {
        return core.isUsed;
      },
      send: (text) => this.worker.postMessage(text satisfies ToSessionWorker),
    };
  }

  /** Opens a program; whatever was done for the one before ends. Its bytes go over. */
  async open(opened: OpenedProgram): Promise<void> {
    await this.compiled;
    if (this.isUsed) {
      this.end();
      this.worker = this.start();
      // After the module was posted.
      await Promise.resolve();
    }
    this.isUsed = true;
    this.worker.postMessage({ open: opened } satisfies ToSessionWorker, [opened.program]);
  }

  /** Other files lie next to the program now. */
  files(files: ProgramFile[]): void {
    this.worker.postMessage({ files } satisfies ToSessionWorker);
  }

  /** The program is compared with another one, once the page asks for it. */
  against(against: OtherProgram): void {
    this.worker.postMessage({ against } satisfies ToSessionWorker);
  }

  /** For tests: a part of the interpreter fails. */
  fail(what: WorkKind | "answers"): void {
    this.worker.postMessage({ fail: what } satisfies ToSessionWorker);
  }
}
