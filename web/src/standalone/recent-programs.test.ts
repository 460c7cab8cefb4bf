import { expect, test } from "vitest";
import { namesWithoutRoom, sizeOf } from "./recent-programs";

test("the newest programs stay, as many and as large as there is room", () => {
  const entry = (name: string, at: number, bytes: number) => ({ name, at, bytes });
  expect(namesWithoutRoom([])).toEqual([]);
  const many = Array.from({ length: 25 }, (_, at) => entry(`p${at}`, at, 10));
  expect(namesWithoutRoom(many)).toEqual(["p4", "p3", "p2", "p1", "p0"]);
  const large = [1, 2, 3, 4, 5, 6].map((at) => entry(`p${at}`, at, 30 * 2 ** 20));
  expect(namesWithoutRoom(large)).toEqual(["p2", "p1"]);
  expect(sizeOf({ program: new ArrayBuffer(3), files: [{ path: "a", bytes: new ArrayBuffer(4) }] })).toBe(7);
});
