// The page that stands alone: opens and saves programs, shares them, and keeps those of before.

import "./start-dialog.css";
import type { Page, PageHost } from "../page-host";
import { element } from "../panels/dom";
import { type Asked, asked, asking, fetched, fileOf } from "./address";
import type { Against, File_, Opened } from "./engine";
import { openDroppedFiles } from "./file-drop";
import { type Example, gallery, named } from "./gallery";
import { apart, nameOf, sorted, tooLarge } from "./opened-files";
import { MOST_EACH, find, keep, sizeOf } from "./recent-programs";
import { offline } from "./service-worker";
import { MOST_LINK, type Shared, fragmentOf, sharedIn } from "./share-link";
import { Start } from "./start-dialog";
import { Core } from "./worker-connection";

/** The address of the module, whose name changes with it. */
declare const MODULE: string;

/** A program of more bytes is kept in the browser only when its path is there, after so many ms. */
const LONG_BYTES = 2 ** 20;
const KEEP_LONG_AFTER_MS = 15_000;
/** Loading that takes longer is reported, ms. */
const SLOW_MS = 500;
/** The browser has taken a download by then, ms. */
const DOWNLOAD_MS = 10_000;

async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL(MODULE, document.baseURI));
  if (!response.ok) throw new Error(`${MODULE}: ${response.status} ${response.statusText}`);
  // Only a response of its own type can be compiled while it comes.
  const type = response.headers.get("content-type")?.split(";")[0]?.trim();
  if (type === "application/wasm") return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

const encode = (text: string) => new TextEncoder().encode(text).buffer as ArrayBuffer;

function errorText(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function download(fileName: string, bytes: Uint8Array): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>], { type: "application/octet-stream" }));
  link.download = fileName;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), DOWNLOAD_MS);
}

function button(id: string, text: string, title: string, act: () => void): HTMLButtonElement {
  const made = element("button", "", text);
  Object.assign(made, { type: "button", id, title });
  made.addEventListener("click", act);
  return made;
}

/** What an address asks for, loaded. */
async function openingOf({ program, files: fileUrls, against: other, machine }: Asked): Promise<Opened> {
  const [bytes, otherBytes, ...rest] = await Promise.all([fetched(program), other && fetched(other), ...fileUrls.map(fetched)]);
  const files = fileUrls.map((url, index) => ({ path: fileOf(url), bytes: rest[index]! }));
  const chosen = machine ?? sorted([{ name: fileOf(program) }, ...files.map(({ path }) => ({ name: path }))]).machine;
  const against = other && otherBytes && { name: apart(fileOf(other), fileOf(program)), program: otherBytes, machine: chosen };
  return { name: fileOf(program), program: bytes, files, machine: chosen, against };
}

export class StandaloneHost implements PageHost {
  readonly lost = "";
  readonly another = "“Another file…” opens a second program.";
  readonly saved = "Saved: the file is with the browser's downloads.";
  /** What is open. */
  private name = "";
  private files: File_[] = [];
  private against: Against | undefined;
  /** The machine that was opened with it. */
  private machineAtOpening: string | undefined;
  /** A machine file that is chosen as soon as it is in the list of machines. */
  private chooseLater: string | undefined;
  private page!: Page;
  private start!: Start;
  private core = new Core(compile(), (name) => new Worker(new URL("./worker-entry.ts", import.meta.url), { type: "module", name }));

  dial: PageHost["dial"] = (take) => this.core.dial(take);

  keep = (fileName: string, bytes: Uint8Array): void => {
    download(fileName, bytes);
    this.remember(bytes.slice().buffer as ArrayBuffer);
  };

  furnish = (page: Page): void => {
    this.page = page;
    const { ui } = page;
    this.start = this.makeStart();
    this.offerAnother(ui.panels.compare);
    ui.save.title = "Save: the browser keeps the file with its downloads (Ctrl-S)";
    ui.save.before(button("open", "Open", "Open a program, an example, or machine files", () => this.start.show()));
    const sharing = button("share", "Share", "A link with the program in it", () => void this.share());
    sharing.hidden = true;
    ui.save.after(sharing);
    this.chooseWhenListed();
    this.core.onLost = (why) => this.offerRestart(why);
    openDroppedFiles(document, {
      files: (files) => {
        this.start.hide();
        void this.openFiles(files);
      },
      text: (text) => {
        this.start.hide();
        this.openPasted(text);
      },
    });
    window.addEventListener("hashchange", () => void this.openLink());
    void this.openFirst();
    offline((load) => ui.ask("A newer version of this page is ready.", [["Load it", load], ["Later", () => {}]]));
    this.exposeForTests();
  };

