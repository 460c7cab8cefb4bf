// Keyboard shortcuts of the page.

import type { PathView } from "../view/path-view";
import type { Timeline } from "./timeline";

export interface KeyTargets {
  timeline: Timeline;
  view: PathView;
  measure: { isOn: boolean; set(on: boolean): void };
  /** Goes to the next difference of two programs, or the one before. */
  walk(direction: 1 | -1): void;
}

/** Adds the shortcuts, which do nothing while a text or a number is typed. */
export function listenToKeys({ timeline, view, measure, walk }: KeyTargets): void {
  document.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "F9") {
      event.preventDefault();
      return walk(event.shiftKey ? -1 : 1);
    }
    if (target.closest(".cm-editor, input:not([type=range]):not([type=checkbox]), select, textarea")) return;
    if (event.key === " " && target.closest("button, summary, input")) return;
    const actions: Record<string, () => void> = {
      " ": () => timeline.toggle(),
      ",": () => timeline.onStep(-1),
      ".": () => timeline.onStep(1),
      r: () => timeline.onToCursor(),
      "[": () => timeline.faster(-1),
      "]": () => timeline.faster(1),
      "1": () => view.setView("top"),
      "2": () => view.setView("front"),
      "3": () => view.setView("right"),
      "4": () => view.setView("iso"),
      f: () => view.fit(),
      m: () => measure.set(!measure.isOn),
      n: () => walk(1),
      p: () => walk(-1),
      escape: () => measure.set(false),
    };
    const action = actions[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
