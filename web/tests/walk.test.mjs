// What a machinist looks for on the page: playback, colours, measures, units, narrow windows.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ROOT, picture, session } from "./browser.mjs";

const HOUSING = join(ROOT, "examples/textbook/switch-housing.nc");
const BRACKET = join(ROOT, "examples/fadal/bracket.nc");
const folder = mkdtempSync(join(tmpdir(), "chordal-walk-"));

const tests = session();

after(() => rmSync(folder, { recursive: true, force: true }));

async function show(file, ...more) {
  const shown = await tests.open(file, ...more);
  await shown.page.waitForFunction(() => window.chordal.report() && window.chordal.setpoints() && window.chordal.view.isComplete);
  return shown;
}

function written(name, text) {
  const path = join(folder, name);
  writeFileSync(path, text);
  return path;
}

const SQUARE = "%\nO1\nG21 G17 G90 G94 G54\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5.\nG1 Z-1. F200.\nX40.\nY30.\nX0\nY0\nG0 Z5.\nM30\n%\n";

const seek = (page, share) => page.evaluate((share) => {
  const { timeline, setpoints } = window.chordal;
  timeline.seek(setpoints().totalS * share);
}, share);

/** How far the picture at a row is from the background at most, of all colours. */
function strengthAt(page, row, share = 0.5) {
  return page.evaluate(async ([row, share]) => {
    const { view, path } = window.chordal;
    const canvas = document.querySelector("canvas.path");
    const copy = document.createElement("canvas");
    const drawn = view.onDrawn;
    // The picture is there until the frame is shown. On a slow machine a frame may show a part of the path.
    await new Promise((done) => {
      view.onDrawn = () => {
        drawn();
        if (!view.isComplete) return void setTimeout(() => view.placeTool(undefined), 20);
        [copy.width, copy.height] = [canvas.width, canvas.height];
        copy.getContext("2d", { willReadFrequently: true }).drawImage(canvas, 0, 0);
        view.onDrawn = drawn;
        done();
      };
      view.placeTool(undefined);
    });
    const scale = canvas.width / canvas.clientWidth;
    const [x, y] = view.project(path().pointOn(row, share)).map((at) => Math.round(at * scale));
    const context = copy.getContext("2d");
    const [r, g, b] = context.getImageData(1, 1, 1, 1).data;
    const { data } = context.getImageData(x - 3, y - 3, 7, 7);
    let most = 0;
    for (let at = 0; at < data.length; at += 4) {
      most = Math.max(most, Math.hypot(data[at] - r, data[at + 1] - g, data[at + 2] - b));
    }
    return most;
  }, [row, share]);
}

/** All of the path is drawn as it was asked for last. */
async function settled(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await page.waitForFunction(() => window.chordal.view.isComplete);
}

const rowOf = (page, line) => page.evaluate((line) => window.chordal.path().rowsOfLine(line)[0], line);

test("what is done has its full colour, what is to come is pale, within one line, too", async () => {
  const { page, complaints } = await show(written("square.nc", SQUARE), "--machine", "haas-vf2");
  const [first, second, third] = [await rowOf(page, 8), await rowOf(page, 9), await rowOf(page, 10)];
  const whole = await strengthAt(page, third);
  // In the middle of the second side.
  const time = await page.evaluate((row) => {
    const { setpoints } = window.chordal;
    const { row: rows, periodS } = setpoints();
    const [from, to] = [rows.indexOf(row), rows.indexOf(row + 1)];
    return ((from + to) / 2) * periodS;
  }, second);
  await page.evaluate((time) => window.chordal.timeline.seek(time), time);
  await page.evaluate(() => window.chordal.view.markRows(undefined));
  const done = await strengthAt(page, first);
  const toCome = await strengthAt(page, third);
  assert.ok(done > 0.9 * whole, `${done} of ${whole}`);
  assert.ok(toCome < 0.5 * whole && toCome > 0.1 * whole, `${toCome} of ${whole}`);
  const [before, after] = [await strengthAt(page, second, 0.25), await strengthAt(page, second, 0.75)];
  assert.ok(before > 0.9 * whole && after < 0.5 * whole, `${before} ${after} of ${whole}`);
  await picture(page, "walk-done");
  // Back at the start, and at the end, nothing is pale.
  for (const share of [0, 1]) {
    await seek(page, share);
    await page.evaluate(() => window.chordal.view.markRows(undefined));
    assert.ok((await strengthAt(page, third)) > 0.9 * whole);
  }
  assert.deepEqual(complaints, []);
  await page.close();
});

