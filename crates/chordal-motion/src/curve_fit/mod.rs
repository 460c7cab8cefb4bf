//! One smooth curve through many chords, within the tolerance.
//!
//! | pass | file |
//! |---|---|
//! | the run as a function of its length | `chords.rs` |
//! | how wide it may be smoothed at each place | `widths.rs` |
//! | knots, control points, pieces | `spline.rs` |
//! | how far the curve is from the chords, with proof | `certificate.rs` |
//!
//! A curve does not depend on the feed. It is smoothed no wider than the axes need at their limits:
//! a wider curve would be an inward parallel of the chords, and slower.

mod certificate;
mod chords;
mod spline;
mod widths;

use chordal_geometry::AXES;

use crate::AxisValues;
use crate::cube_root::cbrt;
use crate::path_limits::AxisArrays;
use crate::piece::AxisJet;
use certificate::ToleranceCertificate;
pub(crate) use chords::ChordPath;
use spline::FittedSpline;
use widths::SmoothingWidths;

/// Rounds in which the widths are made narrower, until the curve is within the tolerance.
const MAX_NARROWINGS: usize = 60;

/// A curve that is beyond the tolerance by no larger factor is pulled back, so many times, before the widths are made
/// narrower: narrower ones move all knots that follow, and there is another place that is too far. So every round pulls.
const MAX_PULLED_EXCESS: f64 = 4.0;
const MAX_PULLS: usize = 12;

/// On a long chord widths are looked for at this distance from its ends, too, in tolerances, and then at twice that each time:
/// in the middle of it the curve may be much wider than at its ends.
const WIDTH_SPACING_TOLERANCES: f64 = 16.0;

/// The differences of the path over a width, in tolerances, up to which it is allowed: the second one for the plain kernel,
/// the fourth one for the sharp kernel, alone and before the plain one. They are what each kernel is off the path by, with a
/// factor; a curve of the sharp kernel alone may be a little beyond, since it is pulled back.
const MAX_SECOND_DIFFERENCE: f64 = 3.0;
const MAX_FOURTH_DIFFERENCE: f64 = 16.0;
const DENOISE_FOURTH_DIFFERENCE: f64 = 8.0;
/// The share of the tolerance that the first of two smoothings, which takes the rounding off, may use.
const DENOISE_TOLERANCE_SHARE: f64 = 0.2;
/// The largest widths, as factors of the width that the axes need at their limits: of the plain kernel, of the sharp one, and
/// of the sharp one before the plain one. Wider curves would be inward parallels of the path, and slower.
const PLAIN_WIDTH_FACTOR: f64 = 1.5;
const SHARP_WIDTH_FACTOR: f64 = 1.5;
const DENOISE_WIDTH_FACTOR: f64 = 1.0;

/// How places are smoothed at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SmoothingKernel {
    /// By means with positive weights: never beyond the chords.
    Plain,
    /// With the bias of second order taken off.
    Sharp,
}

/// How places are smoothed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SmoothingKind {
    /// The inside of bends, as far as the tolerance allows: by the plain kernel. Coordinates are rounded, and its
    /// widths would be too small where that is much for the tolerance: so the rounding is taken off by the sharp
    /// kernel first.
    Inside,
    /// Along the chords, for tight tolerances: by the sharp kernel.
    Along,
}

impl SmoothingKind {
    /// All of them.
    pub const ALL: [SmoothingKind; 2] = [SmoothingKind::Inside, SmoothingKind::Along];
}

/// Tolerances, and what the axes can do.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ToleranceMeasure {
    /// One by the tolerance of X, Y and Z, and of the rotary axes.
    linear: f64,
    rotary: f64,
    /// The least of the axes whose lengths σ is of.
    jerk: f64,
    turns_only: bool,
    /// No width is smaller, mm or rad.
    least: f64,
}

impl ToleranceMeasure {
    /// Tolerances in mm and rad, above zero, for σ in mm or, where rotary axes alone move, in rad.
    pub fn new(
        linear_mm: f64,
        rotary_rad: f64,
        turns_only: bool,
        limits: &AxisArrays,
    ) -> ToleranceMeasure {
        let jerks = if turns_only { &limits.jerk[3..] } else { &limits.jerk[..3] };
        ToleranceMeasure {
            linear: 1.0 / linear_mm,
            rotary: 1.0 / rotary_rad,
            jerk: jerks.iter().fold(f64::INFINITY, |least, jerk| least.min(*jerk)),
            turns_only,
            least: if turns_only { rotary_rad } else { linear_mm },
        }
    }

    /// The same with another tolerance of X, Y and Z, mm.
    pub fn with_linear(&self, linear_mm: f64) -> ToleranceMeasure {
        let least = if self.turns_only { self.least } else { linear_mm };
        ToleranceMeasure { linear: 1.0 / linear_mm, least, ..*self }
    }

