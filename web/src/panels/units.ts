// Texts of quantities, in the units of the program.

export interface Units {
  inch: boolean;
  /** What coordinates of X, Y and Z are multiplied by: 2 where they are programmed as diameters; undefined: 1. */
  factors?: readonly number[];
  /** Whether the machine has X, Y and Z; undefined: it has all. */
  has?: readonly boolean[];
}

/** A position as it is programmed, with diameters. */
export function programmed({ factors }: Units, at: readonly [number, number, number]): [number, number, number] {
  return at.map((value, axis) => value * (factors?.[axis] ?? 1)) as [number, number, number];
}

/** `X 10.000  Y –  Z -5.000 mm`: a position as it is programmed, with a dash for an unknown coordinate, and without axes that the machine lacks. */
export function positionText(units: Units, at: readonly (number | undefined)[]): string {
  const texts = at.map((value, axis) =>
    `${"XYZ"[axis]} ${value === undefined ? "–" : coordinate(units, value * (units.factors?.[axis] ?? 1))}`);
  return `${texts.filter((_, axis) => units.has?.[axis] ?? true).join("  ")} ${units.inch ? "in" : "mm"}`;
}

const MM_PER_INCH = 25.4;
const KW_PER_HP = 0.745699871582270;

/** Without trailing zeros. */
function trimmed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  const short = text.includes(".") ? text.replace(/0+$/, "").replace(/\.$/, "") : text;
  return short === "-0" ? "0" : short;
}

/** A length, rounded to 0.0001 in or 0.001 mm, or to a number of significant digits; 0: to those decimals. */
export function length({ inch }: Units, mm: number, withUnit = true, significantDigits = 0): string {
  const value = inch ? mm / MM_PER_INCH : mm;
  const text = significantDigits > 0 ? String(Number(value.toPrecision(significantDigits))) : trimmed(value, inch ? 4 : 3);
  return withUnit ? `${text} ${inch ? "in" : "mm"}` : text;
}

/** A volume between two bounds, in cm³ or in³. */
export function volume({ inch }: Units, lowMm3: number, highMm3: number): string {
  const convert = (mm3: number) => (inch ? mm3 / MM_PER_INCH ** 3 : mm3 / 1000).toFixed(2);
  const [low, high] = [convert(lowMm3), convert(highMm3)];
  return `${low === high ? low : `${low} to ${high}`} ${inch ? "in³" : "cm³"}`;
}

/** A coordinate with a fixed number of decimals, so that the readout does not jump. */
export function coordinate({ inch }: Units, mm: number): string {
  const text = inch ? (mm / MM_PER_INCH).toFixed(4) : mm.toFixed(3);
  return /^-0\.0*$/.test(text) ? text.slice(1) : text;
}

/** The angles of A, B and C, rad, that are not zero: `A 90.000°`. */
export function angles(rotaryAngles: ArrayLike<number>): string {
  const named = ["A", "B", "C"].map((letter, axis) => [letter, (rotaryAngles[axis]! * 180) / Math.PI] as const);
  return named.filter(([, degrees]) => Math.abs(degrees) > 5e-4).map(([letter, degrees]) => `  ${letter} ${degrees.toFixed(3)}°`).join("");
}

/** A speed in mm/min. */
export function speed({ inch }: Units, mmPerMin: number): string {
  return inch ? `${trimmed(mmPerMin / MM_PER_INCH, 1)} in/min` : `${trimmed(mmPerMin, 0)} mm/min`;
}

/** A power in kW. */
export function power({ inch }: Units, kw: number): string {
  return inch ? `${trimmed(kw / KW_PER_HP, 2)} hp` : `${trimmed(kw, 2)} kW`;
}

/** `9.4 s`, `3:07.5`, `1:02:03`. */
export function duration(seconds: number): string {
  if (!Number.isFinite(seconds)) return "–";
  if (seconds < 60) return `${seconds.toFixed(seconds < 10 ? 2 : 1)} s`;
  const tenths = Math.round(seconds * 10);
  const rest = (tenths % 600) / 10;
  const minutes = Math.floor(tenths / 600);
  if (minutes < 60) return `${minutes}:${rest.toFixed(1).padStart(4, "0")}`;
  const whole = Math.round(seconds);
  const twoDigits = (value: number) => String(value).padStart(2, "0");
  return `${Math.floor(whole / 3600)}:${twoDigits(Math.floor(whole / 60) % 60)}:${twoDigits(whole % 60)}`;
}

/** `1,234,567`. */
export function count(value: number): string {
  return value.toLocaleString("en-US");
}

/** `1 block`, `7 blocks`. */
export function countText(value: number, singular: string, plural = `${singular}s`): string {
  return `${count(value)} ${value === 1 ? singular : plural}`;
}
