//! Finds a rapid in a contour: between two arcs, at depth, tangent to both of them. Positioning moves do not look like
//! this; probably the program has a G0 instead of a G1.

use chordal_command::{ArcShape, Move, Origin};
use chordal_diagnostics::TextShift;
use chordal_geometry::{ParamCurve, Vec3};

use crate::segment::{curve_of, is_known, point};

/// Directions that differ by less are equal, rad (0.5°).
const EQUAL_DIRECTION_RAD: f64 = 0.008_73;

/// The state from one move to the next.
#[derive(Clone, Debug, Default)]
pub(crate) struct ContourRapid {
    /// The last move, if it was an arc.
    arc: Option<(Move, ArcShape)>,
    /// The last move, if it was a rapid tangent to an arc before it.
    rapid: Option<OpenRapid>,
}

/// A rapid that continues an arc without a corner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OpenRapid {
    pub from: Vec3,
    pub to: Vec3,
    pub origin: Origin,
}

impl ContourRapid {
    /// Follows an arc. Returns the rapid before it, if both ends of that rapid are tangent to arcs.
    #[inline]
    pub fn arc(&mut self, motion: &Move, shape: &ArcShape) -> Option<OpenRapid> {
        self.arc = Some((*motion, *shape));
        let rapid = self.rapid.take()?;
        let curve = curve_of(motion, Some(shape));
        let direction = rapid.to - rapid.from;
        let joined = curve.start() == rapid.to && is_same(direction, curve.tangent_at(0.0));
        joined.then_some(rapid)
    }

    /// Follows a rapid; `plane` is the height below which it is at depth, mm.
    #[inline]
    pub fn rapid(&mut self, motion: &Move, plane: f64, origin: Origin) {
        self.rapid = None;
        let Some((before, shape)) = self.arc.take() else { return };
        let (from, to) = (point(&motion.from), point(&motion.to));
        let level = from.z == to.z && to.z < plane;
        if origin.cycle || from == to || !level || !is_known(motion) {
            return;
        }
        let curve = curve_of(&before, Some(&shape));
        if curve.end() == from && is_same(to - from, curve.tangent_at(curve.length())) {
            self.rapid = Some(OpenRapid { from, to, origin });
        }
    }

    /// Follows any other motion.
    #[inline]
    pub fn other(&mut self) {
        (self.arc, self.rapid) = (None, None);
    }

    /// Moves the positions in the text after an edit of other text; `None` if one of them was in the edited text.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        if let Some(rapid) = &mut self.rapid {
            rapid.origin = rapid.origin.shifted(shift)?;
        }
        Some(())
    }
}

fn is_same(first: Vec3, second: Vec3) -> bool {
    let size = first.length() * second.length();
    first.dot(second) > 0.0 && first.cross(second).length() < size * EQUAL_DIRECTION_RAD
}
