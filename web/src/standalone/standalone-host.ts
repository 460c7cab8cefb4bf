// The page that stands alone: opens and saves programs, shares them, and keeps those of before.

import "./start-dialog.css";
import { element } from "../panels/dom";
import { type Page, use } from "../page-host";
import { type Asked, asked, asking, fetched, fileOf } from "./address";
import { Core } from "./worker-connection";
import type { Against, File_, Opened } from "./engine";
import { type Example, gallery, named } from "./gallery";
import { apart, nameOf, sorted, tooLarge } from "./opened-files";
import { offline } from "./service-worker";
import { MOST_EACH, find, keep, sizeOf } from "./recent-programs";
import { MOST_LINK, type Shared, fragmentOf, sharedIn } from "./share-link";
import { Start } from "./start-dialog";

/** The address of the module, whose name changes with it. */
declare const MODULE: string;

async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL(MODULE, document.baseURI));
  if (!response.ok) throw new Error(`${MODULE}: ${response.status} ${response.statusText}`);
  // Only a response of its own type can be compiled while it comes.
  const type = response.headers.get("content-type")?.split(";")[0]?.trim();
  if (type === "application/wasm") return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

const core = new Core(compile(), (name) => new Worker(new URL("./worker-entry.ts", import.meta.url), { type: "module", name }));

/** What is open. */
let name = "";
let files: File_[] = [];
let against: Against | undefined;
/** The machine that was opened with it. */
let machineAtOpening: string | undefined;
let page: Page | undefined;

const encode = (text: string) => new TextEncoder().encode(text).buffer as ArrayBuffer;

function download(fileName: string, bytes: Uint8Array): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>], { type: "application/octet-stream" }));
  link.download = fileName;
  link.click();
  // The browser has taken it by then.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A program is put away at once, so that closing the page does not lose it; a long one when its path is there, ms. */
const KEEP_LONG_AFTER_MS = 15_000;
const LONG_BYTES = 2 ** 20;

function remember(program: ArrayBuffer, machine?: string): void {
  if (sizeOf({ program, files }) > MOST_EACH) return;
  // The page gives the bytes away.
  const kept = { name, program: program.slice(0), files, machine, at: Date.now() };
  if (program.byteLength > LONG_BYTES) setTimeout(() => void keep(kept), KEEP_LONG_AFTER_MS);
  else void keep(kept);
}

/** Opens a program, once nothing that was typed would be lost. */
function open(opening: Opened, isFromLink = false): void {
  const { ui, editor, link } = page!;
  const go = () => {
    name = opening.name;
    ({ files, against } = opening);
    machineAtOpening = opening.machine;
    link.forget();
    // The address is that of the program it was opened with.
    if (!isFromLink && location.hash + location.search !== "") history.replaceState(null, "", location.pathname);
    remember(opening.program, opening.machine);
    document.querySelector<HTMLElement>("#share")!.hidden = false;
    core.open(opening).catch((error: unknown) => ui.tell("error", `The page is not complete: ${String(error)}`));
  };
  if (!editor.dirty) return go();
  ui.ask(`What you typed in ${name} is not saved.`, [
    [`Open ${opening.name} and lose it`, go],
    ["Cancel", () => {}],
  ]);
}

async function openFiles(given: File[]): Promise<void> {
  const { ui } = page!;
  const found = await readAll(given);
  if (!found) return;
  const { program, bytes, beside, read, machine } = found;
  if (!program || !bytes) return lay(read, machine);
  // Machine files stay: the next program may be for the same machine.
  const machines = files.filter(({ path }) => path.endsWith(".toml") && path !== "chordal.toml" && !read.some((own) => own.path === path));
  const others = beside.filter((file) => !/\.toml$/i.test(file.name)).length;
  open({ name: nameOf(program.name), program: bytes, files: [...read, ...machines], machine });
  if (others > 0) ui.tell("note", `${program.name} is shown; ${others === 1 ? "1 other file lies" : `${others} other files lie`} next to it.`);
}

/** The program among files and what lies next to it, read; nothing where that cannot be. */
async function readAll(given: File[]) {
  const complaint = given.map((file) => tooLarge(file.name, file.size)).find(Boolean);
  if (complaint) return refuse(complaint);
  const { program, beside, machine } = sorted(given);
  try {
    const read = await Promise.all(beside.map(async (file) => ({ path: nameOf(file.name), bytes: await file.arrayBuffer() })));
    return { program, bytes: await program?.arrayBuffer(), beside, read, machine };
  } catch (error) {
    return refuse(`A file cannot be read: ${String(error)}`);
  }
}

