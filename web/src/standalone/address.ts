// Programs that the address of the page names: `?program=https://…`, fetched by the browser.

import { MAX_PROGRAM_BYTES, nameOf, sizeComplaint } from "./opened-files";

export interface AddressRequest {
  program: URL;
  /** What lies next to it. */
  files: URL[];
  /** The program that it is compared with. */
  against: URL | undefined;
  /** A built-in machine, or the name of one of the files. */
  machine: string | undefined;
}

/** What the address asks for; nothing where it names no program, an error where it names none that can be loaded. */
export function addressRequest(search: string, base: string): AddressRequest | undefined {
  const words = new URLSearchParams(search);
  const program = words.get("program");
  if (!program) return undefined;
  const against = words.get("against");
  return {
    program: addressOf(program, base),
    files: words.getAll("file").map((file) => addressOf(file, base)),
    against: against ? addressOf(against, base) : undefined,
    machine: words.get("machine") ?? undefined,
  };
}

/** The address of the page with a program in it. */
export function programQuery(program: string): string {
  return `?${new URLSearchParams({ program })}`;
}

function addressOf(text: string, base: string): URL {
  const url = URL.canParse(text, base) ? new URL(text, base) : undefined;
  if (url?.protocol === "https:" || url?.protocol === "http:") return url;
  throw new Error(`${text.slice(0, 200)} is not the address of a program: it begins with https:// or http://.`);
}

/** The name of the file at an address. */
export function fileOf(url: URL): string {
  const last = url.pathname.split("/").pop() ?? "";
  try {
    return nameOf(decodeURIComponent(last));
  } catch {
    return nameOf(last);
  }
}

const SAVE_HINT = "Save the file, and open it here.";

/** Loads a file; an error with a sentence for people where that cannot be. */
export async function fetchFile(url: URL): Promise<ArrayBuffer> {
  const name = fileOf(url);
  if (location.protocol === "https:" && url.protocol === "http:" && !isOwn(url)) {
    throw new Error(`${name} cannot be loaded: its address begins with http://, and a page of https:// must not load it. ${SAVE_HINT}`);
  }
  const response = await fetch(url).catch(async () => {
    throw new Error(await whyNot(url, name));
  });
  const { status, statusText } = response;
  if (!response.ok) throw new Error(`${name} cannot be loaded: ${url.host} answers ${`${status} ${statusText}`.trim()}.`);
  if (response.headers.get("content-type")?.startsWith("text/html")) {
    throw new Error(`${name} cannot be loaded: there is a page at ${url.host}, not a program. Give the address of the file itself.`);
  }
  return read(response, name).catch((error: unknown) => {
    if (error instanceof TooLarge) throw error;
    throw new Error(`${name} cannot be loaded: the connection to ${url.host} ended too early.`);
  });
}

function isOwn({ hostname }: URL): boolean {
  return hostname === "localhost" || hostname === "127.0.0.1" || hostname === "[::1]";
}

class TooLarge extends Error {}

async function read(response: Response, name: string): Promise<ArrayBuffer> {
  const refuse = (bytes: number) => {
    const complaint = sizeComplaint(name, bytes);
    if (complaint) throw new TooLarge(complaint);
  };
  refuse(Number(response.headers.get("content-length") ?? 0));
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let bytes = 0;
  const reader = response.body?.getReader();
  for (;;) {
    const { done, value } = (await reader?.read()) ?? { done: true, value: undefined };
    if (done || !value) break;
    bytes += value.length;
    // What comes is counted: a server need not say how much there is, or may say less.
    if (bytes > MAX_PROGRAM_BYTES) await reader?.cancel();
    refuse(bytes);
    parts.push(value);
  }
  return new Blob(parts).arrayBuffer();
}

/** A browser does not say why it could not load a file; a second request shows whether the server answers at all. */
async function whyNot(url: URL, name: string): Promise<string> {
  const end = new AbortController();
  const isThere = await fetch(url, { mode: "no-cors", signal: end.signal }).then(() => true, () => false);
  end.abort();
  return isThere
    ? `${name} cannot be loaded: ${url.host} does not allow other pages to read it (CORS). ${SAVE_HINT}`
    : `${name} cannot be loaded: ${url.host} does not answer, or sends the browser to another address. ${SAVE_HINT}`;
}
