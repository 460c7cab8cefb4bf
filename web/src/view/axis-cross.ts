// The small cross of X, Y and Z in the corner of the path.

import type { Vec3 } from "../path/batch";

const AXIS_NAMES = ["X", "Y", "Z"];

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
  const order = [0, 1, 2].sort((a, b) => axes[a]![2] - axes[b]![2]);
  for (const axis of order) {
    const [x, y] = axes[axis]!;
    const color = style.getPropertyValue(`--axis-${AXIS_NAMES[axis]!.toLowerCase()}`);
    context.strokeStyle = context.fillStyle = color;
    context.beginPath();
    context.moveTo(middle, middle);
    context.lineTo(middle + x * middle * 0.62, middle - y * middle * 0.62);
    context.stroke();
    if (Math.hypot(x, y) > 0.05) context.fillText(AXIS_NAMES[axis]!, middle + x * middle * 0.84, middle - y * middle * 0.84);
  }
}
