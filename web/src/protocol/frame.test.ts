import { expect, it } from "vitest";
import { f32, readFrame, u8 } from "./frame";

function frame(header: object, data: Uint8Array): ArrayBuffer {
  let text = JSON.stringify(header);
  while ((text.length + 4) % 8 !== 0) text += " ";
  const bytes = new Uint8Array(4 + text.length + data.length);
  new DataView(bytes.buffer).setUint32(0, text.length, true);
  bytes.set(new TextEncoder().encode(text), 4);
  bytes.set(data, 4 + text.length);
  return bytes.buffer;
}

it("looks at columns where they lie", () => {
  const data = new Uint8Array(16);
  data[0] = 7;
  new DataView(data.buffer).setFloat32(8, 1.5, true);
  const columns = {
    kind: { type: "u8", offset: 0, count: 1 },
    x: { type: "f32", offset: 8, count: 1 },
  };
  const read = readFrame(frame({ type: "path", run: 4, columns }, data));
  expect(read.header).toEqual({ type: "path", run: 4 });
  expect(u8(read, "kind")[0]).toBe(7);
  expect(f32(read, "x")[0]).toBe(1.5);
  expect(() => f32(read, "kind")).toThrow();
});
