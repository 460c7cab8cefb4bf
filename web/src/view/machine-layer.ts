// The bodies of the machine, where they are relative to the part.

import { Group, Matrix4 } from "three";
import type { Vec3 } from "../path/batch";
import { bodyPose } from "../path/rotation";
import type { AxisMotion, MachineBodies } from "../protocol/messages";
import type { Palette } from "./colors";
import { ShadedMesh } from "./shaded-mesh";

/** The path and the part are seen through the bodies. */
const OPACITY = 0.25;

export class MachineLayer {
  readonly object = new Group();
  private bodies: { name: string; mesh: ShadedMesh; motions: AxisMotion[] }[] = [];
  private toPart = new Matrix4();

  constructor(private palette: Palette, private requestFrame: () => void) {
    this.object.visible = false;
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    for (const { mesh } of this.bodies) mesh.setColor(palette.machine);
  }

  /** Sets the bodies, or none; `origin` is that of the path. */
  set(bodies: MachineBodies | null, origin: Vec3): void {
    for (const { mesh } of this.bodies) mesh.set(undefined, "");
    this.object.clear();
    const toPart = bodies?.to_part;
    this.bodies = (toPart ? bodies.solids : []).map(({ name, corners, motions }) => {
      const mesh = new ShadedMesh(OPACITY);
      mesh.set(new Float32Array(corners), this.palette.machine);
      mesh.object.matrixAutoUpdate = false;
      this.object.add(mesh.object);
      return { name, mesh, motions };
    });
    if (toPart) this.toPart.fromArray(toPart);
    this.object.position.set(-origin[0], -origin[1], -origin[2]);
    this.place(undefined);
  }

  /** Moves the bodies to where they are with the axes at positions, mm and rad; undefined hides those that axes move. */
  place(axes: number[] | undefined): void {
    for (const { mesh: { object }, motions } of this.bodies) {
      object.visible = axes !== undefined || motions.length === 0;
      if (object.visible) object.matrix.fromArray(bodyPose(motions, axes ?? [])).premultiply(this.toPart);
    }
    if (this.object.visible) this.requestFrame();
  }

  show(shown: boolean): void {
    this.object.visible = shown;
    this.requestFrame();
  }

  /** Where the point of each shown body is that is at the zero of the machine with all axes at zero, in the frame of the run: for tests. */
  places(): Record<string, Vec3> {
    const shown = this.bodies.filter(({ mesh }) => mesh.object.visible);
    return Object.fromEntries(shown.map(({ name, mesh }) => [name, mesh.object.matrix.elements.slice(12, 15) as Vec3]));
  }
}
