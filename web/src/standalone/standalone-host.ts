// The host of the standalone page: it opens and saves programs, shares them, and stores recent ones.

import "./start-dialog.css";
import type { PageHost, PageParts } from "../page-host";
import { element } from "../panels/dom";
import { type AddressRequest, addressRequest, fetchFile, fileOf, programQuery } from "./address";
import type { OpenedProgram, OtherProgram, ProgramFile } from "./engine";
import { openDroppedFiles } from "./file-drop";
import { type Example, exampleAt, gallery } from "./gallery";
import { distinctName, nameOf, sizeComplaint, sortFiles } from "./opened-files";
import { MAX_RECENT_BYTES, findRecent, keepRecent, sizeOf } from "./recent-programs";
import { registerServiceWorker } from "./service-worker";
import { type SharedProgram, MAX_LINK_CHARACTERS, fragmentOf, programInFragment } from "./share-link";
import { StartDialog } from "./start-dialog";
import { WorkerConnection } from "./worker-connection";

/** The address of the WebAssembly module; its name contains a hash of the content. */
declare const MODULE: string;

/** A larger program is stored as a recent one only after a delay, when its path is probably complete. */
const LONG_PROGRAM_BYTES = 2 ** 20;
const STORE_LONG_AFTER_MS = 15_000;
/** Loading that takes longer is shown to the user, ms. */
const SLOW_MS = 500;
/** The address of a download is revoked after this time, ms: the browser has read it by then. */
const DOWNLOAD_MS = 10_000;

async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL(MODULE, document.baseURI));
  if (!response.ok) throw new Error(`${MODULE}: ${response.status} ${response.statusText}`);
  // Streaming compilation requires the type of WebAssembly.
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

function button(id: string, text: string, title: string, onClick: () => void): HTMLButtonElement {
  const item = element("button", "", text);
  Object.assign(item, { type: "button", id, title });
  item.addEventListener("click", onClick);
  return item;
}

/** Loads the program and the files that an address names. */
async function loadRequested({ program, files: fileUrls, against: other, machine }: AddressRequest): Promise<OpenedProgram> {
  const [bytes, otherBytes, ...rest] = await Promise.all([fetchFile(program), other && fetchFile(other), ...fileUrls.map(fetchFile)]);
  const files = fileUrls.map((url, index) => ({ path: fileOf(url), bytes: rest[index]! }));
  const chosen = machine ?? sortFiles([{ name: fileOf(program) }, ...files.map(({ path }) => ({ name: path }))]).machine;
  const against = other && otherBytes && { name: distinctName(fileOf(other), fileOf(program)), program: otherBytes, machine: chosen };
  return { name: fileOf(program), program: bytes, files, machine: chosen, against };
}

export class StandaloneHost implements PageHost {
  readonly lostMessage = "";
  readonly anotherHint = "“Another file…” opens a second program.";
  readonly savedMessage = "Saved: the file is with the browser's downloads.";
  /** The name of the open program; empty before the first. */
  private name = "";
  private files: ProgramFile[] = [];
  private against: OtherProgram | undefined;
  /** The machine that the program was opened with. */
  private machineAtOpening: string | undefined;
  /** A machine file that is to be chosen when it is in the list of machines. */
  private pendingMachine: string | undefined;
  private page!: PageParts;
  private startDialog!: StartDialog;
  private core = new WorkerConnection(compile(), (name) => new Worker(new URL("./worker-entry.ts", import.meta.url), { type: "module", name }));

  dial: PageHost["dial"] = (onData) => this.core.dial(onData);

  keepFile = (fileName: string, bytes: Uint8Array): void => {
    download(fileName, bytes);
    this.storeRecent(bytes.slice().buffer as ArrayBuffer);
  };

  addControls = (page: PageParts): void => {
    this.page = page;
    const { ui } = page;
    this.startDialog = this.makeStart();
    this.offerAnother(ui.panels.compare);
    ui.save.title = "Save: the browser keeps the file with its downloads (Ctrl-S)";
    ui.save.before(button("open", "Open", "Open a program, an example, or machine files", () => this.startDialog.show()));
    const sharing = button("share", "Share", "A link with the program in it", () => void this.share());
    sharing.hidden = true;
    ui.save.after(sharing);
    this.chooseWhenListed();
    this.core.onLost = (why) => this.offerRestart(why);
    openDroppedFiles(document, {
      files: (files) => {
        this.startDialog.hide();
        void this.openFiles(files);
      },
      text: (text) => {
        this.startDialog.hide();
        this.openPasted(text);
      },
    });
    window.addEventListener("hashchange", () => void this.openLink());
    void this.openFirst();
    registerServiceWorker((load) => ui.prompt("A newer version of this page is ready.", [["Load it", load], ["Later", () => {}]]));
    this.exposeForTests();
  };

