// The examples of the repository as data for the page that stands alone.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import type { ExampleGroup } from "./src/standalone/gallery";

const TITLES: Record<string, string> = {
  "fadal": "Fadal", "fanuc": "Fanuc", "fanuc-lathe": "Fanuc, lathe", "fluidnc": "FluidNC", "grbl": "GRBL", "grblhal": "grblHAL",
  "haas": "Haas", "haas-lathe": "Haas, lathe", "heidenhain": "HEIDENHAIN", "linuxcnc": "LinuxCNC", "linuxcnc-lathe": "LinuxCNC, lathe", "mach3": "Mach3", "marlin": "Marlin",
  "mitsubishi": "Mitsubishi", "mitsubishi-lathe": "Mitsubishi, lathe", "mitsubishi-type2": "Mitsubishi, arcs of type 2",
  "sinumerik": "Sinumerik", "stock": "Stock that is cut", "textbook": "Programs of textbooks", "textbook-absolute-center": "Arc centres as positions",
  "textbook-from-center": "Arc centres to the start",
};

/** Setups that are not named as their program. */
const SETUPS: Record<string, string> = {
  "stock/pocket.nc": "feeds.toml", "stock/trochoid.nc": "feeds.toml", "stock/contour.nc": "feeds.toml", "fanuc-lathe/bolt-first.nc": "bolt.toml",
};

/** A comment as a sentence: programs shout. */
function sentence(text: string): string {
  const isLoud = !/[a-z]/.test(text);
  const calm = isLoud ? text.replace(/[A-Z]{2,}/g, (word) => word.toLowerCase()).replace(/\bA\b/g, "a") : text;
  const plain = calm.replace(/\s+/g, " ").trim().replace(/[,:]$/, "");
  return plain.charAt(0).toUpperCase() + plain.slice(1);
}

/** What a program says of itself: the first comment that is not for the tests, up to the end of its sentence. */
function shows(text: string): string {
  const sentences: string[] = [];
  for (const line of text.split("\n")) {
    const comment = /^[^(;]*(?:\(([^)]*)\)?|;(.*))/.exec(line.trim());
    const words = (comment?.[1] ?? comment?.[2] ?? "").trim();
    // After a semicolon as well: `;(machine: marlin-router)`.
    if (words === "" || /^\(?(machine|set|units|tools|settings): /.test(words)) {
      if (sentences.length > 0) break;
      continue;
    }
    sentences.push(words);
    if (/\.$/.test(words) || !/[a-z]/.test(words) || sentences.length === 3) break;
  }
  return sentence(sentences.join(" "));
}

/** What the comments for the tests say: the machine, and what is set of it. */
function machineOf(text: string): { name: string | null; set: string[] } {
  const set = [...text.matchAll(/\(set: ([^)]*)\)/g)].map(([, assignment]) => assignment!);
  return { name: /\(machine: ([\w-]+)\)/.exec(text)?.[1] ?? null, set };
}

export function gallery(root: string): ExampleGroup[] {
  const folders = readdirSync(root, { withFileTypes: true }).filter((entry) => entry.isDirectory());
  return folders.map(({ name: folder }) => {
    const names = readdirSync(join(root, folder)).sort();
    const read = (name: string) => readFileSync(join(root, folder, name), "utf8");
    const examples = names.filter((name) => /\.(nc|ngc)$/.test(name)).map((name) => {
      const text = read(name);
      const setup = SETUPS[`${folder}/${name}`] ?? name.replace(/\.\w+$/, ".toml");
      const files: [string, string][] = [];
      const commented = machineOf(text);
      let machine = commented.name;
      if (existsSync(join(root, folder, setup)) && !/\.stl"/.test(read(setup))) {
        files.push([setup, read(setup)]);
        machine = setup;
      } else if (machine && commented.set.length > 0) {
        const own = name.replace(/\.\w+$/, "-machine.toml");
        files.push([own, `inherits = "${machine}"\n${commented.set.join("\n")}\n`]);
        machine = own;
      }
      return { name, shows: shows(text), text, files, machine };
    });
    return { title: TITLES[folder] ?? folder, folder, examples };
  }).filter(({ examples }) => examples.length > 0);
}
