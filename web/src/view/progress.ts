// Playback progress along the path: every material of the path draws pale what is not reached yet.

import { type Material, Color } from "three";
import type { LineArrays } from "../path/lines";

/** How much of its own colour the remaining path keeps, as a fraction; the rest is the background's. */
export const PALE_FRACTION = 0.4;

export class PathProgress {
  /** Rows done, with the fraction of the present one; infinite where nothing is drawn pale. */
  done = Infinity;
  private doneRows = { value: 1e9 };
  private background = { value: new Color() };

  set(done: number): void {
    this.done = done;
    this.doneRows.value = Math.min(1e9, done);
  }

  setBackground(color: string): void {
    this.background.value.set(color);
  }

  /** Makes a material draw pale what is not reached yet. Its geometries need the attribute `rowAtEnd`, those of wide lines `rowsAtEnds`. */
  attach(material: Material, isWide = false): void {
    const [attribute, row] = isWide
      ? ["attribute vec2 rowsAtEnds;", "position.y < 0.5 ? rowsAtEnds.x : rowsAtEnds.y"]
      : ["attribute float rowAtEnd;", "rowAtEnd"];
    const { doneRows, background } = this;
    material.onBeforeCompile = (shader) => {
      shader.uniforms.doneRows = doneRows;
      shader.uniforms.pageBackground = background;
      shader.vertexShader = shader.vertexShader.replace(
        "void main() {",
        `${attribute} varying float vRow;\nvoid main() { vRow = ${row};`,
      );
      shader.fragmentShader = shader.fragmentShader
        .replace("void main() {", "uniform float doneRows; uniform vec3 pageBackground; varying float vRow;\nvoid main() {")
        .replace(
          "#include <color_fragment>",
          `#include <color_fragment>\nif (vRow > doneRows) diffuseColor.rgb = mix(pageBackground, diffuseColor.rgb, ${PALE_FRACTION});`,
        );
    };
    material.customProgramCacheKey = () => `progress ${isWide}`;
  }
}

/** The row and the fraction of it at both ends of each segment of a batch; `first` is the first row of the batch. */
export function rowsAtEndsOf(first: number, { rows, count }: Pick<LineArrays, "rows" | "count">): Float32Array {
  const rowsAtEnds = new Float32Array(2 * count);
  for (let from = 0; from < count; ) {
    const row = rows ? rows[from]! : from;
    let to = from + 1;
    while (rows && to < count && rows[to] === row) to++;
    for (let line = from; line < to; line++) {
      rowsAtEnds[2 * line] = first + row + (line - from) / (to - from);
      rowsAtEnds[2 * line + 1] = first + row + (line + 1 - from) / (to - from);
    }
    from = to;
  }
  return rowsAtEnds;
}

/** The first segment on the rows `from` to `to` of a batch, both included, and the one after the last. */
export function linesOnRows({ rows, count }: Pick<LineArrays, "rows" | "count">, from: number, to: number): [number, number] {
  const countBefore = (row: number): number => {
    let low = 0;
    let high = count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((rows ? rows[middle]! : middle) < row) low = middle + 1;
      else high = middle;
    }
    return low;
  };
  return [countBefore(from), countBefore(to + 1)];
}
