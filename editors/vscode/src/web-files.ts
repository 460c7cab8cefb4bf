// Which files the server in the browser gets, and under which names.

const ENDINGS = ["toml", "nc", "ngc", "tap", "eia", "gcode", "cnc", "min", "mpf", "tbl"];
/** Machine files, and programs: one may call another. */
export const NEEDED = `**/*.{${ENDINGS.join(",")}}`;

/** A file that programs may need, by its name. */
export function isNeeded(name: string): boolean {
  return ENDINGS.includes(name.slice(name.lastIndexOf(".") + 1).toLowerCase());
}

/** A folder that is looked into, by its name. */
export function isOpen(name: string): boolean {
  return !name.startsWith(".") && name !== "node_modules";
}

/** Most files that are brought. */
export const MOST_FILES = 500;
/** How deep folders are looked into. */
export const DEEPEST = 8;
/** Most bytes of all files together. */
export const MOST_BYTES = 16_000_000;

interface Address {
  path: string;
  with(change: { scheme: string; authority: string; query: string; fragment: string }): { toString(): string };
}

/** The address of a file for the server, which knows files by their paths alone. */
export function pathOf(uri: Address): string {
  return uri.with({ scheme: "file", authority: "", query: "", fragment: "" }).toString();
}