  private makeStart(): StartDialog {
    return new StartDialog({
      files: (files) => void this.openFiles(files),
      text: (text) => this.openPasted(text),
      recent: (name) => void findRecent(name).then((program) => program && this.open(program)),
      example: (example: Example) => this.openTexts(example),
      // The content policy allows the page to load only what its own address names.
      address: (text) => location.assign(programQuery(text)),
    });
  }

  /** Opens the program that the address of the page names; otherwise shows the start dialog. */
  private async openFirst(): Promise<void> {
    const isOpen = (await this.openLink()) || (await this.openExample()) || (await this.openAddress());
    if (!isOpen) this.startDialog.show();
  }

  /** Stores the program as a recent one: at once, so that closing the page does not lose it, but a long one with a delay. */
  private storeRecent(program: ArrayBuffer, machine?: string): void {
    const { name, files } = this;
    if (sizeOf({ program, files }) > MAX_RECENT_BYTES) return;
    // A copy, because the bytes are transferred to the worker.
    const recent = { name, program: program.slice(0), files, machine, at: Date.now() };
    if (program.byteLength > LONG_PROGRAM_BYTES) setTimeout(() => void keepRecent(recent), STORE_LONG_AFTER_MS);
    else void keepRecent(recent);
  }

  /** Opens a program; where unsaved changes would be lost, the user is prompted before. */
  private open(opening: OpenedProgram, isFromLink = false): void {
    const { ui, editor, connection } = this.page;
    const openNow = () => {
      ({ name: this.name, files: this.files, against: this.against, machine: this.machineAtOpening } = opening);
      connection.dropQueries();
      // The address no longer names the open program.
      if (!isFromLink && location.hash + location.search !== "") history.replaceState(null, "", location.pathname);
      this.storeRecent(opening.program, opening.machine);
      document.querySelector<HTMLElement>("#share")!.hidden = false;
      this.core.open(opening).catch((error: unknown) => ui.notify("error", `The page is not complete: ${String(error)}`));
    };
    if (!editor.dirty) return openNow();
    ui.prompt(`What you typed in ${this.name} is not saved.`, [
      [`Open ${opening.name} and lose it`, openNow],
      ["Cancel", () => {}],
    ]);
  }

  private async openFiles(files: File[]): Promise<void> {
    const opened = await this.readAll(files);
    if (!opened) return;
    const { program, bytes, others, read, machine } = opened;
    if (!program || !bytes) return this.addFiles(read, machine);
    // Machine files are kept: the next program may be for the same machine.
    const machines = this.files.filter(({ path }) => path.endsWith(".toml") && path !== "chordal.toml" && !read.some((file) => file.path === path));
    const otherCount = others.filter((file) => !/\.toml$/i.test(file.name)).length;
    this.open({ name: nameOf(program.name), program: bytes, files: [...read, ...machines], machine });
    if (otherCount > 0) this.page.ui.notify("note", `${program.name} is shown; ${otherCount === 1 ? "1 other file lies" : `${otherCount} other files lie`} next to it.`);
  }

  /** Reads files, and finds the program among them; undefined, with a message, where that fails. */
  private async readAll(files: File[]) {
    const complaint = files.map((file) => sizeComplaint(file.name, file.size)).find(Boolean);
    if (complaint) return this.refuse(complaint);
    const { program, others, machine } = sortFiles(files);
    try {
      const read = await Promise.all(others.map(async (file) => ({ path: nameOf(file.name), bytes: await file.arrayBuffer() })));
      return { program, bytes: await program?.arrayBuffer(), others, read, machine };
    } catch (error) {
      return this.refuse(`A file cannot be read: ${String(error)}`);
    }
  }

  /** Compares the program with another one, on the same machine unless the files include one. */
  private async compareWith(files: File[]): Promise<void> {
    const { editor, connection } = this.page;
    const opened = await this.readAll(files);
    if (!opened) return;
    const { program, bytes, read, machine } = opened;
    if (!program || !bytes) return this.refuse("There is no program among these files.");
    if (read.length > 0) this.addFiles(read, undefined);
    this.against = { name: distinctName(nameOf(program.name), this.name), program: bytes, machine: machine ?? this.chosenMachine() };
    editor.flush();
    this.core.setOtherProgram(this.against);
    connection.send("compare_with", { other: "named" });
  }

  /** Adds files to the open program. */
  private addFiles(more: ProgramFile[], machine: string | undefined): void {
    const { editor, connection } = this.page;
    if (this.name === "") return this.refuse("These files belong to a program: choose it together with them.");
    this.files = [...this.files.filter(({ path }) => !more.some((file) => file.path === path)), ...more];
    editor.flush();
    this.core.setFiles(this.files);
    // An empty change runs the text again.
    if (!machine) return connection.send("edit", { changes: [] });
    this.pendingMachine = machine;
    connection.send("machine", { name: machine });
  }

  /** Shows why something cannot be opened. */
  private refuse(why: string): undefined {
    this.page.ui.notify("error", why);
    this.startDialog.setMessage(why);
  }

