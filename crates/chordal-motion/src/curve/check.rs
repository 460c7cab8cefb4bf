//! The certificate: how far the curve is from the chords, at most.
//!
//! Both are functions of one σ, so the distance at the same σ bounds the distance both ways. Between
//! knots and places of the chords it is a cubic whose second derivative is the curve's: with δ the
//! length of such a part, |e| ≤ max(|e₀|, |e₁|) + max|q''|·δ²/8.

use super::Measure;
use super::chords::Chords;
use super::fit::Spline;
use super::width::Widths;
use crate::Axes;
use crate::piece::{SIXTH, ahead};

/// Where it is too far, widths around fall to at least and at most these shares, by the root of the excess.
const FALL: [f64; 2] = [0.6, 0.9];

/// The largest distance in tolerances; widths fall where it is above one.
pub(super) fn certify(
    chords: &Chords,
    spline: &Spline,
    measure: &Measure,
    widths: &mut Widths,
) -> f64 {
    let mut most = 0.0_f64;
    let mut falls = vec![1.0_f64; chords.count() + 1];
    let (mut piece, mut from, mut before) = (0, 0.0_f64, 0.0_f64);
    for chord in 0..chords.count() {
        let (begin, end) = (chords.at[chord], chords.at[chord + 1]);
        let mut off = 0.0_f64;
        while from < end {
            let until = spline.at[piece + 1].min(end);
            let jet = &spline.jets[piece];
            let way = until - spline.at[piece];
            let after = measure.of(&distance(chords, chord, until, jet, way));
            let start = ahead(jet, from - spline.at[piece], 6)[2];
            let bend = measure.of(&start).max(measure.of(&ahead(jet, way, 6)[2]));
            let part = until - from;
            off = off.max(before.max(after) + bend * part * part / 8.0);
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
    if most > 1.0 {
        widths.shares.iter_mut().zip(&falls).for_each(|(share, fall)| *share *= fall);
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
