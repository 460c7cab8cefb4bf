// Measures a large program, from the command on: `node tests/large.mjs FILE`.
//
// Prints when the first lines of the path were drawn, when all of them were, how long a key press
// waited meanwhile, how long a frame takes while the view turns, what the page holds, and how long it
// was busy without a break. With CHORDAL_STANDALONE of the page that stands alone (`tools/wasm page`), which is open when
// the program is given to it. CHROMIUM_FLAGS chooses what draws (see `browser.mjs`).

import { performance } from "node:perf_hooks";
import { folderServer } from "./standalone.mjs";
import { browser, memoryOf, memoryOfPages, picture, processorSeconds, serve } from "./browser.mjs";

const file = process.argv[2];
const chromium = await browser();
// A page that is open already: how long a browser takes to start is not the question.
const page = await chromium.context.newPage();
await page.goto("about:blank");
await page.addInitScript(() => {
  window.events = [];
  new PerformanceObserver((list) => {
    for (const { name, startTime, processingStart, duration } of list.getEntries()) {
      if (name === "keydown") window.events.push([startTime, processingStart - startTime, duration]);
    }
  }).observe({ type: "event", durationThreshold: 16, buffered: true });
});
// What the page's tasks take of a processor: how long they last says as much about other load.
const session = await chromium.context.newCDPSession(page);
const events = [];
session.on("Tracing.dataCollected", ({ value }) => events.push(...value));
await session.send("Tracing.start", {
  traceConfig: { includedCategories: ["toplevel", "__metadata"], excludedCategories: ["*"] },
  transferMode: "ReportEvents",
});
const isStandalone = Boolean(process.env.CHORDAL_STANDALONE);
const folder = isStandalone ? await folderServer() : undefined;
if (folder) {
  await page.goto(folder.url);
  await page.waitForSelector("#files");
  // The interpreter is ready, as it is for whoever reads the page first.
  await page.waitForTimeout(3000);
}
const begun = performance.now();
const since = () => `${((performance.now() - begun) / 1000).toFixed(2)} s`;
const server = folder ?? (await serve(file));
console.log(`address        ${since()}`);
if (isStandalone) {
  await page.setInputFiles("#files", file);
  console.log(`given          ${since()}`);
}
else await page.goto(server.url, { waitUntil: "commit" });
// Somebody who presses a key all the time while the program is loaded.
let loading = true;
let presses = 0;
const presser = (async () => {
  await page.waitForSelector("#tab-state");
  await page.locator("#tab-problems").focus();
  while (loading) {
    await page.keyboard.press("ArrowRight");
    presses++;
    await page.waitForTimeout(100);
  }
})();
await page.waitForFunction(() => window.chordal?.path().rows > 0 && window.chordal.view.drawnFrames > 0, null, { polling: 20 });
console.log(`first picture  ${since()}  (${await page.evaluate(() => window.chordal.path().rows)} rows)`);
await page.waitForFunction(() => window.chordal.report(), null, { polling: 50, timeout: 120_000 });
console.log(`whole path     ${since()}  (${await page.evaluate(() => window.chordal.path().rows)} rows)`);
await page.waitForFunction(() => window.chordal.editor.view.state.doc.lines > 1000, null, { polling: 50, timeout: 60_000 });
console.log(`text           ${since()}  (${await page.evaluate(() => window.chordal.editor.view.state.doc.lines)} lines)`);
await page.waitForFunction(() => window.chordal.setpoints(), null, { polling: 100, timeout: 300_000 });
console.log(`times          ${since()}`);
loading = false;
await presser;
const ended = new Promise((done) => session.once("Tracing.tracingComplete", done));
await session.send("Tracing.end");
await ended;
const mainThreads = new Set(events.filter(({ args }) => args?.name === "CrRendererMain").map(({ pid, tid }) => `${pid} ${tid}`));
const tasks = events.filter(({ ph, pid, tid, name }) => ph === "X" && /RunTask$/.test(name) && mainThreads.has(`${pid} ${tid}`));
const first = Math.min(...tasks.map(({ ts }) => ts));
const longest = (field) => tasks.toSorted((a, b) => (b[field] ?? 0) - (a[field] ?? 0)).slice(0, 4)
  .map((task) => `${(task[field] / 1000).toFixed(0)} ms at ${((task.ts - first) / 1e6).toFixed(1)} s`).join(", ");
