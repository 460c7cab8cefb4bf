// How far from an arc the straight pieces that are drawn of it may be.

import { Vector3 } from "three";
import type { Eye } from "./camera";
import type { Tolerance } from "../path/lines";
import { arcReach } from "../path/arcs";
import type { Vec3 } from "../path/batch";

export type { Tolerance };

/**
 * A quarter of a pixel, for arcs that can be seen; the others stay as coarse as they may. `shift` is how far the
 * origin of their path is from that of the shown one.
 */
export function seenTolerance(eye: Eye, [dx, dy, dz]: Vec3, isLong: boolean): Tolerance {
  const pixel = eye.pixel();
  const matrix = eye.matrix();
  const side = eye.shorterSide();
  const center = new Vector3();
  return (arcs, index) => {
    const reach = arcReach(arcs, index);
    center.set(arcs[13 * index]! + dx, arcs[13 * index + 1]! + dy, arcs[13 * index + 2]! + dz).applyMatrix4(matrix);
    const margin = 1 + (2 * reach) / side;
    const isSeen = Math.abs(center.x) < margin && Math.abs(center.y) < margin;
    return isSeen ? pixel * (isLong ? 0.5 : 0.25) : Math.max(pixel, reach / 20);
  };
}
