// Files that were chosen or dropped: which of them is the program, and which lie next to it.

export interface SortedFiles<T> {
  program: T | undefined;
  others: T[];
  /** The machine or setup file that counts without being chosen. */
  machine: string | undefined;
}

/** Endings of what a program or a setup names: machines, shapes, tables. */
const COMPANION_FILE = /\.(toml|stl|dxf|tbl|csv|svg)$/i;

/** The last part of a path, as a name that is safe to show and to save under. */
export function nameOf(path: string): string {
  const last = path.split(/[\\/]/).pop() ?? "";
  // eslint-disable-next-line no-control-regex
  const plain = last.replace(/[\u0000-\u001f\u007f<>:"|?*]/g, "").trim().slice(0, 120);
  return plain === "" || /^\.+$/.test(plain) ? "program.nc" : plain;
}

/** A name for a second program that differs from that of the first: `part (2).nc`. */
export function distinctName(name: string, first: string): string {
  return name === first ? name.replace(/(\.\w+)?$/, " (2)$1") : name;
}

/** The first file that is not of a kind that lies next to programs is the program; other programs lie next to it. */
export function sortFiles<T extends { name: string }>(files: T[]): SortedFiles<T> {
  const program = files.find(({ name }) => !COMPANION_FILE.test(name));
  const others = files.filter((file) => file !== program);
  const machines = others.filter(({ name }) => /\.toml$/i.test(name) && name !== "chordal.toml");
  return { program, others, machine: machines.length === 1 ? machines[0]!.name : undefined };
}

/** The largest program that the page takes: it is in memory several times, bytes. */
export const MAX_PROGRAM_BYTES = 256 * 2 ** 20;

/** Why a file is not taken; nothing where it is. */
export function sizeComplaint(name: string, bytes: number): string | undefined {
  if (bytes <= MAX_PROGRAM_BYTES) return undefined;
  const mib = (of: number) => `${(of / 2 ** 20).toFixed(0)} MiB`;
  return `${name} has ${mib(bytes)}; this page takes up to ${mib(MAX_PROGRAM_BYTES)}. \`chordal view\` on your computer takes more.`;
}
