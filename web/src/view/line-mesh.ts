// Coloured lines: wide ones where there are few, lines of one pixel where there are many.

import { type Group, BufferAttribute, BufferGeometry, InstancedBufferAttribute, InstancedInterleavedBuffer, InterleavedBufferAttribute, LineBasicMaterial, LineSegments } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { PathProgress } from "./progress";

export class LineMaterials {
  thin = new LineBasicMaterial({ vertexColors: true });
  wide = new LineMaterial({ vertexColors: true, linewidth: 1.8 });

  constructor(progress: PathProgress) {
    progress.attach(this.thin);
    progress.attach(this.wide, true);
  }
}

/** Some lines with a colour each. */
export class LineMesh {
  readonly object: LineSegments | LineSegments2;
  constructor(
    private points: Float32Array,
    private colors: Uint8Array,
    /** The rows at both ends of each line. */
    private spans: Float32Array,
    materials: LineMaterials,
    readonly isWide: boolean,
  ) {
    if (isWide) {
      this.object = new LineSegments2(this.wideGeometry(), materials.wide);
    } else {
      const geometry = geometryOf(points, spans);
      geometry.setAttribute("color", new BufferAttribute(colors, 3, true));
      this.object = new LineSegments(geometry, materials.thin);
    }
    // Nearly all of a path is visible, and computing its bounding sphere costs more than culling saves.
    this.object.frustumCulled = false;
  }

  private wideGeometry(): LineSegmentsGeometry {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(this.points);
    const colors = new InstancedInterleavedBuffer(this.colors, 6, 1);
    geometry.setAttribute("instanceColorStart", new InterleavedBufferAttribute(colors, 3, 0, true));
    geometry.setAttribute("instanceColorEnd", new InterleavedBufferAttribute(colors, 3, 3, true));
    geometry.setAttribute("rowSpan", new InstancedBufferAttribute(this.spans, 2));
    return geometry;
  }

  setColors(colors: Uint8Array): void {
    this.colors = colors;
    if (this.isWide) {
      this.object.geometry.dispose();
      this.object.geometry = this.wideGeometry();
    } else this.object.geometry.setAttribute("color", new BufferAttribute(colors, 3, true));
  }

  removeLines(): void {
    this.object.geometry.dispose();
    this.object.removeFromParent();
  }
}

/** Geometry of lines; `spans` are the rows at both ends of each, where what is not done yet is drawn pale. */
export function geometryOf(points: Float32Array, spans?: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  if (spans) geometry.setAttribute("rowAt", new BufferAttribute(spans, 1));
  return geometry;
}

export function removeLines(object: LineSegments | undefined): void {
  if (!object) return;
  object.geometry.dispose();
  object.removeFromParent();
}

export function emptyGroup(group: Group): void {
  for (const object of [...group.children]) removeLines(object as LineSegments);
}
