//! Binary STL.

use chordal_geometry::Vec3;

use super::{WriteError, count};
use crate::mesh::{LengthUnit, Mesh};

/// Bytes of the text in the head. It names the unit for people; no program reads it. It must not begin with "solid".
const HEAD: usize = 80;

/// A mesh as binary STL in a unit. Coordinates are rounded to 32-bit floats; corners of one vertex stay equal.
///
/// # Errors When the number of triangles does not fit 32 bits.
pub fn write_stl(mesh: &Mesh, unit: LengthUnit) -> Result<Vec<u8>, WriteError> {
    let triangles = count("triangles", mesh.triangles().len())?;
    let mut bytes = Vec::with_capacity(HEAD + 4 + 50 * mesh.triangles().len());
    let name = match unit {
        LengthUnit::Millimetre => "millimetres",
        LengthUnit::Centimetre => "centimetres",
        LengthUnit::Metre => "metres",
        LengthUnit::Inch => "inches",
    };
    bytes.extend_from_slice(format!("{:HEAD$}", format!("binary STL in {name}")).as_bytes());
    bytes.extend_from_slice(&triangles.to_le_bytes());
    for triangle in 0..mesh.triangles().len() {
        let [a, b, c] = mesh.corners(triangle);
        // The normal of a triangle without area is zero: readers then compute it from the corners.
        let normal = (b - a).cross(c - a).normalized().unwrap_or(Vec3::ZERO);
        put(&mut bytes, normal);
        for corner in [a, b, c] {
            put(&mut bytes, corner / unit.millimetres());
        }
        bytes.extend_from_slice(&[0, 0]);
    }
    Ok(bytes)
}

fn put(bytes: &mut Vec<u8>, point: Vec3) {
    for value in point.to_array() {
        bytes.extend_from_slice(&(value as f32).to_le_bytes());
    }
}
