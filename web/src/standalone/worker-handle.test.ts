import { expect, test, vi } from "vitest";
import type { FromJobWorker, ToJobWorker } from "./job-worker";
import { type JobWorker, WorkerHandle } from "./worker-handle";

/** A worker that does what the test says. */
class Fake implements JobWorker {
  got: ToJobWorker[] = [];
  isEnded = false;
  onmessage: ((event: MessageEvent<FromJobWorker>) => void) | null = null;
  onerror = null;
  postMessage = (message: ToJobWorker) => void this.got.push(message);
  terminate = () => void (this.isEnded = true);
  say = (data: FromJobWorker) => this.onmessage?.({ data } as MessageEvent<FromJobWorker>);
  get kinds() {
    return this.got.map((message) => Object.keys(message)[0]);
  }
}

function made() {
  const workers: Fake[] = [];
  const events = { out: vi.fn(), done: vi.fn(), failed: vi.fn() };
  const start = () => {
    workers.push(new Fake());
    return workers.at(-1)!;
  };
  return { workers, events, handle: new WorkerHandle(start, () => ({ name: "a", files: [] }), events) };
}

const job = () => ({ order: new ArrayBuffer(0), text: new ArrayBuffer(0) });

test("a newer job waits a moment, and then ends the one before", () => {
  vi.useFakeTimers();
  const { workers, events, handle } = made();
  handle.assign(job());
  expect(workers[0].kinds).toEqual(["serve", "job"]);
  // Soon done: the same worker goes on, and its result for the older text is dropped.
  handle.assign(job());
  workers[0].say({ done: "old" });
  expect(events.done).not.toHaveBeenCalled();
  expect(workers[0].kinds).toEqual(["serve", "job", "job"]);
  workers[0].say({ done: "new" });
  expect(events.done).toHaveBeenCalledWith("new");
  // Not soon done: another worker, which gets the open requests again.
  handle.assign(job());
  handle.query(7, "{}");
  handle.assign(job());
  vi.advanceTimersByTime(1000);
  expect(workers[0].isEnded).toBe(true);
  expect(workers[1].kinds).toEqual(["serve", "job", "request"]);
  workers[0].say({ out: "late" });
  expect(events.out).not.toHaveBeenCalled();
  vi.useRealTimers();
});

test("a worker that fails is replaced, and who waits hears of it", () => {
  const { workers, events, handle } = made();
  handle.assign(job());
  handle.query(3, "{}");
  workers[0].say({ failed: "asked to panic" });
  expect(events.failed).toHaveBeenCalledWith("asked to panic", [3]);
  handle.assign(job());
  expect(workers[1].kinds).toEqual(["serve", "job"]);
  workers[1].say({ done: "" });
  expect(events.done).toHaveBeenCalledWith("");
});
