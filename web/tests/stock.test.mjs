// The stock on the page: it is cut as the program plays, forward and backward, and what is touched is listed.

import assert from "node:assert/strict";
import { test } from "node:test";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ROOT, picture, session } from "./browser.mjs";

const PROGRAM = join(ROOT, "examples/stock/op1.nc");
const SETUP = join(ROOT, "examples/stock/op1.toml");

const tests = session();

async function show(program, setup) {
  const opened = await tests.open(program, "--setup", setup);
  const { page } = opened;
  await page.waitForFunction(() => window.chordal.setpoints() && window.chordal.stock.drops()?.count > 0);
  await page.waitForFunction(() => /removed/.test(document.querySelector("#stock").textContent));
  await complete(page);
  return opened;
}

const complete = (page) => page.waitForFunction(() => window.chordal.view.isComplete);
const seek = async (page, seconds) => {
  await page.evaluate((seconds) => window.chordal.timeline.seek(seconds), seconds);
  await complete(page);
};

/** The height of the column at a place of the part, from the top, mm, as it is drawn. */
const heightAt = (page, x, y) => page.evaluate(([x, y]) => {
  const { surface } = window.chordal.view.stock;
  const { low, pitch } = surface.stock;
  const column = (axis, at) => Math.floor((at - low[axis]) / pitch);
  return surface.z[(column(1, y) + 1) * surface.width + column(0, x) + 1];
}, [x, y]);

/** All heights, and who cut them, as one number each. */
const sums = (page) => page.evaluate(() => {
  const { z, slot } = window.chordal.view.stock.surface;
  return [z.reduce((sum, value, at) => (sum * 31 + Math.round(value * 1e4) + at) % 1e9, 7), slot.reduce((sum, value, at) => (sum * 31 + value + at) % 1e9, 7)];
});