    /// Whether X, Y and Z have a part in it.
    pub fn has_linear(&self) -> bool {
        !self.turns_only
    }

    /// The tolerance of X, Y and Z, mm.
    pub fn linear_mm(&self) -> f64 {
        1.0 / self.linear
    }

    /// The same with a share of the tolerances.
    fn part(&self, share: f64) -> ToleranceMeasure {
        let [linear, rotary] = [self.linear, self.rotary].map(|one| one / share);
        ToleranceMeasure { linear, rotary, least: self.least * share, ..*self }
    }

    /// How far from the ends of a chord widths are looked for as well, mm or rad.
    pub fn width_point_spacing(&self) -> f64 {
        WIDTH_SPACING_TOLERANCES * self.least
    }

    /// How many tolerances a difference of places is.
    #[inline]
    pub fn of(&self, places: &AxisValues) -> f64 {
        let [x, y, z, a, b, c] = *places;
        let linear = (x * x + y * y + z * z).sqrt() * self.linear;
        linear.max(a.abs().max(b.abs()).max(c.abs()) * self.rotary)
    }

    /// The same of the first axes, the others being zero.
    #[inline(always)]
    fn of_first<const N: usize>(&self, places: &[f64; N]) -> f64 {
        let mut all = [0.0; AXES];
        all[..N].copy_from_slice(places);
        self.of(&all)
    }

    /// The largest speed around a bend by jerk, σ per s. Acceleration has no part in it: where it is the
    /// limit the curve is a little wider than it need be, but more of it never makes the curve another one.
    fn fastest(&self, bend: &AxisValues) -> f64 {
        let bends = if self.turns_only { &bend[3..] } else { &bend[..3] };
        let square: f64 = bends.iter().map(|bend| bend * bend).sum();
        if square > 1e-24 { cbrt(self.jerk / square).min(1e9) } else { 1e9 }
    }
}

/// Makes curves, one after the other; keeps its memory.
#[derive(Debug, Default)]
pub(crate) struct CurveSmoother {
    widths: SmoothingWidths,
    spline: FittedSpline,
    /// The chords without rounding.
    quiet: ChordPath,
    certificate: ToleranceCertificate,
}

/// A smooth curve over some chords: at the same σ it is no farther from them than the tolerance.
#[derive(Debug)]
pub(crate) struct SmoothCurve<'a> {
    /// σ where each piece begins, and where the last ends.
    pub at: &'a [f64],
    /// The axes and their derivatives where each piece begins.
    pub jets: &'a [AxisJet],
}