test("of a long path the picture that is kept follows what is done", async () => {
  const lines = [SQUARE.slice(0, SQUARE.indexOf("X40."))];
  for (let at = 0; at < 12_000; at++) lines.push(`X${((at % 100) + Math.sin(at)).toFixed(3)} Y${(at / 100).toFixed(3)}`);
  const { page } = await show(written("long.nc", `${lines.join("\n")}\nM30\n%\n`), "--machine", "haas-vf2");
  // On any machine the path is too long for one frame, however fast that has become: a picture is kept, with edges
  // that are not smoothed.
  await page.evaluate(() => Object.assign(window.chordal.view.painter.slices, { lines: 8_000, took: () => {} }));
  // Sparse places, so that no other line crosses them.
  await page.evaluate(() => window.chordal.view.setView("top"));
  await settled(page);
  const strength = async (line) => strengthAt(page, await rowOf(page, line));
  const whole = await strength(9_000);
  await seek(page, 0.4);
  await settled(page);
  await page.evaluate(() => window.chordal.view.markRows(undefined));
  const pale = await strength(9_000);
  assert.ok(pale < 0.6 * whole, `${pale} of ${whole}`);
  // On from there: only what is done now is drawn anew.
  await page.evaluate(() => {
    const { timeline, setpoints } = window.chordal;
    for (let share = 0.4; share < 0.95; share += 0.005) timeline.seek(setpoints().totalS * share);
  });
  await settled(page);
  await page.evaluate(() => window.chordal.view.markRows(undefined));
  assert.ok((await strength(9_000)) > 0.9 * whole);
  assert.ok((await strength(11_990)) < 0.6 * whole);
  await page.close();
});

test("what is active follows the line that plays", async () => {
  const { page } = await show(HOUSING);
  await page.locator("#tab-state").click();
  await page.getByRole("button", { name: /Faster/ }).click({ clickCount: 2 });
  await page.locator("#play").click();
  const lines = await page.evaluate(async () => {
    const visible = new Set();
    const { timeline, setpoints } = window.chordal;
    while (timeline.isPlaying && visible.size < 3) {
      await new Promise((next) => setTimeout(next, 30));
      const cell = document.querySelector("#panel-state td");
      if (cell) visible.add(Number(cell.innerText.replace(",", "")));
      timeline.seek(timeline.time + setpoints().totalS / 60);
    }
    return [...visible];
  });
  assert.ok(lines.length >= 3, String(lines));
  await page.locator("#play").click();
  await page.waitForFunction(() => Number(document.querySelector("#panel-state td").innerText) === window.chordal.editor.line);
  await page.close();
});

test("the program pane is never blank while a long program plays fast", async () => {
  const lines = [SQUARE.slice(0, SQUARE.indexOf("X40."))];
  // Short moves, so that each frame is hundreds of lines further.
  for (let at = 0; at < 12_000; at++) lines.push(`X${at % 2 === 0 ? 1 : 0}. F2000.`);
  const { page } = await show(written("many.nc", `${lines.join("\n")}\nM30\n%\n`), "--machine", "haas-vf2");
  for (let times = 0; times < 5; times++) await page.getByRole("button", { name: /Faster/ }).click();
  assert.match(await page.locator(".rate").innerText(), /200×/);
  await page.locator("#play").click();
  const fewest = await page.evaluate(async () => {
    const { timeline } = window.chordal;
    let fewest = Infinity;
    const from = timeline.time;
    for (let frame = 0; frame < 40; frame++) {
      await new Promise((next) => requestAnimationFrame(next));
      const pane = document.querySelector(".code .cm-scroller").getBoundingClientRect();
      const visible = [...document.querySelectorAll(".code .cm-line")].filter((line) => {
        const box = line.getBoundingClientRect();
        return box.bottom > pane.top && box.top < pane.bottom;
      });
      fewest = Math.min(fewest, visible.length);
    }
    return timeline.time > from ? fewest : -1;
  });
  assert.ok(fewest > 10, `${fewest} lines in sight`);
  await page.close();
});

