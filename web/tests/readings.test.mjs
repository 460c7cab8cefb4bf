// A program that does not name its control: the page asks once how it should be read, with the readings next to each other.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ROOT, picture, session } from "./browser.mjs";

const tests = session();
const folder = mkdtempSync(join(tmpdir(), "chordal-readings-"));
after(() => rmSync(folder, { recursive: true, force: true }));

/** Neither a control nor units are named. */
const UNCLEAR = "G0 X0 Y0 Z5\nG1 Z-1 F100\nX20 Y10\n";

function written(name, text) {
  const path = join(folder, name);
  writeFileSync(path, text);
  return path;
}

const questionShown = (page) => page.waitForSelector(".readings:not([hidden])");
const problems = (page) => page.locator("#panel-problems").innerText();
/** How far the path goes along X, mm. */
const lengthX = (page) => page.evaluate(() => {
  const { low, high } = window.chordal.path().bounds;
  return high[0] - low[0];
});
const pathIs = (page, mm) => page.waitForFunction((mm) => {
  const { bounds } = window.chordal.path();
  return window.chordal.report() && bounds && Math.abs(bounds.high[0] - bounds.low[0] - mm) < 0.01;
}, mm);

test("the readings of an unclear program stand next to each other, and one is picked", async () => {
  const { page, complaints } = await tests.open(written("unclear.nc", UNCLEAR));
  await questionShown(page);
  await page.waitForFunction(() => window.chordal.setpoints());
  const panel = page.getByRole("region", { name: "How should this program be read?" });
  assert.match(await panel.innerText(), /line 1, G0 X0 Y0 Z5/);
  const columns = panel.getByRole("listitem");
  assert.ok((await columns.count()) >= 2);
  assert.match(await columns.first().innerText(), /in inch assumed[^]*508 x 254 x 152\.4 mm[^]*Z 127 mm/);
  assert.equal(await lengthX(page), 508);
  assert.match(await problems(page), /what this program moves depends on its control/);
  const millimetres = columns.filter({ hasText: "20 x 10 x 6 mm" });
  assert.match(await millimetres.innerText(), /in mm/);
  await picture(page, "readings");
  await millimetres.getByRole("button").click();
  await pathIs(page, 20);
  assert.equal(await panel.isVisible(), false);
  assert.doesNotMatch(await problems(page), /depends on its control/);
  const machine = await page.locator("#machine").evaluate((select) => [select.value, select.selectedOptions[0].text]);
  assert.match(machine.join("; "), /^\S+ in mm; .* in mm$/);
  // An answer is no comparison with what was only assumed.
  assert.equal(await page.locator(".paths").isVisible(), false);
  // The recognized machine can still be chosen; that is no second question.
  await page.locator("#machine").selectOption("");
  await pathIs(page, 508);
  assert.equal(await panel.isVisible(), false);
  assert.match(await problems(page), /depends on its control/);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("the assumed reading can be kept by the keyboard, and edits do not ask again", async () => {
  const { page } = await tests.open(written("kept.nc", UNCLEAR));
  await questionShown(page);
  await page.locator(".readings h2").focus();
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.innerText), "Keep the assumed one");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".readings").isVisible(), false);
  assert.equal(await page.evaluate(() => document.activeElement.id), "machine");
  assert.match(await problems(page), /depends on its control/);
  await page.evaluate(() => {
    const { view } = window.chordal.editor;
    view.dispatch({ changes: { from: view.state.doc.length, insert: "X30\n" } });
  });
  await pathIs(page, 762);
  assert.equal(await page.locator(".readings").isVisible(), false);
  await page.close();
});

test("a program that names its units and its control is not asked about", async () => {
  const { page } = await tests.open(join(ROOT, "examples/fadal/profile-g18.nc"));
  assert.equal(await page.locator(".readings").isVisible(), false);
  await page.close();
});

test("the question has nothing serious against it, light and dark, wide and narrow", async () => {
  const axe = readFileSync(join(ROOT, "web/node_modules/axe-core/axe.min.js"), "utf8");
  const { page } = await tests.open(written("axe.nc", UNCLEAR));
  await questionShown(page);
  await page.evaluate(axe);
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    for (const width of [1280, 420]) {
      await page.setViewportSize({ width, height: 720 });
      const { violations } = await page.evaluate(() => window.axe.run());
      const serious = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
      assert.deepEqual(serious.map(({ id, nodes }) => `${colorScheme} ${width} ${id}: ${nodes.map(({ html }) => html).join(" ").slice(0, 300)}`), []);
      await picture(page, `readings-${colorScheme}-${width}`);
    }
  }
  await page.close();
});
