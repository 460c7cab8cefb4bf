import { expect, test } from "vitest";
import type { Batch } from "../path/batch";
import { type ColorScale, type Palette, DARK, LIGHT, colorsOf, rampColor, rgb, toolColor } from "./colors";
import { PALE_FRACTION } from "./progress";

type Numbers = number[];

const linear = (part: number) => (part / 255 <= 0.04045 ? part / 255 / 12.92 : ((part / 255 + 0.055) / 1.055) ** 2.4);

/** WCAG: from 1 to 21. */
function contrast(one: Numbers, other: Numbers): number {
  const light = (color: Numbers) => 0.2126 * linear(color[0]!) + 0.7152 * linear(color[1]!) + 0.0722 * linear(color[2]!);
  const [low, high] = [light(one), light(other)].sort((a, b) => a - b) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

/** Who sees a colour: matrices of Machado, Oliveira and Fernandes (2009) for linear light. */
const VISIONS = {
  normal: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
/** The least difference of any two colours, in hundredths of the lightness from black to white. */
const MIN_DIFFERENCE = { normal: 15, protanopia: 9, deuteranopia: 9, tritanopia: 6 };

/** OKLab, times 100, of a colour as that vision perceives it. */
function perceived(color: Numbers, matrix: Numbers[]): Numbers {
  const light = color.map(linear);
  const [r, g, b] = matrix.map((row) => Math.min(1, Math.max(0, row.reduce((sum, part, index) => sum + part * light[index]!, 0)))) as [number, number, number];
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    100 * (0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s),
    100 * (1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s),
    100 * (0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s),
  ];
}

function colorDifference(one: Numbers, other: Numbers, vision: keyof typeof VISIONS): number {
  const [a, b] = [perceived(one, VISIONS[vision]), perceived(other, VISIONS[vision])];
  return Math.hypot(...a.map((value, index) => value - b[index]!));
}

const SHEETS: [string, Palette][] = [["light", LIGHT], ["dark", DARK]];
const VISION_NAMES = Object.keys(VISIONS) as (keyof typeof VISIONS)[];

test.each(SHEETS)("any two tools differ for every eye, and from rapids: %s", (_, palette) => {
  for (const vision of VISION_NAMES) {
    palette.tools.forEach((one, index) => {
      for (const other of palette.tools.slice(index + 1)) {
        expect(colorDifference(rgb(one), rgb(other), vision), `${one} ${other} ${vision}`).toBeGreaterThan(MIN_DIFFERENCE[vision]);
      }
      expect(colorDifference(rgb(one), rgb(palette.rapid), vision), `${one} rapid ${vision}`).toBeGreaterThan(5);
    });
  }
});

test.each(SHEETS)("every line shows on the background: %s", (_, palette) => {
  const { background, rapid, contour, other, chord, measure, difference: differs, toolShape, tools } = palette;
  for (const color of [rapid, contour, other, chord, measure, differs, toolShape, ...tools]) {
    expect(contrast(rgb(color), rgb(background)), color).toBeGreaterThan(3);
  }
  const marks = [palette.mark, palette.markEdge].map((color) => contrast(rgb(color), rgb(background)));
  expect(Math.max(...marks)).toBeGreaterThan(7);
  expect(contrast(rgb(palette.mark), rgb(palette.markEdge))).toBeGreaterThan(7);
  for (let step = 0; step <= 20; step++) expect(contrast(rampColor(palette, step, [0, 20]), rgb(background))).toBeGreaterThan(2.9);
});

test.each(SHEETS)("the ramp goes from one lightness to another, so that it has an order without colours: %s", (_, palette) => {
  for (const vision of VISION_NAMES) {
    const lightness = palette.ramp.map((color) => perceived(rgb(color), VISIONS[vision])[0]!);
    const steps = lightness.slice(1).map((value, index) => value - lightness[index]!);
    expect(Math.min(...steps), vision).toBeGreaterThan(4);
  }
});

test.each(SHEETS)("what is to come is told from what is done, and can still be seen: %s", (_, palette) => {
  const back = rgb(palette.background);
  for (const color of [...palette.tools, ...palette.ramp]) {
    const pale = rgb(color).map((part, index) => back[index]! + (part - back[index]!) * PALE_FRACTION);
    expect(colorDifference(pale, rgb(color), "normal"), color).toBeGreaterThan(15);
    expect(contrast(pale, back), color).toBeGreaterThan(1.25);
  }
});

test("twenty tools have twenty colours", () => {
  for (const [, palette] of SHEETS) {
    const colors = Array.from({ length: 20 }, (_, index) => toolColor(palette, index));
    expect(new Set(colors).size).toBe(20);
  }
});

const batch = { tool: Uint32Array.of(0, 9), feed: Float32Array.of(100, 200) } as Batch;
const lines = { points: Float32Array.of(0, 0, 0, 10, 0, 0, 10, 0, 0, 10, 0, -4), rows: undefined, count: 2 };
const scale: ColorScale = { by: "tool", tools: [9, 0], feeds: [100, 200], depths: [-4, 0], powers: [0, 1000] };

test("a tool has the colour of its place in the order of first cuts, not of its number", () => {
  const colors = colorsOf(LIGHT, scale, batch, lines);
  expect([...colors.slice(0, 3)]).toEqual(rgb(LIGHT.tools[1]!));
  expect([...colors.slice(6, 9)]).toEqual(rgb(LIGHT.tools[0]!));
});

test("by depth each end of a line has the colour of its height", () => {
  const colors = colorsOf(LIGHT, { ...scale, by: "depth" }, batch, lines);
  const [low, high] = [rgb(LIGHT.ramp[0]!), rgb(LIGHT.ramp.at(-1)!)];
  expect([...colors.slice(0, 3)]).toEqual(high);
  expect([...colors.slice(6, 9)]).toEqual(high);
  expect([...colors.slice(9, 12)]).toEqual(low);
});

test("by power a line has the colour of its S, from off to the most", () => {
  const laser = { ...batch, power: Float32Array.of(0, 1000) } as Batch;
  const colors = colorsOf(LIGHT, { ...scale, by: "power" }, laser, lines);
  expect([...colors.slice(0, 3)]).toEqual(rgb(LIGHT.ramp[0]!));
  expect([...colors.slice(9, 12)]).toEqual(rgb(LIGHT.ramp.at(-1)!));
});

test("by feed a line has the colour of its feed", () => {
  const colors = colorsOf(LIGHT, { ...scale, by: "speed" }, batch, lines);
  expect([...colors.slice(0, 3)]).toEqual(rgb(LIGHT.ramp[0]!));
  expect([...colors.slice(9, 12)]).toEqual(rgb(LIGHT.ramp.at(-1)!));
});
