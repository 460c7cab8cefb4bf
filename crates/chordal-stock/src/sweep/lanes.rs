//! The floor of a part of a cutter on a piece of a path, for four columns at once, in single precision.
//!
//! Only + − × ÷ √, minimum and maximum are used, so the bits do not depend on the width of the lanes. Rounding acts
//! like a shift of the column in plan; the bounds from above and below allow for it by `slack`.
//!
//! Any position s on the piece gives an upper bound, so the floor is evaluated at one that is nearly optimal, with
//! the profile pushed outwards. For the lower bound the column is moved nearer to the piece, and the piece is
//! extended.

use wide::{CmpGe, CmpLe, CmpLt, f32x4};

use super::shape::{PartKind, ROUND_SHIFT, is_ball};
use super::{BodyPart, PartShape, SweepPiece};

const ZERO: f32x4 = f32x4::ZERO;

/// The floor of a column that is not reached.
pub(crate) const NOT_REACHED: f32 = f32::INFINITY;

/// Bound of the rounding as a shift in plan, relative to lengths: 8 times the rounding unit of single precision. A
/// sum of three products and two roots stays far below.
const SHIFT: f64 = 1.0 / (1 << 21) as f64;

/// Bound of the rounding of heights, mm; plus `SHIFT` times their range.
const HEIGHT_ROUNDING_MM: f64 = 1e-5;

/// Rows of corners in a block.
const ROWS: usize = 9;

/// The floor itself, without allowance for rounding.
pub(crate) const PLAIN: u8 = 0;
/// An upper bound of the floor.
pub(crate) const UPPER: u8 = 1;
/// A lower bound of the floor.
pub(crate) const LOWER: u8 = 2;

/// The parameters of one of the three floors.
#[derive(Clone, Copy)]
pub(crate) struct FloorSide {
    reach_square: f32x4,
    reach: f32x4,
    /// The ends of the piece, measured from the anchor, mm.
    from: f32x4,
    to: f32x4,
    /// The height of the part at the anchor, mm.
    height: f32x4,
}

/// A piece near a tile. Positions along it are measured from the anchor, its point nearest to the middle of the tile;
/// heights from the top of the stock.
pub(crate) struct TileCourse {
    /// Position along the piece at the tile's corner, and its change per cell along X and Y, mm; `across` likewise
    /// across the piece.
    pub along: [f32; 3],
    pub across: [f32; 3],
    pub slope: f32,
    /// −1 when the piece rises, 1 when it falls: the side of the lowest contact.
    pub lowest_side: f32x4,
    pub upper: FloorSide,
    pub lower: FloorSide,
    pub plain: FloorSide,
    /// How far the profile is pushed outwards for the upper bound, mm.
    grow: f32x4,
    /// How much nearer to the piece columns are for the lower bound, mm.
    nearer: f32x4,
    /// The change along the piece and across it from the first row of cells to each row, mm.
    pub rows: [[f32x4; ROWS]; 2],
    /// Half the diagonal of a cell plus `slack`, mm.
    pub half_diagonal: f32,
    /// Error bound in plan, mm.
    pub slack: f32,
    /// Lower bound of the height of the part at the anchor, mm.
    least_height: f32,
    /// The upper bound is higher by this, mm.
    pub gap: f32,
    /// The difference between the height of the part itself and its lower bound, mm.
    pub raise: f32x4,
}

/// The tile and the stock on which a course depends.
pub(crate) struct CourseFrame {
    /// The corner of the tile, mm.
    pub corner: [f64; 2],
    /// The size of a cell, mm.
    pub cell: f64,
    /// Cells along a side of the tile.
    pub cells: u32,
    /// The top of the stock, mm.
    pub top: f64,
    /// The height of the stock, mm.
    pub depth: f64,
}

