// A server and Chromium for a test.

import { spawn } from "node:child_process";
import { after, before } from "node:test";
import { mkdirSync, mkdtempSync, readFileSync, readdirSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { removeProfile } from "../../tools/profile.mjs";
import { standaloneSession } from "./standalone.mjs";

export const ROOT = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
export const CHORDAL = process.env.CHORDAL ?? join(ROOT, "target/debug/chordal");
const PICTURES = join(ROOT, "target/view");
mkdirSync(PICTURES, { recursive: true });

/** Starts `chordal view` and gives its address. */
export function serve(file, ...more) {
  return command("view", file, "--no-browser", ...more);
}

/** Starts a command that shows a page, and gives its address; nothing is there that could open it. */
export async function command(...words) {
  const process_ = spawn(CHORDAL, words, { stdio: ["ignore", "pipe", "pipe"], env: { ...process.env, PATH: "" } });
  const url = await new Promise((answer, fail) => {
    let text = "";
    process_.stdout.on("data", (data) => {
      text += data;
      const found = /^http:\S+$/m.exec(text);
      if (found) answer(found[0]);
    });
    process_.stderr.on("data", (data) => (text += data));
    process_.on("exit", (code) => fail(new Error(`chordal ended with ${code}: ${text}`)));
  });
  return { url, process: process_, stop: () => process_.kill() };
}

/** What draws: the processor, the page as well as WebGL. */
const DRAWS = process.env.CHROMIUM_FLAGS ?? "--use-gl=angle --use-angle=swiftshader";

/** Starts Chromium without what reaches for the network. */
export async function browser() {
  const folder = mkdtempSync(join(tmpdir(), "chordal-view-"));
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    viewport: { width: 1280, height: 720 },
    args: [
      "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--enable-unsafe-swiftshader", ...DRAWS.split(" "),
    ],
  });
  if (process.env.CHORDAL_PAGE) await replace(context, process.env.CHORDAL_PAGE);
  return {
    context,
    async stop() {
      await context.close();
      removeProfile(folder);
    },
  };
}

/** Takes the page's files from a folder, so that the command need not be built for each change. */
async function replace(context, folder) {
  await context.route(/\/app\.(js|css)$/, (route) => {
    const name = new URL(route.request().url()).pathname.split("/").pop();
    return route.fulfill({ path: join(folder, name) });
  });
}

/** A page with whatever it complains of. */
export async function listened(context) {
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error)));
  return { page, complaints };
}

/** Until a program has run. */
export const reported = (page) => page.waitForFunction(() => window.chordal?.report(), null, { timeout: 30_000 });

/** A page on a program, with whatever it complains of. */
export async function open(context, url) {
  const opened = await listened(context);
  await opened.page.goto(url);
  await reported(opened.page);
  return opened;
}

export async function picture(page, name) {
  // Two frames, so that what was asked last is drawn.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await page.waitForTimeout(250);
  await page.screenshot({ path: join(PICTURES, `${name}.png`) });
}

/** Chromium's processes of a type. */
function* processesOf(type) {
  const stat = (pid) => readFileSync(`/proc/${pid}/stat`, "utf8").split(") ").pop().split(" ");
  const isOurs = (pid) => {
    for (let at = pid; at > 1; at = Number(stat(at)[1])) if (at === process.pid) return true;
    return false;
  };
  for (const pid of readdirSync("/proc").filter((name) => /^\d+$/.test(name)).map(Number)) {
    try {
      if (readFileSync(`/proc/${pid}/cmdline`, "utf8").includes(`--type=${type}`) && isOurs(pid)) yield [pid, stat(pid)];
    } catch {
      // It has ended meanwhile.
    }
  }
}

/** What Chromium's drawing and page processes have used of a processor, s: other load does not count. */
export function processorSeconds(type) {
  let seconds = 0;
  for (const [, fields] of processesOf(type)) seconds += (Number(fields[11]) + Number(fields[12])) / 100;
  return seconds;
}

/** What a process holds of memory, bytes. */
export function memoryOf(pid) {
  return 1024 * Number(/^VmRSS:\s+(\d+)/m.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]);
}

/** What Chromium's pages hold, their workers included, bytes. */
export function memoryOfPages() {
  return [...processesOf("renderer")].reduce((sum, [pid]) => sum + memoryOf(pid), 0);
}

/** One browser for the tests of a file, and the servers that end with it. With CHORDAL_STANDALONE they are of the page that stands alone. */
export function session() {
  return process.env.CHORDAL_STANDALONE ? standaloneSession() : servedSession();
}

function servedSession() {
  const servers = [];
  let own;
  before(async () => {
    own = await browser();
  });
  after(async () => {
    servers.forEach((server) => server.stop());
    await own?.stop();
  });
  const started = async (file, ...more) => {
    const server = await serve(file, ...more);
    servers.push(server);
    return server;
  };
  return {
    isStandalone: false,
    /** A page whose program is on its way. */
    async begin(file) {
      const server = await started(file);
      const page = await own.context.newPage();
      await page.goto(server.url);
      return page;
    },
    async open(file, ...more) {
      return open(own.context, (await started(file, ...more)).url);
    },
    /** Saves, and gives what was saved. */
    async save(page, file) {
      await page.keyboard.press("Control+s");
      await page.waitForFunction(() => document.querySelector(".dirty").innerText === "");
      return readFileSync(file, "utf8");
    },
  };
}
