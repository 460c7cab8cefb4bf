// Line, clock, readout and tool are one state: at random moments they agree, and with the setpoints that the command prints.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { after, test } from "node:test";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { CHORDAL, picture, session } from "./browser.mjs";

const MOMENTS = 200;
const SEED = 20240617;
/** Of the setpoints that are compared with, s. */
const PERIOD_S = 0.002;

const tests = session();
const folder = mkdtempSync(join(tmpdir(), "chordal-moments-"));
after(() => rmSync(folder, { recursive: true, force: true }));

const MILL = `%
O1 (MOMENTS)
G21 G17 G40 G80 G90 G94
T1 M6
G54
S3000 M3
G0 X0 Y0
G0 Z25.
G1 Z-2. F300.
X40.
G3 X60. Y20. J20.
G4 P0.5
G1 Y40.
G2 I-10.
G0 Z25.
G0 X80. Y5.
G83 Z-9. R2. Q4. F200.
X90.
G80
G91 G28 Z0
G90 G0 X0 Y0
M30
%
`;

/** With limits of the speed of G96 between the cuts, which part the moves where the spindle reaches them. */
const LATHE = `%
O2 (MOMENTS)
G21 G40 G99
T0101
G50 S1500
G96 S180 M3
G0 X62. Z2.
G0 Z0
G1 X-1.6 F0.2
G50 S900
G0 Z2.
X40.
G1 Z-30.
G50 S2000
G2 X60. Z-40. R10.
G4 U0.5
G1 X64.
G97 S500
G0 X100. Z100.
G28 U0 W0
M30
%
`;

const PROGRAMS = [
  // The lines that move, and the lines after which each axis is known; none again from a line on.
  { name: "mill", axes: ["X", "Y", "Z"], text: MILL, machine: "haas-vf2", factorX: 1, moving: [7, 8, 9, 10, 11, 13, 14, 15, 16, 17, 18, 20, 21], known: { X: [7, 99], Y: [7, 99], Z: [8, 20] } },
  { name: "lathe", axes: ["X", "Z"], text: LATHE, machine: "fanuc-lathe", factorX: 2, moving: [7, 8, 9, 11, 12, 13, 15, 17, 19, 20], known: { X: [7, 20], Z: [7, 20] } },
];

/** Numbers from 0 to 1 that are the same in every run. */
function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** What the command prints: time, X, Y and Z in mm, the line. */
function setpointsOf(file, machine) {
  const text = execFileSync(CHORDAL, ["sample", file, "-m", machine, "--period", `${PERIOD_S * 1000}ms`], { stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 28 });
  const [head, ...rows] = text.toString().trim().split("\n").map((row) => row.split(","));
  const columns = ["time_s", "x_mm", "y_mm", "z_mm", "line"].map((name) => head.indexOf(name));
  // A place that is not known is blank.
  return rows.map((row) => columns.map((column) => (row[column] === "" ? NaN : Number(row[column]))));
}

const between = (a, b, share) => a.map((value, at) => value + (b[at] - value) * share);

/** The place at a time, and how far the tool goes from one setpoint to the next there. */
function placeAt(setpoints, seconds) {
  const exact = Math.min(setpoints.length - 1, seconds / PERIOD_S);
  const at = Math.min(setpoints.length - 2, Math.floor(exact));
  const [one, other] = [setpoints[at].slice(1, 4), setpoints[at + 1].slice(1, 4)];
  return { place: between(one, other, exact - at), step: Math.hypot(...one.map((value, axis) => other[axis] - value)) };
}

/** The last line up to another that moves; the first that moves where there is none. */
const motionOf = (moving, line) => moving.findLast((own) => own <= line) ?? moving[0];

/** What the page shows. */
const shown = (page) => page.evaluate(() => {
  const { view, editor, path, playback } = window.chordal;
  const doc = editor.view.state.doc;
  const now = document.querySelector(".line-now");
  return {
    clock: document.querySelector("#clock").innerText,
    seconds: Number(document.querySelector("#scrubber").value),
    readout: document.querySelector(".readout").innerText,
    tool: view.toolPose(),
    cursor: editor.line,
    marked: now ? doc.lineAt(editor.view.posAtDOM(now)).number : undefined,
    row: path().lineOf(playback().row).line,
  };
});

/** Until the line is marked: the one that was clicked, else that of the path where the tool is; it follows the picture. */
const settled = (page, clicked) => page.waitForFunction((clicked) => {
  const { editor, path, playback } = window.chordal;
  const now = document.querySelector(".line-now");
  const line = clicked ?? path().lineOf(playback().row).line;
  return now && editor.view.state.doc.lineAt(editor.view.posAtDOM(now)).number === line;
}, clicked);

/** `9.43 s` or `1:03.5` in seconds. */
function secondsOf(text) {
  const own = text.split(" / ")[0];
  if (own.endsWith(" s")) return Number(own.slice(0, -2));
  return own.split(":").reduce((sum, part) => 60 * sum + Number(part), 0);
}

