// The tool as its shape: a cylinder, or a ball or bull nose where the table gives a corner radius.

import { Group, LatheGeometry, Mesh, MeshBasicMaterial, Vector2, DoubleSide, EdgesGeometry, LineSegments, LineBasicMaterial, Vector3 } from "three";
import type { Palette } from "./colors";
import type { Vec3 } from "./path";

const SPINDLE = new Vector3(0, 0, 1);

/** The outline from the tip up: radius and height, mm. */
export function outline(diameter: number, length: number, corner: number): [number, number][] {
  const radius = diameter / 2;
  const round = Math.min(Math.max(0, corner), radius);
  const points: [number, number][] = [[0, 0]];
  const steps = round > 0 ? 8 : 0;
  if (round === 0) points.push([radius, 0]);
  for (let step = 0; step <= steps && round > 0; step++) {
    const angle = (step / steps) * (Math.PI / 2);
    points.push([radius - round + round * Math.sin(angle), round - round * Math.cos(angle)]);
  }
  points.push([radius, Math.max(length, round)], [0, Math.max(length, round)]);
  return points;
}

export class ToolShape {
  object = new Group();
  private fill = new MeshBasicMaterial({ transparent: true, opacity: 0.28, side: DoubleSide, depthWrite: false });
  private edge = new LineBasicMaterial({ transparent: true, opacity: 0.8 });

  constructor(palette: Palette) {
    this.object.visible = false;
    this.setPalette(palette);
  }

  setPalette(palette: Palette): void {
    this.fill.color.set(palette.toolShape);
    this.edge.color.set(palette.toolShape);
  }

  /** Numbers that no table gives are taken from the size of the part; such a tool is a thin pin. */
  shape(diameter: number | null, length: number | null, corner: number | null, size: number): void {
    for (const child of [...this.object.children]) {
      (child as Mesh).geometry.dispose();
      child.removeFromParent();
    }
    const wide = diameter && diameter > 0 ? diameter : size / 80;
    const high = Math.min(length && length > 0 ? length : size / 3, Math.max(4 * wide, size / 3));
    const points = outline(wide, high, corner ?? 0).map(([r, z]) => new Vector2(r, z));
    const geometry = new LatheGeometry(points, 32);
    // A lathe turns about Y; the spindle about Z.
    geometry.rotateX(Math.PI / 2);
    this.object.add(new Mesh(geometry, this.fill));
    this.object.add(new LineSegments(new EdgesGeometry(geometry, 30), this.edge));
  }

  /** Its tip at a place, its shank along a direction. */
  place(at: Vec3 | undefined, up: Vec3): void {
    this.object.visible = at !== undefined;
    if (at) this.object.position.set(...at);
    this.object.quaternion.setFromUnitVectors(SPINDLE, new Vector3(...up).normalize());
  }
}
