// A program in the fragment of an address: compressed, and not sent to any server. Everyone with the link has the program.

export interface SharedProgram {
  name: string;
  text: string;
  /** The machine that was chosen. */
  machine: string | null;
  /** The files next to it: path and text. */
  files: [string, string][];
}

/** Characters of a link: longer ones are often cut by mail and chat programs. */
export const MAX_LINK_CHARACTERS = 16_000;
/** The largest program in a link, bytes: a short compressed text could expand to very much. */
const MAX_TEXT_BYTES = 4 * 2 ** 20;

const FRAGMENT_PREFIX = "#p=";

function base64(bytes: Uint8Array): string {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const plain = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(plain, (character) => character.charCodeAt(0));
}

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream, most: number): Promise<Uint8Array> {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts: Uint8Array[] = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > most) {
      await reader.cancel();
      throw new Error("too long");
    }
    parts.push(value);
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** The fragment of a program. */
export async function fragmentOf(shared: SharedProgram): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify([shared.name, shared.text, shared.machine, shared.files]));
  return FRAGMENT_PREFIX + base64(await through(bytes, new CompressionStream("deflate-raw"), Infinity));
}

/** The program of a fragment; nothing where it has none, an error where it is damaged. */
export async function programInFragment(fragment: string): Promise<SharedProgram | undefined> {
  if (!fragment.startsWith(FRAGMENT_PREFIX)) return undefined;
  const damaged = () => new Error("The link is damaged or incomplete: it holds no program.");
  let read: unknown;
  try {
    const bytes = await through(bytesOf(fragment.slice(FRAGMENT_PREFIX.length)), new DecompressionStream("deflate-raw"), MAX_TEXT_BYTES);
    read = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
  } catch {
    throw damaged();
  }
  if (!Array.isArray(read)) throw damaged();
  const [name, text, machine, files] = read as unknown[];
  const isPair = (pair: unknown) => Array.isArray(pair) && pair.length === 2 && pair.every((part) => typeof part === "string");
  if (typeof name !== "string" || typeof text !== "string") throw damaged();
  if ((machine !== null && typeof machine !== "string") || !Array.isArray(files) || !files.every(isPair)) throw damaged();
  return { name, text, machine, files: files as [string, string][] };
}
