// Triangles with flat shading and their edges: fixtures, and bodies of the machine.

import { BufferAttribute, BufferGeometry, Color, DoubleSide, EdgesGeometry, FrontSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Vector3 } from "three";

/** Edges are drawn between faces whose normals differ by more than this, degrees. */
const EDGE_ANGLE_DEGREES = 20;
/** To the light; the shaders of the stock have the same. */
const LIGHT_DIRECTION = new Vector3(-0.35, -0.55, 0.9).normalize();

export class ShadedMesh {
  readonly object = new Group();
  private faces = new MeshBasicMaterial({ vertexColors: true, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  private lines = new LineBasicMaterial();
  private mesh: Mesh<BufferGeometry> | undefined;

  /** With an opacity below 1, what is inside and on the far side is seen through the faces, which then need their corners counter-clockwise seen from outside. */
  constructor(opacity = 1) {
    if (opacity === 1) return;
    Object.assign(this.faces, { transparent: true, opacity, depthWrite: false, side: FrontSide });
    Object.assign(this.lines, { transparent: true, opacity: Math.min(1, 2 * opacity) });
  }

  get isEmpty(): boolean {
    return this.mesh === undefined;
  }

  /** Sets the triangles, nine numbers each, mm in the frame of the run; undefined for none. */
  set(corners: Float32Array | undefined, color: string): void {
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
    this.setColor(color);
  }

  setColor(of: string): void {
    const base = new Color(of);
    this.lines.color.copy(base).multiplyScalar(0.6);
    if (!this.mesh) return;
    const { position, color } = this.mesh.geometry.attributes as { position: BufferAttribute; color: BufferAttribute };
    const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
    for (let first = 0; first + 2 < position.count; first += 3) {
      [a, b, c].forEach((corner, n) => corner.fromBufferAttribute(position, first + n));
      const normal = b.sub(a).cross(c.sub(a)).normalize();
      const light = 0.6 + 0.4 * Math.max(0, normal.dot(LIGHT_DIRECTION)) - 0.12 * Math.max(0, normal.x);
      for (let n = 0; n < 3; n++) color.setXYZ(first + n, base.r * light, base.g * light, base.b * light);
    }
    color.needsUpdate = true;
  }
}
