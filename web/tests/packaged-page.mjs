// The page that stands alone, out of its package: opens an example in Chromium, and asks nobody else.
//
// usage: node tests/packaged-page.mjs FOLDER

import assert from "node:assert/strict";
import { folderServer } from "./standalone.mjs";
import { browser, open } from "./browser.mjs";

const server = await folderServer(process.argv[2]);
const { context, stop } = await browser();
try {
  const requested = [];
  context.on("request", (request) => requested.push(request.url()));
  const { page, complaints } = await open(context, `${server.url}?example=haas/thread-mill.nc`);
  assert.equal(await page.locator("#counts").innerText(), "0 errors");
  assert.ok(await page.evaluate(() => window.chordal.path().rows > 0));
  assert.deepEqual(complaints, []);
  assert.deepEqual(requested.filter((address) => /^http/.test(address) && !address.startsWith(server.url)), []);
} finally {
  await stop();
  server.stop();
}
