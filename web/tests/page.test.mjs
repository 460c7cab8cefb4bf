// The page in a real browser: what a user sees and does.

import assert from "node:assert/strict";
import { test } from "node:test";
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ROOT, picture, session } from "./browser.mjs";

const PROFILE = join(ROOT, "examples/fadal/profile-g18.nc");

const tests = session();

async function show(file, ...more) {
  return tests.open(file, ...more);
}

/** A copy that a test may write to. */
function copy(file) {
  const folder = mkdtempSync(join(tmpdir(), "chordal-page-"));
  const path = join(folder, "part.nc");
  copyFileSync(file, path);
  return { path, remove: () => rmSync(folder, { recursive: true, force: true }) };
}

const line = (page) => page.evaluate(() => window.chordal.editor.line);

/** The middle of a row of the path, on the page. */
function placeOfRow(page, row, share = 0.5) {
  return page.evaluate(([row, share]) => {
    const { view, path } = window.chordal;
    const [x, y] = view.project(path().pointOn(row, share));
    const box = document.querySelector("canvas.path").getBoundingClientRect();
    return { x: box.x + x, y: box.y + y };
  }, [row, share]);
}

test("program and path are shown, and nothing complains", async () => {
  const { page, complaints } = await show(PROFILE);
  assert.match(await page.locator(".cm-content").innerText(), /X-2\.9928 Z-\.952 I-\.48 K\.8314 G2/);
  assert.equal(await page.evaluate(() => window.chordal.path().rows > 5), true);
  await page.waitForFunction(() => window.chordal.setpoints());
  await picture(page, "profile");
  assert.deepEqual(complaints, []);
  await page.close();
});

test("a click on the path goes to its line, and the line's path is marked", async () => {
  const { page } = await show(PROFILE);
  const row = await page.evaluate(() => window.chordal.path().rowsOfLine(10)[0]);
  const { x, y } = await placeOfRow(page, row);
  await page.mouse.click(x, y);
  assert.equal(await line(page), 10);
  await page.locator("#tab-state").click();
  await page.waitForFunction(() => document.querySelector("#panel-state").innerText.includes("ZX"));
  const state = await page.locator("#panel-state").innerText();
  assert.match(state, /arc/);
  assert.match(state, /20 in\/min/);
  await picture(page, "line-to-path");
  // And back: the cursor on another line marks another piece.
  await page.locator(".cm-line").nth(11).click();
  assert.equal(await line(page), 12);
  await page.waitForFunction(() => /X 0\.0000 +Y/.test(document.querySelector("#panel-state").innerText));
  await page.close();
});

test("an edit makes an error and clears it, and only a save writes the file", async () => {
  const { path, remove } = copy(PROFILE);
  const { page } = await show(path, "--machine", "fadal-4020");
  const before = readFileSync(path, "utf8");
  await page.locator(".cm-line").nth(9).click();
  await page.keyboard.press("End");
  // The end of the line is `G2`: as a Fadal without a plane in force the arc no longer fits.
  await page.locator(".cm-line").nth(5).click();
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+End");
  await page.keyboard.type("(G18)");
  await page.waitForFunction(() => document.querySelector("#counts").classList.contains("bad"));
  await page.waitForSelector(".cm-lintRange-error");
  await picture(page, "error");
  assert.match(await page.locator("#panel-problems").innerText(), /error/);
  await page.locator(".problem.error").first().click();
  assert.equal(readFileSync(path, "utf8"), before);
  assert.match(await page.locator(".dirty").innerText(), /Not saved/);
  // Undo mends it.
  await page.locator(".cm-content").click();
  for (let times = 0; times < 12; times++) await page.keyboard.press("Control+z");
  await page.waitForFunction(() => !document.querySelector("#counts").classList.contains("bad"));
  await page.keyboard.press("Control+End");
  await page.keyboard.type("(DONE)");
  assert.equal(readFileSync(path, "utf8"), before);
  assert.equal(await tests.save(page, path), before + "(DONE)");
  assert.equal(await page.locator(".dirty").innerText(), "");
  if (!tests.isStandalone) await followsTheFile(page, path, before);
  await page.close();
  remove();
});

/** Somebody else writes the file. */
async function followsTheFile(page, path, text) {
  writeFileSync(path, text);
  await page.waitForFunction(() => !document.querySelector(".cm-content").innerText.includes("DONE"));
}

