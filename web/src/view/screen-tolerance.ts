// How far from an arc its drawn chords may be.

import { Vector3 } from "three";
import { ARC_NUMBERS, arcReach } from "../path/arcs";
import type { Vec3 } from "../path/batch";
import type { ArcTolerance } from "../path/lines";
import type { ViewCamera } from "./camera";

export type { ArcTolerance };

/**
 * A quarter of a pixel for visible arcs, half of one in a long path, and more for arcs out of sight. The vector is the offset of
 * the origin of their path from that of the program's path, mm.
 */
export function screenTolerance(camera: ViewCamera, [dx, dy, dz]: Vec3, isLong: boolean): ArcTolerance {
  const pixel = camera.pixel();
  const matrix = camera.matrix();
  const side = camera.shorterSide();
  const center = new Vector3();
  return (arcs, index) => {
    const reach = arcReach(arcs, index);
    const offset = ARC_NUMBERS * index;
    center.set(arcs[offset]! + dx, arcs[offset + 1]! + dy, arcs[offset + 2]! + dz).applyMatrix4(matrix);
    const margin = 1 + (2 * reach) / side;
    const isVisible = Math.abs(center.x) < margin && Math.abs(center.y) < margin;
    return isVisible ? pixel * (isLong ? 0.5 : 0.25) : Math.max(pixel, reach / 20);
  };
}
