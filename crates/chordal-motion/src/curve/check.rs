//! The certificate: how far the curve is from the chords, at most.
//!
//! Both are functions of one σ, so the distance at the same σ bounds the distance both ways. Between
//! knots and places of the chords it is a cubic whose second derivative is the curve's: with δ the
//! length of such a part, |e| ≤ max(|e₀|, |e₁|) + max|q''|·δ²/8.

use super::Measure;
use super::chords::Chords;
use super::fit::{Pull, Spline};
use super::width::Widths;
use chordal_geometry::AXES;

use crate::Axes;
use crate::piece::{SIXTH, ahead};

/// Where it is too far, widths around fall to at least and at most these shares, by the root of the excess.
const FALL: [f64; 2] = [0.6, 0.97];
/// A pull takes so much of the way to this share of the tolerance: pulls reach over their neighbours.
const AIM: f64 = 0.95;
const DAMPING: f64 = 0.8;

/// What a curve that is too far asks for.
#[derive(Debug, Default)]
pub(super) struct Wishes {
    /// Where the curve is to be moved, and how.
    pub pulls: Vec<Pull>,
    /// The shares to which widths are to fall.
    pub falls: Vec<f64>,
}

/// The largest distance in tolerances, and what is wished where it is above one.
pub(super) fn certify(
    chords: &Chords,
    spline: &Spline,
    measure: &Measure,
    widths: &Widths,
    wishes: &mut Wishes,
) -> f64 {
    let mut most = 0.0_f64;
    let Wishes { pulls, falls } = wishes;
    pulls.clear();
    falls.clear();
    falls.resize(chords.count() + 1, 1.0);
    let (mut piece, mut from, mut before) = (0, 0.0_f64, (0.0_f64, [0.0; AXES]));
    for chord in 0..chords.count() {
        let (begin, end) = (chords.at[chord], chords.at[chord + 1]);
        let mut off = 0.0_f64;
        while from < end {
            let until = spline.at[piece + 1].min(end);
            let jet = &spline.jets[piece];
            let way = until - spline.at[piece];
            let away = distance(chords, chord, until, jet, way);
            let after = (measure.of(&away), away);
            let start = ahead(jet, from - spline.at[piece], 6)[2];
            let bend = measure.of(&start).max(measure.of(&ahead(jet, way, 6)[2]));
            let part = until - from;
            let own = before.0.max(after.0) + bend * part * part / 8.0;
            off = off.max(own);
            if own > 1.0 {
                let length = spline.at[piece + 1] - spline.at[piece];
                let (farther, at) =
                    if before.0 > after.0 { (&before, from) } else { (&after, until) };
                let back = -DAMPING * (own - AIM) / farther.0;
                let by = farther.1.map(|away| away * back);
                pulls.push(Pull { piece, share: (at - spline.at[piece]) / length, by });
            }
            (from, before) = (until, after);
            if until >= spline.at[piece + 1] && piece + 1 < spline.jets.len() {
                piece += 1;
            } else if until >= spline.at[piece + 1] {
                break;
            }
        }
        from = from.max(end);
        most = most.max(off);
        if off > 1.0 {
            let fall = (FALL[1] / off.sqrt()).max(FALL[0]);
            let wide = |at: usize| widths.boxes[at].max(widths.knots[at]);
            let reach = 1.5 * wide(chord).max(wide(chord + 1));
            let down = (0..=chord).rev().take_while(|k| chords.at[*k] >= begin - reach);
            down.for_each(|k| falls[k] = falls[k].min(fall));
            let up = (chord + 1..=chords.count()).take_while(|k| chords.at[*k] <= end + reach);
            up.for_each(|k| falls[k] = falls[k].min(fall));
        }
    }
    most
}

fn distance(chords: &Chords, chord: usize, at: f64, jet: &[Axes; 4], way: f64) -> Axes {
    let (begin, end) = (chords.at[chord], chords.at[chord + 1]);
    let share = (at - begin) / (end - begin);
    let (from, to) = (&chords.places[chord], &chords.places[chord + 1]);
    let [x, d1, d2, d3] = jet;
    std::array::from_fn(|axis| {
        let on_curve =
            x[axis] + way * (d1[axis] + way * (d2[axis] * 0.5 + way * (d3[axis] * SIXTH)));
        on_curve - (from[axis] + share * (to[axis] - from[axis]))
    })
}