impl CurveSmoother {
    /// The curve through some chords; `None` where none was found within the tolerance.
    pub fn smooth(
        &mut self,
        chords: &ChordPath,
        measure: &ToleranceMeasure,
        kind: SmoothingKind,
    ) -> Option<SmoothCurve<'_>> {
        if chords.count() == 0 {
            return None;
        }
        let CurveSmoother { widths, spline, quiet, certificate } = self;
        let (through, kernel, (most, times)) = match kind {
            SmoothingKind::Along => {
                (chords, SmoothingKernel::Sharp, (MAX_FOURTH_DIFFERENCE, SHARP_WIDTH_FACTOR))
            }
            SmoothingKind::Inside => {
                let part = measure.part(DENOISE_TOLERANCE_SHARE);
                widths.find(chords, &part, SmoothingKernel::Sharp, DENOISE_FOURTH_DIFFERENCE);
                widths.settle(chords, &part, SmoothingKernel::Sharp, DENOISE_WIDTH_FACTOR);
                if !spline.fit(chords, widths, SmoothingKernel::Sharp) {
                    return None;
                }
                let mut piece = 0;
                quiet.displace(chords, |at| spline.place_at(at, &mut piece));
                (&*quiet, SmoothingKernel::Plain, (MAX_SECOND_DIFFERENCE, PLAIN_WIDTH_FACTOR))
            }
        };
        widths.find(through, measure, kernel, most);
        for _ in 0..MAX_NARROWINGS {
            widths.settle(through, measure, kernel, times);
            if !spline.fit(through, widths, kernel) {
                return None;
            }
            let mut off = certificate.find(chords, spline, measure);
            for pull in 0..=MAX_PULLS {
                if off <= 1.0 {
                    return Some(SmoothCurve { at: &spline.at, jets: &spline.jets });
                }
                if pull == MAX_PULLS || off > MAX_PULLED_EXCESS {
                    break;
                }
                spline.pull(&certificate.pulls);
                off = certificate.find_moved(chords, spline, measure);
            }
            widths.narrow(certificate.falls(chords, widths));
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use chordal_geometry::AXES;

    use super::*;
    use crate::limits::{AxisLimit, KinematicLimits};
    use crate::piece::ahead;

    fn measure(tolerance: f64) -> ToleranceMeasure {
        let limit = AxisLimit { velocity: 500.0, acceleration: 5000.0, jerk: 1e5 };
        let limits = KinematicLimits::new([Some(limit); AXES]).expect("positive limits");
        ToleranceMeasure::new(tolerance, 1e-4, false, &AxisArrays::new(&limits))
    }

    /// A wave with noise, with a sharp corner and chords of any length, by a simple generator.
    fn wave(seed: u64) -> ChordPath {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut chords = ChordPath::default();
        let mut at = [0.0; AXES];
        chords.begin(at);
        let mut angle = 0.0_f64;
        for index in 0..400 {
            let length = 10f64.powf(-2.5 + 3.0 * random() * random());
            angle += 0.2 * (random() - 0.5) + if index % 97 == 50 { 0.6 } else { 0.0 };
            at[0] += length * angle.cos() + 1e-3 * (random() - 0.5);
            at[1] += length * angle.sin() + 1e-3 * (random() - 0.5);
            at[3] += 1e-3 * length * random();
            let before = chords.places[chords.places.len() - 1];
            let chord_length = ((at[0] - before[0]).powi(2) + (at[1] - before[1]).powi(2)).sqrt();
            chords.push(at, chord_length, false);
        }
        chords
    }

    #[test]
    fn long_chords_next_to_one_of_a_nanometre_are_cut_into_few_pieces() {
        let mut chords = ChordPath::default();
        let mut at = [0.0; AXES];
        chords.begin(at);
        for length in [1e-6, 1e-6, 300.0, 300.0, 300.0, 1e-6, 300.0] {
            at[0] += length * 0.6;
            at[1] += length * 0.8 + 1e-9;
            chords.push(at, length, false);
        }
        let mut smoothing = CurveSmoother::default();
        for kind in SmoothingKind::ALL {
            for tolerance in [1e-6, 1e-4, 0.01] {
                let pieces = smoothing.smooth(&chords, &measure(tolerance), kind);
                assert!(pieces.is_none_or(|smooth| smooth.at.len() < 10_500));
            }
        }
    }

    #[test]
    fn the_certificate_bounds_every_distance_and_the_curve_has_no_steps() {
        // More: `CHORDAL_ROUNDS=1000000 cargo test --release -p chordal-motion --lib certificate`.
        let rounds = option_env!("CHORDAL_ROUNDS").and_then(|rounds| rounds.parse().ok());
        let rounds = rounds.unwrap_or(60);
        let mut smoothing = CurveSmoother::default();
        // A path with as many corners as these has no curve now and then, and is planned corner by corner.
        let mut without = 0;
        for seed in 1..rounds {
            let measure = measure([0.001, 0.01, 0.1][seed as usize % 3]);
            let chords = wave(seed);
            let kind = SmoothingKind::ALL[seed as usize / 3 % 2];
            let Some(smooth) = smoothing.smooth(&chords, &measure, kind) else {
                without += 1;
                continue;
            };
            let (at, jets) = (smooth.at.to_vec(), smooth.jets.to_vec());
            let certified =
                ToleranceCertificate::default().find(&chords, &smoothing.spline, &measure);
            assert!(certified <= 1.0);
            let mut hint = 0;
            let mut most = 0.0_f64;
            for (index, jet) in jets.iter().enumerate() {
                let length = at[index + 1] - at[index];
                for part in 0..=8 {
                    let offset = length * f64::from(part) / 8.0;
                    let on_chords = chords.place_at(at[index] + offset, &mut hint);
                    let on_curve = ahead(jet, offset, AXES)[0];
                    let off = std::array::from_fn(|axis| on_curve[axis] - on_chords[axis]);
                    most = most.max(measure.of(&off));
                }
                let Some(next) = jets.get(index + 1) else { continue };
                let end = ahead(jet, length, AXES);
                for order in 0..3 {
                    for axis in 0..AXES {
                        let size = jet[order][axis].abs().max(1.0)
                            + jet[3][axis].abs() * length.powi(3 - order as i32);
                        let step = (end[order][axis] - next[order][axis]).abs();
                        assert!(step <= 1e-9 * size, "seed {seed}, piece {index}: {step}");
                    }
                }
            }
            assert!(most <= certified * (1.0 + 1e-9), "seed {seed}: {most} above {certified}");
            let [first, last] = [jets[0], jets[jets.len() - 1]];
            let end = ahead(&last, at[at.len() - 1] - at[at.len() - 2], AXES);
            for axis in 0..AXES {
                let place = chords.places[chords.count()][axis];
                assert!((first[0][axis] - chords.places[0][axis]).abs() < 1e-9);
                assert!((end[0][axis] - place).abs() < 1e-9 * place.abs().max(1.0));
            }
        }
        println!("{without} of {rounds} without a curve");
        assert!(without * 500 <= rounds, "{without} of {rounds}");
    }
}
