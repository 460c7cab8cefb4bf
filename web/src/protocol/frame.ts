// Binary frames of the server: a JSON header, then columns, which are typed arrays over the same buffer.
// See crates/chordal-view/src/frame.rs.

export type FrameColumn = Float32Array | Float64Array | Uint32Array | Uint8Array;

export interface Frame {
  header: Record<string, unknown> & { type: string };
  columns: Record<string, FrameColumn>;
}

interface Place {
  type: "u8" | "u32" | "f32" | "f64";
  offset: number;
  count: number;
}

const ARRAYS = {
  u8: Uint8Array,
  u32: Uint32Array,
  f32: Float32Array,
  f64: Float64Array,
} as const;

export function readFrame(buffer: ArrayBuffer): Frame {
  const length = new DataView(buffer).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(buffer, 4, length));
  const { columns: places, ...header } = JSON.parse(text) as Frame["header"] & {
    columns: Record<string, Place>;
  };
  const columns: Record<string, FrameColumn> = {};
  for (const [name, { type, offset, count }] of Object.entries(places)) {
    columns[name] = new ARRAYS[type](buffer, 4 + length + offset, count);
  }
  return { header: header as Frame["header"], columns };
}

export function f32(frame: Frame, name: string): Float32Array {
  const column = frame.columns[name];
  if (!(column instanceof Float32Array)) throw new Error(`no column ${name} of f32`);
  return column;
}

export function u32(frame: Frame, name: string): Uint32Array {
  const column = frame.columns[name];
  if (!(column instanceof Uint32Array)) throw new Error(`no column ${name} of u32`);
  return column;
}

export function u8(frame: Frame, name: string): Uint8Array {
  const column = frame.columns[name];
  if (!(column instanceof Uint8Array)) throw new Error(`no column ${name} of u8`);
  return column;
}