test("the motion plays in planned time, and steps by block", async () => {
  const { page } = await show(PROFILE);
  await page.waitForFunction(() => window.chordal.setpoints());
  await page.locator("#play").click();
  await page.waitForFunction(() => window.chordal.timeline.time > 0.4);
  await page.locator("#play").click();
  const stopped = await page.evaluate(() => window.chordal.timeline.time);
  assert.ok(stopped < 5, `at 1× it was after ${stopped} s`);
  await page.getByRole("button", { name: /Next block/ }).click();
  const first = await line(page);
  await page.getByRole("button", { name: /Next block/ }).click();
  assert.ok((await line(page)) > first, `${first} ${await line(page)}`);
  await page.locator("#scrubber").fill("20");
  assert.ok(Math.abs((await page.evaluate(() => window.chordal.timeline.time)) - 20) < 0.5);
  assert.match(await page.locator(".readout").innerText(), /20 in\/min/);
  await picture(page, "playback");
  await page.locator("#tab-times").click();
  assert.match(await page.locator("#panel-times").innerText(), /T2/);
  await picture(page, "times");
  await page.close();
});

test("another machine shows its path and marks what differs", async () => {
  const { page } = await show(join(ROOT, "examples/mitsubishi/cone.nc"));
  const before = await page.evaluate(() => window.chordal.path().rows);
  await page.locator("#machine").selectOption("haas-vf2");
  await page.waitForFunction(() => document.querySelector(".comparison").innerText !== "");
  // The machine before is what it is held against now, as long as one likes.
  assert.match(await page.locator(".comparison").innerText(), /difference/);
  assert.match(await page.locator(".paths").innerText(), /Haas.*\n*.*Mitsubishi/);
  assert.ok((await page.locator(".line-differs").count()) > 0);
  await picture(page, "machine");
  assert.ok(before > 0);
  await page.getByRole("button", { name: "Stop comparing" }).click();
  await page.waitForFunction(() => document.querySelectorAll(".line-differs").length === 0);
  assert.equal(await page.locator(".paths").isVisible(), false);
  await page.close();
});

test("the slider draws chords, fewer with a larger tolerance", async () => {
  const { page } = await show(PROFILE);
  await page.locator("#chords").check();
  const chords = async () => {
    await page.waitForFunction(() => /chord/.test(document.querySelector(".chord-text").innerText));
    return Number(/([\d,]+) chord/.exec(await page.locator(".chord-text").innerText())[1].replace(",", ""));
  };
  const set = async (value) => {
    await page.locator("#tolerance").fill(value);
    await page.waitForTimeout(400);
    return chords();
  };
  const coarse = await set("0.5");
  await picture(page, "chords");
  const fine = await set("-3");
  assert.ok(fine > 5 * coarse, `${coarse} ${fine}`);
  await page.close();
});

test("a control that cuts arcs itself has its own chords", async () => {
  const { page } = await show(join(ROOT, "examples/grbl/sign.nc"));
  await page.locator("#chords").check();
  const chordText = (pattern) => page.waitForFunction(
    (text) => new RegExp(text).test(document.querySelector(".chord-text").innerText), pattern);
  await chordText("0.002 mm: [\\d,]+ chords? on .*chord error 0.00\\d+ mm");
  assert.equal(await page.locator("#tolerance").isVisible(), false);
  await picture(page, "chords-own");
  await page.locator("#own-chords").uncheck();
  await chordText("Tolerance 0.32");
  assert.ok(await page.locator("#tolerance").isVisible());
  await page.close();
  const other = await show(PROFILE);
  await other.page.locator("#chords").check();
  assert.equal(await other.page.locator("#own-chords").isVisible(), false);
  await other.page.close();
});

test("a laser is coloured by power, and nothing else is", async () => {
  const laser = await show(join(ROOT, "examples/grbl/engraving-laser.nc"));
  await laser.page.locator("#color").selectOption("power");
  await laser.page.waitForFunction(() => /S 0[\s\S]*S 600/.test(document.querySelector(".legend").innerText));
  await picture(laser.page, "power");
  await laser.page.close();
  const { page } = await show(PROFILE);
  assert.equal(await page.locator("#color option[value=power]").count(), 0);
  await page.close();
});

test("dark follows the system and the switch", async () => {
  const { page } = await show(PROFILE);
  const back = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  await page.emulateMedia({ colorScheme: "dark" });
  const dark = await back();
  await picture(page, "dark");
  await page.locator("#theme").click();
  assert.notEqual(await back(), dark);
  await page.close();
});

