// The stock of a lathe on the page: its half section at every moment, the tool in it, what is touched, and diameters.

import assert from "node:assert/strict";
import { test } from "node:test";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ROOT, picture, session } from "./browser.mjs";

const PROGRAM = join(ROOT, "examples/fanuc-lathe/bolt.nc");
const SETUP = join(ROOT, "examples/fanuc-lathe/bolt.toml");

const tests = session();

async function show(program, setup) {
  const opened = await tests.open(program, "--setup", setup);
  const { page } = opened;
  // So wide that the line of the position never wraps: the picture keeps its size.
  await page.setViewportSize({ width: 1600, height: 800 });
  await page.waitForFunction(() => innerWidth === 1600);
  await page.waitForFunction(() => window.chordal.setpoints() && window.chordal.lathe.sections());
  await page.waitForFunction(() => /removed/.test(document.querySelector("#turned").textContent));
  await complete(page);
  return opened;
}

const complete = (page) => page.waitForFunction(() => window.chordal.view.isComplete);

/** To the time when a share of a line is done. */
const seekLine = (page, line, share) => page.evaluate(([line, share]) => {
  const { path, setpoints, timeline } = window.chordal;
  const [first, last] = path().rowsOfLine(line);
  const { row, periodS } = setpoints();
  const [from, to] = [row.findIndex((own) => own >= first), row.findIndex((own) => own > last)];
  timeline.seek((from + (to - from) * share) * periodS);
}, [line, share]);

/** The colour at a place of the half plane (z, radius), as it is drawn. */
async function pixel(page, z, r) {
  await complete(page);
  return page.evaluate(async ([z, r]) => {
    const { view, path } = window.chordal;
    const { origin } = path();
    const [px, py] = view.project([r - origin[0], -origin[1], z - origin[2]]);
    // What is drawn is gone after the frame: it is read in it.
    return new Promise((done) => {
      const after = view.onDrawn;
      view.onDrawn = () => {
        after();
        view.onDrawn = after;
        const canvas = document.querySelector("canvas.path");
        const gl = canvas.getContext("webgl2");
        const scale = canvas.width / canvas.clientWidth;
        const data = new Uint8Array(4);
        gl.readPixels(Math.round(px * scale), canvas.height - Math.round(py * scale), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, data);
        done([...data.slice(0, 3)].join());
      };
      view.redraw();
    });
  }, [z, r]);
}

