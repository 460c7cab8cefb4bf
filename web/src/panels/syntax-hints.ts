// Syntax colours of the visible lines, and the meaning of the word under the pointer; both come from the server.

import { type Extension, RangeSetBuilder, StateEffect } from "@codemirror/state";
import { type DecorationSet, type ViewUpdate, Decoration, EditorView, ViewPlugin, hoverTooltip } from "@codemirror/view";
import type { WordMeaning } from "../protocol/messages";
import { element } from "./dom";

/** Four numbers for each token: line from 1, first column and the one after the last, in UTF-16 code units, and the index of its class. */
export type Tokens = number[];

export interface WordQueries {
  tokens: (from: number, to: number) => Promise<{ classes: string[]; tokens: Tokens } | undefined>;
  meaning: (line: number, column: number) => Promise<WordMeaning | undefined>;
}

/** Lines before and after the visible ones that are coloured as well. */
const MARGIN_LINES = 60;
/** How long scrolling and typing must rest before tokens are requested, ms. */
const REST_MS = 60;

const setTokens = StateEffect.define<DecorationSet>();
const refreshEffect = StateEffect.define<null>();

export function syntaxHints(queries: WordQueries): Extension {
  const marks = new Map<string, Decoration>();
  const markOf = (name: string) => {
    let mark = marks.get(name);
    if (!mark) marks.set(name, (mark = Decoration.mark({ class: `word-${name}` })));
    return mark;
  };
  const plugin = ViewPlugin.fromClass(
    class {
      decorations: DecorationSet = Decoration.none;
      private timer = 0;
      private version = 0;

      constructor(private view: EditorView) {
        this.requestLater();
      }

      update(update: ViewUpdate): void {
        if (update.docChanged) {
          this.version++;
          this.decorations = this.decorations.map(update.changes);
        }
        for (const transaction of update.transactions) {
          for (const effect of transaction.effects) {
            if (effect.is(setTokens)) this.decorations = effect.value;
            if (effect.is(refreshEffect)) this.requestLater();
          }
        }
        if (update.viewportChanged) this.requestLater();
      }

      destroy(): void {
        window.clearTimeout(this.timer);
      }

      private requestLater(): void {
        window.clearTimeout(this.timer);
        this.timer = window.setTimeout(() => void this.request(), REST_MS);
      }

      private async request(): Promise<void> {
        const { version, view } = this;
        const { doc } = view.state;
        const from = Math.max(1, doc.lineAt(view.viewport.from).number - MARGIN_LINES);
        const to = Math.min(doc.lines, doc.lineAt(view.viewport.to).number + MARGIN_LINES) + 1;
        const answer = await queries.tokens(from, to);
        // An answer about an older text is out of date; the run of the newer one requests tokens again.
        if (!answer || version !== this.version) return;
        view.dispatch({ effects: setTokens.of(this.build(answer.classes, answer.tokens)) });
      }

      private build(classes: string[], tokens: Tokens): DecorationSet {
        const { doc } = this.view.state;
        const builder = new RangeSetBuilder<Decoration>();
        let last = -1;
        for (let index = 0; index + 3 < tokens.length; index += 4) {
          const [number, start, end, kind] = tokens.slice(index, index + 4) as [number, number, number, number];
          if (number > doc.lines) break;
          const line = doc.line(number);
          const from = Math.min(line.to, line.from + start);
          const to = Math.min(line.to, line.from + end);
          if (from >= to || from < last) continue;
          last = from;
          builder.add(from, to, markOf(classes[kind] ?? "unknown"));
        }
        return builder.finish();
      }
    },
    { decorations: (value) => value.decorations },
  );
  const hover = hoverTooltip(async (view, offset) => {
    const line = view.state.doc.lineAt(offset);
    const answer = await queries.meaning(line.number, offset - line.from);
    if (!answer || answer.line > view.state.doc.lines) return null;
    const answerLine = view.state.doc.line(answer.line);
    return {
      pos: Math.min(answerLine.to, answerLine.from + answer.column),
      end: Math.min(answerLine.to, answerLine.from + answer.end_column),
      create: () => ({ dom: markdown(answer.text) }),
    };
  }, { hoverTime: 250 });
  return [plugin, hover];
}

/** Requests tokens again, after a run of the text. */
export function refreshTokens(view: EditorView): void {
  view.dispatch({ effects: refreshEffect.of(null) });
}

/** A line of at least this length was probably wrapped for a terminal. */
const MIN_WRAPPED_CHARACTERS = 70;

/** Undoes the wrapping of a text for a terminal: each paragraph becomes one line. */
export function unwrapParagraphs(text: string): string {
  return text.replace(/^(.*)\n(?=[^\s\-*`|>])/gm, (whole, line: string) => (line.length >= MIN_WRAPPED_CHARACTERS ? `${line} ` : whole));
}

/** Renders paragraphs, code and bold of Markdown; everything else stays text. */
export function markdown(text: string): HTMLElement {
  const root = element("div", "meaning");
  // A fenced block is always a separate paragraph, even without blank lines around it.
  text = text.replace(/\n*(```\w*\n[\s\S]*?\n?```)\n*/g, "\n\n$1\n\n");
  for (const paragraph of text.split(/\n{2,}/)) {
    const fenced = /^```\w*\n([\s\S]*?)\n?```$/.exec(paragraph.trim());
    if (fenced) {
      root.append(element("pre", "", fenced[1]));
      continue;
    }
    const block = element("p");
    for (const [piece, code, bold] of markdownPieces(paragraph)) {
      if (code) block.append(element("code", "", piece));
      else if (bold) block.append(element("strong", "", piece));
      else block.append(piece);
    }
    root.append(block);
  }
  return root;
}

/** The pieces of a paragraph: the text, whether it is code, whether it is bold. */
export function markdownPieces(paragraph: string): [string, boolean, boolean][] {
  const pieces: [string, boolean, boolean][] = [];
  const pattern = /`([^`]+)`|\*\*([^*]+)\*\*/g;
  let last = 0;
  for (const match of paragraph.matchAll(pattern)) {
    if (match.index > last) pieces.push([paragraph.slice(last, match.index), false, false]);
    pieces.push([match[1] ?? match[2]!, match[1] !== undefined, match[2] !== undefined]);
    last = match.index + match[0].length;
  }
  if (last < paragraph.length) pieces.push([paragraph.slice(last), false, false]);
  return pieces;
}