test("play and pause are drawn signs, not letters of a font", async () => {
  const { page } = await show(HOUSING);
  const sign = () => page.locator("#play svg").getAttribute("data-sign");
  assert.equal(await sign(), "play");
  await page.locator("#play").click();
  assert.equal(await sign(), "pause");
  assert.equal(await page.locator("#play").innerText(), "");
  assert.equal(await page.locator("#play").getAttribute("aria-label"), "Pause (Space)");
  await page.locator("#play").click();
  assert.equal(await sign(), "play");
  await page.close();
});

test("the tool has its own diameter, and the picture does not lie under the legend", async () => {
  const { page } = await show(HOUSING);
  const width = (line) => page.evaluate((line) => {
    window.chordal.editor.goTo(line);
    const { timeline, setpoints, path, view } = window.chordal;
    const row = path().rowsOfLine(line)[0];
    const at = setpoints().row.findIndex((own) => own >= row);
    timeline.seek((at + 0.5) * setpoints().periodS);
    return view.toolPose().width;
  }, line);
  assert.ok(Math.abs((await width(84)) - 25.4) < 1e-6);
  const legend = await page.locator(".legend").innerText();
  assert.match(legend, /T1 Ø1 in flat/);
  assert.match(legend, /T2 Ø0\.177 in drill/);
  const [key, canvas] = [await page.locator(".strip").boundingBox(), await page.locator("canvas.path").boundingBox()];
  assert.ok(key.y + key.height <= canvas.y + 0.5, JSON.stringify([key, canvas]));
  await page.close();
});

test("every tool has a colour of its own, also T1 and T9", async () => {
  const text = ["%", "O1", "G21 G17 G90 G94 G54"];
  for (let tool = 1; tool <= 12; tool++) text.push(`T${tool} M6`, "S1000 M3", `G0 X0 Y${tool}. Z5.`, "G1 Z-1. F200.", "X40.", "G0 Z5.");
  const { page } = await show(written("tools.nc", `${text.join("\n")}\nM30\n%\n`), "--machine", "haas-vf2");
  for (const scheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: scheme });
    const colors = await page.locator(".legend .swatch").evaluateAll((all) => all.map((one) => one.style.background));
    assert.equal(colors.length, 12);
    assert.equal(new Set(colors).size, 12);
  }
  await picture(page, "walk-tools");
  await page.close();
});

test("cuts are coloured by depth and by feed, with the ends of the scale and their units", async () => {
  // Both work offsets are given, so that the holes lie where the pockets do.
  const offsets = ["E1", "E7"].flatMap((name) => ["X", "Y", "Z"].flatMap((axis) => ["--set", `work_offsets.${name}.${axis}=0 in`]));
  const { page } = await show(BRACKET, ...offsets);
  await page.locator("#color").selectOption("depth");
  assert.match(await page.locator(".legend").innerText(), /Z -0\.6 in\s+Z 0 in/);
  await picture(page, "walk-depth");
  await page.locator("#color").selectOption("speed");
  assert.match(await page.locator(".legend").innerText(), /8 in\/min\s+30 in\/min/);
  await page.locator("#color").selectOption("tool");
  assert.match(await page.locator(".legend").innerText(), /T1/);
  await page.close();
});