  private makeStart(): Start {
    return new Start({
      files: (files) => void this.openFiles(files),
      text: (text) => this.openPasted(text),
      recent: (name) => void find(name).then((program) => program && this.open(program)),
      example: (example: Example) => this.openTexts(example),
      // With the address in it the page may load what is there.
      address: (text) => location.assign(asking(text)),
    });
  }

  /** Opens what the address of the page names; otherwise asks for a program. */
  private async openFirst(): Promise<void> {
    const isOpen = (await this.openLink()) || (await this.openExample()) || (await this.openAddress());
    if (!isOpen) this.start.show();
  }

  /** A program is put away at once, so that closing the page does not lose it; a long one when its path is there. */
  private remember(program: ArrayBuffer, machine?: string): void {
    const { name, files } = this;
    if (sizeOf({ program, files }) > MOST_EACH) return;
    // A copy: the bytes go over to the worker.
    const recent = { name, program: program.slice(0), files, machine, at: Date.now() };
    if (program.byteLength > LONG_BYTES) setTimeout(() => void keep(recent), KEEP_LONG_AFTER_MS);
    else void keep(recent);
  }

  /** Opens a program, once nothing that was typed would be lost. */
  private open(opening: Opened, isFromLink = false): void {
    const { ui, editor, link } = this.page;
    const go = () => {
      ({ name: this.name, files: this.files, against: this.against, machine: this.machineAtOpening } = opening);
      link.forget();
      // The address is that of the program it was opened with.
      if (!isFromLink && location.hash + location.search !== "") history.replaceState(null, "", location.pathname);
      this.remember(opening.program, opening.machine);
      document.querySelector<HTMLElement>("#share")!.hidden = false;
      this.core.open(opening).catch((error: unknown) => ui.tell("error", `The page is not complete: ${String(error)}`));
    };
    if (!editor.dirty) return go();
    ui.ask(`What you typed in ${this.name} is not saved.`, [
      [`Open ${opening.name} and lose it`, go],
      ["Cancel", () => {}],
    ]);
  }

  private async openFiles(files: File[]): Promise<void> {
    const opened = await this.readAll(files);
    if (!opened) return;
    const { program, bytes, others, read, machine } = opened;
    if (!program || !bytes) return this.addFiles(read, machine);
    // Machine files stay: the next program may be for the same machine.
    const machines = this.files.filter(({ path }) => path.endsWith(".toml") && path !== "chordal.toml" && !read.some((file) => file.path === path));
    const count = others.filter((file) => !/\.toml$/i.test(file.name)).length;
    this.open({ name: nameOf(program.name), program: bytes, files: [...read, ...machines], machine });
    if (count > 0) this.page.ui.tell("note", `${program.name} is shown; ${count === 1 ? "1 other file lies" : `${count} other files lie`} next to it.`);
  }

  /** The program among files and what lies next to it, read; undefined where that cannot be. */
  private async readAll(files: File[]) {
    const complaint = files.map((file) => tooLarge(file.name, file.size)).find(Boolean);
    if (complaint) return this.refuse(complaint);
    const { program, beside: others, machine } = sorted(files);
    try {
      const read = await Promise.all(others.map(async (file) => ({ path: nameOf(file.name), bytes: await file.arrayBuffer() })));
      return { program, bytes: await program?.arrayBuffer(), others, read, machine };
    } catch (error) {
      return this.refuse(`A file cannot be read: ${String(error)}`);
    }
  }

  /** Compares the program with that of another file, on the same machine unless one comes with it. */
  private async compareWith(files: File[]): Promise<void> {
    const { editor, link } = this.page;
    const opened = await this.readAll(files);
    if (!opened) return;
    const { program, bytes, read, machine } = opened;
    if (!program || !bytes) return this.refuse("There is no program among these files.");
    if (read.length > 0) this.addFiles(read, undefined);
    this.against = { name: apart(nameOf(program.name), this.name), program: bytes, machine: machine ?? this.chosenMachine() };
    editor.flush();
    this.core.against(this.against);
    link.tell("against", { other: "named" });
  }

  /** Files without a program lie next to the one that is open. */
  private addFiles(more: File_[], machine: string | undefined): void {
    const { editor, link } = this.page;
    if (this.name === "") return this.refuse("These files belong to a program: choose it together with them.");
    this.files = [...this.files.filter(({ path }) => !more.some((file) => file.path === path)), ...more];
    editor.flush();
    this.core.files(this.files);
    // The same text runs again.
    if (!machine) return link.tell("edit", { changes: [] });
    this.chooseLater = machine;
    link.tell("machine", { name: machine });
  }

