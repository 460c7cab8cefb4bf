//! Frames of coordinates: mirror, scaling, rotation, and the rotation of a work coordinate system.
//!
//! The words of a program are points of the innermost frame. `F = rotation · scaling · mirror`, the rightmost
//! first, maps them to the work coordinate system, in which commands are emitted and cutter compensation
//! works. Starting a frame moves nothing: only the program coordinates of the machine's position change. The
//! centre of a frame is mapped by the frames inside it that are active when it starts.

mod commands;
mod map;
pub mod plane_forms;
mod polar;

use chordal_command::{AxisMask, Position};
use chordal_geometry::Plane;
use chordal_machine::{AXES, PerAxis};

pub use map::{FrameMap, InPlane, sin_cos_degrees};
pub use polar::{PolarReading, PolarWords};

/// Scaling of each axis by its own factor.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AxisScaling {
    /// The point that does not move.
    pub center: Position,
    /// Factor of each axis; a negative one mirrors.
    pub factors: Position,
}

/// The factors of a scaling as programmed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ScaleFactors {
    /// One for all axes.
    Common(f64),
    /// Of X, Y and Z; an axis without one is not scaled.
    Each([Option<f64>; 3]),
    /// The program gives none.
    Omitted,
}

/// Rotation in a plane.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PlaneRotation {
    /// The plane.
    pub plane: Plane,
    /// The point that does not move, on the two axes of the plane, mm.
    pub center: [f64; 2],
    /// Positive from the first axis to the second.
    pub degrees: f64,
}

/// Which kinds of frames are active.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct FrameKinds {
    /// Axes are mirrored.
    pub mirror: bool,
    /// Axes are scaled.
    pub scaling: bool,
    /// Coordinates are rotated.
    pub rotation: bool,
    /// The work coordinate system is rotated.
    pub work: bool,
    /// End points are a radius and an angle.
    pub polar: bool,
    /// Two coordinates lie on a surface that turns with a rotary axis.
    pub surface: bool,
    /// Coordinates are those of the tip in a frame that is fixed to the part.
    pub part: bool,
}

impl FrameKinds {
    /// Any of them.
    pub fn any(self) -> bool {
        self != FrameKinds::default()
    }
}

/// The active frames.
#[derive(Clone, PartialEq, Debug)]
pub struct Frames {
    mirror: PerAxis<Option<f64>>,
    scaling: Option<AxisScaling>,
    rotation: Option<PlaneRotation>,
    /// Rotation of the work coordinate system about its own X0 Y0.
    work: Option<PlaneRotation>,
    map: FrameMap,
    inverse: FrameMap,
    plain: bool,
}

impl Default for Frames {
    fn default() -> Frames {
        Frames {
            mirror: [None; AXES],
            scaling: None,
            rotation: None,
            work: None,
            map: FrameMap::IDENTITY,
            inverse: FrameMap::IDENTITY,
            plain: true,
        }
    }
}

impl Frames {
    /// True when none changes coordinates.
    #[inline]
    pub fn is_plain(&self) -> bool {
        self.plain
    }

    /// True when the frames act inside presets and shifts; the rotation of a work coordinate system acts outside.
    pub fn are_inside_presets(&self) -> bool {
        !self.plain && self.work.is_none()
    }

    /// From program coordinates to the work coordinate system.
    pub fn map(&self) -> &FrameMap {
        &self.map
    }

    /// From the work coordinate system to program coordinates.
    pub fn inverse(&self) -> &FrameMap {
        &self.inverse
    }

    /// What they do to the circles of a plane.
    #[inline]
    pub fn in_plane(&self, plane: Plane) -> InPlane {
        match self.plain {
            true => InPlane::Similar { factor: 1.0, mirrored: false },
            false => self.map.in_plane(plane),
        }
    }

    /// The active rotation.
    pub fn rotation(&self) -> Option<&PlaneRotation> {
        self.rotation.as_ref()
    }

    /// The active scaling.
    pub fn scaling(&self) -> Option<&AxisScaling> {
        self.scaling.as_ref()
    }

    /// Which kinds are active; the state fills in those that it keeps itself.
    pub fn kinds(&self) -> FrameKinds {
        FrameKinds {
            mirror: self.mirrored() != AxisMask::NONE,
            scaling: self.scaling.is_some(),
            rotation: self.rotation.is_some(),
            work: self.work.is_some(),
            polar: false,
            surface: false,
            part: false,
        }
    }

