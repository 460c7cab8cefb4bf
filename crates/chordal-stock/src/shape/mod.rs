//! Shapes of stock, fixtures and targets: boxes, cylinders, tubes and meshes.
//!
//! Two things are computed, each between two bounds: what a shape fills over each cell of a grid
//! ([`SolidShape::cells`]), and its distance from a body of revolution about a vertical axis
//! ([`SolidShape::distance`], [`SolidShape::distance_along`], [`SolidShape::passage`]).

mod body;
mod cells;
mod clip;
mod convex;
mod distance;
mod mesh_shape;
mod passage;
mod profile;
mod revolved;
mod round;
mod tree;
mod turning_passage;

use chordal_geometry::{Aabb, Vec3};

use crate::mesh::{Edges, MAX_COORDINATE_MM, Mesh};
use mesh_shape::MeshedShape;
use round::CylinderShape;

pub use body::{BodyBound, BodyError, Frustum, RoundBody};
pub use cells::{CellGrid, EDGE, HeightSpan, ShapeCells};
pub use convex::DistanceInterval;
pub use passage::{PassageAnswer, TipMotion};

/// The direction of one of the three axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeAxis {
    /// Along X.
    X,
    /// Along Y.
    Y,
    /// Along Z.
    Z,
}

/// Why a shape cannot be made or evaluated.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    /// A dimension is not above zero, not finite or too large.
    #[error("the {what} cannot be {value} mm")]
    Dimension {
        /// What it is.
        what: &'static str,
        /// Its value, mm.
        value: f64,
    },
    /// The mesh has no triangle.
    #[error("the mesh has no triangle")]
    NoTriangle,
    /// The mesh is open.
    #[error("the mesh is open at {} of {} edges, first from {} to {}",
        .edges.open, .edges.count, place(.edges, 0), place(.edges, 1))]
    Open {
        /// How its triangles meet.
        edges: Edges,
    },
    /// More triangles over the cells of a row than memory should hold.
    #[error("too many triangles over row {row} of the grid")]
    TooManyTriangles {
        /// The row, from zero.
        row: usize,
    },
    /// A grid with too many cells, or with invalid numbers.
    #[error("a grid of {columns} × {rows} cells of {cell} mm")]
    Grid {
        /// Cells along X.
        columns: usize,
        /// Cells along Y.
        rows: usize,
        /// Their side, mm.
        cell: f64,
    },
}

/// Words an end of the first open edge.
fn place(edges: &Edges, end: usize) -> String {
    edges.first_open.map_or_else(String::new, |ends| {
        let Vec3 { x, y, z } = ends[end];
        format!("X{x} Y{y} Z{z}")
    })
}

/// A solid body or, for a mesh that is not closed, a surface.
#[derive(Clone, Debug)]
pub struct SolidShape(ShapeKind);

#[derive(Clone, Debug)]
enum ShapeKind {
    Cuboid(Aabb),
    Round(CylinderShape),
    Meshed(Box<MeshedShape>),
}

fn finite(what: &'static str, value: f64) -> Result<f64, ShapeError> {
    let good = value.abs() <= MAX_COORDINATE_MM;
    if good { Ok(value) } else { Err(ShapeError::Dimension { what, value }) }
}

fn positive(what: &'static str, value: f64) -> Result<f64, ShapeError> {
    if value > 0.0 { finite(what, value) } else { Err(ShapeError::Dimension { what, value }) }
}

impl SolidShape {
    /// The box between two opposite corners, mm.
    ///
    /// # Errors
    /// When a side has no length.
    pub fn cuboid(a: Vec3, b: Vec3) -> Result<SolidShape, ShapeError> {
        for point in [a, b] {
            for value in point.to_array() {
                finite("corner", value)?;
            }
        }
        let around = Aabb::of_points(a, b);
        for (what, value) in ["length", "width", "height"].into_iter().zip(around.size().to_array())
        {
            positive(what, value)?;
        }
        Ok(SolidShape(ShapeKind::Cuboid(around)))
    }