/** Compares the program with that of another file, on the same machine unless one comes with it. */
async function compareWith(given: File[]): Promise<void> {
  const { editor, link } = page!;
  const found = await readAll(given);
  if (!found) return;
  const { program, bytes, read, machine } = found;
  if (!program || !bytes) return refuse("There is no program among these files.");
  if (read.length > 0) lay(read, undefined);
  against = { name: apart(nameOf(program.name), name), program: bytes, machine: machine ?? chosenMachine() };
  editor.flush();
  core.against(against);
  link.tell("against", { other: "named" });
}

/** Files without a program lie next to the one that is open. */
function lay(more: File_[], machine: string | undefined): void {
  const { editor, link } = page!;
  if (name === "") return refuse("These files belong to a program: choose it together with them.");
  files = [...files.filter(({ path }) => !more.some((own) => own.path === path)), ...more];
  editor.flush();
  core.files(files);
  // The same text runs again.
  if (!machine) return link.tell("edit", { changes: [] });
  chooseLater = machine;
  link.tell("machine", { name: machine });
}

/** A machine file that is chosen as soon as it is in the list. */
let chooseLater: string | undefined;

function refuse(why: string): undefined {
  page!.ui.tell("error", why);
  start?.say(why);
}

function openTexts({ name: own, text, files: beside, machine }: Pick<Shared, "name" | "text" | "machine" | "files">, isFromLink = false): void {
  const texts = beside.map(([path, content]) => ({ path, bytes: encode(content) }));
  open({ name: nameOf(own), program: encode(text), files: texts, machine: machine ?? undefined }, isFromLink);
}

async function openLink(): Promise<boolean> {
  try {
    const shared = await sharedIn(location.hash);
    if (shared) openTexts(shared, true);
    return shared !== undefined;
  } catch (error) {
    refuse(error instanceof Error ? error.message : String(error));
    return false;
  }
}

/** Opens the example that the address names: `?example=haas/thread-mill.nc`, as pages link to it. */
async function openExample(): Promise<boolean> {
  const wanted = new URLSearchParams(location.search).get("example");
  if (!wanted) return false;
  try {
    const example = named(await gallery(), wanted);
    if (example) openTexts(example, true);
    else refuse(`There is no example ${wanted}.`);
    return example !== undefined;
  } catch (error) {
    refuse(`The examples cannot be read: ${String(error)}`);
    return false;
  }
}

/** Loading that takes longer is said, ms. */
const SLOW_MS = 500;

/** Opens the program that the address names: `?program=https://…`. */
async function openAddress(): Promise<boolean> {
  let slow: ReturnType<typeof setTimeout> | undefined;
  try {
    const wanted = asked(location.search, document.baseURI);
    if (!wanted) return false;
    slow = setTimeout(() => page!.ui.tell("note", `Loading ${fileOf(wanted.program)} from ${wanted.program.host}…`), SLOW_MS);
    open(await openingOf(wanted), true);
    return true;
  } catch (error) {
    refuse(error instanceof Error ? error.message : String(error));
    return false;
  } finally {
    clearTimeout(slow);
  }
}

async function openingOf({ program, files: beside, against: other, machine }: Asked): Promise<Opened> {
  const [bytes, otherBytes, ...rest] = await Promise.all([fetched(program), other && fetched(other), ...beside.map(fetched)]);
  const read = beside.map((url, at) => ({ path: fileOf(url), bytes: rest[at]! }));
  const on = machine ?? sorted([{ name: fileOf(program) }, ...read.map(({ path }) => ({ name: path }))]).machine;
  const against = other && otherBytes && { name: apart(fileOf(other), fileOf(program)), program: otherBytes, machine: on };
  return { name: fileOf(program), program: bytes, files: read, machine: on, against };
}

async function share(): Promise<void> {
  const { ui, editor } = page!;
  const decoder = new TextDecoder("utf-8", { fatal: true });
  const texts: [string, string][] = [];
  try {
    for (const { path, bytes } of files) texts.push([path, decoder.decode(bytes)]);
  } catch {
    return ui.tell("warning", "Files that are not text cannot be shared in a link: send the files.");
  }
  const machine = chosenMachine() ?? null;
  const fragment = await fragmentOf({ name, text: editor.view.state.doc.toString(), machine, files: texts });
  const address = location.origin + location.pathname + fragment;
  if (address.length > MOST_LINK) {
    return ui.tell("warning", `The link would have ${address.length.toLocaleString("en")} characters; up to ${MOST_LINK.toLocaleString("en")} can be shared. Send the file.`);
  }
  history.replaceState(null, "", address);
  try {
    await navigator.clipboard.writeText(address);
    ui.tell("note", "The link is copied. The program is in the link itself: nothing was sent.");
  } catch {
    ui.tell("note", "The link is in the address bar. The program is in the link itself: nothing was sent.");
  }
}

