// Binary frames of the server: a JSON header, then columns, which are typed arrays over the same buffer.
// See crates/chordal-view/src/frame.rs.

export type FrameColumn = Float32Array | Float64Array | Uint32Array | Uint8Array;

export interface Frame {
  header: Record<string, unknown> & { type: string };
  columns: Record<string, FrameColumn>;
}

interface ColumnLocation {
  type: "u8" | "u32" | "f32" | "f64";
  /** Bytes after the header. */
  offset: number;
  /** Number of elements. */
  count: number;
}

const ARRAY_TYPES = {
  u8: Uint8Array,
  u32: Uint32Array,
  f32: Float32Array,
  f64: Float64Array,
} as const;

/** Reads a frame: the length of the header (u32, little-endian), the header, the columns. */
export function readFrame(buffer: ArrayBuffer): Frame {
  const headerLength = new DataView(buffer).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(buffer, 4, headerLength));
  const { columns: locations, ...header } = JSON.parse(text) as Frame["header"] & {
    columns: Record<string, ColumnLocation>;
  };
  const columns: Record<string, FrameColumn> = {};
  for (const [name, { type, offset, count }] of Object.entries(locations)) {
    columns[name] = new ARRAY_TYPES[type](buffer, 4 + headerLength + offset, count);
  }
  return { header: header as Frame["header"], columns };
}

/** A column of a frame; an error where there is none of that type. */
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
