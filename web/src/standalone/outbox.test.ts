import { expect, test } from "vitest";
import { Outbox } from "./outbox";

function made() {
  const sent: (string | number)[] = [];
  const out = new Outbox((data) => void sent.push(typeof data === "string" ? data : data.byteLength));
  return { sent, out };
}

test("columns go no faster than the page takes them, and nothing overtakes", () => {
  const { sent, out } = made();
  for (let at = 1; at <= 10; at++) out.put(new ArrayBuffer(at));
  out.put("report");
  expect(sent).toEqual([1, 2, 3, 4, 5, 6, 7, 8]);
  out.acknowledge(1);
  expect(sent.slice(8)).toEqual([9]);
  out.acknowledge(2);
  expect(sent.slice(8)).toEqual([9, 10, "report"]);
  // Words alone wait for nothing.
  out.put("state");
  expect(sent.at(-1)).toBe("state");
});

test("a long text waits for the first picture, then takes turns with the path", () => {
  const { sent, out } = made();
  out.pause();
  for (let at = 1; at <= 3; at++) out.putDeferred(new ArrayBuffer(100 * at));
  out.put("run");
  expect(sent).toEqual(["run"]);
  // The page is busy with what came before.
  for (let times = 0; times < 8; times++) out.put(new ArrayBuffer(7));
  for (let at = 1; at <= 3; at++) out.put(new ArrayBuffer(at), true);
  for (let times = 0; times < 6; times++) out.acknowledge(1);
  expect(sent).toEqual(["run", ...Array(8).fill(7), 1, 100, 2, 200, 3, 300]);
  const other = made();
  other.out.pause();
  other.out.putDeferred(new ArrayBuffer(100));
  other.out.release();
  expect(other.sent).toEqual([100]);
});