test("programs that are empty, broken or endless show their message", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-page-"));
  const cases = [
    ["empty.nc", "", /no block|nothing/i],
    ["endless.nc", "O1\nN1 G1 X1. F100.\nX0\nGOTO 1\nM30\n", /endless|budget|blocks/i],
    ["broken.nc", "G20\nG1 X1.. Y) F\n@@@\n", /error/],
  ];
  for (const [name, text, message] of cases) {
    const path = join(folder, name);
    writeFileSync(path, text);
    const { page } = await show(path, "--machine", "fanuc-30i");
    assert.match(await page.locator("#panel-problems").innerText(), message);
    await picture(page, name.replace(".nc", ""));
    await page.close();
  }
  rmSync(folder, { recursive: true, force: true });
});

test("a distance between two places of the path is told in the program's units", async () => {
  const { page } = await show(PROFILE);
  await page.locator("#measure").click();
  const row = await page.evaluate(() => window.chordal.path().rowsOfLine(10)[0]);
  for (const share of [0, 1]) {
    const { x, y } = await placeOfRow(page, row, share);
    await page.mouse.click(x, y);
  }
  // From X-3.4585 Z-1.618 to X-2.9928 Z-.952.
  const text = await page.locator(".measured").innerText();
  assert.match(text, /^0\.8127 in/);
  assert.match(text, /X 0\.4657 +Y 0 +Z 0\.666 in/);
  await picture(page, "measure");
  await page.locator("#measure").click();
  assert.equal(await page.locator(".measured").innerText(), "");
  await page.close();
});

test("a section shows the lines, the tool or the depth that is chosen", async () => {
  const { page } = await show(join(ROOT, "examples/haas/drilled-plate.nc"));
  const visible = (row) => placeOfRow(page, row).then(({ x, y }) =>
    page.evaluate(([x, y]) => {
      const box = document.querySelector("canvas.path").getBoundingClientRect();
      return window.chordal.view.pick(x - box.x, y - box.y)?.row ?? null;
    }, [x, y]));
  const rows = await page.evaluate(() => window.chordal.path().rows);
  const cut = await page.evaluate((rows) => {
    for (let row = rows - 1; row > 0; row--) {
      const [batch, at] = window.chordal.path().find(row);
      if ((batch.kind[at] & 0x1f) === 0x11) return row;
    }
    return 0;
  }, rows);
  assert.notEqual(await visible(cut), null);
  await page.locator(".section summary", { hasText: "Section" }).click();
  await page.getByLabel("Last line").fill("3");
  await page.waitForTimeout(100);
  assert.equal(await visible(cut), null);
  await picture(page, "section");
  await page.getByRole("button", { name: "Show all" }).click();
  assert.notEqual(await visible(cut), null);
  await page.getByLabel("Lowest depth").fill("999");
  await picture(page, "section-depth");
  await page.keyboard.press("Escape");
  await page.close();
});

test("everything is reached by the keyboard", async () => {
  const { page } = await show(PROFILE);
  await page.waitForFunction(() => window.chordal.setpoints());
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("1");
  const top = await page.evaluate(() => window.chordal.view.axes());
  assert.ok(Math.abs(top[0][0] - 1) < 1e-3 && Math.abs(top[1][1] - 1) < 1e-3, "X is right and Y is up");
  await page.keyboard.press("2");
  const front = await page.evaluate(() => window.chordal.view.axes());
  assert.ok(Math.abs(front[0][0] - 1) < 1e-3 && Math.abs(front[2][1] - 1) < 1e-3, "X is right and Z is up");
  await page.keyboard.press(".");
  assert.ok((await page.evaluate(() => window.chordal.timeline.time)) > 0);
  const reached = new Set();
  for (let times = 0; times < 60; times++) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.textContent.slice(0, 12)));
  }
  for (const id of ["save", "machine", "theme", "tab-problems", "color", "measure", "chords", "play", "scrubber"]) {
    assert.ok(reached.has(id), `${id}: ${[...reached]}`);
  }
  await page.close();
});

test("an accessibility check finds nothing serious, light and dark", async () => {
  const axe = readFileSync(join(ROOT, "web/node_modules/axe-core/axe.min.js"), "utf8");
  const { page } = await show(PROFILE, "--as", "fadal-4020", "--as", "haas-vf2");
  await page.locator("#tab-compare").click();
  await page.waitForSelector(".verdict.different");
  await page.evaluate(axe);
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    for (const panel of ["problems", "state", "times", "compare"]) {
      await page.locator(`#tab-${panel}`).click();
      const { violations } = await page.evaluate(() => window.axe.run());
      const serious = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
      const texts = serious.map(({ id, nodes }) => `${colorScheme} ${id}: ${nodes.map(({ html }) => html).join(" ").slice(0, 300)}`);
      assert.deepEqual(texts, []);
    }
  }
  await page.close();
});

