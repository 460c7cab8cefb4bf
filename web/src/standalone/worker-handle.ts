// The session worker's handle of a job worker for one kind of work: it assigns the newest work order, and sends the requests that
// only this worker can answer. When a newer order comes and the worker does not finish soon, it is terminated.

import type { OpenedProgram, WorkOrder } from "./engine";
import type { FromJobWorker, ToJobWorker } from "./job-worker";

/** How long an order may take while a newer one waits, ms: as long as it takes to start another worker. */
const OVERTAKE_AFTER_MS = 60;

/** The part of a `Worker` that the handle uses. */
export interface JobWorker {
  postMessage(message: ToJobWorker, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<FromJobWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate(): void;
}

export interface HandleEvents {
  out: (data: string | ArrayBuffer) => void;
  done: (remoteRun: string) => void;
  failed: (why: string, queries: number[]) => void;
}

export class WorkerHandle {
  private worker: JobWorker | undefined;
  /** The worker has the files of the program. */
  private isPrepared = false;
  private isBusy = false;
  /** When the present order was sent, ms. */
  private sentAt = 0;
  private next: WorkOrder | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private queries = new Map<number, string>();

  constructor(
    private start: () => JobWorker,
    private opened: () => Omit<OpenedProgram, "program">,
    private events: HandleEvents,
  ) {}

  /** Starts a worker where there is none, possibly before it is needed. */
  warm(): void {
    if (this.worker) return;
    const worker = this.start();
    this.worker = worker;
    worker.onmessage = (event) => this.take(event.data);
    worker.onerror = (event) => this.fail(event.message);
  }

  /** Sends an order, or keeps it as the next one where the worker is busy. */
  assign(job: WorkOrder): void {
    if (!this.isBusy) return this.send(job);
    this.next = job;
    clearTimeout(this.timer);
    const remaining = Math.max(0, OVERTAKE_AFTER_MS - (performance.now() - this.sentAt));
    this.timer = setTimeout(() => this.overtake(), remaining);
  }

  /** Sends a request that only this worker can answer. */
  query(id: number, request: string): void {
    this.prepare();
    this.queries.set(id, request);
    this.worker!.postMessage({ request, id });
  }

  /** Terminates the worker after a change of the files: the next one gets the new files. */
  renew(): void {
    this.next = undefined;
    this.end();
  }

  /** Makes the worker fail: for tests. */
  breakDown(): void {
    this.prepare();
    this.worker!.postMessage({ fail: true });
  }

  /** Gives the worker the files of the program; returns whether it had none. */
  private prepare(): boolean {
    this.warm();
    if (this.isPrepared) return false;
    this.isPrepared = true;
    this.worker!.postMessage({ serve: this.opened() });
    return true;
  }

  private send(job: WorkOrder): void {
    const isNew = this.prepare();
    this.isBusy = true;
    this.sentAt = performance.now();
    this.worker!.postMessage({ job }, [job.order, job.text]);
    // Again, the requests that the worker before has not answered.
    if (isNew) for (const [id, request] of this.queries) this.worker!.postMessage({ request, id });
  }

  /** Terminates the worker and starts the newer order. */
  private overtake(): void {
    const { next } = this;
    if (!next) return;
    this.next = undefined;
    this.end();
    this.send(next);
  }

  private end(): void {
    clearTimeout(this.timer);
    this.worker?.terminate();
    if (this.worker) this.worker.onmessage = this.worker.onerror = null;
    this.worker = undefined;
    this.isBusy = this.isPrepared = false;
  }

  private take(message: FromJobWorker): void {
    if ("out" in message) return this.events.out(message.out);
    if ("answered" in message) return void this.queries.delete(message.answered);
    if ("failed" in message) return this.fail(message.failed);
    this.isBusy = false;
    clearTimeout(this.timer);
    const { next } = this;
    this.next = undefined;
    if (next) this.send(next);
    else this.events.done(message.done);
  }

  private fail(why: string): void {
    const { next } = this;
    const queries = [...this.queries.keys()];
    this.next = undefined;
    this.queries.clear();
    this.end();
    this.events.failed(why, queries);
    if (next) this.send(next);
  }
}
