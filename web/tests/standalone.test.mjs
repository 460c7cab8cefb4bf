// The page that stands alone: the tests of the page that `chordal view` serves, and what only this one does.

import assert from "node:assert/strict";
import { test } from "node:test";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

process.env.CHORDAL_STANDALONE = "1";
const { otherServer } = await import("./standalone.mjs");
const { ROOT, picture, reported, session } = await import("./browser.mjs");
await import("./page.test.mjs");
await import("./readings.test.mjs");

const PROFILE = join(ROOT, "examples/fadal/profile-g18.nc");
const tests = session();
/** Servers elsewhere that these tests name. */
const linked = [];
const textOf = (page) => page.evaluate(() => window.chordal.editor.view.state.doc.toString());
const toast = (page, words) => page.waitForFunction((words) => new RegExp(words).test(document.querySelector(".toast").innerText), words);

/** Types behind the last line and waits for what comes of it. */
async function type(page, text) {
  await page.evaluate(() => {
    const { view } = window.chordal.editor;
    view.dispatch({ selection: { anchor: view.state.doc.length } });
    view.focus();
  });
  await page.keyboard.type(text);
}

test("a start shows examples with what each shows, and one is opened", async () => {
  const { page, complaints } = await tests.started();
  await page.locator(".examples summary", { hasText: "Stock" }).click();
  const card = page.locator(".examples .card", { hasText: "op1.nc" });
  assert.match(await card.innerText(), /Operation 1: pocket and round groove/);
  await picture(page, "standalone-start");
  await card.click();
  await reported(page);
  await page.waitForFunction(() => window.chordal.stock.shown?.() !== undefined || document.querySelector(".stock-slot").innerText !== "");
  assert.match(await page.locator(".name").innerText(), /op1\.nc/);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("the dialog of the start has nothing serious against it, light and dark", async () => {
  const axe = readFileSync(join(ROOT, "web/node_modules/axe-core/axe.min.js"), "utf8");
  const { page } = await tests.started();
  await page.locator(".examples summary").first().click();
  await page.evaluate(axe);
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    const { violations } = await page.evaluate(() => window.axe.run());
    const serious = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
    assert.deepEqual(serious.map(({ id, nodes }) => `${colorScheme} ${id}: ${nodes.map(({ html }) => html).join(" ").slice(0, 300)}`), []);
  }
  await picture(page, "standalone-start-dark");
  await page.close();
});

test("an address names an example", async () => {
  const { page } = await tests.started();
  await page.goto(`${tests.url()}?example=haas/thread-mill.nc`);
  await reported(page);
  assert.match(await textOf(page), /THREAD HOB/);
  await page.goto(`${tests.url()}?example=haas/none.nc`);
  await page.getByText("There is no example haas/none.nc.").first().waitFor();
  await page.locator("#start-title").waitFor();
  await page.close();
});

const OLD = "%\nO1\nG21 G90 G54 S900 M3\nG0 X0. Y0. Z5.\nG1 Z0. F100.\nX10.\nM98 P2\nM30\n%\n";
const NEW = OLD.replace("X10.", "X10.5");
const DOWN = "%\nO2\nG91 G1 Y3. F100.\nG90\nM99\n%\n";

test("an address names programs elsewhere, which are loaded and compared", async () => {
  const other = await otherServer({ "/old/part.nc": OLD, "/new/part.nc": NEW, "/O2.nc": DOWN });
  linked.push(other.url);
  const { page, complaints } = await tests.started();
  const words = new URLSearchParams([["program", `${other.url}/old/part.nc`], ["file", `${other.url}/O2.nc`], ["against", `${other.url}/new/part.nc`], ["machine", "haas-vf2"]]);
  await page.goto(`${tests.url()}?${words}`);
  await reported(page);
  assert.equal(await textOf(page), OLD);
  assert.equal(await page.locator("#counts").innerText(), "0 errors");
  await page.locator("#tab-compare").click();
  await page.locator(".verdict.different").waitFor();
  assert.match(await page.locator(".verdict").innerText(), /0\.5 mm/);
  assert.match(await page.locator(".paths").innerText(), /part\.nc on Haas[^]*part \(2\)\.nc on Haas/);
  await picture(page, "standalone-address");
  assert.deepEqual(other.requested.sort(), ["/O2.nc", "/new/part.nc", "/old/part.nc"]);
  assert.deepEqual(complaints, []);
  // Nothing else is asked there, and nothing at another address.
  const byName = other.url.replace("127.0.0.1", "localhost");
  linked.push(byName);
  const canFetch = (address) => page.evaluate((address) => fetch(address).then(() => true, () => false), address);
  assert.equal(await canFetch(`${byName}/old/part.nc`), false);
  await page.goto(tests.url());
  await page.locator("#start-title").waitFor();
  assert.equal(await canFetch(`${other.url}/old/part.nc`), false);
  assert.equal(other.requested.length, 3);
  other.stop();
  await page.close();
});

test("a program that cannot be loaded from an address is told why, and the page goes on", async () => {
  const other = await otherServer({ "/closed/part.nc": OLD, "/part.html": "<p>part.nc</p>" });
  linked.push(other.url);
  const gone = await otherServer({});
  linked.push(gone.url);
  gone.stop();
  const { page } = await tests.started();
  const host = new URL(other.url).host;
  for (const [address, sentence] of [
    [`${other.url}/closed/part.nc`, `part.nc cannot be loaded: ${host} does not allow other pages to read it (CORS). Save the file, and open it here.`],
    [`${other.url}/none.nc`, `none.nc cannot be loaded: ${host} answers 404 Not Found.`],
    [`${other.url}/part.html`, `part.html cannot be loaded: there is a page at ${host}, not a program. Give the address of the file itself.`],
    [`${gone.url}/part.nc`, `part.nc cannot be loaded: ${new URL(gone.url).host} does not answer, or sends the browser to another address. Save the file, and open it here.`],
    ["file:///etc/passwd", "file:///etc/passwd is not the address of a program: it begins with https:// or http://."],
  ]) {
    await page.locator("#address").fill(address);
    await Promise.all([page.waitForEvent("load"), page.getByRole("button", { name: "Load", exact: true }).click()]);
    await page.locator(".start-message", { hasText: /\S/ }).waitFor();
    assert.equal(await page.locator(".start-message").innerText(), sentence);
  }
  await picture(page, "standalone-address-refused");
  await page.locator("#paste").fill(OLD);
  await page.getByRole("button", { name: "Open the text" }).click();
  await reported(page);
  // The address is not that of this program.
  assert.equal(page.url(), tests.url());
  other.stop();
  await page.close();
});

test("another file is compared with the program, and follows what is typed", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-standalone-"));
  const [a, b] = ["a.nc", "b.nc"].map((name) => join(folder, name));
  writeFileSync(a, OLD.replace("M98 P2\n", ""));
  writeFileSync(b, NEW.replace("M98 P2\n", ""));
  const { page, complaints } = await tests.open(a, "--machine", "haas-vf2");
  await page.locator("#tab-compare").click();
  const verdict = page.locator(".verdict");
  assert.match(await verdict.innerText(), /“Another file…” opens a second program/);
  await page.setInputFiles("#another", b);
  await page.locator(".verdict.different").waitFor();
  assert.equal(await page.locator("#against").evaluate((select) => select.selectedOptions[0].textContent), "b.nc");
  assert.match(await page.locator(".paths").innerText(), /a\.nc on Haas[^]*b\.nc on Haas/);
  await picture(page, "standalone-another");
  await page.evaluate(() => {
    const { view } = window.chordal.editor;
    const at = view.state.doc.toString().indexOf("X10.") + 4;
    view.dispatch({ changes: { from: at, insert: "5" } });
    window.chordal.editor.flush();
  });
  await page.waitForFunction(() => /same/.test(document.querySelector(".verdict").className));
  // Read the other program, then compare with itself on another machine, and with the file again.
  await page.setInputFiles("#another", a);
  await page.locator(".verdict.different").waitFor();
  await page.locator(".difference .read").first().click();
  await page.locator(".other-file h2", { hasText: "a (2).nc, read only" }).waitFor();
  await page.keyboard.press("Escape");
  await page.locator("#against").selectOption("machine fanuc-30i");
  await page.waitForFunction(() => /Fanuc/.test(document.querySelector(".paths").innerText));
  await page.locator("#against").selectOption("named");
  await page.locator(".verdict.different").waitFor();
  // A part that fails, and a file that is no program.
  await page.evaluate(() => window.standalone.core.fail(2));
  await page.setInputFiles("#another", b);
  await page.waitForFunction(() => /same/.test(document.querySelector(".verdict").className));
  writeFileSync(b, Buffer.from(Array.from({ length: 10_000 }, (_, at) => (at * 7919) % 256)));
  await page.setInputFiles("#another", b);
  await page.waitForFunction(() => !/waiting|same/.test(document.querySelector(".verdict").className));
  assert.deepEqual(complaints, []);
  await page.evaluate(() => window.chordal.editor.setDirty(false));
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});