test("nothing is cut off in narrow windows", async () => {
  const { page } = await show(written("plain.nc", SQUARE.replace("T1 M6\n", "")), "--machine", "haas-vf2", "--set", "axes.X.travel=[\"-1 mm\", \"0 mm\"]");
  const other = await show(written("nobody.nc", "G21 G90\nG0 X0 Y0 Z5.\nG1 Z-1. F200.\nX10.\nG2 X20. Y3. I1. J0.\n"));
  for (const shown of [page, other.page]) {
    for (const [width, height] of [[800, 600], [1024, 768], [1440, 900]]) {
      await shown.setViewportSize({ width, height });
      await seek(shown, 0.5);
      const cut = await shown.evaluate(() => {
        const found = [];
        for (const part of document.querySelectorAll(".top *, .bar *, .strip *, .tab-row *, .transport *")) {
          const box = part.getBoundingClientRect();
          if (box.width === 0 || part.closest(".choices, svg, select, .sr")) continue;
          const pane = part.closest(".left, .right, .top").getBoundingClientRect();
          const style = getComputedStyle(part);
          const isCut = style.overflow !== "visible" && part.scrollWidth > part.clientWidth + 1 && part.clientWidth > 0;
          if (isCut || box.right > pane.right + 1 || box.left < pane.left - 1) found.push(`${part.className || part.tagName}: ${part.textContent}`);
        }
        return found;
      });
      assert.deepEqual(cut, [], `${width} wide`);
      assert.match(await shown.locator("#counts").innerText(), /error/);
    }
  }
  const why = await other.page.locator(".why").innerText();
  assert.match(why, /nothing in the text says which control it is for/);
  await picture(other.page, "walk-narrow");
  await page.close();
  await other.page.close();
});

test("a machine that nobody named is a control, not a machine with axes", async () => {
  const { page } = await show(written("nobody.nc", "G21 G90\nG0 X0 Y0 Z5.\nG1 Z-1. F200.\nX10.\n"));
  const text = await page.evaluate(() => `${document.querySelector(".top").innerText} ${document.querySelector("#machine").selectedOptions[0].text}`);
  assert.match(text, /assumed Fanuc: .*; machine not named, its limits are typical/);
  assert.doesNotMatch(`${await page.locator(".why").innerText()} ${await page.locator("#machine option").first().innerText()}`, /five.axis/i);
  await page.close();
});

/** Where a share of a row is on the page. */
const placeOf = (page, row, share) => page.evaluate(([row, share]) => {
  const [x, y] = window.chordal.view.project(window.chordal.path().pointOn(row, share));
  const box = document.querySelector("canvas.path").getBoundingClientRect();
  return [box.x + x, box.y + y];
}, [row, share]);

const MEASURED = "%\nO1\nG21 G17 G90 G94 G54\nS1000 M3\nG0 X0 Y0 Z0\nG1 X60. F200.\nY30.\nX0\nY0\nG0 X20. Y15.\n"
  + "G2 I5. J0 F200.\nG0 X40. Y12.\nG3 I3. J3.\nG0 Z5.\nM30\n%\n";

test("measuring marks what it takes, and finds lines, arcs and the distances between them", async () => {
  const { page } = await show(written("measured.nc", MEASURED), "--machine", "haas-vf2");
  await page.evaluate(() => window.chordal.view.setView("top"));
  await page.locator("#measure").click();
  const measured = page.locator(".measured");
  const rows = { bottom: await rowOf(page, 6), right: await rowOf(page, 7), top: await rowOf(page, 8), ring: await rowOf(page, 11), small: await rowOf(page, 13) };
  const click = async (row, share) => page.mouse.click(...await placeOf(page, row, share));
  // What a click would take is marked before the click.
  await page.mouse.move(...await placeOf(page, rows.bottom, 1));
  await page.waitForFunction(() => window.chordal.view.snapped?.of === "end");
  await page.mouse.move(...await placeOf(page, rows.ring, 0.5));
  await page.waitForFunction(() => window.chordal.view.snapped?.kind === "arc");
  await picture(page, "walk-measure-mark");
  await click(rows.ring, 0.4);
  assert.match(await measured.innerText(), /Arc R 5 mm, Ø 10 mm, 360°, centre X 25 +Y 15 +Z 0 mm/);
  await click(rows.small, 0.3);
  // From 25, 15 to 43, 15.
  assert.match(await measured.innerText(), /^18 mm centre to centre/);
  await picture(page, "walk-measure-centres");
  await click(rows.bottom, 0.3);
  assert.match(await measured.innerText(), /Line, 60 mm long/);
  await click(rows.top, 0.4);
  assert.match(await measured.innerText(), /^30 mm parallel lines/);
  await click(rows.ring, 0.4);
  await click(rows.right, 0.4);
  assert.match(await measured.innerText(), /^35 mm centre to line/);
  await click(rows.bottom, 0);
  await click(rows.right, 0.4);
  assert.match(await measured.innerText(), /^60 mm point to line/);
  await page.keyboard.press("Escape");
  assert.equal(await measured.isVisible(), false);
  await page.close();
});

