import { expect, test } from "vitest";
import { fragmentOf, programInFragment } from "./share-link";

const shared = { name: "Ø.nc", text: "G0 X1\n(ä → 😀)\n", machine: "mill.toml", files: [["mill.toml", 'inherits = "haas-vf2"\n']] as [string, string][] };

test("a program comes out of its link as it went in", async () => {
  const fragment = await fragmentOf(shared);
  expect(fragment).toMatch(/^#p=[\w-]+$/);
  expect(await programInFragment(fragment)).toEqual(shared);
  expect(await programInFragment("")).toBe(undefined);
  expect(await programInFragment("#elsewhere")).toBe(undefined);
});

test("a damaged link is told, whatever is in it", async () => {
  const fragment = await fragmentOf(shared);
  const packed = async (object: unknown) => {
    const bytes = new Blob([JSON.stringify(object)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    return `#p=${btoa(String.fromCharCode(...new Uint8Array(await new Response(bytes).arrayBuffer())))}`;
  };
  const wrong = [
    "#p=", "#p=%%%", `${fragment.slice(0, 20)}`, await packed({}), await packed([1, 2, 3, 4]),
    await packed(["a", "b", null, [["x"]]]), await packed(["a", "b", 7, []]),
    // Small as a link, large as a text.
    await packed(["a", "0".repeat(30_000_000), null, []]),
  ];
  for (const each of wrong) await expect(programInFragment(each)).rejects.toThrow("damaged");
});
