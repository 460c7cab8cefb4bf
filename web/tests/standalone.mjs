// The page that stands alone, for a test: a plain web server for its folder, and the same start as `chordal view`.

import { createServer } from "node:http";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { after, before } from "node:test";
import { tmpdir } from "node:os";
import { basename, dirname, extname, join } from "node:path";
import { ROOT, browser, listened, reported } from "./browser.mjs";

/** Where `tools/wasm page` has built it. */
const folderOf = () => process.env.CHORDAL_STATIC ?? join(ROOT, "web/dist-static");

const TYPES = {
  ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml",
  ".wasm": "application/wasm", ".json": "application/json",
};

/** Serves the folder as any web server does. */
export async function folderServer(folder = folderOf()) {
  /** Files that are given out otherwise than they are in the folder. */
  const changed = {};
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url, "http://localhost");
    const name = pathname.endsWith("/") ? "index.html" : basename(pathname);
    const path = join(folder, name);
    if (!existsSync(path)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": TYPES[extname(name)] ?? "application/octet-stream" });
    const bytes = readFileSync(path);
    response.end(changed[name]?.(bytes.toString()) ?? bytes);
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  return {
    url: `http://127.0.0.1:${server.address().port}/view/`,
    changed,
    stop() {
      server.closeAllConnections();
      server.close();
    },
  };
}

/** A server elsewhere: paths with texts that any page may read, but for those that begin with `/closed`. */
export async function otherServer(texts) {
  const requested = [];
  const server = createServer((request, response) => {
    requested.push(request.url);
    const open = request.url.startsWith("/closed") ? {} : { "access-control-allow-origin": "*" };
    const found = texts[request.url];
    if (found === undefined) return response.writeHead(404, open).end("<h1>none</h1>");
    const type = request.url.endsWith(".html") ? "text/html" : "text/plain";
    response.writeHead(200, { ...open, "content-type": type }).end(found);
  });
  // A test that fails leaves nothing that keeps it from ending.
  server.unref();
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  return { url: `http://127.0.0.1:${server.address().port}`, requested, stop: () => server.close() };
}

/** The files that `chordal view` would find: the program, what lies next to it, and what the options name. */
function filesOf(file, options, scratch) {
  const folder = dirname(file);
  const isNext = (name) => name === "chordal.toml" || (/\.(nc|ngc)$/i.test(name) && name !== basename(file));
  const files = [file, ...readdirSync(folder).filter(isNext).map((name) => join(folder, name))];
  const of = (name) => options.flatMap((word, at) => (options[at - 1] === name ? [word] : []));
  const machine = of("--machine")[0] ?? of("--as")[0];
  if (machine) {
    const path = join(scratch, "machine.toml");
    // The command takes lengths without quotes, a machine file does not.
    const set = of("--set").map((assignment) => assignment.replace(/=\s*(-?[\d.]+\s?[a-z]+)$/, '="$1"'));
    writeFileSync(path, `inherits = "${machine}"\n${set.join("\n")}\n`);
    files.push(path);
  }
  const setup = of("--setup")[0];
  if (setup) {
    files.push(setup, ...readdirSync(dirname(setup)).filter((name) => name.endsWith(".stl")).map((name) => join(dirname(setup), name)));
  }
  return { files, on: of("--as")[1] };
}

let session;

/** One browser and one web server for all tests. */
export function standaloneSession() {
  return (session ??= begun());
}

function begun() {
  let own;
  let server;
  let scratch;
  /** Addresses that were asked for. */
  const requested = [];
  before(async () => {
    own = await browser();
    own.context.on("request", (request) => requested.push(request.url()));
    server = await folderServer();
    scratch = mkdtempSync(join(tmpdir(), "chordal-standalone-"));
  });
  after(async () => {
    server?.stop();
    await own?.stop();
    if (scratch) rmSync(scratch, { recursive: true, force: true });
  });
  const started = async () => {
    const opened = await listened(own.context);
    await opened.page.goto(server.url);
    await opened.page.waitForSelector("#files");
    return opened;
  };
  return {
    isStandalone: true,
    requested,
    started,
    context: () => own.context,
    url: () => server.url,
    server: () => server,
    async begin(file) {
      const { page } = await started();
      await page.setInputFiles("#files", file);
      return page;
    },
    async open(file, ...more) {
      const opened = await started();
      const { files, on } = filesOf(file, more, scratch);
      await opened.page.setInputFiles("#files", files);
      await reported(opened.page);
      if (on) {
        await opened.page.locator("#tab-compare").click();
        await opened.page.locator("#against").selectOption(`machine ${on}`);
      }
      return opened;
    },
    /** Saves, and gives what the browser keeps. */
    async save(page) {
      const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Control+s")]);
      return readFileSync(await download.path(), "utf8");
    },
  };
}
