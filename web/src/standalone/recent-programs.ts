// Recently opened programs, stored in this browser only, with limits on their number and their total size.

import type { ProgramFile } from "./engine";

export interface RecentProgram {
  name: string;
  program: ArrayBuffer;
  files: ProgramFile[];
  machine?: string;
  /** When it was opened or saved last, ms since the epoch. */
  at: number;
}

/** An entry of the list, stored without the program itself. */
export interface RecentEntry {
  name: string;
  bytes: number;
  at: number;
}

const MAX_ENTRIES = 20;
/** The largest program, with its files, that is stored, bytes. */
export const MAX_RECENT_BYTES = 32 * 2 ** 20;
const MAX_TOTAL_BYTES = 128 * 2 ** 20;

/** Names of the oldest entries, which exceed the limits. */
export function namesWithoutRoom(entries: RecentEntry[]): string[] {
  let bytes = 0;
  const newest = [...entries].sort((a, b) => b.at - a.at);
  return newest.filter((entry, index) => (bytes += entry.bytes) > MAX_TOTAL_BYTES || index >= MAX_ENTRIES).map(({ name }) => name);
}

/** The size of a program with its files, bytes. */
export function sizeOf({ program, files }: Pick<RecentProgram, "program" | "files">): number {
  return files.reduce((sum, { bytes }) => sum + bytes.byteLength, program.byteLength);
}

/** Waits for a request of IndexedDB. */
function completed<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

/** Opens the stores of programs and of their entries, which are separate so that listing does not read the programs. */
async function stores(mode: IDBTransactionMode): Promise<{ programs: IDBObjectStore; entries: IDBObjectStore; close: () => void }> {
  const opening = indexedDB.open("chordal", 1);
  opening.onupgradeneeded = () => {
    opening.result.createObjectStore("programs", { keyPath: "name" });
    opening.result.createObjectStore("entries", { keyPath: "name" });
  };
  const database = await completed(opening);
  const transaction = database.transaction(["programs", "entries"], mode);
  return { programs: transaction.objectStore("programs"), entries: transaction.objectStore("entries"), close: () => database.close() };
}

/** Stores a program, where the browser allows it. */
export async function keepRecent(recent: RecentProgram): Promise<void> {
  const bytes = sizeOf(recent);
  if (bytes > MAX_RECENT_BYTES) return;
  try {
    const { programs, entries, close } = await stores("readwrite");
    await completed(programs.put(recent));
    await completed(entries.put({ name: recent.name, bytes, at: recent.at } satisfies RecentEntry));
    for (const name of namesWithoutRoom((await completed(entries.getAll())) as RecentEntry[])) {
      await completed(programs.delete(name));
      await completed(entries.delete(name));
    }
    close();
  } catch {
    // No room, or a private window.
  }
}

/** The stored programs, the newest first. */
export async function listRecent(): Promise<RecentEntry[]> {
  try {
    const { entries, close } = await stores("readonly");
    const stored = (await completed(entries.getAll())) as RecentEntry[];
    close();
    return stored.sort((a, b) => b.at - a.at);
  } catch {
    return [];
  }
}

export async function findRecent(name: string): Promise<RecentProgram | undefined> {
  const { programs, close } = await stores("readonly");
  const stored = (await completed(programs.get(name))) as RecentProgram | undefined;
  close();
  return stored;
}

export async function forgetRecent(name: string): Promise<void> {
  const { programs, entries, close } = await stores("readwrite");
  await completed(programs.delete(name));
  await completed(entries.delete(name));
  close();
}
