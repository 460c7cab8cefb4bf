// How much of the path is done: the remainder is drawn pale, in every material that draws the path.

import { type Material, Color } from "three";
import type { LineArrays } from "../path/lines";

/** The fraction of its own colour that the remaining path has; the other fraction is the background's. */
export const PALE_FRACTION = 0.4;

export class PathProgress {
  /** Rows that are done, with the fraction of the row that is being done; all of them while nothing plays. */
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

  /** Makes a material draw pale what is not done yet. Its geometries need `rowAt`, wide ones `rowSpan`. */
  attach(material: Material, isWide = false): void {
    const [attribute, row] = isWide
      ? ["attribute vec2 rowSpan;", "position.y < 0.5 ? rowSpan.x : rowSpan.y"]
      : ["attribute float rowAt;", "rowAt"];
    const { doneRows, background } = this;
    material.onBeforeCompile = (shader) => {
      shader.uniforms.doneRows = doneRows;
      shader.uniforms.pageBackground = background;
      shader.vertexShader = shader.vertexShader.replace(
        "void main() {",
        `${attribute} varying float vRowAt;\nvoid main() { vRowAt = ${row};`,
      );
      shader.fragmentShader = shader.fragmentShader
        .replace("void main() {", "uniform float doneRows; uniform vec3 pageBackground; varying float vRowAt;\nvoid main() {")
        .replace(
          "#include <color_fragment>",
          `#include <color_fragment>\nif (vRowAt > doneRows) diffuseColor.rgb = mix(pageBackground, diffuseColor.rgb, ${PALE_FRACTION});`,
        );
    };
    material.customProgramCacheKey = () => `progress ${isWide}`;
  }
}

/** The rows at both ends of each line, with the fraction of the row; `first` is the row that the batch begins with. */
export function spansOf(first: number, { rows, count }: Pick<LineArrays, "rows" | "count">): Float32Array {
  const spans = new Float32Array(2 * count);
  for (let from = 0; from < count; ) {
    const row = rows ? rows[from]! : from;
    let to = from + 1;
    while (rows && to < count && rows[to] === row) to++;
    for (let at = from; at < to; at++) {
      spans[2 * at] = first + row + (at - from) / (to - from);
      spans[2 * at + 1] = first + row + (at + 1 - from) / (to - from);
    }
    from = to;
  }
  return spans;
}

/** From and to of the lines that lie on rows of a batch, from and to, both counted. */
export function linesOnRows({ rows, count }: Pick<LineArrays, "rows" | "count">, from: number, to: number): [number, number] {
  const before = (row: number): number => {
    let low = 0;
    let high = count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((rows ? rows[middle]! : middle) < row) low = middle + 1;
      else high = middle;
    }
    return low;
  };
  return [before(from), before(to + 1)];
}