  private refuse(why: string): undefined {
    this.page.ui.tell("error", why);
    this.start.say(why);
  }

  private openPasted(text: string): void {
    this.openTexts({ name: "pasted.nc", text, machine: null, files: [] });
  }

  private openTexts({ name, text, files, machine }: Pick<Shared, "name" | "text" | "machine" | "files">, isFromLink = false): void {
    const encoded = files.map(([path, content]) => ({ path, bytes: encode(content) }));
    this.open({ name: nameOf(name), program: encode(text), files: encoded, machine: machine ?? undefined }, isFromLink);
  }

  /** Opens the program that is in the fragment of the address. */
  private async openLink(): Promise<boolean> {
    try {
      const shared = await sharedIn(location.hash);
      if (shared) this.openTexts(shared, true);
      return shared !== undefined;
    } catch (error) {
      this.refuse(errorText(error));
      return false;
    }
  }

  /** Opens the example that the address names: `?example=haas/thread-mill.nc`, as pages link to it. */
  private async openExample(): Promise<boolean> {
    const path = new URLSearchParams(location.search).get("example");
    if (!path) return false;
    try {
      const example = named(await gallery(), path);
      if (example) this.openTexts(example, true);
      else this.refuse(`There is no example ${path}.`);
      return example !== undefined;
    } catch (error) {
      this.refuse(`The examples cannot be read: ${String(error)}`);
      return false;
    }
  }

  /** Opens the program that the address names: `?program=https://…`. */
  private async openAddress(): Promise<boolean> {
    let slow: ReturnType<typeof setTimeout> | undefined;
    try {
      const address = asked(location.search, document.baseURI);
      if (!address) return false;
      slow = setTimeout(() => this.page.ui.tell("note", `Loading ${fileOf(address.program)} from ${address.program.host}…`), SLOW_MS);
      this.open(await openingOf(address), true);
      return true;
    } catch (error) {
      this.refuse(errorText(error));
      return false;
    } finally {
      clearTimeout(slow);
    }
  }

  private async share(): Promise<void> {
    const { ui, editor } = this.page;
    const decoder = new TextDecoder("utf-8", { fatal: true });
    const files: [string, string][] = [];
    try {
      for (const { path, bytes } of this.files) files.push([path, decoder.decode(bytes)]);
    } catch {
      return ui.tell("warning", "Files that are not text cannot be shared in a link: send the files.");
    }
    const machine = this.chosenMachine() ?? null;
    const fragment = await fragmentOf({ name: this.name, text: editor.view.state.doc.toString(), machine, files });
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
  private chosenMachine(): string | undefined {
    const { machine } = sorted([{ name: this.name }, ...this.files.map(({ path }) => ({ name: path }))]);
    return this.page.ui.machine.value || machine || this.machineAtOpening;
  }

  /** A machine file that was laid next to the program is the one that it runs on. */
  private chooseWhenListed(): void {
    const { machine } = this.page.ui;
    new MutationObserver(() => {
      if (this.chooseLater === undefined || ![...machine.options].some(({ value }) => value === this.chooseLater)) return;
      machine.value = this.chooseLater;
      this.chooseLater = undefined;
    }).observe(machine, { childList: true });
  }

  /** The worker has failed: offers to begin again with the text of the page. */
  private offerRestart(why: string): void {
    const { ui, editor } = this.page;
    const text = editor.view.state.doc.toString();
    if (this.name === "") return ui.tell("error", `Chordal cannot start: ${why}.`);
    ui.ask(`Chordal failed: ${why}. What you typed is still here.`, [
      ["Begin again with it", () => {
        editor.setDirty(false);
        const { name, files, against } = this;
        this.open({ name, program: encode(text), files, machine: this.chosenMachine(), against });
      }],
    ]);
  }

  /** The choice of another file to compare with. */
  private offerAnother(panel: HTMLElement): void {
    const input = element("input");
    Object.assign(input, { type: "file", multiple: true, id: "another", hidden: true });
    input.addEventListener("change", () => {
      const files = [...(input.files ?? [])];
      input.value = "";
      if (files.length > 0) void this.compareWith(files);
    });
    const choose = element("button", "", "Another file…");
    Object.assign(choose, { type: "button", title: "Compare with another file, chosen with its machine file where it needs one" });
    choose.addEventListener("click", () => input.click());
    panel.querySelector("#against")!.closest("label")!.after(choose, input);
  }

  /** What the browser's tests look at. */
  private exposeForTests(): void {
    Object.assign(window, {
      standalone: { core: this.core, open: (opening: Opened) => this.open(opening), opened: () => ({ name: this.name, files: this.files }) },
    });
  }
}
