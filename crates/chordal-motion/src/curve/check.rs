//! The certificate: how far the curve is from the chords, at most.
//!
//! Both are functions of one σ, so the distance at the same σ bounds the distance both ways. Between
//! knots and places of the chords it is a cubic whose second derivative is the curve's: with δ the
//! length of such a part, |e| ≤ max(|e₀|, |e₁|) + max|q''|·δ²/8.
//!
//! Where some pieces were moved, only the chords beside them are measured again.

use std::ops::Range;

use super::Measure;
use super::chords::Chords;
use super::fit::{Pull, Spline};
use super::width::Widths;
use chordal_geometry::AXES;

use crate::Axes;
use crate::piece::{Jet, SIXTH};

/// Where it is too far, widths around fall to at least and at most these shares, by the root of the excess.
const FALL: [f64; 2] = [0.6, 0.97];
/// A pull takes so much of the way to this share of the tolerance: pulls reach over their neighbours.
const AIM: f64 = 0.95;
const DAMPING: f64 = 0.8;

/// How far the curve is from each chord, and what a curve that is too far asks for.
#[derive(Debug, Default)]
pub(super) struct Certificate {
    /// The largest distance from each chord, in tolerances.
    offs: Vec<f64>,
    /// Where the curve is to be moved, and how; in the order of the chords.
    pub pulls: Vec<Pull>,
    /// The shares to which widths are to fall.
    falls: Vec<f64>,
    before: Vec<Pull>,
}

/// Where the next part begins, and how far the curve is from the chords there.
struct Standing {
    piece: usize,
    from: f64,
    away: (f64, Axes),
}

impl Certificate {
    /// Measures the whole curve: the largest distance, in tolerances.
    pub fn find(&mut self, chords: &Chords, spline: &Spline, measure: &Measure) -> f64 {
        self.pulls.clear();
        self.offs.clear();
        self.offs.resize(chords.count(), 0.0);
        self.look(0..chords.count(), chords, spline, measure);
        self.most()
    }

    /// Measures the pieces that were moved last: the largest distance of the whole curve, then.
    pub fn find_moved(&mut self, chords: &Chords, spline: &Spline, measure: &Measure) -> f64 {
        self.before.clear();
        std::mem::swap(&mut self.pulls, &mut self.before);
        let (mut known, mut looked) = (0, 0);
        for pieces in &spline.dirty {
            // The chords beside them, too: what is known of a joint is known from the piece before it.
            let [begin, end] = [spline.at[pieces.start], spline.at[pieces.end]];
            let first = chords.at.partition_point(|at| *at < begin).saturating_sub(2);
            let last = (chords.at.partition_point(|at| *at <= end) + 1).min(chords.count());
            let range = first.max(looked)..last;
            if range.is_empty() {
                continue;
            }
            let kept = self.before[known..].iter().take_while(|pull| pull.chord < range.start);
            let until = known + kept.count();
            self.pulls.extend_from_slice(&self.before[known..until]);
            let left = self.before[until..].iter().take_while(|pull| pull.chord < range.end);
            known = until + left.count();
            looked = range.end;
            self.look(range, chords, spline, measure);
        }
        self.pulls.extend_from_slice(&self.before[known..]);
        self.most()
    }

    fn most(&self) -> f64 {
        self.offs.iter().fold(0.0, |most, off| most.max(*off))
    }

    fn look(&mut self, range: Range<usize>, chords: &Chords, spline: &Spline, measure: &Measure) {
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
        chords: &Chords,
        spline: &Spline,
        measure: &Measure,
    ) {
        let Standing { mut piece, mut from, away: mut before } =
            standing(range.start, chords, spline, measure);
        for chord in range {
            let end = chords.at[chord + 1];
            let mut off = 0.0_f64;
            while from < end {
                let (begin, next) = (spline.at[piece], spline.at[piece + 1]);
                let until = next.min(end);
                let jet = &spline.jets[piece];
                let away = distance::<N>(chords, chord, until, jet, until - begin);
                let after = (measure.of(&away), away);
                let bend = |way: f64| {
                    let mut bend = [0.0; N];
                    for axis in 0..N {
                        bend[axis] = jet[2][axis] + way * jet[3][axis];
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
                    let back = -DAMPING * (own - AIM) / farther.0;
                    let by = farther.1.map(|away| away * back);
                    let share = (at - begin) / (next - begin);
                    self.pulls.push(Pull { chord, piece, share, by });
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
    pub fn falls(&mut self, chords: &Chords, widths: &Widths) -> &[f64] {
        let falls = &mut self.falls;
        falls.clear();
        falls.resize(chords.count() + 1, 1.0);
        for (chord, off) in self.offs.iter().enumerate().filter(|(_, off)| **off > 1.0) {
            let (begin, end) = (chords.at[chord], chords.at[chord + 1]);
            let fall = (FALL[1] / off.sqrt()).max(FALL[0]);
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

/// How the curve stands where a chord begins, as it is known from the chord before.
fn standing(chord: usize, chords: &Chords, spline: &Spline, measure: &Measure) -> Standing {
    let from = chords.at[chord];
    if chord == 0 {
        return Standing { piece: 0, from, away: (0.0, [0.0; AXES]) };
    }
    let ends = &spline.at[1..];
    let last = spline.jets.len() - 1;
    let piece = ends.partition_point(|end| *end < from).min(last);
    let way = from - spline.at[piece];
    let away = distance::<AXES>(chords, chord - 1, from, &spline.jets[piece], way);
    let next = if ends[piece] <= from { (piece + 1).min(last) } else { piece };
    Standing { piece: next, from, away: (measure.of(&away), away) }
}

/// How far the curve is from a chord, in the first axes.
#[inline(always)]
fn distance<const N: usize>(
    chords: &Chords,
    chord: usize,
    at: f64,
    [x, d1, d2, d3]: &Jet,
    way: f64,
) -> Axes {
    let (begin, end) = (chords.at[chord], chords.at[chord + 1]);
    let share = (at - begin) / (end - begin);
    let (from, to) = (&chords.places[chord], &chords.places[chord + 1]);
    let mut away = [0.0; AXES];
    for axis in 0..N {
        let on_curve =
            x[axis] + way * (d1[axis] + way * (d2[axis] * 0.5 + way * (d3[axis] * SIXTH)));
        away[axis] = on_curve - (from[axis] + share * (to[axis] - from[axis]));
    }
    away
}
