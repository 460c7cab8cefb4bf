import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { defineConfig, type Plugin } from "vite";
import { gallery } from "./gallery.ts";

// The page that stands alone: `tools/wasm page` builds the module first and says where it is.

const hashOf = (bytes: string | Uint8Array) => createHash("sha256").update(bytes).digest("hex").slice(0, 8);

const wasm = readFileSync(process.env.CHORDAL_WASM ?? "../target/page.wasm");
const examples = JSON.stringify(gallery(resolve("../examples")));
/** Names that change with their content: a browser may keep such a file for ever. */
const MODULE = `chordal-${hashOf(wasm)}.wasm`;
const EXAMPLES = `examples-${hashOf(examples)}.json`;

/** The page may load nothing from other servers but a program that its own address names: `content-policy.ts` narrows `connect-src`
to that. A server that sends these rules as a header may add `frame-ancestors`. */
const POLICY = [
  "default-src 'none'", "script-src 'self' 'wasm-unsafe-eval'", "worker-src 'self'", "connect-src 'self' https: http:",
  "img-src 'self' data:", "style-src 'self' 'nonce-chordal'", "base-uri 'none'", "form-action 'none'",
].join("; ");

const BEFORE = "Chordal is loading. It needs JavaScript and WebAssembly, and a web server: opened as a file, browsers refuse its parts.";

function page(): Plugin {
  return {
    name: "chordal-page",
    transformIndexHtml: {
      order: "pre",
      handler: (html) =>
        html
          .replace("/src/server-page.ts", "/src/standalone-page.ts")
          .replace("NONCE-OF-THE-PAGE", "chordal")
          .replace('<meta name="viewport"', `<meta http-equiv="Content-Security-Policy" content="${POLICY}" />\n    <meta name="viewport"`)
          .replace("<title>", '<meta name="description" content="Runs NC programs as their control would, in the browser" />\n    <meta name="referrer" content="no-referrer" />\n    <title>')
          .replace("</head>", `  <link rel="preload" as="fetch" type="application/wasm" crossorigin href="./${MODULE}" />\n  </head>`)
          .replace('<div id="app"></div>', `<div id="app"></div>\n    <p class="before">${BEFORE}</p>`),
    },
    generateBundle: {
      order: "post",
      handler(_options, bundle) {
        this.emitFile({ type: "asset", fileName: MODULE, source: wasm });
        this.emitFile({ type: "asset", fileName: EXAMPLES, source: examples });
        const icon = readFileSync("public/icon.svg");
        const built = Object.values(bundle).map((file) => [file.fileName, file.type === "chunk" ? file.code : file.source] as const);
        const own = built.filter(([name]) => name !== "index.html").map(([name]) => name);
        const files = ["./", "icon.svg", MODULE, EXAMPLES, ...own].sort();
        const worker = readFileSync("src/standalone/sw.js", "utf8");
        const all = [...built.map(([, content]) => hashOf(content)).sort(), hashOf(icon), MODULE, EXAMPLES, hashOf(worker)];
        const head = `const VERSION = "${hashOf(all.join(" "))}";\nconst FILES = ${JSON.stringify(files)};\n`;
        this.emitFile({ type: "asset", fileName: "sw.js", source: head + worker });
      },
    },
  };
}

export default defineConfig({
  base: "./",
  define: { MODULE: JSON.stringify(MODULE), EXAMPLES: JSON.stringify(EXAMPLES) },
  plugins: [page()],
  build: {
    outDir: "dist-static",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    assetsDir: ".",
  },
  worker: { format: "es" },
});
