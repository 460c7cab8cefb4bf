//! Moves that both have, at another time.

use std::ops::Range;

use chordal::geometry::ParamCurve;

use crate::SAME_MM;
use crate::course::{Course, Moved};
use crate::difference::{Category, Difference, Place};

/// Most pairs of gaps that are held against each other.
const MOST_PAIRS: usize = 100_000;

/// Makes one difference of order of two differences of path where what one program lacks is what the
/// other has elsewhere.
pub(crate) fn reordered(
    courses: [&Course; 2],
    gaps: &[[Range<usize>; 2]],
    differences: &mut Vec<Difference>,
) {
    let moves = |side: usize, range: &Range<usize>| -> Vec<&Moved> {
        let moves = range.clone().filter_map(|at| courses[side].moved(at));
        moves.filter(|moved| moved.known).collect()
    };
    let only = |side: usize| -> Vec<Vec<&Moved>> {
        let mine = gaps.iter().map(|gap| (moves(side, &gap[side]), moves(1 - side, &gap[1 - side])));
        mine.filter(|(mine, other)| !mine.is_empty() && other.is_empty())
            .map(|(mine, _)| mine)
            .collect()
    };
    let (gone, mut new) = (only(0), only(1));
    if gone.len() * new.len() > MOST_PAIRS {
        return;
    }
    for gone in gone {
        let Some(at) = new.iter().position(|new| is_same(&gone, new)) else { continue };
        let new = new.swap_remove(at);
        let find = |side: usize, moved: &Moved| {
            differences.iter().position(|difference| {
                let is_mine = difference.steps[1 - side] == 0;
                let begins = difference.blocks[side].map(|blocks| blocks.first);
                let here = Some(Place::from(&moved.origin));
                difference.category == Category::Path && is_mine && begins == here
            })
        };
        let Some((lost, found)) = find(0, gone[0]).zip(find(1, new[0])) else { continue };
        differences[lost].category = Category::Order;
        differences[lost].blocks[1] = differences[found].blocks[1];
        differences[lost].steps[1] = differences[found].steps[1];
        differences[lost].distance_mm = None;
        differences.remove(found);
    }
}

fn is_same(a: &[&Moved], b: &[&Moved]) -> bool {
    let is_near = |a: &Moved, b: &Moved| {
        let apart = (a.curve.start() - b.curve.start()).length();
        let apart = apart.max((a.curve.end() - b.curve.end()).length());
        apart.max((a.length_mm - b.length_mm).abs()) <= SAME_MM
    };
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_near(a, b))
}