impl TileCourse {
    pub fn new(piece: &SweepPiece, part: &BodyPart, place: &CourseFrame) -> TileCourse {
        let [ux, uy] = piece.along;
        let width = place.cell * f64::from(place.cells);
        let corner = [place.corner[0] - piece.start.x, place.corner[1] - piece.start.y];
        let middle = [corner[0] + width / 2.0, corner[1] + width / 2.0];
        let anchor = (middle[0] * ux + middle[1] * uy).clamp(0.0, piece.length);
        let along = corner[0] * ux + corner[1] * uy - anchor;
        let across = corner[1] * ux - corner[0] * uy;
        // Beyond this distance from the anchor no column of the tile is reached.
        let far = part.reach + 2.0 * width;
        let (from, to) = ((-anchor).max(-far), (piece.length - anchor).min(far));
        let newton = match part.kind {
            PartShape::Round { .. } if !is_ball(part) => ROUND_SHIFT * part.reach,
            PartShape::Round { .. } | PartShape::Flat | PartShape::Cone(_) => 0.0,
        };
        let round = SHIFT * (part.reach + width) + newton;
        let height = piece.start.z + piece.slope * anchor + part.height - place.top;
        let slope = piece.slope.abs();
        let range = place.depth + height.abs() + slope * (to - from);
        let lift = HEIGHT_ROUNDING_MM + SHIFT * range;
        let lane = |value: f64| f32x4::splat(value as f32);
        let (over, under) = (round + piece.off, round + piece.off_in_run);
        let high = part.reach - over - round;
        // The ends of the piece, rounded inwards: for the upper bound a position must be on the piece.
        let (mut inner_from, mut inner_to) = ((from as f32).next_up(), (to as f32).next_down());
        if from == to || inner_from > inner_to {
            // The piece is as short as rounding: its lower end represents it.
            let low = if piece.slope > 0.0 { from } else { to };
            (inner_from, inner_to) = (low as f32, low as f32);
        }
        let side = |reach: f64, ends: [f32; 2], height: f64| FloorSide {
            // Nothing is reached where the error is as large as the part.
            reach_square: lane(if reach > 0.0 { reach * reach } else { -1.0 }),
            reach: lane(reach),
            from: f32x4::splat(ends[0]),
            to: f32x4::splat(ends[1]),
            height: lane(height),
        };
        let rows = |step: f64| core::array::from_fn(|row| lane(step * row as f64));
        let low = height - lift - piece.off_in_run - slope * (under + round);
        let longer = [(from - under - round) as f32, (to + under + round) as f32];
        TileCourse {
            along: [along as f32, (ux * place.cell) as f32, (uy * place.cell) as f32],
            across: [across as f32, (-uy * place.cell) as f32, (ux * place.cell) as f32],
            slope: piece.slope as f32,
            lowest_side: f32x4::splat(if piece.slope > 0.0 { -1.0 } else { 1.0 }),
            upper: side(high, [inner_from, inner_to], height + lift + piece.off),
            lower: side(part.reach, longer, low),
            plain: side(part.reach, [from as f32, to as f32], height),
            grow: lane(over),
            nearer: lane(under + round),
            rows: [rows(uy * place.cell), rows(ux * place.cell)],
            half_diagonal: (place.cell / core::f64::consts::SQRT_2 + under + round) as f32,
            slack: (under + round) as f32,
            least_height: (height - lift - piece.off_in_run) as f32,
            gap: (2.0 * lift + piece.off) as f32,
            raise: lane(height) - lane(low),
        }
    }

