//! Cutters with edges above their widest point: T-slot cutters, lollipops, thread mill discs.

use libm::tan;

use super::shapes::{at_most, positive};
use super::{CutterError, CutterProfile, Ring, RingElement};

/// A cutter that is wider below than above. It removes from a column what is between its lower and its upper side.
///
/// The neck above the edges never cuts: it is treated as a part of the shank.
#[derive(Clone, Debug, PartialEq)]
pub struct Undercut {
    lower: CutterProfile,
    /// The upper side, mirrored.
    upper: CutterProfile,
    /// The height of the upper end of the edges above the tip, mm.
    height: f64,
    neck: f64,
}

impl Undercut {
    /// A cutter from both its sides: `lower` from the tip upwards, `upper` likewise from the upper end of the edges
    /// downwards, which is at `height` above the tip; `neck` is a diameter; mm.
    ///
    /// # Errors
    /// When the sides differ in radius, cross each other, or the neck is wider than they are.
    pub fn of(
        lower: CutterProfile,
        upper: CutterProfile,
        height: f64,
        neck: f64,
    ) -> Result<Undercut, CutterError> {
        positive("height of the edges", height)?;
        let diameter = 2.0 * lower.radius();
        at_most("neck diameter", positive("neck diameter", neck)?, diameter)?;
        if upper.radius() != lower.radius() {
            let (what, value, most) = ("upper side's radius", upper.radius(), lower.radius());
            return Err(CutterError::TooLarge { what, value, most });
        }
        // Both sides only rise outwards, so they are nearest to each other at the rim.
        at_most(
            "rise of both sides",
            lower.side() + upper.side(),
            height + HEIGHT_ROUNDING_MM * height,
        )?;
        Ok(Undercut { lower, upper, height, neck })
    }

    /// A disc with a neck: diameter, thickness and diameter of the neck, mm.
    ///
    /// # Errors
    /// When a dimension is not above zero, or the neck is wider than the disc.
    pub fn t_slot(diameter: f64, thickness: f64, neck: f64) -> Result<Undercut, CutterError> {
        let side = CutterProfile::flat(diameter)?;
        Undercut::of(side.clone(), side, positive("thickness", thickness)?, neck)
    }

    /// A ball on a neck: both diameters, mm.
    ///
    /// # Errors
    /// When a dimension is not above zero, or the neck is wider than the ball.
    pub fn lollipop(diameter: f64, neck: f64) -> Result<Undercut, CutterError> {
        let side = CutterProfile::ball(diameter)?;
        Undercut::of(side.clone(), side, diameter, neck)
    }

    /// One tooth of a thread cutter: the diameter over its crest, the width of the crest, the angle between a flank
    /// and the plane normal to the axis (rad; half the angle of the thread, zero for a plain disc) and the diameter
    /// of the neck, mm. The tip is the lowest point of the tooth, where it meets the neck.
    ///
    /// # Errors When a length is not above zero, the angle is negative or above 1.5 rad, or the neck is wider than
    /// the crest.
    pub fn thread_disc(
        diameter: f64,
        crest: f64,
        flank: f64,
        neck: f64,
    ) -> Result<Undercut, CutterError> {
        let to = positive("diameter", diameter)? / 2.0;
        let crest = positive("width of the crest", crest)?;
        let from = at_most("neck diameter", positive("neck diameter", neck)?, diameter)? / 2.0;
        if flank.is_nan() || flank < 0.0 {
            return Err(CutterError::NotPositive { what: "flank angle", value: flank });
        }
        const STEEPEST: f64 = 1.5;
        at_most("flank angle", flank, STEEPEST)?;
        let slope = tan(flank);
        if slope == 0.0 || from >= to {
            return Undercut::t_slot(diameter, crest, neck);
        }
        let side = CutterProfile::of(vec![
            Ring { from: 0.0, to: from, element: RingElement::Disc { height: 0.0 } },
            Ring { from, to, element: RingElement::Cone { height: 0.0, slope } },
        ]);
        let height = crest + 2.0 * side.side();
        Undercut::of(side.clone(), side, height, neck)
    }

    /// The lower side.
    pub const fn lower(&self) -> &CutterProfile {
        &self.lower
    }

    /// The upper side, mirrored: at the distance r it is at `height() − upper().height_at(r)` above the tip.
    pub const fn upper(&self) -> &CutterProfile {
        &self.upper
    }

    /// From the tip to the highest place of the edges, mm.
    pub const fn height(&self) -> f64 {
        self.height
    }

    /// The diameter of the neck, mm.
    pub const fn neck(&self) -> f64 {
        self.neck
    }

    /// The largest radius, mm.
    pub fn radius(&self) -> f64 {
        self.lower.radius()
    }
}

/// Relative tolerance for the sum of the sides' heights, for rounding.
const HEIGHT_ROUNDING_MM: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_of_the_usual_shapes() {
        let slot = Undercut::t_slot(20.0, 4.0, 8.0).unwrap();
        assert_eq!((slot.height(), slot.radius(), slot.neck()), (4.0, 10.0, 8.0));
        let ball = Undercut::lollipop(6.0, 3.0).unwrap();
        let top = ball.height() - ball.upper().height_at(2.0);
        assert!((top - (3.0 + 5.0_f64.sqrt())).abs() < 1e-12);
        let thread = Undercut::thread_disc(20.0, 0.2, 30.0_f64.to_radians(), 10.0).unwrap();
        let side = 5.0 * 30.0_f64.to_radians().tan();
        assert!((thread.height() - (0.2 + 2.0 * side)).abs() < 1e-12);
        assert_eq!(thread.lower().height_at(4.0), 0.0);
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        assert!(Undercut::t_slot(20.0, 4.0, 21.0).is_err());
        assert!(Undercut::t_slot(20.0, f64::NAN, 8.0).is_err());
        assert!(Undercut::thread_disc(20.0, 1.0, -0.1, 8.0).is_err());
        assert!(Undercut::thread_disc(20.0, 1.0, 1.57, 8.0).is_err());
        let (wide, narrow) = (CutterProfile::flat(8.0).unwrap(), CutterProfile::flat(6.0).unwrap());
        assert!(Undercut::of(wide.clone(), narrow, 2.0, 4.0).is_err());
        let ball = CutterProfile::ball(8.0).unwrap();
        assert!(Undercut::of(ball, wide, 3.0, 4.0).is_err());
    }
}
