//! Starts and ends polar and cylindrical interpolation.

use chordal_command::{
    AxisMask, CommandKind, CompensationSide, FeedMode, RotarySurface, SurfaceRun, SurfaceShape,
};
use chordal_geometry::Plane;

use crate::kernel::Kernel;
use crate::surface::{SurfacePlane, SurfaceState};

/// A surface to start.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NewSurface {
    /// The surface.
    pub surface: RotarySurface,
    /// The plane of its two coordinates.
    pub own_plane: Plane,
    /// How the plane of the program relates to it.
    pub plane: SurfacePlane,
    /// F is per minute on it, even if it is per revolution before.
    pub own_feed: bool,
}

impl Kernel<'_> {
    /// The face of the rotating part, with the tool at its present position on the first coordinate axis.
    pub fn face(&self, rotary: usize, along: usize, across: usize) -> RotarySurface {
        self.face_from(self.state.position[rotary], [rotary, along, across])
    }

    /// The face of the rotating part whose first coordinate axis is under the tool where the rotary axis is at `zero`, rad;
    /// `axes` are the rotary axis, the linear axis that moves and the one across.
    pub fn face_from(&self, zero: f64, [rotary, along, across]: [usize; 3]) -> RotarySurface {
        let position = &self.state.position;
        let negative = position[along] < 0.0;
        let shape = SurfaceShape::Face { along, zero, turned: position[rotary] - zero, negative };
        RotarySurface { shape, rotary, across, across_position: position[across] }
    }

    /// From here on, coordinates lie on a surface; the machine does not move.
    pub fn begin_surface(&mut self, new: NewSurface) {
        let NewSurface { surface, own_plane, plane, own_feed } = new;
        let state = &mut self.state;
        let known = [state.known, state.machine_known];
        state.position = surface.on_surface(&state.position);
        let is_known = match surface.shape {
            // The angle at the start becomes the zero, so it need not be known.
            SurfaceShape::Face { along, .. } => state.known.has(along),
            SurfaceShape::Cylinder { .. } => state.known.has(surface.rotary),
        };
        let across = AxisMask(1 << surface.across);
        state.known = if is_known { state.known.or(across) } else { state.known.without(across) };
        let per_time = own_feed && state.feed_mode == FeedMode::PerRevolution;
        let feed_after = per_time.then_some((state.feed_mode, state.feed));
        let run = SurfaceRun::new(surface);
        let plane_after = state.plane;
        state.surface = Some(SurfaceState { run, plane, plane_after, feed_after, known });
        let position = state.position;
        self.emit(CommandKind::Surface { surface: Some(surface), position });
        self.plane_of_surface(own_plane);
        if per_time {
            self.set_feed_mode(FeedMode::PerTime);
        }
    }

    /// Ends the surface: coordinates are those of the axes again.
    pub fn end_surface(&mut self) {
        self.end_corner_before("interpolation on the surface ends before the next move");
        let Some(before) = self.state.surface.take() else { return };
        let surface = before.run.surface;
        let state = &mut self.state;
        let place = match surface.shape {
            SurfaceShape::Face { along, .. } => along,
            SurfaceShape::Cylinder { .. } => surface.across,
        };
        let [known, machine_known] = before.known;
        let across = AxisMask(1 << surface.across);
        let rotary = AxisMask(1 << surface.rotary);
        // On a cylinder, a programmed length gives the angle of the rotary axis; on a face, its start angle is needed.
        let is_placed = match surface.shape {
            SurfaceShape::Face { .. } => known.has(surface.rotary),
            SurfaceShape::Cylinder { .. } => state.known.has(place),
        };
        state.position = before.run.on_axes(&state.position);
        let restored = |now: AxisMask, then: AxisMask| now.without(across).or(then.and(across));
        state.known = restored(state.known, known);
        if is_placed {
            state.known = state.known.or(rotary);
        }
        let mut machine = restored(state.machine_known, machine_known);
        if is_placed && state.offsets.known().has(surface.rotary) {
            machine = machine.or(rotary);
        }
        state.machine_known = machine;
        let position = state.position;
        self.emit(CommandKind::Surface { surface: None, position });
        self.plane_of_surface(before.plane_after);
        if let Some((mode, feed)) = before.feed_after {
            self.set_feed_mode(mode);
            self.state.feed = feed;
        }
    }

    fn plane_of_surface(&mut self, plane: Plane) {
        if self.state.plane != plane {
            self.state.plane = plane;
            self.emit(CommandKind::Plane(plane));
        }
    }

    /// True when cutter compensation is on.
    pub fn is_compensating(&self) -> bool {
        self.state.side != CompensationSide::Off
    }
}
