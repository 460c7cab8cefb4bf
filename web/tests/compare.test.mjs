// Two programs in one picture, in a real browser.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ROOT, browser, command, open, picture, serve } from "./browser.mjs";

/** A square with an arc, 0.3 mm deep cuts at two feeds. */
const RELEASED = `%
O1 (RELEASED)
T1 M6
G21 G90 G54 S3000 M3
G0 X0 Y0 Z5.
G1 Z-0.3 F200.
X40. F600.
G3 X50. Y10. I0 J10.
G1 Y40.
X0
Y0
G0 Z5.
M30
%
`;
/** The same, restructured; the arc's end is 0.05 mm off, and a feed is another. */
const RETURNED = `%
O1 (RETURNED)
T1 M6
G21 G90 G54 S3000 M3
G0 Z5.
X0 Y0
G1 Z-.3 F200
N10 X20. F650
N20 X40.
N30 G3 X50. Y10. I0 J10.
N40 G1 X50.05 Y40.
N50 X0
N60 Y0
G0 Z5.
M30
%
`;

let chromium;
let folder;
const servers = [];

before(async () => {
  chromium = await browser();
  folder = mkdtempSync(join(tmpdir(), "chordal-compare-"));
});

after(async () => {
  servers.forEach((server) => server.stop());
  await chromium?.stop();
  rmSync(folder, { recursive: true, force: true });
});

async function show(name, ...more) {
  const files = ["released", "returned"].map((each) => join(folder, `${name}-${each}.nc`));
  writeFileSync(files[0], RELEASED);
  writeFileSync(files[1], RETURNED);
  const server = await serve(files[0], "--against", files[1], "--machine", "haas-vf2", ...more);
  servers.push(server);
  const { page, complaints } = await open(chromium.context, server.url);
  await page.locator("#tab-compare").click();
  await page.waitForSelector(".difference");
  return { page, complaints, files };
}

const line = (page) => page.evaluate(() => window.chordal.editor.line);
const verdict = (page) => page.locator(".verdict").innerText();

/** How many pixels of the canvas have about this colour. */
function pixels(page, [r, g, b]) {
  return page.evaluate(async ([r, g, b]) => {
    const canvas = document.querySelector("canvas.path");
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
    // What is drawn is there until the frame ends.
    await new Promise((done) => {
      window.chordal.view.onDrawn = () => {
        copy.drawImage(canvas, 0, 0);
        done();
      };
      window.chordal.view.placeTool(undefined);
    });
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let at = 0; at < data.length; at += 4) {
      if (Math.abs(data[at] - r) + Math.abs(data[at + 1] - g) + Math.abs(data[at + 2] - b) < 60) count++;
    }
    return count;
  }, [r, g, b]);
}

test("both paths are drawn, each with a switch, and the differences are told as the command tells them", async () => {
  const { page, complaints } = await show("both");
  assert.match(await verdict(page), /^different: 2 differences; the paths are at most 0\.05 mm apart$/);
  const texts = await page.locator(".difference").allInnerTexts();
  assert.equal(texts.length, 2);
  assert.match(texts[0], /^feed/);
  assert.match(texts[0], /lines 7–11[^]*600 mm\/min[^]*lines 8–13[^]*650 mm\/min/);
  assert.match(texts[1], /^path: at most 0\.05 mm apart[^]*lines 9–10[^]*lines 11–12[^]*X50\.05 Y40/);
  assert.match(await page.locator(".notes").innerText(), /Furthest apart at line 9 of both-released\.nc and line 11 of both-returned\.nc/);
  const [own, other] = await page.locator(".paths label").allInnerTexts();
  assert.match(own, /both-released\.nc on Haas/);
  assert.match(other, /both-returned\.nc on Haas/);
  assert.deepEqual(
    await page.evaluate(() => [...document.querySelectorAll(".line-differs")].map((each) => each.innerText)),
    ["X40. F600.", "G3 X50. Y10. I0 J10.", "G1 Y40.", "X0", "Y0"],
  );
  // What is apart is purple, in a dot where it is small; that of a page of the same is not.
  assert.ok((await pixels(page, [0xa3, 0x4f, 0xe0])) > 20);
  // The tool's blue, and near black for the other.
  const [blue, dark] = [[0x00, 0x96, 0xff], [0x11, 0x1a, 0x22]];
  const shown = [await pixels(page, blue), await pixels(page, dark)];
  assert.ok(shown[0] > 100 && shown[1] > 100, String(shown));
  await picture(page, "compare-light");
  await page.locator("#show-other").uncheck();
  assert.equal(await pixels(page, dark), 0);
  await page.locator("#show-other").check();
  await page.locator("#show-own").uncheck();
  const alone = [await pixels(page, blue), await pixels(page, dark)];
  assert.ok(alone[0] === 0 && alone[1] > 100, String(alone));
  assert.deepEqual(complaints, []);
  await page.close();
});

