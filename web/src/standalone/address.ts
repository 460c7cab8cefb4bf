// Programs that are named in the address of the page, `?program=https://…`, and fetched by the browser.

import { MAX_PROGRAM_BYTES, nameOf, sizeComplaint } from "./opened-files";

export interface AddressRequest {
  program: URL;
  /** Files of its folder: subprograms, machine and setup. */
  files: URL[];
  /** The program to compare it with. */
  against: URL | undefined;
  /** A built-in machine, or the name of one of the files. */
  machine: string | undefined;
}

/** The request in the query of an address; undefined where it names no program. Throws where an address is not of http or https. */
export function addressRequest(search: string, base: string): AddressRequest | undefined {
  const parameters = new URLSearchParams(search);
  const program = parameters.get("program");
  if (!program) return undefined;
  const against = parameters.get("against");
  return {
    program: addressOf(program, base),
    files: parameters.getAll("file").map((file) => addressOf(file, base)),
    against: against ? addressOf(against, base) : undefined,
    machine: parameters.get("machine") ?? undefined,
  };
}

/** The query that makes the page load a program. */
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

/** Loads a file; throws an error with a message for the user. */
export async function fetchFile(url: URL): Promise<ArrayBuffer> {
  const name = fileOf(url);
  if (location.protocol === "https:" && url.protocol === "http:" && !isLocal(url)) {
    throw new Error(`${name} cannot be loaded: its address begins with http://, and a page of https:// must not load it. ${SAVE_HINT}`);
  }
  const response = await fetch(url).catch(async () => {
    throw new Error(await fetchFailure(url, name));
  });
  const { status, statusText } = response;
  if (!response.ok) throw new Error(`${name} cannot be loaded: ${url.host} answers ${`${status} ${statusText}`.trim()}.`);
  if (response.headers.get("content-type")?.startsWith("text/html")) {
    throw new Error(`${name} cannot be loaded: there is a page at ${url.host}, not a program. Give the address of the file itself.`);
  }
  return readBody(response, name).catch((error: unknown) => {
    if (error instanceof TooLargeError) throw error;
    throw new Error(`${name} cannot be loaded: the connection to ${url.host} ended too early.`);
  });
}

function isLocal({ hostname }: URL): boolean {
  return hostname === "localhost" || hostname === "127.0.0.1" || hostname === "[::1]";
}

class TooLargeError extends Error {}

/** Reads the body; throws where it is too large. */
async function readBody(response: Response, name: string): Promise<ArrayBuffer> {
  const checkSize = (bytes: number) => {
    const complaint = sizeComplaint(name, bytes);
    if (complaint) throw new TooLargeError(complaint);
  };
  checkSize(Number(response.headers.get("content-length") ?? 0));
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let bytes = 0;
  const reader = response.body?.getReader();
  for (;;) {
    const { done, value } = (await reader?.read()) ?? { done: true, value: undefined };
    if (done || !value) break;
    bytes += value.length;
    // Counted as it comes: the server may omit the content length, or state a smaller one.
    if (bytes > MAX_PROGRAM_BYTES) await reader?.cancel();
    checkSize(bytes);
    parts.push(value);
  }
  return new Blob(parts).arrayBuffer();
}

/** Why a file could not be loaded. The browser does not tell; a second request, without CORS, shows whether the server answers. */
async function fetchFailure(url: URL, name: string): Promise<string> {
  const abort = new AbortController();
  const answers = await fetch(url, { mode: "no-cors", signal: abort.signal }).then(() => true, () => false);
  abort.abort();
  return answers
    ? `${name} cannot be loaded: ${url.host} does not allow other pages to read it (CORS). ${SAVE_HINT}`
    : `${name} cannot be loaded: ${url.host} does not answer, or sends the browser to another address. ${SAVE_HINT}`;
}
