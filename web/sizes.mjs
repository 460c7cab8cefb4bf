// What a visitor of the page that stands alone downloads: `node sizes.mjs` in `web/`, after `tools/wasm page`.

import { readFileSync, readdirSync } from "node:fs";
import { brotliCompressSync, gzipSync } from "node:zlib";

const kib = (bytes) => `${Math.ceil(bytes / 1024)}`.padStart(6);
/** What the first picture does not wait for. */
const LATER = /^(examples|sw)/;

const sums = [0, 0, 0];
console.log("            KiB   gzip brotli");
for (const name of readdirSync("dist-static").sort()) {
  const bytes = readFileSync(`dist-static/${name}`);
  const sizes = [bytes.length, gzipSync(bytes, { level: 9 }).length, brotliCompressSync(bytes).length];
  if (!LATER.test(name)) sizes.forEach((size, index) => (sums[index] += size));
  console.log(`         ${sizes.map(kib).join(" ")}  ${name}${LATER.test(name) ? " (after the first picture)" : ""}`);
}
console.log(`together ${sums.map(kib).join(" ")}  until the first picture`);
