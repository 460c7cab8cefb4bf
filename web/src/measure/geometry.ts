// Features of the path that can be measured, and the distance between two of them.

import { type Units, length, programmed } from "../panels/units";
import { arcIndex } from "../path/arcs";
import { type Vec3, RAPID, kindOf } from "../path/batch";
import type { Path } from "../path/path";
import type { PickedPoint } from "../view/picking";

/** What a click on the path selects; points relative to the origin of the path, mm. */
export type PathFeature =
  | { kind: "point"; at: Vec3; of: "end" | "path" }
  | { kind: "line"; at: Vec3; from: Vec3; to: Vec3 }
  | { kind: "arc"; at: Vec3; center: Vec3; axis: Vec3; radius: number; sweep: number };

/** A distance, from where to where it is, and what it is between. */
export interface MeasuredDistance {
  mm: number;
  from: Vec3;
  to: Vec3;
  between: string;
  /** Between two lines that are not parallel, rad. */
  angle?: number;
}

/** Sine of the angle up to which two lines count as parallel: positions have single precision. */
const PARALLEL_SINE = 1e-3;
/** A curve whose start and end radius differ by less is an arc, mm. */
const CONSTANT_RADIUS_MM = 1e-3;

const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const plus = (a: Vec3, b: Vec3, by = 1): Vec3 => [a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const size = (a: Vec3): number => Math.hypot(...a);

/** The feature at a picked point: an end where one is near, else the arc or the line that was hit. */
export function featureAt(path: Path, { row, fraction, at, snapped }: PickedPoint): PathFeature {
  const found = path.find(row);
  if (snapped || !found) return { kind: "point", at, of: snapped ? "end" : "path" };
  const [batch, own] = found;
  // A curve has no one radius, and one that the table turns is no arc on the part.
  if (batch.curves?.has(own)) return { kind: "point", at, of: "path" };
  const arc = arcIndex(batch, own);
  const place = (from: number): Vec3 => [batch.points[from]!, batch.points[from + 1]!, batch.points[from + 2]!];
  if (arc < 0) return { kind: "line", at, from: place(6 * own), to: place(6 * own + 3) };
  const record = batch.arcs.subarray(13 * arc, 13 * arc + 13);
  const numbers = (from: number): Vec3 => [record[from]!, record[from + 1]!, record[from + 2]!];
  const [first, last, sweep, rise] = [record[9]!, record[10]!, record[11]!, record[12]!];
  if (kindOf(batch.kind[own]!) === RAPID || Math.abs(first - last) > CONSTANT_RADIUS_MM) return { kind: "point", at, of: "path" };
  // The centre at the height of the point that was hit.
  const axis = numbers(6);
  return { kind: "arc", at, center: plus(numbers(0), axis, rise * fraction), axis, radius: first, sweep };
}

/** The point of a feature that distances are taken from. */
function reference(feature: PathFeature): Vec3 {
  return feature.kind === "arc" ? feature.center : feature.at;
}

/** The foot of a point on a line without ends. */
function foot(at: Vec3, { from, to }: { from: Vec3; to: Vec3 }): Vec3 {
  const along = minus(to, from);
  const square = dot(along, along);
  return square > 0 ? plus(from, along, dot(minus(at, from), along) / square) : from;
}

const FEATURE_NAMES = { point: "point", line: "line", arc: "centre" } as const;

/** The distance between two features: the shortest one where one of them is a line, else between points and centres. */
export function measuredDistance(one: PathFeature, other: PathFeature): MeasuredDistance {
  const between = `${FEATURE_NAMES[one.kind]} to ${FEATURE_NAMES[other.kind]}`;
  if (one.kind === "line" && other.kind === "line") return betweenLines(one, other);
  const [from, to] = [reference(one), reference(other)];
  if (one.kind === "line") return distanceFrom(foot(to, one), to, between);
  if (other.kind === "line") return distanceFrom(from, foot(from, other), between);
  return distanceFrom(from, to, between);
}

function distanceFrom(from: Vec3, to: Vec3, between: string): MeasuredDistance {
  return { mm: size(minus(to, from)), from, to, between };
}

function betweenLines(one: Extract<PathFeature, { kind: "line" }>, other: Extract<PathFeature, { kind: "line" }>): MeasuredDistance {
  const [a, b] = [minus(one.to, one.from), minus(other.to, other.from)];
  const cosine = Math.min(1, Math.abs(dot(a, b)) / (size(a) * size(b) || 1));
  const angle = Math.acos(cosine);
  if (Math.sin(angle) < PARALLEL_SINE) return distanceFrom(foot(other.at, one), other.at, "parallel lines");
  return { ...distanceFrom(one.at, other.at, "point to point"), angle };
}

const degrees = (rad: number): string => `${Number(((rad * 180) / Math.PI).toFixed(3))}°`;

/** X, Y and Z of a point or of a distance, with the unit. */
export function parts(units: Units, at: Vec3): string {
  const named = ["X", "Y", "Z"].map((name, axis) => `${name} ${length(units, at[axis]!, false)}`);
  return `${named.join("  ")} ${units.inch ? "in" : "mm"}`;
}

/** A feature as text; `origin` is that of the path. */
export function featureText(feature: PathFeature, origin: Vec3, units: Units): string {
  const at = (place: Vec3) => parts(units, programmed(units, plus(place, origin)));
  switch (feature.kind) {
    case "line":
      return `Line, ${length(units, size(minus(feature.to, feature.from)))} long`;
    case "arc":
      return `Arc R ${length(units, feature.radius)}, Ø ${length(units, 2 * feature.radius)}, ` +
        `${degrees(Math.abs(feature.sweep))}, centre ${at(feature.center)}`;
    default:
      return `${feature.of === "end" ? "End point" : "Point"} ${at(feature.at)}`;
  }
}

/** A distance as text. */
export function distanceText({ mm, from, to, between, angle }: MeasuredDistance, units: Units): string {
  const bent = angle === undefined ? "" : `, the lines are not parallel: ${degrees(angle)}`;
  return `${length(units, mm)} ${between}   (${parts(units, minus(to, from))})${bent}`;
}
