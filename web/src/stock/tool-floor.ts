// The lower side of a rotating tool: what it cuts without moving.

import type { DrawnTool } from "../view/tool-shape";

/** All in mm. */
export interface ToolFloor {
  radius: number;
  /** Height above the tip at a distance from the axis. */
  heightAt: (distance: number) => number;
}

/** The lower side of a tool; undefined where its shape is not known, and for tools that cut only below a neck or a core. */
export function floorOf(tool: DrawnTool | undefined): ToolFloor | undefined {
  if (!tool?.shape || tool.shape === "insert") return undefined;
  if (tool.shape === "form") return formFloor(tool.profile_mm ?? []);
  const radius = Math.abs(tool.diameter_mm ?? 0) / 2;
  if (!(radius > 0)) return undefined;
  switch (tool.shape) {
    case "ball":
      return { radius, heightAt: (distance) => radius - Math.sqrt(Math.max(0, radius * radius - distance * distance)) };
    case "bull": {
      const corner = Math.min(radius, Math.max(0, tool.corner_radius_mm ?? 0));
      return { radius, heightAt: (distance) => {
        const out = Math.max(0, distance - (radius - corner));
        return corner - Math.sqrt(Math.max(0, corner * corner - out * out));
      } };
    }
    case "drill":
    case "chamfer": {
      const tip = tool.shape === "chamfer" ? (tool.tip_diameter_mm ?? 0) / 2 : 0;
      if (!tool.point_angle_rad) return undefined;
      const rise = 1 / Math.tan(tool.point_angle_rad / 2);
      return { radius, heightAt: (distance) => Math.max(0, distance - tip) * rise };
    }
    case "tap":
    case "thread mill":
    case "t-slot":
    case "lollipop":
      // They cut below a neck, or around a core of unknown diameter: their cuts are shown once they have passed.
      return undefined;
    default:
      return { radius, heightAt: () => 0 };
  }
}

/** The lower side of an outline of heights and radii from the tip up. */
function formFloor(profile: [number, number][]): ToolFloor | undefined {
  if (profile.length < 2) return undefined;
  const radius = Math.max(...profile.map(([, r]) => r));
  return { radius, heightAt: (distance) => {
    let lowest = Infinity;
    let [height, from] = [profile[0]![0], 0];
    for (const [nextHeight, to] of profile) {
      if (distance >= Math.min(from, to) && distance <= Math.max(from, to)) {
        const fraction = to === from ? 0 : (distance - from) / (to - from);
        lowest = Math.min(lowest, height + (nextHeight - height) * fraction);
      }
      [height, from] = [nextHeight, to];
    }
    return lowest;
  } };
}
