import { expect, it } from "vitest";
import { ViewExtent, corner, longestSide } from "./extent";

it("takes what points take as the view sees them", () => {
  // From the front: X is right, Z is up.
  const front = new ViewExtent([1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1]);
  expect(front.isEmpty).toBe(true);
  front.add([0, 5, 0, 3, -7, 2]);
  expect(front.edges).toEqual([0, 3, 0, 2]);
  front.addBox({ low: [-1, 0, 0], high: [1, 1, 9] });
  expect(front.edges).toEqual([-1, 3, 0, 9]);
});

it("knows boxes", () => {
  const box = { low: [0, 0, 0], high: [1, 2, 3] } as const;
  expect(corner({ low: [...box.low], high: [...box.high] }, 5)).toEqual([1, 0, 3]);
  expect(longestSide({ low: [...box.low], high: [...box.high] }, 7)).toBe(3);
  expect(longestSide(undefined, 7)).toBe(7);
  expect(longestSide({ low: [1, 1, 1], high: [1, 1, 1] }, 7)).toBe(7);
});
