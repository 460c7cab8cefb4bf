import { LineDashedMaterial } from "three";
import { expect, test } from "vitest";
import { someRapids } from "./lod";

test("of many rapids some are drawn, evenly along the path, wherever its parts begin", () => {
  const part = (from: number, count: number) => {
    const points = new Float32Array(6 * count);
    for (let at = 0; at < count; at++) points.set([from + at, 0, 0, from + at, 0, 5], 6 * at);
    const rapids = { points, rows: undefined, count };
    return { batch: { first: from }, lines: { rapids, cuts: { points: new Float32Array(0), rows: undefined, count: 0 } } };
  };
  const drawn = (most: number) => {
    const some = someRapids([part(0, 7), part(7, 0), part(7, 14)], most, new LineDashedMaterial());
    const places = some.geometry.getAttribute("position");
    return Array.from({ length: places.count / 2 }, (_, at) => places.getX(2 * at));
  };
  expect(drawn(7)).toEqual([0, 3, 6, 9, 12, 15, 18]);
  expect(drawn(1000)).toHaveLength(21);
});