test("Travel says why it shows nothing, and is quiet where it shows the box", async () => {
  const { page } = await show(written("square.nc", SQUARE), "--machine", "haas-vf2");
  await page.locator("#travel").check();
  assert.match(await page.locator(".travel-why").innerText(), /offsets of .* are not known/);
  await page.locator("#travel").uncheck();
  assert.equal(await page.locator(".travel-why").isVisible(), false);
  await page.close();
  const known = await show(written("square.nc", SQUARE), "--machine", "haas-vf2",
    "--set", "work_offsets.G54.X=-200mm", "--set", "work_offsets.G54.Y=-200mm", "--set", "work_offsets.G54.Z=-300mm");
  await known.page.locator("#travel").check();
  assert.equal(await known.page.locator(".travel-why").isVisible(), false);
  await known.page.close();
});

test("Chords shows the tolerance, how many there are and the chord error", async () => {
  const { page } = await show(written("measured.nc", MEASURED), "--machine", "haas-vf2");
  await page.locator("#chords").check();
  await page.locator("#tolerance").fill("-2");
  await page.waitForFunction(() => /Tolerance 0\.01 mm: \d+ chords on 2 curves/.test(document.querySelector(".chord-text").innerText));
  const error = Number(/chord error (0\.\d+) mm/.exec(await page.locator(".chord-text").innerText())[1]);
  assert.ok(error > 0.005 && error <= 0.01, String(error));
  await page.close();
});

test("an inch program is shown in inch throughout, a metric one in mm", async () => {
  for (const [file, wrong] of [[HOUSING, /\d ?mm\b/], [join(ROOT, "examples/mitsubishi/cone.nc"), /\d in\b(?! \d)/]]) {
    const { page } = await show(file, "--as", "haas-vf2", "--as", "linuxcnc-mill");
    await page.locator("#chords").check();
    await page.waitForFunction(() => /chord|No arcs/.test(document.querySelector(".chord-text").innerText));
    await seek(page, 0.5);
    for (const by of ["tool", "speed", "depth"]) {
      await page.locator("#color").selectOption(by);
      for (const panel of ["problems", "outline", "state", "times", "compare"]) {
        await page.locator(`#tab-${panel}`).click();
        await page.waitForTimeout(60);
        const text = await page.evaluate(() => {
          const program = document.querySelector(".cm-editor").innerText;
          return document.querySelector("#app").innerText.replace(program, "");
        });
        const found = wrong.exec(text);
        assert.equal(found && text.slice(Math.max(0, found.index - 60), found.index + 30), null, `${panel} ${by}`);
      }
    }
    await page.close();
  }
});

test("words between backticks are code in the list, in the tooltip and in the explanation", async () => {
  const { page } = await show(join(ROOT, "tests/suite/fadal/inch-with-pattern-words.nc"), "--machine", "fadal-4020");
  const list = page.locator("#panel-problems");
  assert.ok((await list.locator("code").count()) > 0);
  assert.doesNotMatch(await list.innerText(), /`/);
  await page.locator(".cm-lintRange-warning").first().hover();
  await page.waitForSelector(".cm-tooltip .explained");
  const tooltip = page.locator(".cm-tooltip").first();
  await tooltip.locator("summary").first().click();
  assert.ok((await tooltip.locator("code").count()) > 0);
  assert.doesNotMatch(await tooltip.innerText(), /`/);
  await picture(page, "walk-tooltip");
  await page.close();
});
