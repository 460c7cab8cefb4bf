// Which of the files that were chosen or dropped is the program.

export interface SortedFiles<T> {
  program: T | undefined;
  others: T[];
  /** The machine or setup file to use, where there is just one. */
  machine: string | undefined;
}

/** Files that are no programs: machines and setups, shapes, tables. */
const COMPANION_FILE = /\.(toml|stl|dxf|tbl|csv|svg)$/i;

/** The last part of a path, without characters that are not allowed in file names. */
export function nameOf(path: string): string {
  const last = path.split(/[\\/]/).pop() ?? "";
  // eslint-disable-next-line no-control-regex
  const plain = last.replace(/[\u0000-\u001f\u007f<>:"|?*]/g, "").trim().slice(0, 120);
  return plain === "" || /^\.+$/.test(plain) ? "program.nc" : plain;
}

/** The name of a second program, changed where it equals that of the first: `part (2).nc`. */
export function distinctName(name: string, first: string): string {
  return name === first ? name.replace(/(\.\w+)?$/, " (2)$1") : name;
}

/** Takes the first file that can be a program as the program, and the others, which may be subprograms, as its files. */
export function sortFiles<T extends { name: string }>(files: T[]): SortedFiles<T> {
  const program = files.find(({ name }) => !COMPANION_FILE.test(name));
  const others = files.filter((file) => file !== program);
  const machines = others.filter(({ name }) => /\.toml$/i.test(name) && name !== "chordal.toml");
  return { program, others, machine: machines.length === 1 ? machines[0]!.name : undefined };
}

/** The largest program that the page opens, bytes: several copies are in memory. */
export const MAX_PROGRAM_BYTES = 256 * 2 ** 20;

/** Why a file is too large to be opened; undefined where it is not. */
export function sizeComplaint(name: string, bytes: number): string | undefined {
  if (bytes <= MAX_PROGRAM_BYTES) return undefined;
  const mib = (size: number) => `${(size / 2 ** 20).toFixed(0)} MiB`;
  return `${name} has ${mib(bytes)}; this page takes up to ${mib(MAX_PROGRAM_BYTES)}. \`chordal view\` on your computer takes more.`;
}
