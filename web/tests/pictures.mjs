// Takes the pictures of the page, a setup sheet and a picture file for docs/pictures anew: node tests/pictures.mjs [stock …]

import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { CHORDAL, ROOT, browser, open, serve } from "./browser.mjs";

const OUT = join(ROOT, "docs/pictures");
const PROFILE = join(ROOT, "examples/fadal/profile-g18.nc");
const folder = mkdtempSync(join(tmpdir(), "chordal-pictures-"));
const chromium = await browser();

/** A picture of a page after something was done on it. */
async function take(name, { size: [width, height] = [1280, 720], scheme = "light", program, options = [], act }) {
  const server = await serve(program, ...options);
  const { page } = await open(chromium.context, server.url);
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ colorScheme: scheme });
  await page.waitForFunction(() => window.chordal.report() && window.chordal.setpoints() && window.chordal.view.isComplete);
  await act(page);
  await page.waitForTimeout(600);
  await page.screenshot({ path: join(OUT, `${name}.png`) });
  await page.close();
  server.stop();
}

/** To the time when a share of a line is done. */
const seekLine = (page, line, share) => page.evaluate(([line, share]) => {
  const { path, setpoints, timeline } = window.chordal;
  const [first, last] = path().rowsOfLine(line);
  const { row, periodS } = setpoints();
  const [from, to] = [row.findIndex((own) => own >= first), row.findIndex((own) => own > last)];
  timeline.seek((from + (to - from) * share) * periodS);
}, [line, share]);

async function line() {
  await take("view-line", {
    program: PROFILE,
    act: async (page) => {
      await page.locator("#tab-state").click();
      await page.locator(".cm-line").nth(9).click({ position: { x: 40, y: 8 } });
    },
  });
}

async function mistake() {
  const program = join(folder, "part.nc");
  copyFileSync(PROFILE, program);
  await take("view-mistake", {
    program,
    options: ["--machine", "fadal-4020"],
    act: async (page) => {
      await page.locator(".cm-line").nth(5).click();
      await page.keyboard.press("Home");
      await page.keyboard.press("Shift+End");
      await page.keyboard.type("(G18)");
      await page.waitForSelector(".cm-lintRange-error");
    },
  });
}

async function compare() {
  const text = readFileSync(PROFILE, "utf8");
  const [released, returned] = [join(folder, "released.nc"), join(folder, "returned.nc")];
  writeFileSync(released, text);
  writeFileSync(returned, text.replace("Z-2.56 G1 F20.", "Z-2.36 G1 F25."));
  await take("view-compare", {
    program: released,
    options: ["--against", returned, "--as", "fadal-4020", "--as", "fadal-4020"],
    act: async (page) => {
      await page.locator("#tab-compare").click();
      await page.waitForSelector(".difference");
      await page.evaluate(() => document.activeElement.blur());
      await page.keyboard.press("2");
    },
  });
}

async function rotary() {
  const program = join(folder, "round.nc");
  writeFileSync(program,
    "%\nO1 (ABOUT A BAR)\nT1 M6\nG21 G90 G54 S3000 M3\nG0 X0 Y0 Z25. A0\nG1 Z20. F300.\nX20. A720. F2000.\n" +
    "G0 Z25.\nG0 X30. A0\nG1 Z18. F300.\nX45. Y5.\nG0 Z25.\nA120. X30. Y0\nG1 Z18.\nX45. Y5.\nG0 Z25.\n" +
    "A240. X30. Y0\nG1 Z18.\nX45. Y5.\nG0 Z25.\nM30\n%\n");
  await take("view-rotary", {
    program,
    options: ["--machine", "haas-vf2", "--set", "tools.1.diameter=6mm", "--set", "tools.1.shape=ball"],
    act: (page) => seekLine(page, 7, 0.62),
  });
}

/** A program with several tools, while it plays. */
async function playing() {
  for (const scheme of ["light", "dark"]) {
    for (const size of [[1440, 810], [1024, 720]]) {
      await take(`view-${scheme}-${size[0]}`, {
        size,
        scheme,
        program: join(ROOT, "examples/textbook/switch-housing.nc"),
        act: async (page) => {
          await page.locator("#tab-state").click();
          await seekLine(page, 103, 0.5);
        },
      });
    }
  }
}

async function stock() {
  await take("view-stock", {
    program: join(ROOT, "examples/stock/op1.nc"),
    options: ["--setup", join(ROOT, "examples/stock/op1.toml")],
    act: async (page) => {
      await page.waitForFunction(() => /removed/.test(document.querySelector("#stock").textContent));
      await seekLine(page, 25, 0.5);
      await page.waitForFunction(() => window.chordal.view.isComplete);
    },
  });
}

/** A lathe while it roughs: the page stands wide, so that the bolt is large. */
async function lathe() {
  await take("view-lathe", {
    program: join(ROOT, "examples/fanuc-lathe/bolt.nc"),
    options: ["--setup", join(ROOT, "examples/fanuc-lathe/bolt.toml")],
    act: async (page) => {
      await page.waitForFunction(() => /removed/.test(document.querySelector("#turned").textContent));
      await seekLine(page, 22, 0.62);
      await page.waitForFunction(() => window.chordal.view.isComplete);
    },
  });
}

/** Chips over time, with a limit that the slot does not keep; and what is left in a picture of the command. */
async function engagement() {
  const setup = join(folder, "feeds.toml");
  const feeds = readFileSync(join(ROOT, "examples/stock/feeds.toml"), "utf8");
  writeFileSync(setup, feeds.replace("teeth = 3", 'teeth = 3\nmax_chip = "0.045 mm"'));
  await take("view-engagement", {
    program: join(ROOT, "examples/stock/contour.nc"),
    options: ["--setup", setup],
    act: async (page) => {
      await page.locator("#over-time").selectOption("chip", { timeout: 60_000 });
      await page.evaluate(() => window.chordal.timeline.seek(12));
      await page.waitForFunction(() => window.chordal.view.isComplete);
    },
  });
  for (const [name, picture] of [["op1", "stock-run"], ["tslot", "stock-undercut"]]) {
    const run = ["run", `examples/stock/${name}.nc`, "--setup", `examples/stock/${name}.toml`, "-o", join(OUT, `${picture}.png`)];
    execFileSync(CHORDAL, run, { cwd: ROOT });
  }
}

/** The first page of a setup sheet, and a picture file: their colours are those of the page. */
async function files() {
  const sheet = join(folder, "sheet.html");
  execFileSync(CHORDAL, ["report", join(ROOT, "examples/textbook/switch-housing.nc"), "-o", sheet]);
  const page = await chromium.context.newPage();
  await page.setViewportSize({ width: 760, height: 1075 });
  await page.emulateMedia({ media: "print", colorScheme: "light" });
  await page.goto(pathToFileURL(sheet).href);
  await page.evaluate(() => (document.body.style.margin = "24px"));
  await page.screenshot({ path: join(OUT, "report.png") });
  await page.close();
  execFileSync(CHORDAL, ["run", "thread-mill.nc", "-o", join(OUT, "thread-mill.png")], { cwd: join(ROOT, "examples/haas") });
}

/** All of them, or those that are named. */
const all = { line, mistake, compare, rotary, playing, stock, lathe, engagement, files };
const named = process.argv.slice(2);
for (const [name, each] of Object.entries(all)) if (named.length === 0 || named.includes(name)) await each();
await chromium.stop();
rmSync(folder, { recursive: true, force: true });
