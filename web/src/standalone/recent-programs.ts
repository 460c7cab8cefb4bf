// Programs that were open lately, kept in this browser alone: so many of them, and so large together.

import type { File_ } from "./engine";

export interface Kept {
  name: string;
  program: ArrayBuffer;
  files: File_[];
  machine?: string;
  /** When it was opened or saved last, ms. */
  at: number;
}

/** What the list shows of one. */
export interface Entry {
  name: string;
  bytes: number;
  at: number;
}

const MOST_ENTRIES = 20;
/** A program of more is not kept, bytes. */
export const MOST_EACH = 32 * 2 ** 20;
const MOST_TOGETHER = 128 * 2 ** 20;

/** Names of those that have no room any more; the newest stay. */
export function outgrown(entries: Entry[]): string[] {
  let bytes = 0;
  const newest = [...entries].sort((a, b) => b.at - a.at);
  return newest.filter((entry, index) => (bytes += entry.bytes) > MOST_TOGETHER || index >= MOST_ENTRIES).map(({ name }) => name);
}

export function sizeOf({ program, files }: Pick<Kept, "program" | "files">): number {
  return files.reduce((sum, { bytes }) => sum + bytes.byteLength, program.byteLength);
}

function asked<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

/** The store of programs and that of their entries, so that a list does not read the programs. */
async function stores(mode: IDBTransactionMode): Promise<{ programs: IDBObjectStore; entries: IDBObjectStore; close: () => void }> {
  const opening = indexedDB.open("chordal", 1);
  opening.onupgradeneeded = () => {
    opening.result.createObjectStore("programs", { keyPath: "name" });
    opening.result.createObjectStore("entries", { keyPath: "name" });
  };
  const base = await asked(opening);
  const transaction = base.transaction(["programs", "entries"], mode);
  return { programs: transaction.objectStore("programs"), entries: transaction.objectStore("entries"), close: () => base.close() };
}

/** Keeps a program; a browser that keeps nothing is no error. */
export async function keep(kept: Kept): Promise<void> {
  const bytes = sizeOf(kept);
  if (bytes > MOST_EACH) return;
  try {
    const { programs, entries, close } = await stores("readwrite");
    await asked(programs.put(kept));
    await asked(entries.put({ name: kept.name, bytes, at: kept.at } satisfies Entry));
    for (const name of outgrown((await asked(entries.getAll())) as Entry[])) {
      await asked(programs.delete(name));
      await asked(entries.delete(name));
    }
    close();
  } catch {
    // No room, or a private window.
  }
}

/** Those that are kept, the newest first. */
export async function list(): Promise<Entry[]> {
  try {
    const { entries, close } = await stores("readonly");
    const found = (await asked(entries.getAll())) as Entry[];
    close();
    return found.sort((a, b) => b.at - a.at);
  } catch {
    return [];
  }
}

export async function find(name: string): Promise<Kept | undefined> {
  const { programs, close } = await stores("readonly");
  const found = (await asked(programs.get(name))) as Kept | undefined;
  close();
  return found;
}

export async function forget(name: string): Promise<void> {
  const { programs, entries, close } = await stores("readwrite");
  await asked(programs.delete(name));
  await asked(entries.delete(name));
  close();
}
