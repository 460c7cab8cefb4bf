import { defineConfig } from "vitest/config";

// The page goes into the binary: names without hashes, and nothing that depends on where or when
// it is built, so that the same sources give the same bytes.
export default defineConfig({
  base: "./",
  build: {
    outDir: "../crates/chordal-server/page",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    rollupOptions: {
      output: {
        entryFileNames: "app.js",
        assetFileNames: "app[extname]",
      },
    },
  },
  test: { include: ["src/**/*.test.ts"] },
});
