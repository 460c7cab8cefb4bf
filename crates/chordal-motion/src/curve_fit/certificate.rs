//! The certificate: how far the curve is from the chords, at most.
//!
//! Both are functions of one σ, so the distance at the same σ bounds the distance both ways. Between
//! knots and places of the chords it is a cubic whose second derivative is the curve's: with δ the
//! length of such a part, |e| ≤ max(|e₀|, |e₁|) + max|q''|·δ²/8.
//!
//! Where some pieces were moved, only the chords next to them are measured again.

use std::ops::Range;

use super::ToleranceMeasure;
use super::chords::ChordPath;
use super::spline::{CurvePull, FittedSpline};
use super::widths::SmoothingWidths;
use chordal_geometry::AXES;

use crate::AxisValues;
use crate::piece::{AxisJet, SIXTH};

/// Where it is too far, widths around fall to at least and at most these shares, by the root of the excess.
const WIDTH_FALL_SHARES: [f64; 2] = [0.6, 0.97];
/// A pull takes so much of the distance to this share of the tolerance: pulls reach over their neighbours.
const PULL_TARGET_SHARE: f64 = 0.95;
const PULL_DAMPING_SHARE: f64 = 0.8;

/// How far the curve is from each chord, and what a curve that is too far needs.
#[derive(Debug, Default)]
pub(super) struct ToleranceCertificate {
    /// The largest distance from each chord, in tolerances.
    offs: Vec<f64>,
    /// Where the curve is to be moved, and how; in the order of the chords.
    pub pulls: Vec<CurvePull>,
    /// The shares to which widths are to fall.
    falls: Vec<f64>,
    before: Vec<CurvePull>,
}

/// Where the next part begins, and how far the curve is from the chords there.
struct CheckCursor {
    piece: usize,
    from: f64,
    away: (f64, AxisValues),
}

impl ToleranceCertificate {
    /// Measures the whole curve: the largest distance, in tolerances.
    pub fn find(
        &mut self,
        chords: &ChordPath,
        spline: &FittedSpline,
        measure: &ToleranceMeasure,
    ) -> f64 {
        self.pulls.clear();
        self.offs.clear();
        self.offs.resize(chords.count(), 0.0);
        self.look(0..chords.count(), chords, spline, measure);
        self.most()
    }

    /// Measures the pieces that were moved last: the largest distance of the whole curve, then.
    pub fn find_moved(
        &mut self,
        chords: &ChordPath,
        spline: &FittedSpline,
        measure: &ToleranceMeasure,
    ) -> f64 {
        self.before.clear();
        std::mem::swap(&mut self.pulls, &mut self.before);
        let (mut known, mut checked_to) = (0, 0);
        for pieces in &spline.dirty {
            // The chords next to them, too: what is known of a joint is known from the piece before it.
            let [begin, end] = [spline.at[pieces.start], spline.at[pieces.end]];
            let first = chords.at.partition_point(|at| *at < begin).saturating_sub(2);
            let last = (chords.at.partition_point(|at| *at <= end) + 1).min(chords.count());
            let range = first.max(checked_to)..last;
            if range.is_empty() {
                continue;
            }
            let unmoved = self.before[known..].iter().take_while(|pull| pull.chord < range.start);
            let until = known + unmoved.count();
            self.pulls.extend_from_slice(&self.before[known..until]);
            let left = self.before[until..].iter().take_while(|pull| pull.chord < range.end);
            known = until + left.count();
            checked_to = range.end;
            self.look(range, chords, spline, measure);
        }
        self.pulls.extend_from_slice(&self.before[known..]);
        self.most()
    }

    fn most(&self) -> f64 {
        self.offs.iter().fold(0.0, |most, off| most.max(*off))
    }

    fn look(
        &mut self,
        range: Range<usize>,
        chords: &ChordPath,
        spline: &FittedSpline,
        measure: &ToleranceMeasure,
    ) {
        if chords.is_linear {
            self.look_at::<3>(range, chords, spline, measure);
        } else {
            self.look_at::<AXES>(range, chords, spline, measure);
        }
    }

