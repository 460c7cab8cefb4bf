// Measures the stock of a long program on the page: node tests/stock-large.mjs PROGRAM SETUP.toml
//
// How soon it is there, what a moment costs, near and far, and how many frames a second follow on each other.

import { browser, open, processorSeconds, serve } from "./browser.mjs";

const [program, setup] = process.argv.slice(2);
const began = Date.now();
const server = await serve(program, "--setup", setup);
const chromium = await browser();
const { page } = await open(chromium.context, server.url);
const since = () => `${((Date.now() - began) / 1000).toFixed(1)} s`;
await page.waitForFunction(() => window.chordal.stock.drops()?.count > 0, null, { timeout: 300_000 });
console.log(`first of the stock after ${since()}`);
await page.waitForFunction(() => document.querySelector("#stock summary").textContent === "Stock", null, { timeout: 300_000 });
await page.waitForFunction(() => window.chordal.setpoints() && window.chordal.view.isComplete, null, { timeout: 300_000 });
console.log(`all of it, and the times, after ${since()}`);
console.log(await page.evaluate(() => {
  const drops = window.chordal.stock.drops();
  return { columns: drops.heights.length, drops: drops.count, each: drops.count / drops.heights.length, megabytes: drops.bytes / 1e6 };
}));

const used = () => processorSeconds("gpu-process") + processorSeconds("renderer");

/** Milliseconds of moments that are sought one after the other: the list and the surface, until its frame is told, and until that is drawn. */
const seeks = (count, near) => page.evaluate(async ([count, near]) => {
  const { timeline, setpoints, view } = window.chordal;
  const gl = view.painter.renderer.getContext();
  const total = setpoints().totalS;
  const after = view.onDrawn;
  const [times, frames, drawn] = [[], [], []];
  let state = 7;
  for (let n = 0; n < count; n++) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const share = state / 2 ** 32;
    const start = performance.now();
    timeline.seek(near ? (total * (n + 1)) / (count + 1) / 50 : total * share);
    times.push(performance.now() - start);
    const fence = await new Promise((done) => {
      view.onDrawn = () => {
        view.onDrawn = after;
        after();
        frames.push(performance.now() - start);
        const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        gl.flush();
        done(fence);
      };
    });
    do await new Promise((next) => setTimeout(next, 1));
    while (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED);
    gl.deleteSync(fence);
    drawn.push(performance.now() - start);
  }
  const of = (all) => {
    all.sort((a, b) => a - b);
    const mean = all.reduce((sum, one) => sum + one, 0) / all.length;
    return [["median", all[all.length >> 1]], ["mean", mean], ["worst", all.at(-1)]].map(([name, ms]) => `${name} ${ms.toFixed(1)}`).join(", ");
  };
  return { seek: of(times), handled: of(frames), drawn: of(drawn) };
}, [count, near]);
for (const near of [false, true]) {
  const before = used();
  const handled = await seeks(100, near);
  console.log(near ? "near" : "far", handled, `${((used() - before) * 10).toFixed(0)} ms of a processor each`);
}

/** Frames of playback at a rate. */
const play = (rate) => page.evaluate(async (rate) => {
  const { timeline, view } = window.chordal;
  timeline.seek(0);
  while (timeline.rate > 3) timeline.faster(-1);
  for (let n = 0; n < rate; n++) timeline.faster(1);
  const [frames, start] = [view.drawnFrames, performance.now()];
  timeline.toggle();
  await new Promise((done) => setTimeout(done, 5000));
  timeline.pause();
  return [view.drawnFrames - frames, (performance.now() - start) / 1000];
}, rate);
for (const rate of [0, 3]) {
  const before = used();
  const [frames, seconds] = await play(rate);
  const each = ((used() - before) / frames) * 1000;
  console.log(`${[1, 2, 5, 10][rate]}×: ${(frames / seconds).toFixed(1)} frames a second, ${each.toFixed(0)} ms of a processor each`);
}
await chromium.stop();
server.stop();
