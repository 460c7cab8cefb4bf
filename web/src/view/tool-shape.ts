// The drawn shape of the tool, from the tool table or a comment of the program.

import { DoubleSide, EdgesGeometry, Group, LatheGeometry, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Vector2, Vector3 } from "three";
import type { Vec3 } from "../path/batch";
import type { ToolInfo } from "../protocol/messages";
import type { Palette } from "./colors";

const SPINDLE_AXIS = new Vector3(0, 0, 1);
/** Point angles where the tool table has none, rad: for the picture only. */
const DRILL_POINT_RAD = (118 * Math.PI) / 180;
const CHAMFER_POINT_RAD = Math.PI / 2;
/** Chords of a corner radius. */
const CORNER_STEPS = 8;

/** Radius and height above the tip of each point, mm. */
type Outline = [number, number][];

/** The dimensions of a tool, as far as they are known. */
export type DrawnTool = Partial<Omit<ToolInfo, "number" | "kind" | "comment">>;

/** The outline of the end of a tool, from the tip to its full radius. */
function endOutline(tool: DrawnTool, radius: number): Outline {
  switch (tool.shape) {
    case "drill":
      return [[0, 0], [radius, radius / Math.tan((tool.point_angle_rad ?? DRILL_POINT_RAD) / 2)]];
    case "chamfer": {
      const tip = Math.min(radius, (tool.tip_diameter_mm ?? 0) / 2);
      return [[0, 0], [tip, 0], [radius, (radius - tip) / Math.tan((tool.point_angle_rad ?? CHAMFER_POINT_RAD) / 2)]];
    }
    case "tap":
      // The chamfer of a tap is narrower than its thread; the proportions are for the picture only.
      return [[0, 0], [0.7 * radius, 0], [radius, 0.6 * radius]];
    default:
      return cornerOutline(radius, tool.shape === "ball" ? radius : (tool.corner_radius_mm ?? 0));
  }
}

function cornerOutline(radius: number, cornerRadius: number): Outline {
  const rounding = Math.min(Math.max(0, cornerRadius), radius);
  if (rounding === 0) return [[0, 0], [radius, 0]];
  const points: Outline = [[0, 0]];
  for (let step = 0; step <= CORNER_STEPS; step++) {
    const angle = (step / CORNER_STEPS) * (Math.PI / 2);
    points.push([radius - rounding + rounding * Math.sin(angle), rounding - rounding * Math.cos(angle)]);
  }
  return points;
}

/** The closed outline of a tool from the tip up; a part of unknown length ends at `maxHeight`, mm. */
export function outline(tool: DrawnTool, maxHeight: number): Outline {
  if (tool.shape === "form" && (tool.profile_mm?.length ?? 0) > 1) {
    const form = tool.profile_mm!.map(([height, radius]): [number, number] => [radius, height]);
    return withShankAndHolder([[0, form[0]![1]], ...form], tool, maxHeight);
  }
  const radius = Math.abs(tool.diameter_mm ?? 0) / 2;
  const points = endOutline(tool, radius);
  const top = points.at(-1)![1];
  const hasShankOrHolder = (tool.shank_mm?.length ?? 0) > 0 || (tool.holder_mm?.length ?? 0) > 0 || Boolean(tool.shank_diameter_mm);
  const length = hasShankOrHolder ? (tool.flute_length_mm ?? tool.length_mm) : tool.length_mm;
  const height = length && length > 0 ? length : maxHeight;
  points.push([radius, Math.max(top, Math.min(height, maxHeight))]);
  return withShankAndHolder(points, tool, maxHeight);
}

/** Adds shank and holder to an outline, and closes it to the axis at the top. */
function withShankAndHolder(points: Outline, { shank_mm, shank_diameter_mm, holder_mm }: DrawnTool, maxHeight: number): Outline {
  if (shank_diameter_mm && !shank_mm?.length && !holder_mm?.length) {
    // The length of the shank is not known: at least as long as it is wide.
    const radius = shank_diameter_mm / 2;
    const top = points.at(-1)![1];
    points.push([radius, top], [radius, Math.max(top + 2 * radius, maxHeight)]);
  }
  for (const [height, lower, upper] of [...(shank_mm ?? []), ...(holder_mm ?? [])]) {
    const top = points.at(-1)![1];
    points.push([lower / 2, top], [upper / 2, top + height]);
  }
  points.push([0, points.at(-1)![1]]);
  return points;
}

export class ToolShape {
  object = new Group();
  /** The largest drawn diameter, mm: for tests. */
  width = 0;
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

  /** Draws a tool; one of unknown diameter as a thin pin. `partSize` is the size of the path, mm. */
  setTool(tool: DrawnTool | undefined, partSize: number): void {
    for (const child of [...this.object.children]) {
      (child as Mesh).geometry.dispose();
      child.removeFromParent();
    }
    const isKnown = Math.abs(tool?.diameter_mm ?? 0) > 0 || tool?.shape === "form";
    const drawn = isKnown ? tool! : { diameter_mm: partSize / 80 };
    const points = outline(drawn, Math.max(4 * Math.abs(drawn.diameter_mm ?? 0), partSize / 3));
    this.width = 2 * Math.max(...points.map(([radius]) => radius));
    const geometry = new LatheGeometry(points.map(([r, z]) => new Vector2(r, z)), 32);
    // The axis of a LatheGeometry is Y, that of the spindle Z.
    geometry.rotateX(Math.PI / 2);
    this.object.add(new Mesh(geometry, this.fill));
    this.object.add(new LineSegments(new EdgesGeometry(geometry, 30), this.edge));
  }

  /** Puts the tip at a position and the shank along a direction; undefined hides the tool. */
  place(at: Vec3 | undefined, up: Vec3): void {
    this.object.visible = at !== undefined;
    if (at) this.object.position.set(...at);
    this.object.quaternion.setFromUnitVectors(SPINDLE_AXIS, new Vector3(...up).normalize());
  }
}
