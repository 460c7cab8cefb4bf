//! One smooth curve through many chords, within the tolerance.
//!
//! | pass | file |
//! |---|---|
//! | the run as a function of its length | `chords.rs` |
//! | how wide it may be smoothed at each place | `width.rs` |
//! | knots, control points, pieces | `fit.rs` |
//! | how far the curve is from the chords, with proof | `check.rs` |
//!
//! The path does not depend on the feed. It is smoothed no wider than the axes need at their limits:
//! a wider curve would be an inward parallel of the chords, and slower.

mod check;
mod chords;
mod fit;
mod width;

use crate::Axes;
use crate::cell::AxisArrays;
use crate::piece::Jet;
use crate::root::cbrt;
pub(crate) use chords::Chords;
use fit::Spline;
use width::Widths;

/// Rounds of narrower widths.
const ROUNDS: usize = 20;

/// How places are smoothed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kernel {
    /// By means with positive weights: never beyond the chords, quick at corners.
    Plain,
    /// With the bias of second order taken off: for tight tolerances and rounded coordinates.
    Sharp,
}

/// Tolerances, and what the axes can do.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measure {
    /// One by the tolerance of X, Y and Z, and of the rotary axes.
    linear: f64,
    rotary: f64,
    acceleration: Axes,
    /// The least of X, Y and Z.
    jerk: f64,
    /// No width is smaller, mm or rad.
    least: f64,
}

impl Measure {
    /// Tolerances in mm and rad, above zero, for σ in mm or, where rotary axes alone move, in rad.
    pub fn new(linear_mm: f64, rotary_rad: f64, turns_only: bool, limits: &AxisArrays) -> Measure {
        let jerk = limits.jerk[..3].iter().fold(f64::INFINITY, |least, jerk| least.min(*jerk));
        Measure {
            linear: 1.0 / linear_mm,
            rotary: 1.0 / rotary_rad,
            acceleration: limits.acceleration,
            jerk,
            least: if turns_only { rotary_rad } else { linear_mm },
        }
    }

    /// How many tolerances a difference of places is.
    #[inline]
    pub fn of(&self, places: &Axes) -> f64 {
        let [x, y, z, a, b, c] = *places;
        let linear = (x * x + y * y + z * z).sqrt() * self.linear;
        linear.max(a.abs().max(b.abs()).max(c.abs()) * self.rotary)
    }

    /// The largest speed around a bend, σ per s.
    fn fastest(&self, bend: &Axes) -> f64 {
        let mut speed = 1e9_f64;
        for (bend, acceleration) in bend.iter().zip(&self.acceleration) {
            if bend.abs() > 1e-12 {
                speed = speed.min((acceleration / bend.abs()).sqrt());
            }
        }
        let square: f64 = bend[..3].iter().map(|bend| bend * bend).sum();
        if square > 1e-24 {
            speed = speed.min(cbrt(self.jerk / square));
        }
        speed
    }
}

/// Makes curves, one after the other; keeps its memory.
#[derive(Debug, Default)]
pub(crate) struct Smoothing {
    widths: Widths,
    spline: Spline,
}

/// A smooth curve over some chords: at the same σ it is no farther from them than `deviation`.
#[derive(Debug)]
pub(crate) struct Smooth<'a> {
    /// σ where each piece begins, and where the last ends.
    pub at: &'a [f64],
    /// The axes and their derivatives where each piece begins.
    pub jets: &'a [Jet],
    /// The largest distance, in tolerances: at most one.
    pub deviation: f64,
}

impl Smoothing {
    /// The curve through some chords; `None` where none was found within the tolerance.
    pub fn smooth(&mut self, chords: &Chords, measure: &Measure) -> Option<Smooth<'_>> {
        if chords.count() == 0 {
            return None;
        }
        self.widths.find(chords, measure, Kernel::Plain);
        let mut kernel = Kernel::Plain;
        if self.widths.are_tight(chords) {
            kernel = Kernel::Sharp;
            self.widths.find(chords, measure, kernel);
        }
        for _ in 0..ROUNDS {
            self.widths.settle(chords, measure, kernel);
            self.spline.fit(chords, &self.widths, kernel);
            let deviation = check::certify(chords, &self.spline, measure, &mut self.widths);
            if deviation <= 1.0 {
                return Some(Smooth { at: &self.spline.at, jets: &self.spline.jets, deviation });
            }
        }
        None
    }
}
