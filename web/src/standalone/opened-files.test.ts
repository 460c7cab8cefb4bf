import { expect, test } from "vitest";
import { MAX_PROGRAM_BYTES, distinctName, nameOf, sizeComplaint, sortFiles } from "./opened-files";

const files = (...names: string[]) => names.map((name) => ({ name }));

test("the first file that is no machine, shape or table is the program", () => {
  const { program, others, machine } = sortFiles(files("op1.toml", "op1.nc", "O77.nc", "stock.STL"));
  expect(program?.name).toBe("op1.nc");
  expect(others.map(({ name }) => name)).toEqual(["op1.toml", "O77.nc", "stock.STL"]);
  expect(machine).toBe("op1.toml");
  expect(sortFiles(files("a.toml", "b.toml", "part")).machine).toBe(undefined);
  expect(sortFiles(files("chordal.toml", "part")).machine).toBe(undefined);
  expect(sortFiles(files("a.toml")).program).toBe(undefined);
});

test("a name is one that a file can have", () => {
  expect(nameOf("C:\\parts\\O1.nc")).toBe("O1.nc");
  expect(nameOf("../../etc/passwd")).toBe("passwd");
  expect(nameOf("..")).toBe("program.nc");
  expect(nameOf("")).toBe("program.nc");
  expect(nameOf("a\u0000\nb<x>.nc")).toBe("abx.nc");
  expect(nameOf("x".repeat(500)).length).toBe(120);
});

test("a file that is too large is refused with its size", () => {
  expect(sizeComplaint("a.nc", MAX_PROGRAM_BYTES)).toBe(undefined);
  expect(sizeComplaint("a.nc", 700 * 2 ** 20)).toMatch(/a\.nc has 700 MiB; this page takes up to 256 MiB/);
});

test("a second program of the same name can be told from the first", () => {
  expect(distinctName("part.nc", "part.nc")).toBe("part (2).nc");
  expect(distinctName("O1", "O1")).toBe("O1 (2)");
  expect(distinctName("new.nc", "part.nc")).toBe("new.nc");
});