test("words have colours, a hover tells what one does, the outline goes to a tool", async () => {
  const { page } = await show(join(ROOT, "examples/haas/drilled-plate.nc"));
  await page.waitForSelector(".word-gcode");
  const color = (name) => page.evaluate((name) => getComputedStyle(document.querySelector(name)).color, name);
  assert.notEqual(await color(".word-gcode"), await color(".word-comment"));
  await page.locator(".word-gcode", { hasText: "G83" }).first().hover();
  await page.waitForSelector(".cm-tooltip .meaning");
  const meaning = await page.locator(".cm-tooltip .meaning").innerText();
  assert.match(meaning, /peck/i);
  await picture(page, "hover");
  await page.mouse.move(900, 300);
  await page.locator("#tab-outline").click();
  await page.waitForSelector(".entry.tool");
  await picture(page, "outline");
  await page.locator(".entry.tool", { hasText: "T2" }).first().click();
  assert.equal(await line(page), 19);
  // Colours stay right while a line is typed before them.
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("(NEW)\n");
  await page.waitForFunction(() => [...document.querySelectorAll(".word-comment")].some((word) => word.innerText === "(NEW)"));
  await page.close();
});

test("a call leads to its program", async () => {
  const { page } = await show(join(ROOT, "examples/haas/local-calls.nc"));
  const call = await page.evaluate(() => {
    const { doc } = window.chordal.editor.view.state;
    for (let at = 1; at <= doc.lines; at++) if (/M97 *P/.test(doc.line(at).text)) return at;
    return 0;
  });
  assert.ok(call > 0);
  await page.evaluate((call) => {
    const { editor } = window.chordal;
    const text = editor.view.state.doc.line(call).text;
    editor.goTo(call, text.indexOf("P") + 1, true);
  }, call);
  await page.keyboard.press("F12");
  await page.waitForFunction((call) => window.chordal.editor.line !== call, call);
  await page.close();
});

test("a call into another file shows that file, to be read", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-page-"));
  const path = join(folder, "part.nc");
  writeFileSync(path, "%\nO1\nG21 G90 S900 M3\nG0 X0 Y0 Z5.\nM98 P77\nM30\n%\n");
  writeFileSync(join(folder, "O77.nc"), "%\nO77 (A SQUARE)\nG1 Z-1. F100.\nX10.\nY10.\nG0 Z5.\nM99\n%\n");
  const { page, complaints } = await show(path, "--machine", "haas-vf2");
  await page.locator(".cm-line").nth(4).click();
  await page.keyboard.press("End");
  await page.keyboard.press("F12");
  await page.waitForSelector(".other-file:not([hidden])");
  assert.match(await page.locator(".other-file h2").innerText(), /O77\.nc/);
  assert.match(await page.locator(".other-file .cm-activeLine").innerText(), /O77 \(A SQUARE\)/);
  await page.keyboard.type("X");
  assert.doesNotMatch(await page.locator(".other-file .cm-content").innerText(), /X.*O77/);
  await picture(page, "other-file");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".other-file").isVisible(), false);
  assert.equal(await line(page), 5);
  assert.deepEqual(complaints, []);
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});

/** A thread of two turns and three flats about a bar of 40 mm. */
const ROUND =
  "%\nO1 (ABOUT A BAR)\nT1 M6\nG21 G90 G54 S3000 M3\nG0 X0 Y0 Z25. A0\nG1 Z20. F300.\nX20. A720. F2000.\n" +
  "G0 Z25.\nG0 X30. A0\nG1 Z18. F300.\nX45. Y5.\nG0 Z25.\nA120. X30. Y0\nG1 Z18.\nX45. Y5.\nG0 Z25.\n" +
  "A240. X30. Y0\nG1 Z18.\nX45. Y5.\nG0 Z25.\nM30\n%\n";

