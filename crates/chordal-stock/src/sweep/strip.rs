//! Decides which columns a piece of a path lowers, and which it leaves to its neighbours.
//!
//! Where the lowest contact over a column would be before the start of the piece, the previous piece is at least as
//! low, and likewise at its end. A column that both might leave to the other belongs to the earlier piece.

use super::{BodyPart, SweepPiece};

/// A rectangle along a piece: from `from` to `to` along it, measured from its start, and `reach` to both sides, mm.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub(crate) struct SweepStrip {
    pub from: f64,
    pub to: f64,
    pub reach: f64,
}

/// The strip of a piece for a part of the cutter; it contains at least the columns that no neighbour takes.
pub(crate) fn strip(piece: &SweepPiece, part: &BodyPart) -> SweepStrip {
    let reach = part.reach;
    let [back, ahead] = part.contact(piece.slope);
    let from = if piece.follows { -ahead } else { -reach };
    let to = piece.next.map_or(reach, |joint| {
        // The next piece certainly takes what is beyond this distance along itself from the joint.
        let takes = (-part.contact(joint.slope)[0]).min(reach);
        // The furthest point along this piece that the next one may leave, within the circle about the joint.
        let left = if joint.cos * reach <= takes {
            reach
        } else {
            takes * joint.cos + joint.sin.abs() * (reach * reach - takes * takes).max(0.0).sqrt()
        };
        left.max(-back)
    });
    SweepStrip { from, to: piece.length + to, reach }
}

/// The range of u with low ≤ c·u + d·v ≤ high for some v in a range; empty where the first value is larger.
pub(crate) fn span(c: f64, d: f64, [low, high]: [f64; 2], [v0, v1]: [f64; 2]) -> [f64; 2] {
    /// A smaller slope counts as zero: over any tile it makes less than rounding.
    const HORIZONTAL_SLOPE: f64 = 1e-9;
    let (least, most) = ((d * v0).min(d * v1), (d * v0).max(d * v1));
    let (low, high) = (low - most, high - least);
    if c.abs() < HORIZONTAL_SLOPE {
        let none = low > HORIZONTAL_SLOPE * 1e3 || high < -HORIZONTAL_SLOPE * 1e3;
        return if none { [1.0, 0.0] } else { [f64::NEG_INFINITY, f64::INFINITY] };
    }
    let (a, b) = (low / c, high / c);
    [a.min(b), a.max(b)]
}

/// The range of x of a strip between two values of y, both relative to the start of its piece; with `along`
/// exchanged, that of y between two values of x.
pub(crate) fn across(strip: &SweepStrip, along: [f64; 2], band: [f64; 2], margin: f64) -> [f64; 2] {
    let [ux, uy] = along;
    let lengthwise = [strip.from - margin, strip.to + margin];
    let sideways = [-strip.reach - margin, strip.reach + margin];
    let [a0, a1] = span(ux, uy, lengthwise, band);
    let [b0, b1] = span(-uy, ux, sideways, band);
    [a0.max(b0), a1.min(b1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::parts;
    use crate::sweep::pieces::PieceJoint;
    use chordal_geometry::Vec3;

    #[test]
    fn a_straight_run_shares_its_columns_without_a_gap() {
        let ball = parts(crate::CutterProfile::ball(6.0).unwrap().rings())[0];
        let piece = SweepPiece {
            start: Vec3::ZERO,
            along: [1.0, 0.0],
            length: 0.1,
            slope: 0.75,
            off: 0.0,
            off_in_run: 0.0,
            number: 0,
            tag: 0,
            follows: true,
            next: Some(PieceJoint { cos: 1.0, sin: 0.0, slope: 0.75 }),
        };
        let strip = strip(&piece, &ball);
        // The contact is 3·0.75/1.25 = 1.8 behind at the most.
        assert!((strip.from - 0.0).abs() < 1e-12);
        assert!((strip.to - 1.9).abs() < 1e-12);
        let [x0, x1] = across(&strip, [1.0, 0.0], [1.0, 2.0], 0.0);
        assert!((x0 - 0.0).abs() < 1e-12 && (x1 - 1.9).abs() < 1e-12);
        let [x0, x1] = across(&strip, [1.0, 0.0], [3.5, 4.0], 0.0);
        assert!(x0 > x1);
    }
}