test("a difference goes to its line and shows the place, and keys go on to the next", async () => {
  const { page } = await show("walk");
  await page.locator(".difference .shows").nth(1).click();
  assert.equal(await line(page), 9);
  // The two ends, 0.05 mm apart, are seen as two.
  const ends = await page.evaluate(() => {
    const { view, compare, path } = window.chordal;
    const [a, b] = compare().comparison.differences[1].at_mm;
    const [x, y] = view.project(a.map((value, axis) => value - path().origin[axis]));
    const [u, v] = view.project(b.map((value, axis) => value - path().origin[axis]));
    const { clientWidth, clientHeight } = document.querySelector("canvas.path");
    return { pixels: Math.hypot(x - u, y - v), x, y, clientWidth, clientHeight, a, b };
  });
  assert.ok(ends.pixels > 30, JSON.stringify(ends));
  assert.ok(ends.x > 0 && ends.x < ends.clientWidth && ends.y > 0 && ends.y < ends.clientHeight, JSON.stringify(ends));
  assert.deepEqual([ends.a.slice(0, 2), ends.b.slice(0, 2)], [[50, 40], [50.05, 40]]);
  await picture(page, "compare-place");
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("n");
  assert.equal(await page.locator(".difference.chosen").innerText().then((text) => text.slice(0, 4)), "feed");
  assert.equal(await line(page), 7);
  await page.keyboard.press("p");
  assert.equal(await line(page), 9);
  await page.locator(".cm-content").click();
  await page.keyboard.press("F9");
  assert.equal(await line(page), 7);
  assert.match(await page.locator(".which").innerText(), /^1 of 2$/);
  // The other program's line is read beside.
  await page.locator(".difference .read").nth(1).click();
  await page.waitForSelector(".other-file:not([hidden])");
  assert.match(await page.locator(".other-file .cm-activeLine").innerText(), /^N40 G1 X50\.05 Y40\.$/);
  assert.equal(await page.locator(".other-file .cm-activeLineGutter").count(), 0);
  await page.keyboard.press("Escape");
  await page.close();
});

test("a click on the other path shows its line, to be read", async () => {
  const { page, files } = await show("click");
  writeFileSync(files[1], RETURNED.replace("N20 X40.", "N15 Y-8.\nN20 X40.\nY0"));
  await page.waitForFunction(() => /8 mm/.test(document.querySelector(".verdict").innerText));
  const place = await page.evaluate(() => {
    const { view, path, compare } = window.chordal;
    const other = compare().path;
    const at = other.pointOn(other.rowsOfLine(10)[0], 0.5);
    const [x, y] = view.project(at.map((value, axis) => value + other.origin[axis] - path().origin[axis]));
    const box = document.querySelector("canvas.path").getBoundingClientRect();
    return { x: box.x + x, y: box.y + y };
  });
  await page.mouse.click(place.x, place.y);
  await page.waitForSelector(".other-file:not([hidden])");
  assert.match(await page.locator(".other-file .cm-activeLine").innerText(), /^N20 X40\.$/);
  await page.close();
});

test("the comparison follows what is typed, the tolerance, and the other file", async () => {
  const { page, files } = await show("live");
  await page.locator("#compare-tolerance").fill("0.06");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => /1 difference/.test(document.querySelector(".verdict").innerText));
  await page.locator(".cm-line").nth(6).click();
  await page.keyboard.press("End");
  await page.keyboard.press("Shift+Home");
  await page.keyboard.type("X40. F650.");
  await page.waitForSelector(".verdict.within");
  assert.equal(await verdict(page), "within the tolerance: the paths are at most 0.05 mm apart, 0.06 mm is allowed");
  assert.equal(await page.locator(".difference").count(), 0);
  assert.equal(await page.locator(".line-differs").count(), 0);
  writeFileSync(files[1], readFileSync(files[1], "utf8").replace("X50.05", "X50."));
  await page.waitForSelector(".verdict.same");
  assert.equal(await pixels(page, [0xa3, 0x4f, 0xe0]), 0);
  assert.match(await verdict(page), /^same/);
  rmSync(files[1]);
  await page.waitForFunction(() => /cannot read/.test(document.querySelector(".verdict").innerText));
  await page.close();
});

