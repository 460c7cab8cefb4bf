// Fixtures: triangles that do not move, drawn into the picture of the stock.

import { BufferAttribute, BufferGeometry, Color, DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Vector3 } from "three";
import type { Palette } from "../view/colors";

/** Faces that meet at a smaller angle have no line between them, degrees. */
const EDGE_ANGLE_DEGREES = 20;
const LIGHT_DIRECTION = new Vector3(-0.35, -0.55, 0.9).normalize();

export class FixtureMesh {
  readonly object = new Group();
  private faces = new MeshBasicMaterial({ vertexColors: true, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  private lines = new LineBasicMaterial();
  private mesh: Mesh<BufferGeometry> | undefined;

  get isEmpty(): boolean {
    return this.mesh === undefined;
  }

  /** Triangles, nine numbers each, mm in the frame of the run. */
  set(corners: Float32Array | undefined, palette: Palette): void {
    for (const child of [...this.object.children]) {
      (child as Mesh | LineSegments).geometry.dispose();
      child.removeFromParent();
    }
    this.mesh = undefined;
    if (!corners || corners.length === 0) return;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(corners.length), 3));
    this.mesh = new Mesh(geometry, this.faces);
    const edges = new LineSegments(new EdgesGeometry(geometry, EDGE_ANGLE_DEGREES), this.lines);
    for (const object of [this.mesh, edges]) {
      object.frustumCulled = false;
      this.object.add(object);
    }
    this.setPalette(palette);
  }

  setPalette(palette: Palette): void {
    const own = new Color(palette.fixture);
    this.lines.color.copy(own).multiplyScalar(0.6);
    if (!this.mesh) return;
    const { position, color } = this.mesh.geometry.attributes as { position: BufferAttribute; color: BufferAttribute };
    const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
    for (let at = 0; at + 2 < position.count; at += 3) {
      [a, b, c].forEach((corner, n) => corner.fromBufferAttribute(position, at + n));
      const normal = b.sub(a).cross(c.sub(a)).normalize();
      const light = 0.6 + 0.4 * Math.max(0, normal.dot(LIGHT_DIRECTION)) - 0.12 * Math.max(0, normal.x);
      for (let n = 0; n < 3; n++) color.setXYZ(at + n, own.r * light, own.g * light, own.b * light);
    }
    color.needsUpdate = true;
  }
}
