import { expect, test, vi } from "vitest";
import { Hand, type Works } from "./worker-handle";
import type { FromWork, ToWork } from "./job-worker";

/** A worker that does what the test says. */
class Fake implements Works {
  got: ToWork[] = [];
  isEnded = false;
  onmessage: ((event: MessageEvent<FromWork>) => void) | null = null;
  onerror = null;
  postMessage = (message: ToWork) => void this.got.push(message);
  terminate = () => void (this.isEnded = true);
  say = (data: FromWork) => this.onmessage?.({ data } as MessageEvent<FromWork>);
  get kinds() {
    return this.got.map((message) => Object.keys(message)[0]);
  }
}

function made() {
  const workers: Fake[] = [];
  const told = { out: vi.fn(), done: vi.fn(), failed: vi.fn() };
  const start = () => {
    workers.push(new Fake());
    return workers.at(-1)!;
  };
  return { workers, told, hand: new Hand(start, () => ({ name: "a", files: [] }), told) };
}

const job = () => ({ handed: new ArrayBuffer(0), text: new ArrayBuffer(0) });

test("a newer job waits a moment, and then ends the one before", () => {
  vi.useFakeTimers();
  const { workers, told, hand } = made();
  hand.give(job());
  expect(workers[0].kinds).toEqual(["serve", "job"]);
  // Soon done: the same worker goes on, and what it found of the older text is not told.
  hand.give(job());
  workers[0].say({ done: "old" });
  expect(told.done).not.toHaveBeenCalled();
  expect(workers[0].kinds).toEqual(["serve", "job", "job"]);
  workers[0].say({ done: "new" });
  expect(told.done).toHaveBeenCalledWith("new");
  // Not soon done: another worker, which is asked again what nobody has answered.
  hand.give(job());
  hand.ask(7, "{}");
  hand.give(job());
  vi.advanceTimersByTime(1000);
  expect(workers[0].isEnded).toBe(true);
  expect(workers[1].kinds).toEqual(["serve", "job", "ask"]);
  workers[0].say({ out: "late" });
  expect(told.out).not.toHaveBeenCalled();
  vi.useRealTimers();
});

test("a worker that fails is replaced, and who waits hears of it", () => {
  const { workers, told, hand } = made();
  hand.give(job());
  hand.ask(3, "{}");
  workers[0].say({ failed: "asked to panic" });
  expect(told.failed).toHaveBeenCalledWith("asked to panic", [3]);
  hand.give(job());
  expect(workers[1].kinds).toEqual(["serve", "job"]);
  workers[1].say({ done: "" });
  expect(told.done).toHaveBeenCalledWith("");
});
