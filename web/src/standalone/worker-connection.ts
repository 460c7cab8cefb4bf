// The connection of the standalone page to the session worker, which gets the requests as a server would.

import type { Transport } from "../protocol/connection";
import type { OpenedProgram, OtherProgram, ProgramFile, WorkKind } from "./engine";
import type { ClosedMessage, ToSessionWorker } from "./session-worker";

/** How long handled messages wait to be reported by a page that does not draw, ms. */
const MAX_WITHOUT_FRAME_MS = 100;

/** Counts calls, and reports their number after the page has drawn and handled its input, or soon where it is in the background and does not draw. */
function countingReporter(report: (count: number) => void): () => void {
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
  /** A program is open. */
  private isUsed = false;
  private onData: (data: string | ArrayBuffer) => void = () => {};
  /** Called when the worker has failed, with the reason. */
  onLost: (why: string) => void = () => {};

  /** `createWorker` starts a worker of `worker-entry.ts` with a name. */
  constructor(
    private compiled: Promise<WebAssembly.Module>,
    private createWorker: (name: string) => Worker,
  ) {
    // Started before it is needed for a program.
    this.worker = this.start();
    this.compiled.catch((error: unknown) => this.onLost(`the page is not complete: ${String(error)}`));
  }

  private start(): Worker {
    const worker = this.createWorker("answers");
    const count = countingReporter((taken) => worker.postMessage({ taken } satisfies ToSessionWorker));
    worker.onmessage = (event: MessageEvent<string | ArrayBuffer | ClosedMessage>) => {
      const { data } = event;
      if (data instanceof ArrayBuffer) {
        count();
        this.onData(data);
      } else if (typeof data === "string") this.onData(data);
      else this.replaceWorker(data.closed);
    };
    worker.onerror = (event) => this.replaceWorker(event.message || "a worker of the page could not be started");
    void this.compiled.then((module) => worker.postMessage({ module } satisfies ToSessionWorker), () => {});
    return worker;
  }

  private end(): void {
    this.worker.onmessage = this.worker.onerror = null;
    this.worker.terminate();
    this.isUsed = false;
  }

  /** Replaces a worker that has failed. */
  private replaceWorker(why: string): void {
    this.end();
    this.worker = this.start();
    this.onLost(why);
  }

  dial(onData: (data: string | ArrayBuffer) => void): Transport {
    this.onData = onData;
    const connection = this;
    return {
      get isOpen() {
        return connection.isUsed;
      },
      send: (text) => this.worker.postMessage(text satisfies ToSessionWorker),
    };
  }

  /** Opens a program, and stops all work for the one before. Its bytes are transferred to the worker. */
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

  /** Replaces the files of the program. */
  setFiles(files: ProgramFile[]): void {
    this.worker.postMessage({ files } satisfies ToSessionWorker);
  }

  /** Sets the program to compare with, before the page requests the comparison. */
  setOtherProgram(against: OtherProgram): void {
    this.worker.postMessage({ against } satisfies ToSessionWorker);
  }

  /** Makes a worker fail: for tests. */
  fail(what: WorkKind | "answers"): void {
    this.worker.postMessage({ fail: what } satisfies ToSessionWorker);
  }
}
