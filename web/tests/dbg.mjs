process.env.CHORDAL_ALONE="1"; process.env.CHORDAL_STATIC ??= "/tmp/dist-quick";
const { browser, listened, reported } = await import("./browser.mjs");
const { folderServer } = await import("./alone.mjs");
const own = await browser(); const server = await folderServer();
const { page, complaints } = await listened(own.context);
await page.addInitScript(() => {
  window.log = [];
  const W = window.Worker;
  window.Worker = class extends W {
    postMessage(m, t) { if (typeof m === "object" && m.open) window.log.push(["post open", performance.now()]); super.postMessage(m, t); }
    set onmessage(f) { super.onmessage = f && ((e) => {
      const d = e.data; let what;
      if (typeof d === "string") what = JSON.parse(d).type; else if (d instanceof ArrayBuffer) { const n = new DataView(d).getUint32(0, true); what = JSON.parse(new TextDecoder().decode(new Uint8Array(d, 4, n))).type; }
      const t0 = performance.now(); f(e); window.log.push([what, t0, performance.now() - t0]); }); }
  };
});
await page.goto(server.url); await page.waitForSelector("#files"); await page.waitForTimeout(3000);
await page.evaluate(() => { document.querySelector("#files").addEventListener("change", () => window.log.push(["change", performance.now()]), true);
 const tick = () => { if (window.chordal.view.drawnFrames > 0 && window.chordal.path().rows > 0) window.log.push(["drawn", performance.now(), window.chordal.path().rows]); else requestAnimationFrame(tick); }; tick(); });
await page.setInputFiles("#files", "/tmp/surface.ngc");
await page.waitForFunction(() => window.chordal.report(), null, {timeout: 60000});
await page.waitForFunction(() => window.log.some(([w]) => w === "drawn"), null, {timeout: 60000});
const log = await page.evaluate(() => window.log); const t = log.find(([w]) => w === "change")[1];
let last=""; let n=0;
for (const [w, at, took] of log) { if (w === last && n++ > 2) continue; if (w !== last) n = 0; last = w; console.log(w, (at - t).toFixed(0), took?.toFixed(1)); }
console.log(complaints);
await own.stop(); server.stop();
