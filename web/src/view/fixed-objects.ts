// Objects that do not move with playback: zeros of work offsets, and the travel box of the machine.

import { BufferAttribute, Group, LineBasicMaterial, LineSegments } from "three";
import type { Bounds, Vec3 } from "../path/batch";
import { corner } from "./extent";
import { lineGeometry } from "./line-mesh";

/** X red, Y green, Z blue, for both ends of each axis. */
const AXIS_COLORS = [[1, 0.3, 0.3], [0.3, 0.8, 0.3], [0.4, 0.6, 1]].flatMap((color) => [...color, ...color]);

export class FixedObjects {
  readonly object = new Group();
  private travelMaterial = new LineBasicMaterial({ transparent: true, opacity: 0.5 });
  private zeroMaterial = new LineBasicMaterial({ vertexColors: true });
  private box: LineSegments | undefined;

  setColor(color: string): void {
    this.travelMaterial.color.set(color);
  }

  /** Positions are relative to the origin of the path; `axisLength` is that of the axes of a zero; mm. */
  set(zeros: Vec3[], travel: Bounds | undefined, axisLength: number): void {
    for (const child of [...this.object.children]) {
      (child as LineSegments).geometry.dispose();
      child.removeFromParent();
    }
    for (const [x, y, z] of zeros) {
      const geometry = lineGeometry(new Float32Array([x, y, z, x + axisLength, y, z, x, y, z, x, y + axisLength, z, x, y, z, x, y, z + axisLength]));
      geometry.setAttribute("color", new BufferAttribute(new Float32Array(AXIS_COLORS), 3));
      this.object.add(new LineSegments(geometry, this.zeroMaterial));
    }
    this.box = undefined;
    if (travel) {
      this.box = new LineSegments(lineGeometry(boxEdges(travel)), this.travelMaterial);
      this.object.add(this.box);
    }
  }

  showTravel(shown: boolean): void {
    if (this.box) this.box.visible = shown;
  }
}

/** The twelve edges of a box, six numbers each. */
function boxEdges(box: Bounds): Float32Array {
  const points: number[] = [];
  for (let bits = 0; bits < 8; bits++) {
    for (const axis of [1, 2, 4]) if (!(bits & axis)) points.push(...corner(box, bits), ...corner(box, bits | axis));
  }
  return new Float32Array(points);
}
