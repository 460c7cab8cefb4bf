//! Triangle meshes: read from STL, checked, measured, made from heights, written.
//!
//! A mesh is plain data: vertices that triangles share; each triangle is counter-clockwise seen from outside.

mod edges;
mod smooth;
mod steps;
mod stl;
mod weld;
pub mod write;

use chordal_geometry::{Aabb, Vec3};

pub use edges::Edges;
pub use smooth::SmoothError;
pub use steps::{HeightField, HeightFieldError, HeightMesh, LayerField, SolidIntervals};
pub use stl::{LengthUnit, Stl, StlError, StlForm, StlOptions, TextProblem, read_stl};

/// The largest coordinate of a vertex, mm: a hundred metres. Up to this size the rounding of coordinates stays far
/// below a nanometre, on which the bounds of shapes rely.
pub const MAX_COORDINATE_MM: f64 = 1e5;

/// Why vertices and triangles do not form a mesh.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names vertex {vertex}; there are {count}")]
    NoVertex {
        /// The triangle, from zero.
        triangle: usize,
        /// The vertex that it names.
        vertex: u32,
        /// How many there are.
        count: usize,
    },
    /// A coordinate is NaN, infinite or beyond [`MAX_COORDINATE_MM`].
    #[error("vertex {vertex} has the coordinate {value} mm; the largest is {MAX_COORDINATE_MM}")]
    Coordinate {
        /// The vertex, from zero.
        vertex: usize,
        /// The coordinate, mm.
        value: f64,
    },
    /// More vertices or triangles than 32 bits can number.
    #[error("{count} vertices or triangles are more than 32 bits can number")]
    TooMany {
        /// How many.
        count: usize,
    },
}

/// The first coordinate that is out of range or NaN; `None` where all are valid.
fn beyond(point: Vec3) -> Option<f64> {
    let within = |value: f64| value.abs() <= MAX_COORDINATE_MM;
    point.to_array().into_iter().find(|&value| !within(value))
}

/// Triangles that share vertices, mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The mesh of vertices (mm) and triangles of three vertex numbers, counter-clockwise from outside.
    ///
    /// # Errors When a triangle names a vertex that does not exist, or a coordinate is not finite or too large.
    pub fn new(vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Mesh, MeshError> {
        let count = vertices.len().max(triangles.len());
        if u32::try_from(count).is_err() {
            return Err(MeshError::TooMany { count });
        }
        for (vertex, point) in vertices.iter().enumerate() {
            if let Some(value) = beyond(*point) {
                return Err(MeshError::Coordinate { vertex, value });
            }
        }
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices.len()) {
                return Err(MeshError::NoVertex { triangle, vertex, count: vertices.len() });
            }
        }
        Ok(Mesh { vertices, triangles })
    }

    /// The vertices, mm.
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }

    /// The triangles: three numbers of vertices each.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The corners of the triangle with this number, mm.
    ///
    /// # Panics
    /// When there is no such triangle.
    pub fn corners(&self, triangle: usize) -> [Vec3; 3] {
        self.triangles[triangle].map(|vertex| self.vertices[vertex as usize])
    }

    /// The box around the vertices.
    pub fn bounds(&self) -> Aabb {
        self.vertices.iter().fold(Aabb::EMPTY, |around, point| around.include(*point))
    }

    /// The enclosed volume, mm³; negative where the triangles are clockwise from outside. Meaningless where the mesh
    /// is open.
    pub fn volume(&self) -> f64 {
        let bounds = self.bounds();
        if bounds.is_empty() {
            return 0.0;
        }
        // Relative to the middle of the box, so that a small body far from zero loses no digits.
        let middle = bounds.center();
        let six: f64 = (0..self.triangles.len())
            .map(|triangle| {
                let [a, b, c] = self.corners(triangle).map(|corner| corner - middle);
                a.dot(b.cross(c))
            })
            .sum();
        six / 6.0
    }

    /// How the triangles meet, and where the surface is open.
    pub fn edges(&self) -> Edges {
        Edges::of(self)
    }

    /// The surface moved by a vector, mm.
    #[must_use]
    pub fn moved(mut self, by: Vec3) -> Mesh {
        self.vertices.iter_mut().for_each(|vertex| *vertex += by);
        self
    }

    /// The surface after half a turn about an axis through the origin: 0 is X, 1 is Y, 2 is Z.
    #[must_use]
    pub fn turned_over(mut self, axis: usize) -> Mesh {
        let sign = |own: usize| if own == axis { 1.0 } else { -1.0 };
        for vertex in &mut self.vertices {
            *vertex = Vec3::new(vertex.x * sign(0), vertex.y * sign(1), vertex.z * sign(2));
        }
        self
    }

    /// The surface with inside and outside exchanged.
    #[must_use]
    pub fn turned(mut self) -> Mesh {
        for triangle in &mut self.triangles {
            triangle.swap(1, 2);
        }
        self
    }
}