/** The machine that was chosen, or opened with the program. */
function chosenMachine(): string | undefined {
  const { machine } = sorted([{ name }, ...files.map(({ path }) => ({ name: path }))]);
  return page!.ui.machine.value || machine || machineAtOpening;
}

let start: Start | undefined;

function furnish(own: Page): void {
  page = own;
  const { ui, editor } = own;
  start = new Start({
    files: (given) => void openFiles(given),
    text: (text) => openTexts({ name: "pasted.nc", text, machine: null, files: [] }),
    recent: (kept) => void find(kept).then((found) => found && open(found)),
    example: (example: Example) => openTexts(example),
    // With the address in it the page may load what is there.
    address: (text) => location.assign(asking(text)),
  });
  offerAnother(ui.panels.compare);
  const button = (id: string, text: string, title: string, act: () => void) => {
    const made = element("button", "", text);
    Object.assign(made, { type: "button", id, title });
    made.addEventListener("click", act);
    return made;
  };
  ui.save.title = "Save: the browser keeps the file with its downloads (Ctrl-S)";
  ui.save.before(button("open", "Open", "Open a program, an example, or machine files", () => start!.show()));
  const sharing = button("share", "Share", "A link with the program in it", () => void share());
  sharing.hidden = true;
  ui.save.after(sharing);
  // A machine file that was laid next to the program is the one that it runs on.
  new MutationObserver(() => {
    if (chooseLater === undefined || ![...ui.machine.options].some(({ value }) => value === chooseLater)) return;
    ui.machine.value = chooseLater;
    chooseLater = undefined;
  }).observe(ui.machine, { childList: true });
  core.onLost = (why) => {
    const text = editor.view.state.doc.toString();
    if (name === "") return ui.tell("error", `Chordal cannot start: ${why}.`);
    ui.ask(`Chordal failed: ${why}. What you typed is still here.`, [
      ["Begin again with it", () => {
        editor.setDirty(false);
        open({ name, program: encode(text), files, machine: chosenMachine(), against });
      }],
    ]);
  };
  dropped(document);
  window.addEventListener("hashchange", () => void openLink());
  void openLink().then((isOpen) => isOpen || openExample()).then((isOpen) => isOpen || openAddress()).then((isOpen) => {
    if (!isOpen) start!.show();
  });
  offline((load) => ui.ask("A newer version of this page is ready.", [["Load it", load], ["Later", () => {}]]));
  // For the browser's tests.
  Object.assign(window, { alone: { core, open, opened: () => ({ name, files }) } });
}

/** The choice of another file to compare with. */
function offerAnother(panel: HTMLElement): void {
  const input = element("input");
  Object.assign(input, { type: "file", multiple: true, id: "another", hidden: true });
  input.addEventListener("change", () => {
    const given = [...(input.files ?? [])];
    input.value = "";
    if (given.length > 0) void compareWith(given);
  });
  const choose = element("button", "", "Another file…");
  Object.assign(choose, { type: "button", title: "Compare with another file, chosen with its machine file where it needs one" });
  choose.addEventListener("click", () => input.click());
  panel.querySelector("#against")!.closest("label")!.after(choose, input);
}

/** Files and texts that are dropped or pasted anywhere but in the text are opened. */
function dropped(root: Document): void {
  root.addEventListener("dragover", (event) => {
    if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
  });
  root.addEventListener("drop", (event) => {
    const given = [...(event.dataTransfer?.files ?? [])];
    if (given.length === 0) return;
    event.preventDefault();
    start?.hide();
    void openFiles(given);
  }, true);
  root.addEventListener("paste", (event) => {
    if ((event.target as HTMLElement | null)?.closest?.(".cm-editor, input, textarea")) return;
    const given = [...(event.clipboardData?.files ?? [])];
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (given.length === 0 && text.trim() === "") return;
    event.preventDefault();
    start?.hide();
    if (given.length > 0) void openFiles(given);
    else openTexts({ name: "pasted.nc", text, machine: null, files: [] });
  });
}

use({
  dial: (take) => core.dial(take),
  lost: "",
  another: "“Another file…” opens a second program.",
  saved: "Saved: the file is with the browser's downloads.",
  keep: (fileName, bytes) => {
    download(fileName, bytes);
    remember(bytes.slice().buffer as ArrayBuffer);
  },
  furnish,
});
