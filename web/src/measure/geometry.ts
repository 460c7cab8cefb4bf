// Features of the path that can be measured, and the distance between two of them.

import { type Units, length, programmed } from "../panels/units";
import { ARC_NUMBERS, arcIndex } from "../path/arcs";
import { type Vec3, RAPID, kindOf } from "../path/batch";
import type { Path } from "../path/path";
import type { PickedPoint } from "../view/picking";

/** What a click on the path selects; points are relative to the origin of the path, mm, `sweep` is in rad. */
export type PathFeature =
  | { kind: "point"; at: Vec3; of: "end" | "path" }
  | { kind: "line"; at: Vec3; from: Vec3; to: Vec3 }
  | { kind: "arc"; at: Vec3; center: Vec3; axis: Vec3; radius: number; sweep: number };

/** A distance between two points, and what they are. */
export interface MeasuredDistance {
  mm: number;
  from: Vec3;
  to: Vec3;
  between: string;
  /** Between two lines that are not parallel, rad. */
  angle?: number;
}

/** Two lines with a smaller sine of the angle between them are parallel: positions have single precision. */
const PARALLEL_SINE = 1e-3;
/** A spiral whose start and end radius differ by less is an arc, mm. */
const CONSTANT_RADIUS_MM = 1e-3;

const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const plus = (a: Vec3, b: Vec3, by = 1): Vec3 => [a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const norm = (a: Vec3): number => Math.hypot(...a);

/** The feature at a picked point: the end of a row that it was moved to, otherwise the arc or the line that was hit. */
export function featureAt(path: Path, { row, fraction, at, snapped }: PickedPoint): PathFeature {
  const found = path.find(row);
  if (snapped || !found) return { kind: "point", at, of: snapped ? "end" : "path" };
  const [batch, index] = found;
  // A spline has no constant radius, and an arc that a rotary axis turns is no arc on the part.
  if (batch.curves?.has(index)) return { kind: "point", at, of: "path" };
  const arc = arcIndex(batch, index);
  const vectorAt = (numbers: Float32Array, offset: number): Vec3 => [numbers[offset]!, numbers[offset + 1]!, numbers[offset + 2]!];
  if (arc < 0) return { kind: "line", at, from: vectorAt(batch.points, 6 * index), to: vectorAt(batch.points, 6 * index + 3) };
  const record = batch.arcs.subarray(ARC_NUMBERS * arc, ARC_NUMBERS * (arc + 1));
  const [startRadius, endRadius, sweep, rise] = [record[9]!, record[10]!, record[11]!, record[12]!];
  if (kindOf(batch.kind[index]!) === RAPID || Math.abs(startRadius - endRadius) > CONSTANT_RADIUS_MM) return { kind: "point", at, of: "path" };
  // The centre at the height of the point that was hit.
  const axis = vectorAt(record, 6);
  return { kind: "arc", at, center: plus(vectorAt(record, 0), axis, rise * fraction), axis, radius: startRadius, sweep };
}

/** The point of a feature that distances are measured from. */
function referencePoint(feature: PathFeature): Vec3 {
  return feature.kind === "arc" ? feature.center : feature.at;
}

/** The foot of the perpendicular from a point to an infinite line. */
function footOf(at: Vec3, { from, to }: { from: Vec3; to: Vec3 }): Vec3 {
  const along = minus(to, from);
  const square = dot(along, along);
  return square > 0 ? plus(from, along, dot(minus(at, from), along) / square) : from;
}

const FEATURE_NAMES = { point: "point", line: "line", arc: "centre" } as const;

/** The distance between two features: perpendicular where one of them is a line or both are parallel lines, otherwise between the picked points and centres. */
export function measuredDistance(one: PathFeature, other: PathFeature): MeasuredDistance {
  const between = `${FEATURE_NAMES[one.kind]} to ${FEATURE_NAMES[other.kind]}`;
  if (one.kind === "line" && other.kind === "line") return betweenLines(one, other);
  const [from, to] = [referencePoint(one), referencePoint(other)];
  if (one.kind === "line") return distanceFrom(footOf(to, one), to, between);
  if (other.kind === "line") return distanceFrom(from, footOf(from, other), between);
  return distanceFrom(from, to, between);
}

function distanceFrom(from: Vec3, to: Vec3, between: string): MeasuredDistance {
  return { mm: norm(minus(to, from)), from, to, between };
}

function betweenLines(one: Extract<PathFeature, { kind: "line" }>, other: Extract<PathFeature, { kind: "line" }>): MeasuredDistance {
  const [a, b] = [minus(one.to, one.from), minus(other.to, other.from)];
  const cosine = Math.min(1, Math.abs(dot(a, b)) / (norm(a) * norm(b) || 1));
  const angle = Math.acos(cosine);
  if (Math.sin(angle) < PARALLEL_SINE) return distanceFrom(footOf(other.at, one), other.at, "parallel lines");
  return { ...distanceFrom(one.at, other.at, "point to point"), angle };
}

const degrees = (rad: number): string => `${Number(((rad * 180) / Math.PI).toFixed(3))}°`;

/** X, Y and Z of a point or of a distance, with the unit. */
export function componentsText(units: Units, at: Vec3): string {
  const named = ["X", "Y", "Z"].map((name, axis) => `${name} ${length(units, at[axis]!, false)}`);
  return `${named.join("  ")} ${units.inch ? "in" : "mm"}`;
}

/** A feature as text; `origin` is that of the path. */
export function featureText(feature: PathFeature, origin: Vec3, units: Units): string {
  const pointText = (point: Vec3) => componentsText(units, programmed(units, plus(point, origin)));
  switch (feature.kind) {
    case "line":
      return `Line, ${length(units, norm(minus(feature.to, feature.from)))} long`;
    case "arc":
      return `Arc R ${length(units, feature.radius)}, Ø ${length(units, 2 * feature.radius)}, ` +
        `${degrees(Math.abs(feature.sweep))}, centre ${pointText(feature.center)}`;
    default:
      return `${feature.of === "end" ? "End point" : "Point"} ${pointText(feature.at)}`;
  }
}

/** A distance as text. */
export function distanceText({ mm, from, to, between, angle }: MeasuredDistance, units: Units): string {
  const angleText = angle === undefined ? "" : `, the lines are not parallel: ${degrees(angle)}`;
  return `${length(units, mm)} ${between}   (${componentsText(units, minus(to, from))})${angleText}`;
}
