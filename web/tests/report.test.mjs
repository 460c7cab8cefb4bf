// The setup sheet of `chordal report` in a real browser: as it is seen, and as it is printed.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { after, before, test } from "node:test";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { CHORDAL, ROOT, browser } from "./browser.mjs";

const OUT = join(ROOT, "target/report");
mkdirSync(OUT, { recursive: true });

/** Programs that between them have everything that a sheet tells. */
const PROGRAMS = {
  housing: ["examples/textbook/switch-housing.nc"],
  plate: ["examples/haas/drilled-plate.nc"],
  thread: ["examples/haas/thread-mill.nc"],
  profile: ["examples/fadal/profile-g18.nc"],
  broken: written("broken.nc", "O11 (BROKEN ARC)\nG20 G17 G40 G90\nG0 X0 Y0 Z.1\nS900 M3\nG1 Z-.1 F5.\n"
    + "G2 X1. Y1. I.4 J0\nX2. Q5.\nG0 Z.1 M5\nM30\n", "haas-vf2"),
  empty: written("empty.nc", "", "haas-vf2"),
  magazine: written("magazine.nc", magazine(), "haas-vf2"),
};

function written(name, text, machine) {
  const path = join(OUT, name);
  writeFileSync(path, text);
  return [path, "--machine", machine];
}

/** Forty tools with long comments: tables that go over pages. */
function magazine() {
  let text = "O4000 (FORTY TOOLS)\nG21 G17 G40 G80 G90\n";
  for (let tool = 1; tool <= 40; tool++) {
    text += `T${tool} M6 (END MILL D=${tool}. FOUR FLUTES, HOLDER HSK63, LENGTH OUTSIDE 55)\nG54 S${1000 + tool} M3\n`
      + `G0 X${tool}. Y0\nG43 H${tool} Z10. M8\nG1 Z-${tool % 7}. F${100 + tool}.\nG2 X${tool + 10}. Y0 R5.\nG0 Z10.\nM1\n`;
  }
  return `${text}M30\n`;
}

let chromium;
const pages = {};

before(async () => {
  for (const [name, [file, ...more]] of Object.entries(PROGRAMS)) {
    const path = join(OUT, `${name}.html`);
    const done = spawnSync(CHORDAL, ["report", file, "-o", path, ...more], { cwd: ROOT, encoding: "utf8" });
    assert.ok(done.status <= 1, done.stderr);
    pages[name] = path;
  }
  chromium = await browser();
});

after(async () => chromium?.stop());

/** Opens a sheet; what it fetches and complains of is noted. */
async function show(name) {
  const page = await chromium.context.newPage();
  const fetched = [];
  const complaints = [];
  page.on("request", (request) => fetched.push(request.url()));
  page.on("console", (message) => complaints.push(message.text()));
  const address = pathToFileURL(pages[name]).href;
  await page.goto(address);
  return { page, complaints, others: () => fetched.filter((url) => url !== address) };
}

test("a sheet fetches nothing, complains of nothing, and is as wide as the window", async () => {
  for (const name of Object.keys(PROGRAMS)) {
    const { page, complaints, others } = await show(name);
    assert.deepEqual([others(), complaints], [[], []], name);
    for (const width of [1280, 400]) {
      await page.setViewportSize({ width, height: 720 });
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name} at ${width}`);
    }
    await page.close();
  }
});

test("a sheet has its place, its tools and its blanks", async () => {
  const { page } = await show("housing");
  assert.equal(await page.locator("h1").innerText(), "O9013");
  assert.deepEqual(await page.locator("#tools ~ .scroll tbody th").allInnerTexts(), ["T1", "T2", "T3", "T4"]);
  assert.ok((await page.locator(".blank").count()) > 0);
  await page.setViewportSize({ width: 1060, height: 1100 });
  await page.screenshot({ path: join(OUT, "housing.png") });
  await page.close();
});

test("tools have the colours of the drawing, on a light page and on a dark one", async () => {
  const { page } = await show("plate");
  const colors = () => page.evaluate(() => ["#view-top-tool-1", "#tools ~ .scroll tbody tr:first-child svg path"]
    .map((name) => getComputedStyle(document.querySelector(name)).stroke));
  await page.emulateMedia({ colorScheme: "light" });
  const light = await colors();
  assert.equal(light[0], light[1]);
  await page.emulateMedia({ colorScheme: "dark" });
  const dark = await colors();
  assert.equal(dark[0], dark[1]);
  assert.notEqual(dark[0], light[0]);
  await page.screenshot({ path: join(OUT, "plate-dark.png"), fullPage: true });
  // Paper is light, whatever the screen is.
  await page.emulateMedia({ colorScheme: "dark", media: "print" });
  assert.deepEqual(await colors(), light);
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  await page.close();
});

test("an accessibility check finds nothing serious, light, dark and narrow", async () => {
  const axe = readFileSync(join(ROOT, "web/node_modules/axe-core/axe.min.js"), "utf8");
  for (const name of Object.keys(PROGRAMS)) {
    const { page } = await show(name);
    await page.evaluate(axe);
    for (const [colorScheme, width] of [["light", 1280], ["dark", 1280], ["light", 400]]) {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 720 });
      const { violations } = await page.evaluate(() => window.axe.run());
      const serious = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
      const texts = serious.map(({ id, nodes }) => `${name} ${colorScheme} ${width} ${id}: ${nodes.map(({ html }) => html).join(" ").slice(0, 300)}`);
      assert.deepEqual(texts, []);
    }
    await page.close();
  }
});

/** Pages of a PDF. */
const pagesOf = (pdf) => pdf.toString("latin1").match(/\/Type\s*\/Page\b/g).length;

test("a sheet is printed on A4 and Letter without cut rows", async () => {
  for (const name of Object.keys(PROGRAMS)) {
    const { page } = await show(name);
    for (const format of ["A4", "Letter"]) {
      const pdf = await page.pdf({ format, path: join(OUT, `${name}-${format}.pdf`) });
      const most = name === "magazine" ? 9 : 4;
      assert.ok(pagesOf(pdf) <= most, `${name} takes ${pagesOf(pdf)} pages of ${format}`);
    }
    // What would be wider than the paper would be scaled or cut: 186 mm are between the margins of A4.
    await page.emulateMedia({ media: "print" });
    await page.setViewportSize({ width: Math.floor(186 / 25.4 * 96), height: 1000 });
    const wide = await page.evaluate(() => [...document.querySelectorAll("table, pre, svg, h1, p")]
      .filter((each) => each.getBoundingClientRect().right > document.body.getBoundingClientRect().right + 1)
      .map((each) => each.outerHTML.slice(0, 80)));
    assert.deepEqual(wide, [], name);
    if (name === "housing") {
      await page.setViewportSize({ width: 760, height: 1075 });
      await page.evaluate(() => (document.body.style.padding = "24px"));
      const picture = join(OUT, "report.png");
      await page.screenshot({ path: picture });
      if (process.env.CHORDAL_DOCS) copyFileSync(picture, join(ROOT, "docs/pictures/report.png"));
    }
    await page.close();
  }
});
