import { resolve } from "node:path";
import { expect, test } from "vitest";
import { gallery } from "../../gallery";
import { exampleAt } from "./gallery";

test("every example says what it shows, and has its machine", () => {
  const groups = gallery(resolve("../examples"));
  const all = groups.flatMap(({ examples }) => examples);
  expect(all.length).toBeGreaterThan(60);
  for (const { name, shows, machine, files } of all) {
    expect(shows.length, name).toBeGreaterThan(8);
    expect(shows, name).not.toMatch(/machine:|[()]/);
    if (files.length > 0) expect(files.map(([path]) => path), name).toContain(machine);
    else expect(machine, name).toMatch(/^[\w-]+$/);
  }
  // No control is without a title for people.
  for (const { title, folder } of groups) expect(title).not.toBe(folder);
});

test("an example has a path", () => {
  const groups = gallery(resolve("../examples"));
  expect(exampleAt(groups, "haas/thread-mill.nc")?.text).toContain("THREAD HOB");
  for (const path of ["", "haas", "haas/none.nc", "../haas/thread-mill.nc", "none/thread-mill.nc"]) {
    expect(exampleAt(groups, path)).toBeUndefined();
  }
});
