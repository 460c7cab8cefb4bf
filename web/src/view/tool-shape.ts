// The shape of the tool, from the tool table or a comment of the program.

import { DoubleSide, EdgesGeometry, Group, LatheGeometry, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Vector2, Vector3 } from "three";
import type { Vec3 } from "../path/batch";
import type { ToolInfo } from "../protocol/messages";
import type { Palette } from "./colors";

const SPINDLE_AXIS = new Vector3(0, 0, 1);
/** Point angles where the table gives none, rad: they are only used for the picture. */
const DRILL_POINT_RAD = (118 * Math.PI) / 180;
const CHAMFER_POINT_RAD = Math.PI / 2;
/** Pieces of a quarter of a corner. */
const CORNER_STEPS = 8;

/** Radius and height over the tip, mm. */
type Outline = [number, number][];

/** The dimensions of a tool, as far as they are known. */
export type DrawnTool = Partial<Omit<ToolInfo, "number" | "kind" | "comment">>;

/** The end of the tool, from the tip to its full radius. */
function end(tool: DrawnTool, radius: number): Outline {
  switch (tool.shape) {
    case "drill":
      return [[0, 0], [radius, radius / Math.tan((tool.point_angle_rad ?? DRILL_POINT_RAD) / 2)]];
    case "chamfer": {
      const tip = Math.min(radius, (tool.tip_diameter_mm ?? 0) / 2);
      return [[0, 0], [tip, 0], [radius, (radius - tip) / Math.tan((tool.point_angle_rad ?? CHAMFER_POINT_RAD) / 2)]];
    }
    case "tap":
      // The lead of a tap is narrower than its thread.
      return [[0, 0], [0.7 * radius, 0], [radius, 0.6 * radius]];
    default:
      return corner(radius, tool.shape === "ball" ? radius : (tool.corner_radius_mm ?? 0));
  }
}

function corner(radius: number, cornerRadius: number): Outline {
  const round = Math.min(Math.max(0, cornerRadius), radius);
  if (round === 0) return [[0, 0], [radius, 0]];
  const points: Outline = [[0, 0]];
  for (let step = 0; step <= CORNER_STEPS; step++) {
    const angle = (step / CORNER_STEPS) * (Math.PI / 2);
    points.push([radius - round + round * Math.sin(angle), round - round * Math.cos(angle)]);
  }
  return points;
}

/** The outline from the tip up, no higher than `most` where no part of it is. */
export function outline(tool: DrawnTool, most: number): Outline {
  if (tool.shape === "form" && (tool.profile_mm?.length ?? 0) > 1) {
    const form = tool.profile_mm!.map(([height, radius]): [number, number] => [radius, height]);
    return closed([[0, form[0]![1]], ...form], tool, most);
  }
  const radius = Math.abs(tool.diameter_mm ?? 0) / 2;
  const points = end(tool, radius);
  const top = points.at(-1)![1];
  const hasMore = (tool.shank_mm?.length ?? 0) > 0 || (tool.holder_mm?.length ?? 0) > 0 || Boolean(tool.shank_diameter_mm);
  const known = hasMore ? (tool.flute_length_mm ?? tool.length_mm) : tool.length_mm;
  const high = known && known > 0 ? known : most;
  points.push([radius, Math.max(top, Math.min(high, most))]);
  return closed(points, tool, most);
}

/** With the shank and the holder above, down to the axis at the top. */
function closed(points: Outline, { shank_mm, shank_diameter_mm, holder_mm }: DrawnTool, most: number): Outline {
  if (shank_diameter_mm && !shank_mm?.length && !holder_mm?.length) {
    // The length of the last part is not known.
    const radius = shank_diameter_mm / 2;
    const top = points.at(-1)![1];
    points.push([radius, top], [radius, Math.max(top + 2 * radius, most)]);
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
  /** Its largest diameter as it is drawn, mm: for tests. */
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

  /** One without a known diameter is a thin pin; `size` is that of the part, mm. */
  shape(tool: DrawnTool | undefined, size: number): void {
    for (const child of [...this.object.children]) {
      (child as Mesh).geometry.dispose();
      child.removeFromParent();
    }
    const isKnown = Math.abs(tool?.diameter_mm ?? 0) > 0 || tool?.shape === "form";
    const drawn = isKnown ? tool! : { diameter_mm: size / 80 };
    const own = outline(drawn, Math.max(4 * Math.abs(drawn.diameter_mm ?? 0), size / 3));
    this.width = 2 * Math.max(...own.map(([radius]) => radius));
    const geometry = new LatheGeometry(own.map(([r, z]) => new Vector2(r, z)), 32);
    // A lathe turns about Y; the spindle about Z.
    geometry.rotateX(Math.PI / 2);
    this.object.add(new Mesh(geometry, this.fill));
    this.object.add(new LineSegments(new EdgesGeometry(geometry, 30), this.edge));
  }

  /** Its tip at a position, its shank along a direction. */
  place(at: Vec3 | undefined, up: Vec3): void {
    this.object.visible = at !== undefined;
    if (at) this.object.position.set(...at);
    this.object.quaternion.setFromUnitVectors(SPINDLE_AXIS, new Vector3(...up).normalize());
  }
}
