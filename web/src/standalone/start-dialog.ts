// The dialog in which a program is opened: files, a pasted text, an address, recent programs, examples.

import { element } from "../panels/dom";
import { type Example, type ExampleGroup, gallery } from "./gallery";
import { type RecentEntry, forgetRecent, listRecent } from "./recent-programs";

export interface StartHandlers {
  files: (files: File[]) => void;
  text: (text: string) => void;
  recent: (name: string) => void;
  example: (example: Example) => void;
  address: (text: string) => void;
}

function button(text: string, onClick: () => void, className = ""): HTMLButtonElement {
  const item = element("button", className, text);
  item.type = "button";
  item.addEventListener("click", onClick);
  return item;
}

function sizeText(bytes: number): string {
  return bytes < 1024 ? `${bytes} bytes` : bytes < 2 ** 20 ? `${(bytes / 1024).toFixed(0)} KiB` : `${(bytes / 2 ** 20).toFixed(1)} MiB`;
}

/** Recent programs that are shown; the others are in a closed list. */
const MAX_VISIBLE_RECENTS = 6;

export class StartDialog {
  private root = element("dialog", "start");
  private recents = element("section", "recents");
  private examples = element("section", "examples");
  private message = element("p", "start-message");
  private input = element("input");

  constructor(private handlers: StartHandlers) {
    const title = element("h2", "", "Open a program");
    title.id = "start-title";
    this.root.setAttribute("aria-labelledby", title.id);
    const head = element("header");
    const close = button("Close", () => this.root.close());
    head.append(title, close);
    const privacy = element("p", "privacy", "Everything runs in this browser. No program leaves your computer.");
    Object.assign(this.input, { type: "file", multiple: true, id: "files" });
    this.input.addEventListener("change", () => {
      const files = [...(this.input.files ?? [])];
      this.input.value = "";
      if (files.length > 0) this.closeAndRun(() => this.handlers.files(files));
    });
    const label = element("label", "files", "Files: the program, with its machine or setup file and its subprograms");
    label.append(this.input);
    const paste = element("textarea");
    paste.id = "paste";
    Object.assign(paste, { rows: 4, spellcheck: false, placeholder: "%\nO1\nG0 X0 Y0\nM30\n%" });
    const pasteLabel = element("label", "paste", "Or paste a text");
    pasteLabel.append(paste);
    const run = button("Open the text", () => {
      const { value } = paste;
      paste.value = "";
      this.closeAndRun(() => this.handlers.text(value));
    });
    const address = element("input");
    Object.assign(address, { type: "url", id: "address", placeholder: "https://" });
    const addressLabel = element("label", "address", "Or load it from an address");
    addressLabel.append(address);
    const load = button("Load", () => {
      if (address.value.trim() !== "") this.handlers.address(address.value.trim());
    });
    this.message.setAttribute("role", "status");
    const newProgram = element("section", "own");
    newProgram.append(label, element("p", "hint", "Or drop files anywhere on the page."), pasteLabel, run, addressLabel, load);
    this.root.append(head, privacy, this.message, newProgram, this.recents, this.examples);
    document.body.append(this.root);
    // A message stays until the dialog is closed.
    this.setMessage("");
    this.root.addEventListener("close", () => this.setMessage(""));
  }

  show(): void {
    if (this.root.open) return;
    this.root.showModal();
    void listRecent().then((entries) => this.showRecents(entries));
    if (this.examples.childElementCount === 0) {
      gallery().then(
        (groups) => this.showExamples(groups),
        () => this.examples.replaceChildren(element("p", "", "The examples cannot be loaded now.")),
      );
    }
  }

  hide(): void {
    this.root.close();
  }

  get isOpen(): boolean {
    return this.root.open;
  }

  /** Shows why something could not be opened; empty for no message. */
  setMessage(text: string): void {
    this.message.textContent = text;
    this.message.hidden = text === "";
  }

  private closeAndRun(action: () => void): void {
    this.root.close();
    action();
  }

  private showRecents(entries: RecentEntry[]): void {
    this.recents.hidden = entries.length === 0;
    const rows = entries.map((entry) => {
      const row = element("li");
      const open = button("", () => this.closeAndRun(() => this.handlers.recent(entry.name)), "card");
      open.append(element("strong", "", entry.name), element("span", "", `${sizeText(entry.bytes)}, ${new Date(entry.at).toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" })}`));
      const forget = button("Forget", () => void forgetRecent(entry.name).then(() => listRecent()).then((left) => this.showRecents(left)));
      forget.setAttribute("aria-label", `Forget ${entry.name}`);
      row.append(open, forget);
      return row;
    });
    const cards = (items: HTMLElement[]) => {
      const list = element("ul", "cards");
      list.append(...items);
      return list;
    };
    this.recents.replaceChildren(element("h3", "", "Open lately, kept in this browser"), cards(rows.slice(0, MAX_VISIBLE_RECENTS)));
    if (rows.length <= MAX_VISIBLE_RECENTS) return;
    const more = element("details");
    more.append(element("summary", "", `${rows.length - MAX_VISIBLE_RECENTS} more`), cards(rows.slice(MAX_VISIBLE_RECENTS)));
    this.recents.append(more);
  }

  private showExamples(groups: ExampleGroup[]): void {
    const parts = groups.map(({ title, examples }) => {
      const details = element("details");
      const cards = element("ul", "cards");
      for (const example of examples) {
        const row = element("li");
        const open = button("", () => this.closeAndRun(() => this.handlers.example(example)), "card");
        open.append(element("strong", "", example.name), element("span", "", example.shows));
        row.append(open);
        cards.append(row);
      }
      details.append(element("summary", "", `${title} (${examples.length})`), cards);
      return details;
    });
    this.examples.replaceChildren(element("h3", "", "Examples"), ...parts);
  }
}
