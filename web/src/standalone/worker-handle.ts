// The session worker's handle of one worker for one kind of work: the newest work order, and the requests that only
// this worker can answer. The worker is ended when a newer order comes and it does not finish soon.

import type { OpenedProgram, WorkOrder } from "./engine";
import type { FromJobWorker, ToJobWorker } from "./job-worker";

/** How long an order may go on when a newer one waits: as long as it takes to start another worker, ms. */
const OVERTAKE_AFTER_MS = 60;

/** What the handle uses of a worker. */
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
  private isServing = false;
  private isBusy = false;
  private since = 0;
  private next: WorkOrder | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private queries = new Map<number, string>();

  constructor(
    private start: () => JobWorker,
    private opened: () => Omit<OpenedProgram, "program">,
    private events: HandleEvents,
  ) {}

  /** A worker is ready before it is needed. */
  warm(): void {
    if (this.worker) return;
    const worker = this.start();
    this.worker = worker;
    worker.onmessage = (event) => this.take(event.data);
    worker.onerror = (event) => this.fail(event.message);
  }

  assign(job: WorkOrder): void {
    if (!this.isBusy) return this.send(job);
    this.next = job;
    clearTimeout(this.timer);
    const left = Math.max(0, OVERTAKE_AFTER_MS - (performance.now() - this.since));
    this.timer = setTimeout(() => this.overtake(), left);
  }

  query(id: number, request: string): void {
    this.serve();
    this.queries.set(id, request);
    this.worker!.postMessage({ request, id });
  }

  /** The files have changed: what comes next begins with them. */
  renew(): void {
    this.next = undefined;
    this.end();
  }

  /** For tests. */
  breakDown(): void {
    this.serve();
    this.worker!.postMessage({ fail: true });
  }

  /** Makes the worker ready; true if it is a new one. */
  private serve(): boolean {
    this.warm();
    if (this.isServing) return false;
    this.isServing = true;
    this.worker!.postMessage({ serve: this.opened() });
    return true;
  }

  private send(job: WorkOrder): void {
    const isNew = this.serve();
    this.isBusy = true;
    this.since = performance.now();
    this.worker!.postMessage({ job }, [job.order, job.text]);
    // The requests that the worker before has not answered.
    if (isNew) for (const [id, request] of this.queries) this.worker!.postMessage({ request, id });
  }

  /** Ends the present order for a newer one. */
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
    this.isBusy = this.isServing = false;
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
