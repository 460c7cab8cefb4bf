// The axis triad in the corner of the view.

import type { Vec3 } from "../path/batch";

const AXIS_NAMES = ["X", "Y", "Z"];
/** Lengths of an axis and of the distance to its letter, as fractions of half the canvas. */
const AXIS_FRACTION = 0.62;
const LETTER_FRACTION = 0.84;
/** An axis that is seen from its end has no letter: it would cover those of the others. */
const MIN_LETTER_LENGTH = 0.05;

/** Draws the axes; `axes` are their directions on the screen: right, up and towards the viewer. */
export function drawAxes(canvas: HTMLCanvasElement, axes: Vec3[]): void {
  const scale = Math.min(2, window.devicePixelRatio);
  const size = canvas.clientWidth;
  if (canvas.width !== size * scale) canvas.width = canvas.height = size * scale;
  const context = canvas.getContext("2d");
  if (!context) return;
  const style = getComputedStyle(canvas);
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, size, size);
  context.font = "600 11px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = 2;
  const middle = size / 2;
  // The nearest last, over the others.
  const order = [0, 1, 2].sort((a, b) => axes[a]![2] - axes[b]![2]);
  for (const axis of order) {
    const [x, y] = axes[axis]!;
    const color = style.getPropertyValue(`--axis-${AXIS_NAMES[axis]!.toLowerCase()}`);
    context.strokeStyle = context.fillStyle = color;
    context.beginPath();
    context.moveTo(middle, middle);
    context.lineTo(middle + x * middle * AXIS_FRACTION, middle - y * middle * AXIS_FRACTION);
    context.stroke();
    if (Math.hypot(x, y) > MIN_LETTER_LENGTH) context.fillText(AXIS_NAMES[axis]!, middle + x * middle * LETTER_FRACTION, middle - y * middle * LETTER_FRACTION);
  }
}