for (const { name, axes, text, machine, factorX, moving, known } of PROGRAMS) {
  test(`at ${MOMENTS} random moments of a ${name} program line, clock, readout and tool agree`, async (context) => {
    if (tests.isStandalone) return context.skip("the command prints what this page is compared with");
    const file = join(folder, `${name}.nc`);
    writeFileSync(file, text);
    const setpoints = setpointsOf(file, machine);
    const { page, complaints } = await tests.open(file, "--machine", machine);
    await page.waitForFunction(() => window.chordal.setpoints());
    const total = await page.evaluate(() => window.chordal.setpoints().totalS);
    assert.ok(Math.abs(total - setpoints.at(-1)[0]) < 2 * PERIOD_S, `${total} ${setpoints.at(-1)[0]}`);
    const lines = text.trim().split("\n").length;
    const next = random(SEED);
    const did = {};

    const acts = {
      async scrub() {
        const seconds = next() * total;
        await page.evaluate((seconds) => {
          const scrubber = document.querySelector("#scrubber");
          scrubber.value = String(seconds);
          scrubber.dispatchEvent(new Event("input"));
        }, seconds);
        return {};
      },
      async line() {
        const line = 1 + Math.floor(next() * lines);
        await page.locator(".cm-line").nth(line - 1).click();
        return { line };
      },
      async path() {
        const rows = await page.evaluate(() => window.chordal.path().rows);
        // Rows whose place is not known are not drawn, and others may lie outside the view.
        for (;;) {
          const row = Math.floor(next() * rows);
          const place = await page.evaluate(([row, share]) => {
            const { view, path } = window.chordal;
            const [x, y] = view.project(path().pointOn(row, share));
            const box = document.querySelector("canvas.path").getBoundingClientRect();
            return view.pick(x, y) && x > 0 && y > 0 && x < box.width && y < box.height ? [box.x + x, box.y + y] : undefined;
          }, [row, 0.1 + 0.8 * next()]);
          if (place) return page.mouse.click(...place).then(() => ({}));
        }
      },
      async step() {
        await page.getByRole("button", { name: next() < 0.5 ? /Next block/ : /Previous block/ }).click();
        return {};
      },
    };

    for (let moment = 0; moment < MOMENTS; moment++) {
      const kinds = Object.keys(acts);
      const kind = kinds[Math.floor(next() * kinds.length)];
      did[kind] = (did[kind] ?? 0) + 1;
      const { line } = await acts[kind]();
      await settled(page, line);
      const own = await shown(page);
      const what = `${moment} ${kind} ${line ?? ""}: ${JSON.stringify(own)}`;

      // The clock is that of the scrubber, to its last digit.
      const digits = own.seconds < 10 ? 0.005 : 0.05;
      assert.ok(Math.abs(secondsOf(own.clock) - own.seconds) <= digits + 1e-9, what);

      // The line: of the setpoints about that time. One that was clicked is done: what moved last is done.
      assert.equal(own.marked, own.cursor, what);
      const at = Math.round(own.seconds / PERIOD_S);
      const about = setpoints.slice(Math.max(0, at - 2), at + 3).map((row) => motionOf(moving, row[4]));
      assert.ok(about.includes(motionOf(moving, own.marked)), `${what} ${about}`);
      if (line !== undefined) assert.equal(own.marked, line, what);

      // The readout: a dash where an axis is not known, else the place at that time.
      const { place, step } = placeAt(setpoints, own.seconds);
      const words = axes.map((axis) => new RegExp(`${axis} (\\S+)`).exec(own.readout)?.[1]);
      assert.deepEqual(own.readout.match(/[XYZ](?= )/g), axes, what);
      const isNamed = (axis) => {
        const [from, to] = known[axis];
        // Between two lines either is right.
        return [...new Set(about)].map((own) => {
          if (own < from || own > to) return false;
          return own === from || own === to ? undefined : true;
        });
      };
      words.forEach((word, index) => {
        const axis = "XYZ".indexOf(axes[index]);
        const answers = isNamed(axes[index]);
        if (answers.every((answer) => answer === true)) assert.notEqual(word, "–", `${what} ${axis}`);
        if (answers.every((answer) => answer === false)) assert.equal(word, "–", `${what} ${axis}`);
        if (word === "–") return;
        const factor = axis === 0 ? factorX : 1;
        // Next to a time from which on it is known.
        if (Number.isNaN(step)) return;
        assert.ok(Math.abs(Number(word) / factor - place[axis]) <= step + 0.002, `${what}: ${word} and ${place[axis]}`);
      });

      // The tool stands there; where an axis is not known it is not drawn.
      assert.equal(own.tool.isShown, !words.includes("–"), what);
      if (own.tool.isShown) {
        words.forEach((word, index) => {
          const axis = "XYZ".indexOf(axes[index]);
          const factor = axis === 0 ? factorX : 1;
          assert.ok(Math.abs(Number(word) / factor - own.tool.at[axis]) < 0.001, `${what}: tool`);
        });
      }
    }
    assert.ok(Object.values(did).every((count) => count > 20), JSON.stringify(did));
    await picture(page, `moments-${name}`);
    assert.deepEqual(complaints, []);
    await page.close();
  });
}
