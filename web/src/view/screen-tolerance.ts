// How far from an arc the straight pieces that are drawn of it may be.

import { Vector3 } from "three";
import { arcReach } from "../path/arcs";
import type { Vec3 } from "../path/batch";
import type { ArcTolerance } from "../path/lines";
import type { ViewCamera } from "./camera";

export type { ArcTolerance };

/**
 * A quarter of a pixel for visible arcs; others may be coarser. `shift` is how far the
 * origin of their path is from that of the shown one.
 */
export function screenTolerance(camera: ViewCamera, [dx, dy, dz]: Vec3, isLong: boolean): ArcTolerance {
  const pixel = camera.pixel();
  const matrix = camera.matrix();
  const side = camera.shorterSide();
  const center = new Vector3();
  return (arcs, index) => {
    const reach = arcReach(arcs, index);
    center.set(arcs[13 * index]! + dx, arcs[13 * index + 1]! + dy, arcs[13 * index + 2]! + dz).applyMatrix4(matrix);
    const margin = 1 + (2 * reach) / side;
    const isVisible = Math.abs(center.x) < margin && Math.abs(center.y) < margin;
    return isVisible ? pixel * (isLong ? 0.5 : 0.25) : Math.max(pixel, reach / 20);
  };
}
