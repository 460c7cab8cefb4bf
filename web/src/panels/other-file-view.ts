// A read-only view of another file, over the program: for F12 on a call of a subprogram, and for the other program.

import { EditorState } from "@codemirror/state";
import { EditorView, highlightActiveLine, lineNumbers } from "@codemirror/view";
import type { DefinitionPlace } from "../protocol/messages";
import { element } from "./dom";

export class OtherFileView {
  private root = element("section", "other-file");
  private title = element("h2");
  private body = element("div", "other-file-text");
  private close = element("button", "", "Back to the program");
  private view: EditorView | undefined;

  constructor(
    parent: HTMLElement,
    private onClosed: () => void,
  ) {
    this.close.type = "button";
    this.close.title = "Back to the program (Esc)";
    this.close.addEventListener("click", () => this.hide());
    this.root.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      this.hide();
    });
    const head = element("header");
    head.append(this.title, this.close);
    this.root.append(head, this.body);
    this.root.hidden = true;
    parent.append(this.root);
  }

  /** Shows the text of a place at its line; `firstLine` is the number of the first line of the text, which may be an extract of its file. */
  show(place: DefinitionPlace, firstLine = 1): void {
    this.view?.destroy();
    const name = (place.file ?? "").split(/[\\/]/).pop()!;
    this.title.textContent = `${name}, read only${place.cut_off ? " (the beginning)" : ""}`;
    this.root.setAttribute("aria-label", name);
    this.root.hidden = false;
    const nonce = document.querySelector<HTMLMetaElement>("meta[name=csp-nonce]")?.content ?? "";
    const state = EditorState.create({
      doc: place.text ?? "",
      extensions: [
        EditorView.cspNonce.of(nonce),
        EditorState.readOnly.of(true),
        lineNumbers({ formatNumber: (line) => String(line + firstLine - 1) }),
        highlightActiveLine(),
        EditorView.contentAttributes.of({ "aria-label": name }),
      ],
    });
    this.view = new EditorView({ parent: this.body, state });
    const { doc } = state;
    const line = doc.line(Math.max(1, Math.min(doc.lines, place.line - firstLine + 1)));
    const offset = Math.min(line.to, line.from + place.column);
    this.view.dispatch({ selection: { anchor: offset }, effects: EditorView.scrollIntoView(offset, { y: "center" }) });
    this.view.focus();
  }

  private hide(): void {
    this.root.hidden = true;
    this.view?.destroy();
    this.view = undefined;
    this.onClosed();
  }
}