    /// The same where no axes but the first ones move.
    fn look_at<const N: usize>(
        &mut self,
        range: Range<usize>,
        chords: &ChordPath,
        spline: &FittedSpline,
        measure: &ToleranceMeasure,
    ) {
        let CheckCursor { mut piece, mut from, away: mut before } =
            check_cursor(range.start, chords, spline, measure);
        for chord in range {
            let end = chords.at[chord + 1];
            let mut off = 0.0_f64;
            while from < end {
                let (begin, next) = (spline.at[piece], spline.at[piece + 1]);
                let until = next.min(end);
                let jet = &spline.jets[piece];
                let away = distance::<N>(chords, chord, until, jet, until - begin);
                let after = (measure.of(&away), away);
                let bend = |offset: f64| {
                    let mut bend = [0.0; N];
                    for axis in 0..N {
                        bend[axis] = jet[2][axis] + offset * jet[3][axis];
                    }
                    measure.of_first(&bend)
                };
                let bend = bend(from - begin).max(bend(until - begin));
                let part = until - from;
                let own = before.0.max(after.0) + bend * part * part / 8.0;
                off = off.max(own);
                if own > 1.0 {
                    let (farther, at) =
                        if before.0 > after.0 { (&before, from) } else { (&after, until) };
                    let back = -PULL_DAMPING_SHARE * (own - PULL_TARGET_SHARE) / farther.0;
                    let by = farther.1.map(|away| away * back);
                    let share = (at - begin) / (next - begin);
                    self.pulls.push(CurvePull { chord, piece, share, by });
                }
                (from, before) = (until, after);
                if until >= next && piece + 1 < spline.jets.len() {
                    piece += 1;
                } else if until >= next {
                    break;
                }
            }
            from = from.max(end);
            self.offs[chord] = off;
        }
    }

    /// The shares to which the widths at the places of the chords are to fall.
    pub fn falls(&mut self, chords: &ChordPath, widths: &SmoothingWidths) -> &[f64] {
        let falls = &mut self.falls;
        falls.clear();
        falls.resize(chords.count() + 1, 1.0);
        for (chord, off) in self.offs.iter().enumerate().filter(|(_, off)| **off > 1.0) {
            let (begin, end) = (chords.at[chord], chords.at[chord + 1]);
            let fall = (WIDTH_FALL_SHARES[1] / off.sqrt()).max(WIDTH_FALL_SHARES[0]);
            let wide = |at: usize| widths.boxes[at].max(widths.knots[at]);
            let reach = 1.5 * wide(chord).max(wide(chord + 1));
            let down = (0..=chord).rev().take_while(|k| chords.at[*k] >= begin - reach);
            down.for_each(|k| falls[k] = falls[k].min(fall));
            let up = (chord + 1..=chords.count()).take_while(|k| chords.at[*k] <= end + reach);
            up.for_each(|k| falls[k] = falls[k].min(fall));
        }
        falls
    }
}

/// Where the curve is when a chord begins, as it is known from the chord before.
fn check_cursor(
    chord: usize,
    chords: &ChordPath,
    spline: &FittedSpline,
    measure: &ToleranceMeasure,
) -> CheckCursor {
    let from = chords.at[chord];
    if chord == 0 {
        return CheckCursor { piece: 0, from, away: (0.0, [0.0; AXES]) };
    }
    let ends = &spline.at[1..];
    let last = spline.jets.len() - 1;
    let piece = ends.partition_point(|end| *end < from).min(last);
    let offset = from - spline.at[piece];
    let away = distance::<AXES>(chords, chord - 1, from, &spline.jets[piece], offset);
    let next = if ends[piece] <= from { (piece + 1).min(last) } else { piece };
    CheckCursor { piece: next, from, away: (measure.of(&away), away) }
}

/// How far the curve is from a chord, in the first axes.
#[inline(always)]
fn distance<const N: usize>(
    chords: &ChordPath,
    chord: usize,
    at: f64,
    [x, d1, d2, d3]: &AxisJet,
    offset: f64,
) -> AxisValues {
    let (begin, end) = (chords.at[chord], chords.at[chord + 1]);
    let share = (at - begin) / (end - begin);
    let (from, to) = (&chords.places[chord], &chords.places[chord + 1]);
    let mut away = [0.0; AXES];
    for axis in 0..N {
        let on_curve =
            x[axis] + offset * (d1[axis] + offset * (d2[axis] * 0.5 + offset * (d3[axis] * SIXTH)));
        away[axis] = on_curve - (from[axis] + share * (to[axis] - from[axis]));
    }
    away
}
