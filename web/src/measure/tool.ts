// Measuring with the pointer: what it is over is marked, two clicks give a distance.

import { type Feature, describe, describeDistance, distance, featureAt } from "./geometry";
import type { Picked } from "../view/picking";
import type { PathView } from "../view/path-view";
import type { ShownRun } from "../session/shown-run";

export interface Measuring {
  readonly isOn: boolean;
  set: (on: boolean) => void;
  /** A place of the path was clicked. */
  click: (picked: Picked) => void;
}

export function measuring(page: {
  view: PathView;
  canvas: HTMLCanvasElement;
  button: HTMLButtonElement;
  run: ShownRun;
  tell: (text: string) => void;
}): Measuring {
  const { view, canvas, button } = page;
  let isOn = false;
  let first: Feature | undefined;
  let isAsked = false;

  const words = (feature: Feature) => describe(feature, page.run.path.origin, page.run.axisUnits);

  /** Marks what the pointer is over; of many moves in a frame the last counts. */
  function hover(event: PointerEvent): void {
    if (!isOn || event.buttons !== 0 || isAsked) return;
    isAsked = true;
    requestAnimationFrame(() => {
      isAsked = false;
      const picked = isOn ? view.pick(event.offsetX, event.offsetY) : undefined;
      view.showSnap(picked && featureAt(page.run.path, picked));
    });
  }
  canvas.addEventListener("pointermove", hover);
  canvas.addEventListener("pointerleave", () => view.showSnap(undefined));

  function set(on: boolean): void {
    isOn = on;
    first = undefined;
    button.setAttribute("aria-pressed", String(on));
    view.showMeasured(undefined, undefined);
    view.showSnap(undefined);
    page.tell(on ? "Click a point, a line or an arc of the path." : "");
  }

  function click(picked: Picked): void {
    const feature = featureAt(page.run.path, picked);
    if (!first) {
      first = feature;
      view.showMeasured(feature.kind === "arc" ? feature.center : feature.at, undefined);
      page.tell(`${words(feature)}\nClick the second point, line or arc.`);
      return;
    }
    const found = distance(first, feature);
    view.showMeasured(found.from, found.to);
    page.tell(`${describeDistance(found, page.run.axisUnits)}\nFrom: ${words(first)}\nTo: ${words(feature)}`);
    first = undefined;
  }

  button.addEventListener("click", () => set(!isOn));
  return {
    get isOn() {
      return isOn;
    },
    set,
    click,
  };
}