  private openPasted(text: string): void {
    this.openTexts({ name: "pasted.nc", text, machine: null, files: [] });
  }

  private openTexts({ name, text, files, machine }: Pick<SharedProgram, "name" | "text" | "machine" | "files">, isFromLink = false): void {
    const encoded = files.map(([path, content]) => ({ path, bytes: encode(content) }));
    this.open({ name: nameOf(name), program: encode(text), files: encoded, machine: machine ?? undefined }, isFromLink);
  }

  /** Opens the program in the fragment of the address; returns whether there is one. */
  private async openLink(): Promise<boolean> {
    try {
      const shared = await programInFragment(location.hash);
      if (shared) this.openTexts(shared, true);
      return shared !== undefined;
    } catch (error) {
      this.refuse(errorText(error));
      return false;
    }
  }

  /** Opens the example that the address names, `?example=haas/thread-mill.nc`; the documentation links to examples in this way. */
  private async openExample(): Promise<boolean> {
    const path = new URLSearchParams(location.search).get("example");
    if (!path) return false;
    try {
      const example = exampleAt(await gallery(), path);
      if (example) this.openTexts(example, true);
      else this.refuse(`There is no example ${path}.`);
      return example !== undefined;
    } catch (error) {
      this.refuse(`The examples cannot be read: ${String(error)}`);
      return false;
    }
  }

  /** Loads and opens the program that the address names, `?program=https://…`. */
  private async openAddress(): Promise<boolean> {
    let slowTimer: ReturnType<typeof setTimeout> | undefined;
    try {
      const address = addressRequest(location.search, document.baseURI);
      if (!address) return false;
      slowTimer = setTimeout(() => this.page.ui.notify("note", `Loading ${fileOf(address.program)} from ${address.program.host}…`), SLOW_MS);
      this.open(await loadRequested(address), true);
      return true;
    } catch (error) {
      this.refuse(errorText(error));
      return false;
    } finally {
      clearTimeout(slowTimer);
    }
  }

  /** Puts a link with the program into the clipboard, or else only into the address bar. */
  private async share(): Promise<void> {
    const { ui, editor } = this.page;
    const decoder = new TextDecoder("utf-8", { fatal: true });
    const files: [string, string][] = [];
    try {
      for (const { path, bytes } of this.files) files.push([path, decoder.decode(bytes)]);
    } catch {
      return ui.notify("warning", "Files that are not text cannot be shared in a link: send the files.");
    }
    const machine = this.chosenMachine() ?? null;
    const fragment = await fragmentOf({ name: this.name, text: editor.view.state.doc.toString(), machine, files });
    const address = location.origin + location.pathname + fragment;
    if (address.length > MAX_LINK_CHARACTERS) {
      return ui.notify("warning", `The link would have ${address.length.toLocaleString("en")} characters; up to ${MAX_LINK_CHARACTERS.toLocaleString("en")} can be shared. Send the file.`);
    }
    history.replaceState(null, "", address);
    try {
      await navigator.clipboard.writeText(address);
      ui.notify("note", "The link is copied. The program is in the link itself: nothing was sent.");
    } catch {
      ui.notify("note", "The link is in the address bar. The program is in the link itself: nothing was sent.");
    }
  }

  /** The chosen machine, or the one that the program was opened with. */
  private chosenMachine(): string | undefined {
    const { machine } = sortFiles([{ name: this.name }, ...this.files.map(({ path }) => ({ name: path }))]);
    return this.page.ui.machine.value || machine || this.machineAtOpening;
  }

  /** Chooses the machine file that was added, as soon as it is listed. */
  private chooseWhenListed(): void {
    const { machine } = this.page.ui;
    new MutationObserver(() => {
      if (this.pendingMachine === undefined || ![...machine.options].some(({ value }) => value === this.pendingMachine)) return;
      machine.value = this.pendingMachine;
      this.pendingMachine = undefined;
    }).observe(machine, { childList: true });
  }

  /** After a failure of the worker offers to begin again with the text of the page. */
  private offerRestart(why: string): void {
    const { ui, editor } = this.page;
    const text = editor.view.state.doc.toString();
    if (this.name === "") return ui.notify("error", `Chordal cannot start: ${why}.`);
    ui.prompt(`Chordal failed: ${why}. What you typed is still here.`, [
      ["Begin again with it", () => {
        editor.setDirty(false);
        const { name, files, against } = this;
        this.open({ name, program: encode(text), files, machine: this.chosenMachine(), against });
      }],
    ]);
  }

  /** Adds the button to compare with another file. */
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

  /** For the tests in the browser. */
  private exposeForTests(): void {
    Object.assign(window, {
      standalone: { core: this.core, open: (opening: OpenedProgram) => this.open(opening), opened: () => ({ name: this.name, files: this.files }) },
    });
  }
}
