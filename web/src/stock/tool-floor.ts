// The lowest point of a rotating tool over a distance from its axis: what it cuts without moving.

import type { DrawnTool } from "../view/tool-shape";

/** Height over the tip by the distance from the axis, both mm. */
export interface ToolFloor {
  radius: number;
  at: (distance: number) => number;
}

/** `undefined` where the shape is not known, or is of no mill: such a tool cuts no stock. */
export function floorOf(tool: DrawnTool | undefined): ToolFloor | undefined {
  if (!tool?.shape || tool.shape === "insert") return undefined;
  if (tool.shape === "form") return formFloor(tool.profile_mm ?? []);
  const radius = Math.abs(tool.diameter_mm ?? 0) / 2;
  if (!(radius > 0)) return undefined;
  switch (tool.shape) {
    case "ball":
      return { radius, at: (distance) => radius - Math.sqrt(Math.max(0, radius * radius - distance * distance)) };
    case "bull": {
      const corner = Math.min(radius, Math.max(0, tool.corner_radius_mm ?? 0));
      return { radius, at: (distance) => {
        const out = Math.max(0, distance - (radius - corner));
        return corner - Math.sqrt(Math.max(0, corner * corner - out * out));
      } };
    }
    case "drill":
    case "chamfer": {
      const tip = tool.shape === "chamfer" ? (tool.tip_diameter_mm ?? 0) / 2 : 0;
      if (!tool.point_angle_rad) return undefined;
      const rise = 1 / Math.tan(tool.point_angle_rad / 2);
      return { radius, at: (distance) => Math.max(0, distance - tip) * rise };
    }
    case "tap":
    case "thread mill":
    case "t-slot":
    case "lollipop":
      // What they cut lies below a neck, or is a core whose diameter is not known: it is there once they have passed.
      return undefined;
    default:
      return { radius, at: () => 0 };
  }
}

/** The lower side of an outline of heights and radii from the tip up. */
function formFloor(profile: [number, number][]): ToolFloor | undefined {
  if (profile.length < 2) return undefined;
  const radius = Math.max(...profile.map(([, r]) => r));
  return { radius, at: (distance) => {
    let least = Infinity;
    let [height, from] = [profile[0]![0], 0];
    for (const [next, to] of profile) {
      if (distance >= Math.min(from, to) && distance <= Math.max(from, to)) {
        const fraction = to === from ? 0 : (distance - from) / (to - from);
        least = Math.min(least, height + (next - height) * fraction);
      }
      [height, from] = [next, to];
    }
    return least;
  } };
}