    /// The cylinder about an axis through `middle`, between two coordinates along the axis, mm. The coordinate of
    /// `middle` along the axis is ignored.
    ///
    /// # Errors
    /// When the diameter or the length is not above zero.
    pub fn cylinder(
        axis: ShapeAxis,
        middle: Vec3,
        diameter: f64,
        from: f64,
        to: f64,
    ) -> Result<SolidShape, ShapeError> {
        SolidShape::round(axis, middle, [positive("diameter", diameter)?, 0.0], [from, to])
    }

    /// The tube with an outer diameter and a bore; the rest as in [`SolidShape::cylinder`].
    ///
    /// # Errors
    /// When a diameter or the length is not above zero, or the bore is no smaller than the diameter.
    pub fn tube(
        axis: ShapeAxis,
        middle: Vec3,
        [diameter, bore]: [f64; 2],
        from: f64,
        to: f64,
    ) -> Result<SolidShape, ShapeError> {
        positive("diameter", diameter)?;
        let bore = positive("bore", bore)?;
        if bore >= diameter {
            return Err(ShapeError::Dimension { what: "bore", value: bore });
        }
        SolidShape::round(axis, middle, [diameter, bore], [from, to])
    }

    fn round(
        axis: ShapeAxis,
        middle: Vec3,
        [diameter, bore]: [f64; 2],
        [from, to]: [f64; 2],
    ) -> Result<SolidShape, ShapeError> {
        for value in middle.to_array() {
            finite("middle", value)?;
        }
        let (from, to) = (finite("end", from)?.min(to), finite("end", to)?.max(from));
        positive("length", to - from)?;
        let (outer, inner) = (diameter / 2.0, bore / 2.0);
        Ok(SolidShape(ShapeKind::Round(CylinderShape { axis, middle, outer, inner, from, to })))
    }

    /// The body inside a closed mesh. Triangles that are clockwise from outside are turned.
    ///
    /// # Errors
    /// When the mesh is open or has no triangle.
    pub fn solid(mesh: Mesh) -> Result<SolidShape, ShapeError> {
        let edges = mesh.edges();
        if mesh.triangles().is_empty() {
            return Err(ShapeError::NoTriangle);
        }
        if !edges.are_closed() {
            return Err(ShapeError::Open { edges });
        }
        let mesh = if mesh.volume() < 0.0 { mesh.turned() } else { mesh };
        Ok(SolidShape(ShapeKind::Meshed(Box::new(MeshedShape::new(mesh, edges)))))
    }

    /// A closed mesh as a body, an open one as a surface without an inside: it has distances, but fills no cells.
    ///
    /// # Errors
    /// When the mesh has no triangle.
    pub fn surface(mesh: Mesh) -> Result<SolidShape, ShapeError> {
        let edges = mesh.edges();
        if edges.are_closed() {
            return SolidShape::solid(mesh);
        }
        if mesh.triangles().is_empty() {
            return Err(ShapeError::NoTriangle);
        }
        Ok(SolidShape(ShapeKind::Meshed(Box::new(MeshedShape::new(mesh, edges)))))
    }

    /// The box around the shape.
    pub fn bounds(&self) -> Aabb {
        match &self.0 {
            ShapeKind::Cuboid(around) => *around,
            ShapeKind::Round(round) => round.bounds(),
            ShapeKind::Meshed(meshed) => meshed.mesh.bounds(),
        }
    }

    /// The volume, mm³; zero for a surface that is not closed.
    pub fn volume(&self) -> f64 {
        match &self.0 {
            ShapeKind::Cuboid(around) => {
                let size = around.size();
                size.x * size.y * size.z
            }
            ShapeKind::Round(round) => {
                let square = round.outer * round.outer - round.inner * round.inner;
                std::f64::consts::PI * square * (round.to - round.from)
            }
            ShapeKind::Meshed(meshed) if meshed.edges.are_closed() => meshed.mesh.volume(),
            ShapeKind::Meshed(_) => 0.0,
        }
    }
}
