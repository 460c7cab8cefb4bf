//! Binary STL: 80 arbitrary bytes, the count, then for each triangle a normal and three corners (12 floats) and two
//! bytes.

use super::{StlError, TriangleSoup};

/// Bytes of the head with the count.
const HEAD: usize = 84;
/// Bytes of a triangle.
const RECORD: usize = 50;
/// Bytes of the normal before the corners.
const NORMAL: usize = 12;
/// Bytes of a corner: three floats.
const CORNER: usize = 12;

/// How many triangles the head declares; `None` where there are too few bytes for a head.
fn declared(bytes: &[u8]) -> Option<u32> {
    let count = bytes.get(HEAD - 4..HEAD)?;
    Some(u32::from_le_bytes(count.try_into().ok()?))
}

fn needed(count: u32) -> u64 {
    HEAD as u64 + RECORD as u64 * u64::from(count)
}

/// Whether the size agrees with the number of triangles that the head declares.
pub(super) fn has_size(bytes: &[u8]) -> bool {
    declared(bytes).is_some_and(|count| needed(count) == bytes.len() as u64)
}

pub(super) fn read(bytes: &[u8], soup: &mut TriangleSoup) -> Result<(), StlError> {
    let size = bytes.len();
    let declared = declared(bytes).ok_or(StlError::NoHead { size })?;
    if needed(declared) != size as u64 {
        return Err(StlError::Size { declared, needed: needed(declared), size });
    }
    let limit = soup.options.limit;
    if declared as usize > limit {
        return Err(StlError::TooMany { declared: Some(declared), limit });
    }
    for (number, record) in bytes[HEAD..].chunks_exact(RECORD).enumerate() {
        let corner = |which: usize| {
            let from = NORMAL + which * CORNER;
            let values = [0, 4, 8].map(|at| {
                let at = from + at;
                f64::from(f32::from_le_bytes([
                    record[at],
                    record[at + 1],
                    record[at + 2],
                    record[at + 3],
                ]))
            });
            (values, HEAD + number * RECORD + from)
        };
        soup.push([corner(0), corner(1), corner(2)])?;
    }
    Ok(())
}