    /// The position along the piece and across it at a corner of cells, given in cells from the tile's corner.
    #[inline(always)]
    pub fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (
            self.along[0] + x * self.along[1] + y * self.along[2],
            self.across[0] + x * self.across[1] + y * self.across[2],
        )
    }

    /// One of the three floors of a column, given its position along the piece and across it; [`NOT_REACHED`] where
    /// it is not reached.
    #[inline(always)]
    pub fn floor<const LEVEL: bool, const SIDE: u8, S: PartKind>(
        &self,
        shape: &S,
        along: f32x4,
        across: f32x4,
    ) -> f32x4 {
        let side = match SIDE {
            UPPER => &self.upper,
            LOWER => &self.lower,
            _ => &self.plain,
        };
        let e =
            if SIDE == LOWER { (across.abs() - self.nearer).fast_max(ZERO) } else { across.abs() };
        let height = |square: f32x4| {
            if SIDE == UPPER {
                shape.height_beyond(square, self.grow)
            } else {
                shape.height(square)
            }
        };
        let square = e * e;
        let base = side.height + shape.base();
        let (low, high) = (side.from - along, side.to - along);
        let nothing = f32x4::splat(NOT_REACHED);
        if LEVEL {
            let ahead = ZERO.fast_max(low).fast_min(high);
            let square = square + ahead * ahead;
            square.cmp_le(side.reach_square).blend(base + height(square), nothing)
        } else {
            let room = (side.reach_square - square).fast_max(ZERO).sqrt();
            let (low, high) = (low.fast_max(-room), high.fast_min(room));
            let reached = square.cmp_le(side.reach_square) & low.cmp_le(high);
            let best = self.lowest_side * shape.contact(e, square, room);
            let ahead = best.fast_max(low).fast_min(high);
            let value =
                base + f32x4::splat(self.slope) * (along + ahead) + height(square + ahead * ahead);
            reached.blend(value, nothing)
        }
    }

    /// Lower bound of the floor within `radius` mm of a column: the lowest height of the piece within reach plus the
    /// part's height at the least distance. `lowest` is from `lowest_in_reach`.
    #[inline(always)]
    pub fn least_within<S: PartKind>(
        &self,
        shape: &S,
        lowest: f32,
        radius: f32,
        along: f32x4,
        across: f32x4,
    ) -> f32x4 {
        let side = &self.lower;
        let ahead = ZERO.fast_max(side.from - along).fast_min(side.to - along);
        let distance = (across * across + ahead * ahead).sqrt() - f32x4::splat(radius);
        let near = distance.fast_max(ZERO);
        let value = f32x4::splat(lowest) + shape.base() + shape.height(near * near);
        distance.cmp_le(side.reach).blend(value, f32x4::splat(NOT_REACHED))
    }

    /// The least height of the part where it reaches points within `radius` mm of a position along the piece.
    #[inline(always)]
    pub fn lowest_in_reach(&self, along: f32, radius: f32) -> f32 {
        let side = &self.plain;
        let [from, to, reach] = [side.from, side.to, side.reach].map(|lanes| lanes.to_array()[0]);
        let far = reach + radius;
        let first = (along - far).clamp(from, to);
        let last = (along + far).clamp(from, to);
        self.least_height + (self.slope * first).min(self.slope * last)
    }

    /// Upper and lower bound of the height of a level piece, mm.
    pub fn level(&self) -> [f32; 2] {
        [self.upper.height.to_array()[0], self.least_height]
    }

    /// The height of a level piece at the anchor, mm.
    pub fn plain_level(&self) -> f32 {
        self.plain.height.to_array()[0]
    }

    /// For four rectangles of columns, given by their middles and half sizes along the piece and across it: whether
    /// this piece may have to lower any column, which it reaches and does not leave to a neighbour. `next` is the
    /// shape on the slope of the next piece.
    #[inline(always)]
    pub fn takes<S: PartKind>(
        &self,
        piece: &SweepPiece,
        [shape, next]: [&S; 2],
        [along, across]: [f32x4; 2],
        half: [f32; 2],
    ) -> f32x4 {
        let side = &self.plain;
        let slack = f32x4::splat(self.slack);
        let (half_a, half_e) = (f32x4::splat(half[0]) + slack, f32x4::splat(half[1]) + slack);
        let distances = |e: f32x4, half: f32x4| [(e.abs() - half).fast_max(ZERO), e.abs() + half];
        let [near, far] = distances(across, half_e);
        let [back, ahead] = contact(shape, piece.slope, near, far, side.reach_square);
        let (first, last) = (along - half_a, along + half_a);
        let mut takes = near.cmp_le(side.reach)
            & first.cmp_le(side.to + side.reach)
            & last.cmp_ge(side.from - side.reach);
        if piece.follows {
            takes &= (last + ahead).cmp_ge(side.from);
        }
        if let Some(joint) = piece.next {
            let (cos, sin) = (f32x4::splat(joint.cos as f32), f32x4::splat(joint.sin as f32));
            let beyond = along - side.to;
            let (next_along, next_across) =
                (beyond * cos + across * sin, across * cos - beyond * sin);
            let next_half_a = cos.abs() * half_a + sin.abs() * half_e;
            let next_half_e = sin.abs() * half_a + cos.abs() * half_e;
            let [near, far] = distances(next_across, next_half_e);
            let [next_back, _] = contact(next, joint.slope, near, far, side.reach_square);
            takes &= (first + back).cmp_le(side.to)
                | (next_along - next_half_a + next_back).cmp_lt(ZERO);
        }
        takes
    }

    /// Whether the upper bound of a level part covers all four columns.
    #[inline(always)]
    pub fn covers(&self, along: f32x4, across: f32x4) -> bool {
        let side = &self.upper;
        let ahead = ZERO.fast_max(side.from - along).fast_min(side.to - along);
        (across * across + ahead * ahead).cmp_le(side.reach_square).all()
    }
}

/// The range in which the lowest contact is, ahead of a column's position on a piece, for distances from `near` to
/// `far`.
#[inline(always)]
fn contact<S: PartKind>(
    shape: &S,
    slope: f64,
    near: f32x4,
    far: f32x4,
    reach_square: f32x4,
) -> [f32x4; 2] {
    if slope == 0.0 {
        return [ZERO; 2];
    }
    let [least, most] = shape.contacts(near, far, reach_square);
    if slope > 0.0 { [-most, -least] } else { [least, most] }
}
