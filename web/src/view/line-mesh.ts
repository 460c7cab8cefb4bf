// Line segments with colours: one pixel wide, or wide ones that are drawn as triangles.

import { type Group, BufferAttribute, BufferGeometry, InstancedBufferAttribute, InstancedInterleavedBuffer, InterleavedBufferAttribute, LineBasicMaterial, LineSegments } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { PathProgress } from "./progress";

/** Width of a wide line, pixels. */
const WIDE_LINE_PX = 1.8;

/** The materials of the cuts of a path, one for each width; all of its meshes share them. */
export class LineMaterials {
  thin = new LineBasicMaterial({ vertexColors: true });
  wide = new LineMaterial({ vertexColors: true, linewidth: WIDE_LINE_PX });

  constructor(progress: PathProgress) {
    progress.attach(this.thin);
    progress.attach(this.wide, true);
  }
}

/** Line segments with a colour at each end. */
export class LineMesh {
  readonly object: LineSegments | LineSegments2;
  constructor(
    /** Both ends of each segment, mm: six numbers. */
    private points: Float32Array,
    /** Both ends of each segment, RGB: six bytes. */
    private colors: Uint8Array,
    /** The path row at both ends of each segment. */
    private rowsAtEnds: Float32Array,
    materials: LineMaterials,
    readonly isWide: boolean,
  ) {
    if (isWide) {
      this.object = new LineSegments2(this.wideGeometry(), materials.wide);
    } else {
      const geometry = lineGeometry(points, rowsAtEnds);
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
    // Per segment; thin lines have one number per end instead, `rowAtEnd`.
    geometry.setAttribute("rowsAtEnds", new InstancedBufferAttribute(this.rowsAtEnds, 2));
    return geometry;
  }

  setColors(colors: Uint8Array): void {
    this.colors = colors;
    if (this.isWide) {
      this.object.geometry.dispose();
      this.object.geometry = this.wideGeometry();
    } else this.object.geometry.setAttribute("color", new BufferAttribute(colors, 3, true));
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.removeFromParent();
  }
}

/** Geometry of points, or of line segments with the path row at both ends of each: rows not reached yet are drawn pale. */
export function lineGeometry(points: Float32Array, rowsAtEnds?: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  if (rowsAtEnds) geometry.setAttribute("rowAtEnd", new BufferAttribute(rowsAtEnds, 1));
  return geometry;
}

export function disposeLines(object: LineSegments | LineSegments2 | undefined): void {
  if (!object) return;
  object.geometry.dispose();
  object.removeFromParent();
}

/** Disposes of all lines of a group. */
export function clearGroup(group: Group): void {
  for (const object of [...group.children]) disposeLines(object as LineSegments);
}
