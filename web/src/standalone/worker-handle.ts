// One worker for one kind of work, as the worker that answers holds it: the newest job, and the questions that only
// this worker can answer. What it does is ended when a newer job comes and it does not soon have time.

import type { Job, Opened } from "./engine";
import type { FromWork, ToWork } from "./job-worker";

/** How long a job may go on when a newer one waits: as long as it takes to start another worker, ms. */
const PATIENCE_MS = 60;

/** The side of a worker that a hand needs. */
export interface Works {
  postMessage(message: ToWork, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<FromWork>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate(): void;
}

export interface Told {
  out: (data: string | ArrayBuffer) => void;
  done: (told: string) => void;
  failed: (why: string, asked: number[]) => void;
}

export class Hand {
  private worker: Works | undefined;
  private isServing = false;
  private isBusy = false;
  private since = 0;
  private next: Job | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private asked = new Map<number, string>();

  constructor(
    private start: () => Works,
    private opened: () => Omit<Opened, "program">,
    private told: Told,
  ) {}

  /** A worker is ready before it is needed. */
  warm(): void {
    if (this.worker) return;
    const worker = this.start();
    this.worker = worker;
    worker.onmessage = (event) => this.take(event.data);
    worker.onerror = (event) => this.fail(event.message);
  }

  give(job: Job): void {
    if (!this.isBusy) return this.send(job);
    this.next = job;
    clearTimeout(this.timer);
    const left = Math.max(0, PATIENCE_MS - (performance.now() - this.since));
    this.timer = setTimeout(() => this.overtake(), left);
  }

  ask(id: number, ask: string): void {
    this.serve();
    this.asked.set(id, ask);
    this.worker!.postMessage({ ask, id });
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

  /** Whether the worker begins anew with this. */
  private serve(): boolean {
    this.warm();
    if (this.isServing) return false;
    this.isServing = true;
    this.worker!.postMessage({ serve: this.opened() });
    return true;
  }

  private send(job: Job): void {
    const isNew = this.serve();
    this.isBusy = true;
    this.since = performance.now();
    this.worker!.postMessage({ job }, [job.handed, job.text]);
    // What the worker before was asked nobody else answers.
    if (isNew) for (const [id, ask] of this.asked) this.worker!.postMessage({ ask, id });
  }

  /** A newer job comes before what is done now. */
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

  private take(message: FromWork): void {
    if ("out" in message) return this.told.out(message.out);
    if ("answered" in message) return void this.asked.delete(message.answered);
    if ("failed" in message) return this.fail(message.failed);
    this.isBusy = false;
    clearTimeout(this.timer);
    const { next } = this;
    this.next = undefined;
    if (next) this.send(next);
    else this.told.done(message.done);
  }

  private fail(why: string): void {
    const { next } = this;
    const asked = [...this.asked.keys()];
    this.next = undefined;
    this.asked.clear();
    this.end();
    this.told.failed(why, asked);
    if (next) this.send(next);
  }
}
