//! Polar and cylindrical interpolation: coordinates on a surface that turns with a rotary axis.

use chordal_command::{AxisMask, FeedMode, SurfaceRun};
use chordal_geometry::Plane;

/// How the plane of the program lies to the plane of the surface.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SurfacePlane {
    /// It is the same.
    Same,
    /// With its axes in the other order: G2 and G3, G41 and G42 change places.
    Swapped,
    /// Another one: nothing turns or is offset in it.
    Other,
}

/// A surface in force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfaceState {
    /// The surface, and how far its axis has turned.
    pub run: SurfaceRun,
    /// How the plane of the program lies to it.
    pub plane: SurfacePlane,
    /// The plane that is active again after it.
    pub plane_after: Plane,
    /// The feed that is active again after it.
    pub(crate) feed_after: Option<(FeedMode, Option<f64>)>,
    /// What was known before of program and machine coordinates.
    pub(crate) known: [AxisMask; 2],
}
