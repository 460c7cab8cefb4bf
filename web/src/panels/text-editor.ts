// The program as text: CodeMirror, with the problems that the server finds.

import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { type Diagnostic, lintGutter, nextDiagnostic, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { type ChangeSet, EditorState, RangeSetBuilder, StateEffect, StateField, Text } from "@codemirror/state";
import {
  Decoration,
  type DecorationSet,
  EditorView,
  drawSelection,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import type { Problem, SourcePlace } from "../protocol/messages";
import { codeSpans, plainText } from "./code-spans";
import { element } from "./dom";
import { markdown, unwrapParagraphs } from "./syntax-hints";

export interface TextChange {
  from: number;
  to: number;
  insert: string;
}

/** Changes as the server takes them: offsets are those of the text before. */
export function changesOf(set: ChangeSet): TextChange[] {
  const changes: TextChange[] = [];
  set.iterChanges((from, to, _fromB, _toB, inserted) => {
    changes.push({ from, to, insert: inserted.toString() });
  });
  return changes;
}

/** The range of a place that a run has reported, clipped to the text, which may have become shorter since. */
export function rangeOf(doc: Text, place: SourcePlace): { from: number; to: number } {
  const offsetOf = (number: number, column: number) => {
    const line = doc.line(Math.max(1, Math.min(doc.lines, number)));
    return Math.min(line.to, line.from + column);
  };
  const from = offsetOf(place.line, place.column);
  return { from, to: Math.max(from, offsetOf(place.end_line, place.end_column)) };
}

export interface EditorHandlers {
  typed: (changes: TextChange[]) => void;
  /** The cursor was put on a line, by the user or by `TextEditor.goTo`. */
  cursor: (line: number, byUser: boolean) => void;
  save: () => void;
  /** Shows the definition of the name at a line and a column. */
  definition: (line: number, column: number) => void;
}

/** Appends a piece to a text; pieces may end within a line. */
export function appendPiece(before: Text, piece: string): Text {
  return before.append(Text.of(piece.split("\n")));
}

/** How long typing must rest before the changes are sent, ms. */
const REST_MS = 120;

const setLines = StateEffect.define<{ kind: "differs" | "now"; lines: number[] }>();

/** Highlights the lines of the newest `setLines` effect of a kind with a class. */
function lineMarks(kind: "differs" | "now", name: string) {
  const mark = Decoration.line({ class: name });
  return StateField.define<DecorationSet>({
    create: () => Decoration.none,
    update(marks, transaction) {
      marks = marks.map(transaction.changes);
      for (const effect of transaction.effects) {
        if (!effect.is(setLines) || effect.value.kind !== kind) continue;
        const builder = new RangeSetBuilder<Decoration>();
        for (const line of effect.value.lines) {
          if (line < 1 || line > transaction.newDoc.lines) continue;
          const { from } = transaction.newDoc.line(line);
          builder.add(from, from, mark);
        }
        marks = builder.finish();
      }
      return marks;
    },
    provide: (field) => EditorView.decorations.from(field),
  });
}

export class TextEditor {
  readonly view: EditorView;
  /** What was typed and is not sent yet. */
  private pending: ChangeSet | undefined;
  private timer = 0;
  /** Changes are those of the page, not of the user. */
  private isSilent = false;
  private problems: Problem[] = [];
  private differing: number[] = [];
  /** The pieces of the server's text so far. */
  private pendingText = Text.empty;
  dirty = false;
  onDirty: (dirty: boolean) => void = () => {};

  constructor(
    parent: HTMLElement,
    private handlers: EditorHandlers,
    private extensions: import("@codemirror/state").Extension = [],
  ) {
    // Read-only until the text has come.
    this.view = new EditorView({ parent, state: this.stateOf(Text.empty, true) });
    // The pane can be scrolled with the keyboard, too.
    this.view.scrollDOM.tabIndex = 0;
  }

  private stateOf(doc: Text, readOnly = false): EditorState {
    const nonce = document.querySelector<HTMLMetaElement>("meta[name=csp-nonce]")?.content ?? "";
    return EditorState.create({
      doc,
      extensions: [
        EditorView.cspNonce.of(nonce),
        EditorState.readOnly.of(readOnly),
        lineNumbers(),
        history(),
        drawSelection(),
        highlightActiveLine(),
        highlightActiveLineGutter(),
        highlightSelectionMatches(),
        search({ top: true }),
        lintGutter(),
        lineMarks("differs", "line-differs"),
        lineMarks("now", "line-now"),
        EditorView.contentAttributes.of({ "aria-label": "Program" }),
        keymap.of([
          { key: "Mod-s", run: () => (this.handlers.save(), true), preventDefault: true },
          { key: "F8", run: nextDiagnostic },
          { key: "F12", run: (view) => (this.requestDefinition(view.state.selection.main.head), true) },
          ...searchKeymap,
          ...historyKeymap,
          ...defaultKeymap,
        ]),
        this.extensions,
        EditorView.domEventHandlers({
          mousedown: (event, view) => {
            const offset = event.ctrlKey || event.metaKey ? view.posAtCoords(event) : null;
            if (offset === null) return false;
            this.requestDefinition(offset);
            return true;
          },
        }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged && !this.isSilent) this.changed(update.changes);
          if (update.selectionSet || update.docChanged) {
            const line = update.state.doc.lineAt(update.state.selection.main.head).number;
            this.handlers.cursor(line, !this.isSilent);
          }
        }),
      ],
    });
  }

  private requestDefinition(offset: number): void {
    const line = this.view.state.doc.lineAt(offset);
    this.flush();
    this.handlers.definition(line.number, offset - line.from);
  }

  private changed(changes: ChangeSet): void {
    this.pending = this.pending ? this.pending.compose(changes) : changes;
    if (!this.dirty) this.setDirty(true);
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.flush(), REST_MS);
  }

  /** Sends what was typed to the server at once. */
  flush(): void {
    window.clearTimeout(this.timer);
    if (!this.pending) return;
    const changes = changesOf(this.pending);
    this.pending = undefined;
    this.handlers.typed(changes);
  }

  setDirty(dirty: boolean): void {
    this.dirty = dirty;
    this.onDirty(dirty);
  }

  /** Adds a piece of the server's text, which replaces the text of the editor when the last piece has come. */
  addText(piece: string, isFirst: boolean, isLast: boolean): void {
    this.pendingText = appendPiece(isFirst ? Text.empty : this.pendingText, piece);
    if (isLast) this.setText(this.pendingText);
    // Read-only meanwhile: what was typed would belong to neither text.
    else if (isFirst) this.view.setState(this.stateOf(this.view.state.doc, true));
  }

  private setText(doc: Text): void {
    this.pending = undefined;
    this.pendingText = Text.empty;
    this.isSilent = true;
    const line = this.line;
    this.view.setState(this.stateOf(doc));
    this.view.dispatch({ selection: { anchor: doc.line(Math.min(line, doc.lines)).from } });
    this.isSilent = false;
    this.setDirty(false);
    this.setProblems(this.problems);
    this.markLines("differs", this.differing);
  }

  setProblems(problems: Problem[]): void {
    this.problems = problems;
    const { doc } = this.view.state;
    const diagnostics: Diagnostic[] = problems
      .filter(({ place }) => place?.own && place.line <= doc.lines)
      .map((problem) => {
        const { from, to } = rangeOf(doc, problem.place!);
        return {
          from,
          to,
          severity: problem.severity === "note" ? "info" : problem.severity,
          message: plainText(problem.message),
          renderMessage: () => problemDetails(problem),
          actions: this.actionsOf(problem),
        } satisfies Diagnostic;
      })
      .sort((a, b) => a.from - b.from);
    this.view.dispatch(setDiagnostics(this.view.state, diagnostics));
  }

  private actionsOf({ fix, other_fixes }: Problem): Diagnostic["actions"] {
    return [fix, ...other_fixes].flatMap((offered) => {
      const place = offered?.place;
      if (!offered || !place?.own) return [];
      const { replacement, title, safe } = offered;
      return [{
        name: plainText(safe ? title : `${title} (check the result)`),
        apply: (view: EditorView) => {
          const { from, to } = rangeOf(view.state.doc, place);
          view.dispatch({ changes: { from, to, insert: replacement } });
          view.focus();
        },
      }];
    });
  }

  markLines(kind: "differs" | "now", lines: number[]): void {
    if (kind === "differs") this.differing = lines;
    this.view.dispatch({ effects: setLines.of({ kind, lines }) });
  }

  /** Puts the cursor on a line and scrolls to it. */
  goTo(line: number, column = 0, focus = false): void {
    const { doc } = this.view.state;
    const { from, to } = doc.line(Math.max(1, Math.min(doc.lines, line)));
    const offset = Math.min(to, from + column);
    this.isSilent = true;
    this.view.dispatch({
      selection: { anchor: offset },
      effects: EditorView.scrollIntoView(offset, { y: "center" }),
    });
    this.isSilent = false;
    // Forces the layout: otherwise the pane would be empty for a frame, because the lines are replaced now and the scrolling
    // follows in the next frame.
    this.view.coordsAtPos(offset);
    if (focus) this.view.focus();
  }

  /** The line of the cursor, from 1. */
  get line(): number {
    const { doc, selection } = this.view.state;
    return doc.lineAt(selection.main.head).number;
  }
}

/** A problem with all its texts. */
export function problemDetails(problem: Problem): HTMLElement {
  const root = element("div", "explained");
  const part = (name: string, text: string | null | undefined) => {
    if (text) root.append(codeSpans(text, name, "div"));
  };
  part("what", `${problem.code}: ${problem.message}`);
  part("label", problem.label);
  part("alarm", problem.alarm && `The control shows: ${problem.alarm}`);
  problem.notes.forEach((note) => part("note", note));
  part("help", problem.help);
  const more = element("details");
  more.append(element("summary", "", "What it means"), markdown(unwrapParagraphs(problem.explanation)));
  root.append(more);
  return root;
}