test("the stock is cut as the program plays, and is whole again backward", async () => {
  const { page, complaints } = await show(PROGRAM, SETUP);
  // At the beginning the page shows what is left: the pocket, the step and the groove.
  assert.equal(await heightAt(page, 40, 30), -8);
  assert.ok(Math.abs((await heightAt(page, 40, 2)) + 6) < 1e-4);
  assert.ok(Math.abs((await heightAt(page, 50, 50)) + 3) < 0.01);
  const atEnd = await sums(page);
  await picture(page, "stock-left");
  const total = await page.evaluate(() => window.chordal.setpoints().totalS);
  const moments = [0.2, 0.45, 0.8].map((share) => share * total);
  const forward = [];
  for (const moment of moments) {
    await seek(page, moment);
    forward.push(await sums(page));
  }
  await seek(page, moments[1]);
  await picture(page, "stock-playing");
  await seek(page, total);
  assert.deepEqual(await sums(page), atEnd);
  for (const [at, moment] of [...moments.entries()].reverse()) {
    await seek(page, moment);
    assert.deepEqual(await sums(page), forward[at]);
  }
  await seek(page, 0);
  assert.equal(await page.evaluate(() => window.chordal.stock.drops().heights.every((z) => z === 0)), true);
  assert.equal(await heightAt(page, 40, 30), 0);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("a step of playback draws some tiles, not the stock", async () => {
  const { page } = await show(PROGRAM, SETUP);
  const cells = await page.evaluate(() => window.chordal.view.stock.surface.stock.columns.reduce((a, b) => a * b));
  assert.ok(cells > 200_000, `${cells} columns`);
  const triangles = await page.evaluate(async () => {
    const { timeline, view } = window.chordal;
    const drawn = [];
    timeline.seek(9);
    while (!view.isComplete) await new Promise((next) => setTimeout(next, 20));
    const after = view.onDrawn;
    view.onDrawn = () => {
      drawn.push(view.stock.drawnTriangles);
      after();
    };
    for (let step = 1; step <= 30; step++) {
      timeline.seek(9 + step / 30);
      await new Promise((next) => requestAnimationFrame(next));
    }
    view.onDrawn = after;
    return drawn;
  });
  assert.ok(Math.max(...triangles) > 0, String(triangles));
  assert.ok(Math.max(...triangles) < 24_000 + 2 * 32 * 32, String(triangles));
  await page.close();
});

test("colours, a cut through the part, and coarser columns", async () => {
  const { page, complaints } = await show(PROGRAM, SETUP);
  // The tool stands before the part.
  await page.getByLabel("Tool", { exact: true }).uncheck();
  /** A pixel where a place of the part is. */
  const pixel = async (x, y, z) => {
    await complete(page);
    return page.evaluate(async ([x, y, z]) => {
      const { view, path } = window.chordal;
      const [px, py] = view.project([x, y, z].map((value, axis) => value - path().origin[axis]));
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
    }, [x, y, z]);
  };
  const top = [20, 55, 0];
  const step = [20, 12, -6];
  assert.notEqual(await pixel(...top), await pixel(...step));
  const byTool = await pixel(...step);
  await page.locator("#stock summary").click();
  await page.locator("#stock-color").selectOption("depth");
  assert.notEqual(await pixel(...step), byTool);
  assert.equal(await page.locator("#stock-color option[value=deviation]").isDisabled(), true);
  await picture(page, "stock-depth");
  // Cut open along Y in the middle of the part: in front of it there is nothing.
  const background = await pixel(-3, -3, 0);
  await page.locator("#stock-axis").selectOption("y");
  assert.equal(await pixel(5, 5, -6), background);
  await picture(page, "stock-open");
  await page.locator("#stock-axis").selectOption("");
  assert.notEqual(await pixel(5, 5, -6), background);
  // A jaw of the vise, which stands beside the stock.
  const jaw = [40, -18, -15];
  assert.notEqual(await pixel(...jaw), background);
  await page.locator("#stock-fixtures").uncheck();
  assert.equal(await pixel(...jaw), background);
  await page.locator("#stock-shown").uncheck();
  assert.equal(await pixel(...top), background);
  await page.locator("#stock-shown").check();
  await page.locator("#stock-columns").selectOption("60000");
  await page.waitForFunction(() => window.chordal.view.stock.surface.stock.heights.length <= 60_000);
  await page.waitForFunction(() => /removed/.test(document.querySelector("#stock").textContent));
  assert.equal(await heightAt(page, 40, 30), -8);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("what is touched is a problem of its line, and a click shows the stock there", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-stock-"));
  const [program, setup] = [join(folder, "part.nc"), join(folder, "setup.toml")];
  writeFileSync(program, "G21 G90 G17 G54\nT1 M6\nS5000 M3\nG0 X10. Y20. Z5.\nG1 Z-4. F200.\nX30. F600.\nG0 X50.\nZ20.\nM30\n");
  writeFileSync(setup, [
    'machine = "haas-vf2"', "[stock]", 'shape = "box"', 'from = { X = "0 mm", Y = "0 mm", Z = "-20 mm" }',
    'to = { X = "60 mm", Y = "40 mm", Z = "0 mm" }', "[target]", 'shape = "box"', 'from = { X = "0 mm", Y = "0 mm", Z = "-20 mm" }',
    'to = { X = "60 mm", Y = "40 mm", Z = "-3 mm" }', "[tools.1]", 'shape = "flat"', 'diameter = "10 mm"', 'flute_length = "25 mm"', "teeth = 2", 'max_chip = "0.05 mm"', "",
  ].join("\n"));
  const { page } = await show(program, setup);
  const problem = page.locator("#panel-problems .problem", { hasText: "rapid" }).first();
  assert.match(await problem.innerText(), /line 7/i);
  await problem.click();
  assert.equal(await page.evaluate(() => window.chordal.editor.line), 7);
  assert.ok((await page.locator(".cm-lintRange-error").count()) > 0);
  // The rapid cuts nothing: it is what must not be.
  assert.equal(await heightAt(page, 25, 20), -4);
  assert.equal(await heightAt(page, 45, 20), 0);
  await page.locator("#stock summary").click();
  await page.locator("#stock-color").selectOption("deviation");
  await complete(page);
  assert.match(await page.locator("#stock").innerText(), /too deep/);
  await picture(page, "stock-deviation");
  // 600 mm/min, 5000 rev/min and two teeth make chips of 0.06 mm: too thick, and marked so.
  await page.locator("#over-time").selectOption("chip");
  assert.equal(await page.locator("#timeline canvas, .plot canvas").getAttribute("aria-label"), "Chip over time");
  const marked = await page.evaluate(() => {
    const canvas = document.querySelector(".plot canvas");
    const { data } = canvas.getContext("2d").getImageData(0, canvas.height - 1, canvas.width, 1);
    const red = [...getComputedStyle(canvas).getPropertyValue("--error").matchAll(/[0-9a-f]{2}/g)].map(([part]) => parseInt(part, 16));
    return data.filter((value, at) => at % 4 === 0 && value === red[0] && data[at + 1] === red[1]).length / canvas.width;
  });
  assert.ok(marked > 0.1 && marked < 0.9, String(marked));
  // An edit lifts the tool: nothing is touched any more.
  await page.keyboard.press("Escape");
  await page.locator(".cm-line").nth(6).click();
  await page.keyboard.press("Home");
  await page.keyboard.type("G0 Z5.\n");
  await page.waitForFunction(() => /removed/.test(document.querySelector("#stock").textContent) && window.chordal.report());
  await page.waitForFunction(() => !/rapid goes/.test(document.querySelector("#panel-problems").textContent));
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});

test("undercuts are drawn at any moment, and exactly at the end", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-undercut-"));
  const [program, setup] = [join(folder, "part.nc"), join(folder, "setup.toml")];
  const pass = (tool) => `T${tool} M6\nS1000 M3\nG0 X-20. Y0.\nG43 H${tool} Z5.\nG0 Z-12.\nG1 X120. F600.\nG0 Z20.\n`;
  writeFileSync(program, `G21 G90 G17 G54\n${pass(1)}${pass(2)}M30\n`);
  writeFileSync(setup, [
    'machine = "haas-vf2"', "[stock]", 'shape = "box"', 'from = { X = "0 mm", Y = "-30 mm", Z = "-20 mm" }',
    'to = { X = "100 mm", Y = "30 mm", Z = "0 mm" }', "[tools.1]", 'shape = "flat"', 'diameter = "10 mm"', 'flute_length = "25 mm"',
    "[tools.2]", 'shape = "t-slot"', 'diameter = "20 mm"', 'flute_length = "4 mm"', 'shank_diameter = "9 mm"', "",
  ].join("\n"));
  const { page, complaints } = await show(program, setup);
  await page.waitForFunction(() => window.chordal.view.stock.shownPart);
  await complete(page);
  await page.locator("#stock summary").click();
  // In the wall beside the slot there is a gap from 8 to 12 mm down.
  const gap = await page.evaluate(() => {
    const { corners } = window.chordal.view.stock.shownPart;
    const heights = new Set();
    for (let at = 0; at < corners.length; at += 3) if (Math.abs(corners[at + 1] - 9) < 1.1) heights.add(Math.round(corners[at + 2]));
    return [...heights].sort((a, b) => a - b);
  });
  assert.ok(gap.includes(-8) && gap.includes(-12), String(gap));
  await page.keyboard.press("Escape");
  await picture(page, "stock-undercut");
  await page.locator("#stock summary").click();
  await page.locator("#stock-axis").selectOption("x");
  await complete(page);
  await picture(page, "stock-undercut-open");
  await seek(page, 5);
  assert.equal(await page.evaluate(() => window.chordal.view.stock.shownPart === undefined), true);
  assert.equal(await heightAt(page, 90, 0), 0);
  const total = await page.evaluate(() => window.chordal.setpoints().totalS);
  /** The gaps of the column at a place, from the top, mm. */
  const gapsAt = (x, y) => page.evaluate(([x, y]) => {
    const { low, pitch, columns } = window.chordal.view.stock.surface.stock;
    const column = (axis, at) => Math.floor((at - low[axis]) / pitch);
    return window.chordal.stock.gaps().of(column(1, y) * columns[0] + column(0, x)).map((height) => Math.round(height * 10) / 10);
  }, [x, y]);
  // Before the second tool there are none; then they follow it, and are gone again backward.
  assert.deepEqual(await gapsAt(20, 8), []);
  const cutting = await page.evaluate(() => {
    const { timeline, path } = window.chordal;
    const found = path().rows;
    // The moment at which the second tool is in the middle of its pass.
    const total = window.chordal.setpoints().totalS;
    for (let at = total; at > 0; at -= total / 400) {
      timeline.seek(at);
      const { columns } = window.chordal.stock.gaps();
      const count = [...columns].length;
      if (count > 0 && window.chordal.stock.gaps().at < 0.6 * window.chordal.stock.gaps().count) return at;
    }
    return found;
  });
  await seek(page, cutting);
  assert.deepEqual(await gapsAt(2, 8), [-12, -8]);
  assert.deepEqual(await gapsAt(98, 8), []);
  const triangles = await page.evaluate(() => window.chordal.view.stock.drawnTriangles);
  assert.ok(triangles >= 0);
  await picture(page, "stock-undercut-playing");
  await page.locator("#stock-axis").selectOption("");
  await complete(page);
  await picture(page, "stock-undercut-whole");
  await seek(page, 5);
  assert.deepEqual(await gapsAt(2, 8), []);
  await seek(page, total);
  assert.ok(await page.evaluate(() => window.chordal.view.stock.shownPart.triangles) > 50);
  assert.deepEqual(complaints, []);
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});