test("files are dropped, a text is pasted, and what is open lately is kept and forgotten", async () => {
  const { page } = await tests.started();
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File(["%\nO7\nG21 G90\nG0 X1. Y2.\nM30\n%\n"], "dropped.nc"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  });
  await reported(page);
  assert.match(await textOf(page), /O7/);
  await page.locator("#open").click();
  await page.locator("#paste").fill("G21\nG0 X5.\nM30\n");
  await page.getByRole("button", { name: "Open the text" }).click();
  await page.waitForFunction(() => /X5\./.test(window.chordal.editor.view.state.doc.toString()));
  await page.reload();
  const card = page.locator(".recents .card", { hasText: "dropped.nc" });
  await page.locator("#start-title").waitFor();
  // It is put away once the picture is there.
  for (let times = 0; times < 20 && (await card.count()) === 0; times++) {
    await page.waitForTimeout(200);
    await page.getByRole("button", { name: "Close" }).click();
    await page.locator("#open").click();
  }
  await card.click();
  await reported(page);
  assert.match(await textOf(page), /O7/);
  await page.locator("#open").click();
  await page.getByRole("button", { name: "Forget dropped.nc" }).click();
  await page.waitForFunction(() => !/dropped/.test(document.querySelector(".recents").innerText));
  await page.close();
});

