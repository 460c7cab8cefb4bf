// Writes the manifest of the package into npm/dist. The version is that of the workspace.
import { readFileSync, writeFileSync } from "node:fs";

const root = new URL("../", import.meta.url);
const version = /^\[workspace\.package\]\nversion = "([^"]+)"/m.exec(readFileSync(new URL("Cargo.toml", root), "utf8"))?.[1];
if (version === undefined) throw new Error("Cargo.toml: [workspace.package] does not begin with the version");

const manifest = {
  name: "@chordal/core",
  version,
  description: "Runs CNC programs exactly as their control would: problems, commands, exact path, time, setpoints",
  keywords: ["gcode", "cnc", "nc", "cam", "simulation"],
  license: "MIT OR Apache-2.0",
  type: "module",
  sideEffects: false,
  engines: { node: ">=20.19" },
  exports: {
    ".": { types: "./index.d.ts", default: "./index.js" },
    "./worker": { types: "./worker.d.ts", default: "./worker.js" },
    "./chordal.wasm": "./chordal.wasm",
  },
};
writeFileSync(new URL("npm/dist/package.json", root), `${JSON.stringify(manifest, null, 2)}\n`);
