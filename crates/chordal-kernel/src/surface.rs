//! Polar and cylindrical interpolation: coordinates on a surface that turns with a rotary axis.

use chordal_command::{AxisMask, FeedMode, SurfaceRun};
use chordal_geometry::Plane;

/// How the plane of the program relates to the plane of the surface.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SurfacePlane {
    /// It is the same.
    Same,
    /// The same with its axes in the other order: G2 and G3, G41 and G42 are exchanged.
    Swapped,
    /// Another one: no arcs and no compensation are possible.
    Other,
}

/// An active surface.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfaceState {
    /// The surface, and the present angle of its rotary axis.
    pub run: SurfaceRun,
    /// How the plane of the program relates to it.
    pub plane: SurfacePlane,
    /// The plane to restore at its end.
    pub plane_after: Plane,
    /// The feed to restore at its end; `None` when it stays.
    pub(crate) feed_after: Option<(FeedMode, Option<f64>)>,
    /// The axes whose program and machine coordinates were known before.
    pub(crate) known: [AxisMask; 2],
}
