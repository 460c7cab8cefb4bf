//! glTF 2.0 as one binary file (GLB): a head, a JSON chunk, a binary chunk. Metres, Y up.

use std::fmt::Write as _;

use chordal_geometry::Vec3;

use super::{WriteError, count};
use crate::mesh::Mesh;

const MAGIC: u32 = 0x4654_6C67;
const VERSION: u32 = 2;
const JSON: u32 = 0x4E4F_534A;
const BINARY: u32 = 0x004E_4942;
/// Component types and buffer targets of glTF.
const UNSIGNED_BYTE: u32 = 5121;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;
/// Millimetres in the unit of the format.
const METRE: f64 = 1000.0;
/// Chunks are padded to multiples of this many bytes.
const STEP: usize = 4;

/// A mesh as GLB, with its name and, if given, a colour (red, green, blue, opacity) for each vertex.
///
/// Z of the mesh becomes Y, and Y becomes −Z. There are no normals, so viewers use flat shading.
///
/// # Errors
/// When colours are given for another number of vertices, or 32 bits cannot count the bytes.
pub fn write_glb(
    mesh: &Mesh,
    name: &str,
    colours: Option<&[[u8; 4]]>,
) -> Result<Vec<u8>, WriteError> {
    let vertices = mesh.vertices().len();
    if let Some(colours) = colours.filter(|colours| colours.len() != vertices) {
        return Err(WriteError::Colours { colours: colours.len(), vertices });
    }
    let mut numbers = Vec::new();
    let mut parts = BufferParts::default();
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for &vertex in mesh.vertices() {
        for (axis, value) in upright(vertex).into_iter().enumerate() {
            (low[axis], high[axis]) = (low[axis].min(value), high[axis].max(value));
            numbers.extend_from_slice(&value.to_le_bytes());
        }
    }
    if mesh.triangles().is_empty() {
        // Empty buffer views are not allowed, so the file has no mesh.
        return assemble(&format!("{{\"asset\":{}}}", asset()), &[]);
    }
    let box_of = format!(",\"min\":{},\"max\":{}", list(low), list(high));
    parts.add(&numbers, VERTICES, FLOAT, vertices, "VEC3", &box_of);
    for triangle in mesh.triangles() {
        for vertex in triangle {
            numbers.extend_from_slice(&vertex.to_le_bytes());
        }
    }
    parts.add(&numbers, INDICES, UNSIGNED_INT, mesh.triangles().len() * 3, "SCALAR", "");
    let mut attributes = String::from("\"POSITION\":0");
    if let Some(colours) = colours {
        numbers.extend(colours.iter().flatten());
        parts.add(&numbers, VERTICES, UNSIGNED_BYTE, vertices, "VEC4", ",\"normalized\":true");
        attributes.push_str(",\"COLOR_0\":2");
    }
    let name = quoted(name);
    let json = format!(
        "{{\"asset\":{},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\
         \"nodes\":[{{\"mesh\":0,\"name\":{name}}}],\
         \"meshes\":[{{\"name\":{name},\"primitives\":[{{\"attributes\":{{{attributes}}},\
         \"indices\":1,\"material\":0}}]}}],\
         \"materials\":[{{\"pbrMetallicRoughness\":{{\"metallicFactor\":0.2,\"roughnessFactor\":0.6}}}}],\
         \"accessors\":[{}],\"bufferViews\":[{}],\"buffers\":[{{\"byteLength\":{}}}]}}",
        asset(),
        parts.accessors,
        parts.views,
        numbers.len(),
    );
    assemble(&json, &numbers)
}

fn asset() -> &'static str {
    "{\"version\":\"2.0\",\"generator\":\"Chordal\"}"
}

/// A point in metres with Y up, as glTF requires.
fn upright(point: Vec3) -> [f32; 3] {
    // Adding zero turns −0.0 into 0.0.
    [point.x, point.z, -point.y].map(|value| (value / METRE) as f32 + 0.0)
}

/// A vector of JSON. Bounds must equal the vertices exactly, so they are written with all their digits.
fn list(values: [f32; 3]) -> String {
    let [x, y, z] = values.map(f64::from);
    format!("[{x},{y},{z}]")
}

/// A JSON string.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c < ' ' => {
                // Writing to a string never fails.
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// The buffer views and accessors of the binary chunk.
#[derive(Default)]
struct BufferParts {
    accessors: String,
    views: String,
    count: usize,
    end: usize,
}

impl BufferParts {
    /// Adds a part: the bytes from the end of the last part on.
    fn add(
        &mut self,
        numbers: &[u8],
        target: u32,
        kind: u32,
        count: usize,
        shape: &str,
        more: &str,
    ) {
        let comma = if self.count > 0 { "," } else { "" };
        let (view, from, length) = (self.count, self.end, numbers.len() - self.end);
        // Writing to a string never fails.
        let _ = write!(
            self.views,
            "{comma}{{\"buffer\":0,\"byteOffset\":{from},\"byteLength\":{length},\"target\":{target}}}"
        );
        let _ = write!(
            self.accessors,
            "{comma}{{\"bufferView\":{view},\"componentType\":{kind},\"count\":{count},\"type\":\"{shape}\"{more}}}"
        );
        (self.count, self.end) = (view + 1, numbers.len());
    }
}

fn assemble(json: &str, numbers: &[u8]) -> Result<Vec<u8>, WriteError> {
    let json_size = json.len().next_multiple_of(STEP);
    let numbers_size = numbers.len().next_multiple_of(STEP);
    let chunk = |size: usize| if size > 0 { 8 + size } else { 0 };
    let size = count("bytes", 12 + chunk(json_size) + chunk(numbers_size))?;
    let mut bytes = Vec::with_capacity(size as usize);
    for word in [MAGIC, VERSION, size] {
        bytes.extend_from_slice(&word.to_le_bytes());
    }
    for (kind, content, size, fill) in
        [(JSON, json.as_bytes(), json_size, b' '), (BINARY, numbers, numbers_size, 0)]
    {
        if size > 0 {
            // The size fits 32 bits, since that of the whole file does.
            bytes.extend_from_slice(&(size as u32).to_le_bytes());
            bytes.extend_from_slice(&kind.to_le_bytes());
            bytes.extend_from_slice(content);
            bytes.resize(bytes.len() + size - content.len(), fill);
        }
    }
    Ok(bytes)
}