    /// The angle by which the work coordinate system is rotated, degrees.
    pub fn work_rotation_deg(&self) -> f64 {
        self.work.map_or(0.0, |rotation| rotation.degrees)
    }

    /// The axes that are mirrored.
    pub fn mirrored(&self) -> AxisMask {
        AxisMask::with_values(&self.mirror)
    }

    /// The active frames in words, for messages.
    pub fn names(&self) -> String {
        let mut names = Vec::new();
        if self.mirrored() != AxisMask::NONE {
            names.push("mirror image");
        }
        if self.scaling.is_some() {
            names.push("scaling");
        }
        if self.rotation.is_some() {
            names.push("rotation");
        }
        names.join(" and ")
    }

    /// Mirrors an axis at a coordinate, mm; `None` ends its mirror image.
    pub fn set_mirror(&mut self, axis: usize, line: Option<f64>) {
        self.mirror[axis] = line;
        self.update();
    }

    /// Sets the scaling; its centre is mapped by the mirror image.
    pub fn set_scaling(&mut self, scaling: Option<AxisScaling>) {
        self.scaling = scaling.map(|scaling| AxisScaling {
            center: self.mirror_map().point(&scaling.center),
            ..scaling
        });
        self.update();
    }

    /// Sets the rotation; its centre is mapped by mirror image and scaling, and a mirror image reverses it.
    pub fn set_rotation(&mut self, rotation: Option<PlaneRotation>) {
        self.rotation = rotation.map(|rotation| {
            let (a, b, _) = rotation.plane.axes();
            let inside = self.inside_rotation();
            let mut place = [0.0; AXES];
            (place[a], place[b]) = (rotation.center[0], rotation.center[1]);
            let center = inside.point(&place);
            let mirrored = inside.in_plane(rotation.plane).is_mirrored();
            let degrees = if mirrored { -rotation.degrees } else { rotation.degrees };
            PlaneRotation { center: [center[a], center[b]], degrees, ..rotation }
        });
        self.update();
    }

    /// Moves the centre of the rotation in the work coordinate system.
    pub fn move_rotation(&mut self, by: &Position) {
        let Some(rotation) = &mut self.rotation else { return };
        let (a, b, _) = rotation.plane.axes();
        rotation.center[0] += by[a];
        rotation.center[1] += by[b];
        self.update();
    }

    /// The angle of the rotation as programmed: a mirror image reverses it. `None` without a rotation.
    pub fn programmed_degrees(&self) -> Option<f64> {
        let rotation = self.rotation?;
        let mirrored = self.inside_rotation().in_plane(rotation.plane).is_mirrored();
        Some(if mirrored { -rotation.degrees } else { rotation.degrees })
    }

    /// Rotates the work coordinate system about its own zero, which lies at `zero`.
    pub fn set_work_rotation(&mut self, degrees: f64, zero: [f64; 2]) {
        let turns = degrees != 0.0;
        self.work = turns.then_some(PlaneRotation { plane: Plane::Xy, center: zero, degrees });
        self.update();
    }

    /// Ends all frames except the rotation of the work coordinate system.
    pub fn clear(&mut self) {
        *self = Frames { work: self.work, ..Frames::default() };
        self.update();
    }

    fn mirror_map(&self) -> FrameMap {
        let line = self.mirror.map(|line| line.unwrap_or(0.0));
        let factors = self.mirror.map(|line| if line.is_some() { -1.0 } else { 1.0 });
        FrameMap::scaling(&line, &factors)
    }

    fn inside_rotation(&self) -> FrameMap {
        let mirror = self.mirror_map();
        match &self.scaling {
            Some(scaling) => mirror.then(&FrameMap::scaling(&scaling.center, &scaling.factors)),
            None => mirror,
        }
    }

    fn update(&mut self) {
        let mut map = self.inside_rotation();
        for rotation in [self.rotation, self.work].into_iter().flatten() {
            map = map.then(&FrameMap::rotation(rotation.plane, rotation.center, rotation.degrees));
        }
        self.plain = map == FrameMap::IDENTITY;
        (self.map, self.inverse) = (map, map.inverse());
    }
}
