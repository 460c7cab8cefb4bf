//! STL: triangles without shared vertices, as binary or as text, without a unit.
//!
//! A file is binary when its size is that of the triangles it declares, whatever its first word: many
//! binary files begin with "solid". Normals are left unread: they follow from the corners, and files have
//! wrong ones.

mod binary;
mod text;

use chordal_geometry::Vec3;

use super::weld::VertexWelder;
use super::{Mesh, beyond};

pub use text::TextProblem;

/// The length of one unit of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthUnit {
    /// 1 mm.
    Millimetre,
    /// 10 mm.
    Centimetre,
    /// 1000 mm.
    Metre,
    /// 25.4 mm.
    Inch,
}

impl LengthUnit {
    /// The length in mm.
    pub const fn millimetres(self) -> f64 {
        match self {
            LengthUnit::Millimetre => 1.0,
            LengthUnit::Centimetre => 10.0,
            LengthUnit::Metre => 1000.0,
            LengthUnit::Inch => 25.4,
        }
    }
}

/// How to read STL.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StlOptions {
    /// The unit, which the file does not give.
    pub unit: LengthUnit,
    /// Corners up to this far apart become one vertex, mm; with zero only equal coordinates.
    pub weld: f64,
    /// The most triangles that are read.
    pub limit: usize,
}

/// The format of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StlForm {
    /// 50 bytes per triangle.
    Binary,
    /// Words and numbers.
    Text,
}

/// The result of reading STL.
#[derive(Clone, Debug, PartialEq)]
pub struct Stl {
    /// The triangles, mm.
    pub mesh: Mesh,
    /// The format of the file.
    pub form: StlForm,
    /// How many triangles were left out because two of their corners became one vertex.
    pub left_out: usize,
}

/// Why bytes are not a usable STL file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StlError {
    /// There are no bytes.
    #[error("the STL is empty")]
    Empty,
    /// Fewer bytes than the head of a binary file, and not a text that begins with `solid`.
    #[error(
        "{size} bytes are no STL: text begins with 'solid', the head of a binary one has 84 bytes"
    )]
    NoHead {
        /// How many bytes.
        size: usize,
    },
    /// The size of a binary file is not that of the triangles it declares.
    #[error(
        "the binary STL declares {declared} triangles, which are {needed} bytes; it has {size}"
    )]
    Size {
        /// How many triangles its head declares.
        declared: u32,
        /// Size of a file with that many triangles, bytes.
        needed: u64,
        /// Size of the file, bytes.
        size: usize,
    },
    /// More triangles than the caller allows.
    #[error("the STL has {} triangles; {limit} are the most that are read",
        .declared.map_or_else(|| format!("more than {limit}"), |count| count.to_string()))]
    TooMany {
        /// How many a binary file declares; `None` for text.
        declared: Option<u32>,
        /// The most that are allowed.
        limit: usize,
    },
    /// No triangle at all.
    #[error("the STL has no triangle")]
    NoTriangle,
    /// A coordinate that is NaN, infinite or larger than [`super::MAX_COORDINATE_MM`].
    #[error("triangle {triangle} has the coordinate {value} mm (at byte {offset})")]
    Coordinate {
        /// The triangle, from one.
        triangle: usize,
        /// The coordinate, mm.
        value: f64,
        /// Where its corner begins in the file.
        offset: usize,
    },
    /// Text that does not follow the format.
    #[error("line {line} of the STL (byte {offset}): {problem}")]
    Text {
        /// The line, from one.
        line: usize,
        /// The first byte of the word.
        offset: usize,
        /// What is wrong.
        problem: TextProblem,
    },
    /// A welding distance that is negative or not finite.
    #[error("corners cannot be welded at a distance of {value} mm")]
    Weld {
        /// The distance, mm.
        value: f64,
    },
}

/// Reads STL in either format.
///
/// # Errors When the bytes are not a valid STL file or have too many triangles: see [`StlError`].
pub fn read_stl(bytes: &[u8], options: &StlOptions) -> Result<Stl, StlError> {
    let weld = options.weld;
    if !(weld >= 0.0 && weld.is_finite()) {
        return Err(StlError::Weld { value: weld });
    }
    if bytes.is_empty() {
        return Err(StlError::Empty);
    }
    let mut soup = TriangleSoup::new(options);
    let form = if !binary::has_size(bytes) && text::looks_like(bytes) {
        text::read(bytes, &mut soup)?;
        StlForm::Text
    } else {
        binary::read(bytes, &mut soup)?;
        StlForm::Binary
    };
    soup.finish(form)
}

/// Collects triangles from a file.
struct TriangleSoup {
    options: StlOptions,
    welder: VertexWelder,
    triangles: Vec<[u32; 3]>,
    read: usize,
}

impl TriangleSoup {
    fn new(options: &StlOptions) -> TriangleSoup {
        let welder = VertexWelder::new(options.weld);
        TriangleSoup { options: *options, welder, triangles: Vec::new(), read: 0 }
    }

    /// Takes three corners in the unit of the file, each with its offset in the file.
    fn push(&mut self, corners: [([f64; 3], usize); 3]) -> Result<(), StlError> {
        let limit = self.options.limit.min(u32::MAX as usize / 3);
        if self.read >= limit {
            return Err(StlError::TooMany { declared: None, limit });
        }
        self.read += 1;
        let unit = self.options.unit.millimetres();
        let mut vertices = [0; 3];
        for (vertex, (corner, offset)) in vertices.iter_mut().zip(corners) {
            let point = Vec3::from_array(corner) * unit;
            if let Some(value) = beyond(point) {
                return Err(StlError::Coordinate { triangle: self.read, value, offset });
            }
            *vertex = self.welder.vertex(point);
        }
        let [a, b, c] = vertices;
        // The edges of such a triangle run to and fro between two vertices, so the surface stays closed without it.
        if a != b && b != c && c != a {
            self.triangles.push(vertices);
        }
        Ok(())
    }

    fn finish(self, form: StlForm) -> Result<Stl, StlError> {
        if self.read == 0 {
            return Err(StlError::NoTriangle);
        }
        let left_out = self.read - self.triangles.len();
        let mut mesh = Mesh { vertices: self.welder.into_vertices(), triangles: self.triangles };
        if left_out > 0 {
            mesh = without_unused(&mesh);
        }
        Ok(Stl { mesh, form, left_out })
    }
}

/// Removes vertices that no triangle uses: those of triangles that were left out may be anywhere.
fn without_unused(mesh: &Mesh) -> Mesh {
    let mut used = vec![false; mesh.vertices.len()];
    for vertex in mesh.triangles.iter().flatten() {
        used[*vertex as usize] = true;
    }
    let mut vertices = Vec::new();
    let numbers: Vec<u32> = mesh
        .vertices
        .iter()
        .zip(used)
        .map(|(&point, used)| {
            if used {
                vertices.push(point);
            }
            // The number of an unused vertex is never read.
            (vertices.len() as u32).saturating_sub(1)
        })
        .collect();
    let renumbered = |corners: &[u32; 3]| corners.map(|vertex| numbers[vertex as usize]);
    Mesh { vertices, triangles: mesh.triangles.iter().map(renumbered).collect() }
}
