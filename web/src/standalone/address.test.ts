import { describe, expect, test } from "vitest";
import { addressRequest, fileOf, programQuery } from "./address";

const PAGE = "https://shop.example/nc/";

describe("the address of the page", () => {
  test("names a program, what lies next to it, a machine, and the program that it is compared with", () => {
    const found = addressRequest("?program=https://a.example/old/O1.nc&file=sub/O2.nc&file=mine.toml&machine=mine.toml&against=/new/O1.nc", PAGE)!;
    expect(found.program.href).toBe("https://a.example/old/O1.nc");
    expect(found.files.map(({ href }) => href)).toEqual([`${PAGE}sub/O2.nc`, `${PAGE}mine.toml`]);
    expect(found.against?.href).toBe("https://shop.example/new/O1.nc");
    expect(found.machine).toBe("mine.toml");
  });

  test("names nothing unless it names a program", () => {
    for (const search of ["", "?example=haas/thread-mill.nc", "?program=", "?file=O2.nc"]) expect(addressRequest(search, PAGE)).toBeUndefined();
  });

  test("of a kind that no server has is an error with the address", () => {
    for (const text of ["file:///etc/passwd", "javascript:alert(1)", "data:text/plain,G0", "blob:x", "http://", "ftp://a.example/O1.nc"]) {
      expect(() => addressRequest(programQuery(text), PAGE)).toThrow(/is not the address of a program: it begins with https:\/\/ or http:\/\//);
    }
    expect(() => addressRequest("?program=O1.nc&against=file:///x", PAGE)).toThrow("file:///x");
  });

  test("survives characters that addresses give a meaning", () => {
    const text = "https://a.example/a b&c#d?e=ä%20.nc";
    expect(addressRequest(programQuery(text), PAGE)!.program.href).toBe(new URL(text).href);
  });

  test("gives the name of its file", () => {
    const of = (address: string) => fileOf(new URL(address));
    expect(of("https://a.example/x/TEIL%20%C3%84.nc?raw=1")).toBe("TEIL Ä.nc");
    expect(of("https://a.example/%E0%A4%A.nc")).toBe("%E0%A4%A.nc");
    expect(of("https://a.example/..%2F..%2Fpart.nc")).toBe("part.nc");
    expect(of("https://a.example/")).toBe("program.nc");
  });
});
