import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { ThrottledTask } from "./throttled-task";

beforeEach(() => {
  vi.useFakeTimers({ toFake: ["setTimeout", "performance"] });
  vi.stubGlobal("requestAnimationFrame", (frame: () => void) => setTimeout(frame, 16));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("of what comes soon after each other the last is done, and not more often than it may be", () => {
  const later = new ThrottledTask(100);
  const done: number[] = [];
  for (let n = 0; n < 3; n++) later.schedule(() => done.push(n));
  expect(done).toEqual([]);
  vi.advanceTimersByTime(20);
  expect(done).toEqual([2]);
  later.schedule(() => done.push(3));
  vi.advanceTimersByTime(90);
  expect(done).toEqual([2]);
  vi.advanceTimersByTime(40);
  expect(done).toEqual([2, 3]);
  later.schedule(() => done.push(4));
  later.cancel();
  vi.advanceTimersByTime(1000);
  expect(done).toEqual([2, 3]);
});

test("what waits for quiet is done at last, though there is none", () => {
  const later = new ThrottledTask(100);
  const done: number[] = [];
  for (let n = 0; n < 10; n++) {
    later.schedule(() => done.push(n), 150);
    vi.advanceTimersByTime(80);
  }
  expect(done.length).toBe(1);
  vi.advanceTimersByTime(300);
  expect(done.at(-1)).toBe(9);
});