/** How much of the half plane is drawn as cut open, pixels. */
const openPixels = (page) => page.evaluate(() => {
  const { part } = window.chordal.view.lathe;
  const copy = new OffscreenCanvas(part.width, part.height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(part, 0, 0);
  const { data } = copy.getImageData(0, 0, part.width, part.height);
  let found = 0;
  for (let at = 3; at < data.length; at += 4) if (data[at] > 64) found++;
  return found;
});

/** The lines and arcs of the section that is shown. */
const shownLines = (page) => page.evaluate(() => {
  const { sections, moment } = window.chordal.view.lathe;
  return sections.piecesOf(moment.number).map((piece) => [...sections.numbers(piece)].join(" ")).sort();
});

test("the half section is cut as the program plays, and is whole again backward", async () => {
  const { page, complaints } = await show(PROGRAM, SETUP);
  const background = await pixel(page, -10, 35);
  // At the beginning the page shows what is left: the shank of diameter 20 and the groove of 16 before it.
  const inside = await pixel(page, -30, 5.3);
  assert.notEqual(inside, background);
  assert.equal(await pixel(page, -20.5, 9.3), background);
  assert.equal(await pixel(page, -12, 9.3), inside);
  await picture(page, "turned-left");
  const moments = [[22, 0.3], [22, 0.7], [38, 0.5], [48, 0.5]];
  const forward = [];
  for (const [line, share] of moments) {
    await seekLine(page, line, share);
    await complete(page);
    forward.push({ lines: await shownLines(page), pixels: await openPixels(page) });
  }
  const pixels = forward.map((each) => each.pixels);
  assert.deepEqual([...pixels].sort((a, b) => b - a), pixels);
  assert.equal(new Set(forward.map(({ lines }) => lines.join())).size, moments.length);
  await picture(page, "turned-playing");
  for (const [at, [line, share]] of [...moments.entries()].reverse()) {
    await seekLine(page, line, share);
    await complete(page);
    assert.deepEqual(await shownLines(page), forward[at].lines);
    // Smoothed edges may differ by some of their pixels.
    assert.ok(Math.abs((await openPixels(page)) - pixels[at]) < 0.001 * pixels[at]);
  }
  await page.evaluate(() => window.chordal.timeline.seek(0));
  await complete(page);
  // The bar, before the first cut.
  assert.ok((await openPixels(page)) > pixels[0]);
  assert.equal((await shownLines(page)).length, 4);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("while a pass is made the part goes where the tool has been", async () => {
  const { page } = await show(PROGRAM, SETUP);
  const sizes = [];
  // The part-off: one move.
  for (const share of [0.2, 0.5, 0.8]) {
    await seekLine(page, 48, share);
    await complete(page);
    sizes.push(await openPixels(page));
  }
  assert.ok(sizes[0] > sizes[1] && sizes[1] > sizes[2], String(sizes));
  const points = await page.evaluate(() => window.chordal.view.lathe.moment.cutting.length);
  assert.equal(points, 2);
  // The tool is drawn with the section, not as a mill.
  assert.equal(await page.evaluate(() => window.chordal.view.tool.object.visible), false);
  await page.close();
});

test("X is said as a diameter, up at a rear turret and down at one in front", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-turned-"));
  const front = join(folder, "front.toml");
  const setup = readFileSync(SETUP, "utf8");
  writeFileSync(front, setup.replace('machine = "fanuc-lathe"', 'machine = "fanuc-lathe"\nturret = "front"'));
  const axes = [];
  for (const own of [SETUP, front]) {
    const { page } = await show(PROGRAM, own);
    axes.push(await page.evaluate(() => window.chordal.view.axes().map((axis) => axis.map((value) => Math.round(value) + 0))));
    await seekLine(page, 45, 1);
    assert.match(await page.locator(".readout").innerText(), /X 16\.000 +Z -22\.000/);
    await picture(page, own === front ? "turned-front" : "turned-rear");
    await page.close();
  }
  assert.deepEqual(axes.map(([x, , z]) => [x, z]), [[[0, 1, 0], [1, 0, 0]], [[0, -1, 0], [1, 0, 0]]]);
  rmSync(folder, { recursive: true, force: true });
});

test("what is touched is a problem of its line and has a mark, and what is shown can be chosen", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-turned-"));
  const program = join(folder, "hit.nc");
  // The finishing tool comes back through the shoulder.
  writeFileSync(program, readFileSync(PROGRAM, "utf8").replace("G0 X100. Z50.\n(T5", "G0 X20. Z-56.\nG0 X100. Z50.\n(T5"));
  const { page } = await show(program, SETUP);
  await page.locator("#panel-problems .problem", { hasText: "rapid" }).first().waitFor();
  const marks = await page.evaluate(() => window.chordal.view.lathe.marks.map(({ line }) => line));
  assert.ok(marks.length > 0, String(marks));
  await page.locator("#turned summary").click();
  assert.match(await page.locator("#turned").innerText(), /problems, see Problems; removed [\d.]+ cm³; 1 part cut off/);
  await picture(page, "turned-problem");
  const jaw = [-90, 40];
  const background = await pixel(page, -10, 45);
  assert.notEqual(await pixel(page, ...jaw), background);
  await page.locator("#turned-fixtures").uncheck();
  assert.equal(await pixel(page, ...jaw), background);
  await page.locator("#turned-stock").uncheck();
  assert.equal(await pixel(page, -30, 5.3), background);
  // How hard the cuts are over time.
  assert.deepEqual(await page.locator("#over-time option").allInnerTexts(), ["Speed", "Depth of cut", "Chip", "Power"]);
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});

test("another machine keeps the tools and the stock, and is compared with the one before", async () => {
  const { page } = await show(PROGRAM, SETUP);
  const sectionState = () => page.evaluate(() => {
    const sections = window.chordal.lathe.sections();
    return { tools: sections && [...sections.tools.keys()].sort((a, b) => a - b), before: sections?.before };
  });
  const before = await sectionState();
  assert.deepEqual(before.tools, [1, 3, 5]);
  await page.locator("#machine").selectOption("haas-lathe");
  await page.waitForFunction(() => document.querySelector(".comparison").innerText !== "");
  await page.waitForFunction(() => window.chordal.report() && window.chordal.lathe.sections());
  assert.deepEqual(await sectionState(), before);
  await complete(page);
  await picture(page, "turned-other-machine");
  await page.close();
});