test("a machine file that is chosen alone is the machine of the program", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-standalone-"));
  writeFileSync(join(folder, "mine.toml"), 'inherits = "haas-vf2"\ntitle = "Mine"\n');
  writeFileSync(join(folder, "wrong.toml"), 'inherits = "haas-vf2"\ncolour = "red"\n');
  const { page } = await tests.open(PROFILE, "--machine", "fadal-4020");
  await page.setInputFiles("#files", join(folder, "mine.toml"));
  await page.waitForFunction(() => document.querySelector("#machine").value === "mine.toml");
  await page.waitForFunction(() => /Mine/.test(document.querySelector(".paths").innerText));
  // One that is wrong says where and what.
  await page.setInputFiles("#files", join(folder, "wrong.toml"));
  await page.waitForFunction(() => /colour/.test(document.querySelector("#panel-problems").innerText));
  await page.locator("#machine").selectOption("mine.toml");
  await page.waitForFunction(() => document.querySelector("#counts").innerText !== "Cannot run");
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});

test("a link holds the program, and one that is damaged says so", async () => {
  const { page } = await tests.open(PROFILE, "--machine", "fadal-4020");
  await type(page, "(ä → 😀)");
  await page.locator("#share").click();
  await page.waitForFunction(() => location.hash.startsWith("#p="));
  const [address, text] = [page.url(), await textOf(page)];
  await page.evaluate(() => window.chordal.editor.setDirty(false));
  await page.close();
  const other = (await tests.started()).page;
  await other.goto("about:blank");
  await other.goto(address);
  await reported(other);
  assert.equal(await textOf(other), text);
  assert.match(await other.evaluate(() => document.querySelector("#machine").selectedOptions[0].textContent), /Fadal/);
  await other.evaluate(() => (location.hash = "#p=AAAA"));
  await toast(other, "damaged");
  assert.equal(await textOf(other), text);
  // What is too long for a link is not cut off.
  await other.evaluate(() => {
    const words = Array.from({ length: 20_000 }, (_, at) => `(${Math.sin(at)})`).join("\n");
    window.chordal.editor.view.dispatch({ changes: { from: 0, insert: words } });
  });
  await other.locator("#share").click();
  await toast(other, "characters");
  await other.evaluate(() => window.chordal.editor.setDirty(false));
  await other.close();
});

test("whatever a file holds gets an answer, and the next one works", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-standalone-"));
  const line = join(folder, "line.nc");
  writeFileSync(line, `${"G1 X1. Y2. ".repeat(90_000)}\n`);
  const binary = join(folder, "picture.nc");
  writeFileSync(binary, Buffer.from(Array.from({ length: 1_000_000 }, (_, at) => (at * 7919) % 256)));
  const { page, complaints } = await tests.started();
  await page.setInputFiles("#files", line);
  await reported(page);
  await page.waitForFunction(() => /[1-9]\d* error/.test(document.querySelector("#counts").innerText));
  await page.setInputFiles("#files", binary);
  await toast(page, "binary data");
  await page.setInputFiles("#files", PROFILE);
  await page.waitForFunction(() => /G18/.test(window.chordal.editor.view.state.doc.toString()) && window.chordal.report()?.errors === 0);
  await page.setInputFiles("#files", join(ROOT, "examples/stock/op1.toml"));
  assert.deepEqual(complaints, []);
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});

