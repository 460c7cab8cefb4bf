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

/** Changes as the server takes them: places are those of the text before. */
export function changesOf(set: ChangeSet): TextChange[] {
  const changes: TextChange[] = [];
  set.iterChanges((from, to, _fromB, _toB, inserted) => {
    changes.push({ from, to, insert: inserted.toString() });
  });
  return changes;
}

/** The range of a place that a run has reported, cut off where the text has become shorter since. */
export function rangeOf(doc: Text, place: SourcePlace): { from: number; to: number } {
  const at = (line: number, column: number) => {
    const own = doc.line(Math.max(1, Math.min(doc.lines, line)));
    return Math.min(own.to, own.from + column);
  };
  const from = at(place.line, place.column);
  return { from, to: Math.max(from, at(place.end_line, place.end_column)) };
}

export interface EditorHandlers {
  typed: (changes: TextChange[]) => void;
  /** The cursor is on a line, put there by the user or by [`TextEditor.goTo`]. */
  cursor: (line: number, byUser: boolean) => void;
  save: () => void;
  /** The definition of the name at a line and a column is to be shown. */
  definition: (line: number, column: number) => void;
}

/** The text with one more piece after it; pieces may end within a line. */
export function appendPiece(before: Text, piece: string): Text {
  return before.append(Text.of(piece.split("\n")));
}

/** The text is run once nothing was typed for so long, ms. */
const QUIET_MS = 120;

const setLines = StateEffect.define<{ kind: "differs" | "now"; lines: number[] }>();

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
  private pending: ChangeSet | undefined;
  private timer = 0;
  private silent = false;
  private problems: Problem[] = [];
  private differing: number[] = [];
  private pendingText = Text.empty;
  dirty = false;
  onDirty: (dirty: boolean) => void = () => {};

  constructor(
    parent: HTMLElement,
    private handlers: EditorHandlers,
    private more: import("@codemirror/state").Extension = [],
  ) {
    // Nothing may be typed before the text has come.
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
        this.more,
        EditorView.domEventHandlers({
          mousedown: (event, view) => {
            const at = event.ctrlKey || event.metaKey ? view.posAtCoords(event) : null;
            if (at === null) return false;
            this.requestDefinition(at);
            return true;
          },
        }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged && !this.silent) this.changed(update.changes);
          if (update.selectionSet || update.docChanged) {
            const line = update.state.doc.lineAt(update.state.selection.main.head).number;
            this.handlers.cursor(line, !this.silent);
          }
        }),
      ],
    });
  }

  private requestDefinition(at: number): void {
    const line = this.view.state.doc.lineAt(at);
    this.flush();
    this.handlers.definition(line.number, at - line.from);
  }

  private changed(changes: ChangeSet): void {
    this.pending = this.pending ? this.pending.compose(changes) : changes;
    if (!this.dirty) this.setDirty(true);
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.flush(), QUIET_MS);
  }

  /** Sends the server what was typed, now. */
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

  /** Adds a piece of the server's text, which replaces the text of the editor once the last piece has come. */
  addText(piece: string, isFirst: boolean, isLast: boolean): void {
    this.pendingText = appendPiece(isFirst ? Text.empty : this.pendingText, piece);
    if (isLast) this.setText(this.pendingText);
    // What was typed now would belong to neither text.
    else if (isFirst) this.view.setState(this.stateOf(this.view.state.doc, true));
  }

  private setText(doc: Text): void {
    this.pending = undefined;
    this.pendingText = Text.empty;
    this.silent = true;
    const line = this.line;
    this.view.setState(this.stateOf(doc));
    this.view.dispatch({ selection: { anchor: doc.line(Math.min(line, doc.lines)).from } });
    this.silent = false;
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
    return [fix, ...other_fixes].flatMap((one) => {
      const place = one?.place;
      if (!one || !place?.own) return [];
      const { replacement, title, safe } = one;
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

  /** Puts the cursor on a line and shows it. */
  goTo(line: number, column = 0, focus = false): void {
    const { doc } = this.view.state;
    const own = doc.line(Math.max(1, Math.min(doc.lines, line)));
    const at = Math.min(own.to, own.from + column);
    this.silent = true;
    this.view.dispatch({
      selection: { anchor: at },
      effects: EditorView.scrollIntoView(at, { y: "center" }),
    });
    this.silent = false;
    // Without this the pane would be empty for a frame: the lines are replaced now, and only the next
    // frame would scroll to them.
    this.view.coordsAtPos(at);
    if (focus) this.view.focus();
  }

  get line(): number {
    const { doc, selection } = this.view.state;
    return doc.lineAt(selection.main.head).number;
  }
}

/** A problem with everything that is known of it. */
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