test("a rotary table turns the part: the path lies about it, and the tool stands to it", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-page-"));
  const path = join(folder, "round.nc");
  writeFileSync(path, ROUND);
  const { page, complaints } = await show(path, "--machine", "haas-vf2");
  await page.waitForFunction(() => window.chordal.setpoints());
  // Every place of the thread is 20 mm from the axis, all around it.
  const thread = await page.evaluate(() => {
    const own = window.chordal.path();
    const row = own.rowsOfLine(7)[0];
    return [0, 0.125, 0.25, 0.375, 0.5, 1].map((share) => own.pointOn(row, share).map((v, axis) => v + own.origin[axis]));
  });
  for (const [, y, z] of thread) assert.ok(Math.abs(Math.hypot(y, z) - 20) < 0.02, `${y} ${z}`);
  const [start, quarter, half] = thread;
  assert.ok(start[2] > 19.9 && quarter[1] < -19.9 && half[2] < -19.9, JSON.stringify(thread));
  // In playback the tool points away from the axis, wherever it is.
  const time = await page.evaluate(() => {
    const { setpoints } = window.chordal;
    const points = setpoints();
    let at = 0;
    while (points.rotaryAngles[3 * at] < (5 * Math.PI) / 2) at++;
    return at * points.periodS;
  });
  await page.evaluate((seconds) => window.chordal.timeline.seek(seconds), time);
  const tool = await page.evaluate(() => window.chordal.view.toolPose());
  assert.ok(tool.up[1] < -0.95 && tool.at[1] < -19, JSON.stringify(tool));
  await page.evaluate(() => window.chordal.view.fit());
  // What is read is what the program says.
  assert.match(await page.locator(".readout").innerText(), /Y 0\.000  Z 20\.000 mm  A 45\d\.\d+°/);
  await picture(page, "rotary");
  assert.equal(await page.locator(".turns").isVisible(), false);
  assert.deepEqual(complaints, []);
  await page.close();
  // A machine whose file does not say what A turns: drawn without, and told.
  const plain = await show(path, "--machine", "linuxcnc-mill");
  assert.match(await plain.page.locator(".turns").innerText(), /^What A turns is not known/);
  await picture(plain.page, "rotary-unknown");
  await plain.page.close();
  rmSync(folder, { recursive: true, force: true });
});

test("a long program answers while it loads, and turns at a detail that is soon drawn", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-page-"));
  const path = join(folder, "long.ngc");
  writeFileSync(path, surfacing(200_000));
  const page = await tests.begin(path);
  // How far the run is can be seen, and another panel is chosen meanwhile.
  await page.waitForFunction(() => !document.querySelector(".progress").hidden, null, { polling: "raf" });
  await page.locator("#tab-times").click();
  assert.equal(await page.locator("#tab-times").getAttribute("aria-selected"), "true");
  const complete = () => page.waitForFunction(() => window.chordal.report() && window.chordal.view.isComplete, null, { timeout: 60_000 });
  await complete();
  const drawn = () => page.evaluate(() => window.chordal.view.drawnLines);
  assert.ok((await drawn()) >= 200_000, `${await drawn()} lines`);
  await page.waitForFunction((lines) => window.chordal.editor.view.state.doc.lines === lines, 200_000 + 8);
  // The tool moves over the picture that is there: the path is not drawn anew.
  const isUnchanged = await page.evaluate(async () => {
    const { view } = window.chordal;
    view.placeTool([10, 10, 10]);
    await new Promise((next) => requestAnimationFrame(() => requestAnimationFrame(next)));
    return view.isComplete;
  });
  assert.ok(isUnchanged);
  await picture(page, "long");
  const box = await page.locator("canvas.path").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.evaluate(() => {
    const { view } = window.chordal;
    window.turned = [];
    const drawn = view.onDrawn;
    view.onDrawn = () => {
      if (view.isTurning) window.turned.push(view.drawnLines);
      drawn();
    };
  });
  for (let step = 1; step <= 20; step++) await page.mouse.move(x + 5 * step, y + 2 * step);
  const turned = await page.evaluate(() => window.turned);
  assert.ok(turned.length > 0);
  assert.ok(Math.min(...turned) > 1000 && Math.max(...turned) < 70_000, String(turned));
  await page.mouse.up();
  await complete();
  assert.ok((await drawn()) >= 200_000);
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Passes over a wavy surface: so many lines of a tenth of a millimetre, and eight around them. */
function surfacing(count) {
  const lines = ["G21 G90 G17 G64 P0.01", "T1 M6", "S12000 M3", "G0 X0 Y0 Z5", "G1 Z0.3 F3000"];
  for (let at = 0; at < count; at++) {
    const [row, step] = [Math.floor(at / 1000), at % 1000];
    const x = 0.1 * (row % 2 === 0 ? step : 999 - step);
    const z = 0.6 * Math.sin(0.3 * x) + 0.3 * Math.cos(0.11 * x + 0.05 * row);
    lines.push(`X${x.toFixed(3)}${step === 0 ? `Y${(0.1 * row).toFixed(3)}` : ""}Z${z.toFixed(4)}`);
  }
  return [...lines, "G0 Z5", "M30", ""].join("\n");
}