test("an edit overtakes the run of the text before", async () => {
  const folder = mkdtempSync(join(tmpdir(), "chordal-standalone-"));
  const path = join(folder, "long.ngc");
  const rows = Array.from({ length: 150_000 }, (_, at) => `X${(at % 1000) / 10}Y${Math.floor(at / 1000) / 10}`);
  writeFileSync(path, ["G21 G90 F1000", "G1 Z0", ...rows, "M30", ""].join("\n"));
  const page = await tests.begin(path);
  await reported(page);
  const before = await page.evaluate(() => window.chordal.path().rows);
  await page.evaluate(() => {
    const { view } = window.chordal.editor;
    // Two edits, the second while the first runs.
    view.dispatch({ changes: { from: 0, insert: "G0 X1.\n" } });
    window.chordal.editor.flush();
    setTimeout(() => {
      view.dispatch({ changes: { from: 0, insert: "G0 X2.\nG0 X3.\n" } });
      window.chordal.editor.flush();
    }, 150);
  });
  await page.waitForFunction((rows) => window.chordal.report()?.rows === rows, before + 3);
  await page.waitForFunction(() => window.chordal.setpoints());
  // What is asked meanwhile is answered.
  await page.waitForSelector(".word-gcode");
  await page.evaluate(() => window.chordal.editor.setDirty(false));
  await page.close();
  rmSync(folder, { recursive: true, force: true });
});

test("a part of the interpreter that fails is told, and the page goes on", async () => {
  const { page } = await tests.open(PROFILE, "--machine", "fadal-4020");
  await page.waitForFunction(() => window.chordal.setpoints());
  await page.evaluate(() => window.standalone.core.fail(0));
  await page.waitForFunction(() => /asked to panic/.test(document.querySelector("#panel-problems").innerText));
  await type(page, "(A)");
  await page.waitForFunction(() => document.querySelector("#counts").innerText === "0 errors");
  await page.evaluate(() => window.standalone.core.fail("answers"));
  await toast(page, "asked to panic");
  await page.evaluate(() => (window.before = window.chordal.report()));
  await page.getByRole("button", { name: "Begin again with it" }).click();
  await page.waitForFunction(() => window.chordal.report() && window.chordal.report() !== window.before);
  assert.match(await textOf(page), /\(A\)$/);
  await type(page, "(B)");
  await page.waitForFunction(() => /\(A\)\(B\)$/.test(window.chordal.editor.view.state.doc.toString()));
  await page.waitForFunction(() => document.querySelector("#counts").innerText === "0 errors");
  await page.evaluate(() => window.chordal.editor.setDirty(false));
  await page.close();
});

test("nothing is asked of another address, the page works without a network, and a newer one is offered", async () => {
  const { page } = await tests.started();
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
    if (!navigator.serviceWorker.controller) await new Promise((done) => navigator.serviceWorker.addEventListener("controllerchange", done));
  });
  const versions = () => page.evaluate(() => caches.keys());
  const [before] = await versions();
  tests.server().changed["sw.js"] = (text) => text.replace(/VERSION = "\w+"/, 'VERSION = "newer"');
  await page.reload();
  await page.getByRole("button", { name: "Close" }).click();
  await toast(page, "newer version");
  await Promise.all([page.waitForEvent("load"), page.getByRole("button", { name: "Load it" }).click()]);
  await page.waitForFunction(() => caches.keys().then((names) => names.length === 1 && names[0].endsWith(" newer")));
  assert.ok(!before.endsWith(" newer"), before);
  await page.close();
  const foreign = tests.requested.filter((address) => !/^(blob:|data:|about:)/.test(address) && !address.startsWith(tests.url()));
  assert.deepEqual(foreign.filter((address) => !linked.some((url) => address.startsWith(url))), []);
  tests.server().stop();
  await tests.context().setOffline(true);
  const { page: offline, complaints } = await tests.started();
  await offline.locator(".examples summary", { hasText: "Haas" }).first().click();
  await offline.locator(".examples .card", { hasText: "drilled-plate.nc" }).click();
  await reported(offline);
  await offline.waitForFunction(() => window.chordal.setpoints());
  await picture(offline, "standalone-offline");
  assert.deepEqual(complaints, []);
  await offline.close();
});
