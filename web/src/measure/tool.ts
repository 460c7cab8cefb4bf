// The tool that measures: marks what the pointer is over; two clicks give a distance.

import type { ShownRun } from "../session/shown-run";
import type { PathView } from "../view/path-view";
import type { PickedPoint } from "../view/picking";
import { type PathFeature, distanceText, featureAt, featureText, measuredDistance } from "./geometry";

export interface MeasureTool {
  readonly isOn: boolean;
  set: (on: boolean) => void;
  /** A point of the path was clicked. */
  click: (picked: PickedPoint) => void;
}

export function measureTool(page: {
  view: PathView;
  canvas: HTMLCanvasElement;
  button: HTMLButtonElement;
  run: ShownRun;
  setMessage: (text: string) => void;
}): MeasureTool {
  const { view, canvas, button } = page;
  let isOn = false;
  let first: PathFeature | undefined;
  let isFramePending = false;

  const words = (feature: PathFeature) => featureText(feature, page.run.path.origin, page.run.axisUnits);

  /** Marks what the pointer is over; of many moves in a frame the last counts. */
  function hover(event: PointerEvent): void {
    if (!isOn || event.buttons !== 0 || isFramePending) return;
    isFramePending = true;
    requestAnimationFrame(() => {
      isFramePending = false;
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
    page.setMessage(on ? "Click a point, a line or an arc of the path." : "");
  }

  function click(picked: PickedPoint): void {
    const feature = featureAt(page.run.path, picked);
    if (!first) {
      first = feature;
      view.showMeasured(feature.kind === "arc" ? feature.center : feature.at, undefined);
      page.setMessage(`${words(feature)}\nClick the second point, line or arc.`);
      return;
    }
    const found = measuredDistance(first, feature);
    view.showMeasured(found.from, found.to);
    page.setMessage(`${distanceText(found, page.run.axisUnits)}\nFrom: ${words(first)}\nTo: ${words(feature)}`);
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