test("the page can choose a machine of the list, and read no file", async () => {
  const file = join(folder, "secret.toml");
  writeFileSync(file, "control = \"haas\"\nsecret = 4711\n");
  const server = await serve(join(ROOT, "examples/fadal/profile-g18.nc"));
  servers.push(server);
  const { page } = await open(chromium.context, server.url);
  // Another connection than the page's own, which may ask anything.
  const [refused, refusedComparison] = await page.evaluate(async (file) => {
    const live = new WebSocket(new URL("live", location.href).href.replace(/^http/, "ws"));
    const answer = (type) => new Promise((done) => {
      live.addEventListener("message", ({ data }) => {
        if (typeof data === "string" && JSON.parse(data).type === type) done(data);
      });
    });
    await answer("report");
    const refused = answer("refused");
    live.send(JSON.stringify({ request: "machine", name: file }));
    await refused;
    const refusedComparison = answer("compared_program_refused");
    live.send(JSON.stringify({ request: "machine", name: null }));
    live.send(JSON.stringify({ request: "compare_with", other: { machine: file } }));
    return [await refused, await refusedComparison];
  }, file);
  for (const message of [refused, refusedComparison]) {
    assert.match(message, /not a machine of the list/);
    assert.doesNotMatch(message, /4711/);
  }
  await page.close();
});

test("one program on two machines, in the dark", async () => {
  const server = await serve(join(ROOT, "examples/fadal/profile-g18.nc"), "--as", "fadal-4020", "--as", "haas-vf2");
  servers.push(server);
  const { page, complaints } = await open(chromium.context, server.url);
  await page.emulateMedia({ colorScheme: "dark" });
  await page.locator("#tab-compare").click();
  await page.waitForSelector(".difference");
  assert.match(await page.locator(".paths").innerText(), /Fadal[^]*Haas/);
  await picture(page, "compare-dark");
  // Another machine than the command line says, and none.
  await page.locator("#against").selectOption("machine fanuc-30i");
  await page.waitForFunction(() => /Fanuc/.test(document.querySelector(".paths").innerText));
  await page.locator("#against").selectOption("nothing");
  await page.waitForFunction(() => document.querySelectorAll(".difference").length === 0);
  assert.equal(await page.locator(".paths").isVisible(), false);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("a conversion is shown over its source before anything is written, on the machine that it was proved on", async () => {
  const fadal = join(ROOT, "examples/fadal");
  const server = await command("convert", join(fadal, "bracket.nc"), "--machine", join(fadal, "bracket.toml"), "--to", "haas-vf2", "--view");
  servers.push(server);
  const { page, complaints } = await open(chromium.context, server.url);
  await page.locator("#tab-compare").click();
  await page.waitForSelector(".difference");
  // The path is the same, with the tools of the old machine; what differs is of the machines.
  assert.match(await verdict(page), /the paths are the same$/);
  const categories = (await page.locator(".difference .head").allInnerTexts()).sort();
  assert.deepEqual(categories, ["path-mode", "work-offset"]);
  assert.match(await page.locator(".paths").innerText(), /bracket\.nc on Fadal[^]*converted bracket\.nc on Haas/);
  await page.locator(".difference .read").first().click();
  await page.waitForSelector(".other-file:not([hidden])");
  assert.match(await page.locator(".other-file .cm-content").innerText(), /^\(L9601 R0\+20\. R1\+0 R2\+2\. R3\+1\.5\)$/m);
  await picture(page, "compare-convert");
  assert.deepEqual(complaints, []);
  await page.close();
});

test("a transformed program is shown beside its source, as it is", async () => {
  const file = join(folder, "shift.nc");
  writeFileSync(file, RELEASED);
  const server = await command("transform", file, "--machine", "haas-vf2", "--shift", "X5", "--view");
  servers.push(server);
  const { page } = await open(chromium.context, server.url);
  await page.locator("#tab-compare").click();
  await page.waitForSelector(".difference");
  assert.match(await verdict(page), /the paths are at most 5 mm apart$/);
  assert.match(await page.locator(".difference").first().innerText(), /moved by X 5 mm Y 0 mm Z 0 mm/);
  await page.close();
});
