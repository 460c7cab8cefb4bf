// A program in the fragment of an address: compressed, and never sent to a server. Whoever has the link has the program.

export interface SharedProgram {
  name: string;
  text: string;
  /** The chosen machine; null where none was chosen. */
  machine: string | null;
  /** Path and text of its files. */
  files: [string, string][];
}

/** The longest link, characters: mail and chat programs often truncate longer ones. */
export const MAX_LINK_CHARACTERS = 16_000;
/** The largest decompressed content of a link, bytes: a short compressed text could expand without limit. */
const MAX_TEXT_BYTES = 4 * 2 ** 20;

const FRAGMENT_PREFIX = "#p=";

/** Base64 with the alphabet for URLs, without padding. */
function base64(bytes: Uint8Array): string {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const plain = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(plain, (character) => character.charCodeAt(0));
}

/** Compresses or decompresses; throws where the result exceeds `maxBytes`. */
async function transformed(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream, maxBytes: number): Promise<Uint8Array> {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts: Uint8Array[] = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > maxBytes) {
      await reader.cancel();
      throw new Error("too long");
    }
    parts.push(value);
  }
  const all = new Uint8Array(length);
  let offset = 0;
  for (const part of parts) {
    all.set(part, offset);
    offset += part.length;
  }
  return all;
}

/** The address fragment of a program. */
export async function fragmentOf(shared: SharedProgram): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify([shared.name, shared.text, shared.machine, shared.files]));
  return FRAGMENT_PREFIX + base64(await transformed(bytes, new CompressionStream("deflate-raw"), Infinity));
}

/** The program of a fragment; undefined where the fragment has none. Throws where it is damaged. */
export async function programInFragment(fragment: string): Promise<SharedProgram | undefined> {
  if (!fragment.startsWith(FRAGMENT_PREFIX)) return undefined;
  const damaged = () => new Error("The link is damaged or incomplete: it holds no program.");
  let content: unknown;
  try {
    const bytes = await transformed(bytesOf(fragment.slice(FRAGMENT_PREFIX.length)), new DecompressionStream("deflate-raw"), MAX_TEXT_BYTES);
    content = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
  } catch {
    throw damaged();
  }
  if (!Array.isArray(content)) throw damaged();
  const [name, text, machine, files] = content as unknown[];
  const isPair = (pair: unknown) => Array.isArray(pair) && pair.length === 2 && pair.every((part) => typeof part === "string");
  if (typeof name !== "string" || typeof text !== "string") throw damaged();
  if ((machine !== null && typeof machine !== "string") || !Array.isArray(files) || !files.every(isPair)) throw damaged();
  return { name, text, machine, files: files as [string, string][] };
}