console.log(`long tasks     ${longest("dur")}`);
console.log(`of a processor ${longest("tdur")}`);
const keys = await page.evaluate(() => window.events);
const most = (index) => Math.max(0, ...keys.map((key) => key[index])).toFixed(0);
console.log(`keys           ${presses} pressed; the longest waited ${most(1)} ms, was seen after ${most(2)} ms`);
await page.waitForFunction(() => window.chordal.view.isComplete, null, { polling: 100, timeout: 60_000 });
console.log(`all drawn      ${since()}`);
await picture(page, "million");

const used = () => [processorSeconds("gpu-process"), processorSeconds("renderer")];

// Turning: a pointer that moves at sixty a second, whether or not the page keeps up with it.
const box = await page.locator("canvas.path").boundingBox();
await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
await page.mouse.down();
await page.evaluate(() => {
  window.turns = [];
  const { view } = window.chordal;
  const drawn = view.onDrawn;
  view.onDrawn = () => {
    window.turns.push(performance.now());
    drawn();
  };
});
const frames = () => page.evaluate(() => window.chordal.view.drawnFrames);
const [before, framesBefore] = [used(), await frames()];
const turning = performance.now();
let step = 0;
const moves = [];
while (performance.now() - turning < 5000) {
  step++;
  moves.push(page.mouse.move(box.x + box.width / 2 + 150 * Math.sin(step / 20), box.y + box.height / 2 + 60 * Math.cos(step / 25)));
  await new Promise((next) => setTimeout(next, 16));
}
await Promise.all(moves);
const drawn = (await frames()) - framesBefore;
const each = used().map((seconds, index) => ((seconds - before[index]) / drawn) * 1000);
const lines = await page.evaluate(() => window.chordal.view.drawnLines);
await picture(page, "million-turning");
const turns = await page.evaluate(() => window.turns);
await page.mouse.up();
const gaps = turns.slice(1).map((at, index) => at - turns[index]).sort((a, b) => a - b);
const mean = (turns.at(-1) - turns[0]) / gaps.length;
console.log(`turning        ${(1000 / mean).toFixed(0)} frames drawn a second, the slowest of twenty ${gaps[Math.floor(gaps.length * 0.95)].toFixed(0)} ms`);
console.log(`a frame        ${each[0].toFixed(1)} ms of a processor to draw, ${each[1].toFixed(1)} ms in the page (${drawn} frames, ${lines} lines)`);
// Playback, over the picture that is kept.
await page.waitForFunction(() => window.chordal.view.isComplete, null, { polling: 100, timeout: 60_000 });
const [rest, framesAtRest] = [used(), await frames()];
await page.locator("#play").click();
await page.waitForTimeout(4000);
await page.locator("#play").click();
const played = (await frames()) - framesAtRest;
const ofPlay = used().map((seconds, index) => ((seconds - rest[index]) / played) * 1000);
console.log(`playback       ${(played / 4).toFixed(0)} frames a second, each ${ofPlay[0].toFixed(1)} ms to draw, ${ofPlay[1].toFixed(1)} ms in the page`);
await session.send("HeapProfiler.enable");
await session.send("HeapProfiler.collectGarbage");
const metrics = await session.send("Runtime.getHeapUsage");
const mib = (bytes) => (bytes / 2 ** 20).toFixed(0);
console.log(`page           ${mib(metrics.usedSize)} MiB of objects, ${mib(metrics.backingStorageSize ?? 0)} MiB of arrays`);
const [ofPages, ofServer] = [memoryOfPages(), isStandalone ? 0 : memoryOf(server.process.pid)];
console.log(`memory         ${mib(ofPages + ofServer)} MiB: ${mib(ofPages)} of the browser's pages, ${mib(ofServer)} of the server`);
await chromium.stop();
server.stop();
