// The measuring tool: marks the feature under the pointer; two clicks give a distance.

import type { ShownRun } from "../session/shown-run";
import type { PathView } from "../view/path-view";
import type { PickedPoint } from "../view/picking";
import { type PathFeature, distanceText, featureAt, featureText, measuredDistance } from "./geometry";

export interface MeasureTool {
  readonly isOn: boolean;
  set: (on: boolean) => void;
  /** Measures from or to a point of the path that was clicked. */
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

  const textOf = (feature: PathFeature) => featureText(feature, page.run.path.origin, page.run.axisUnits);

  /** Marks the feature under the pointer, once per frame. */
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
      page.setMessage(`${textOf(feature)}\nClick the second point, line or arc.`);
      return;
    }
    const distance = measuredDistance(first, feature);
    view.showMeasured(distance.from, distance.to);
    page.setMessage(`${distanceText(distance, page.run.axisUnits)}\nFrom: ${textOf(first)}\nTo: ${textOf(feature)}`);
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
