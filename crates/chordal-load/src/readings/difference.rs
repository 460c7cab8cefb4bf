//! Finds the first block that moves differently in two readings of a text.

use super::trace::{BlockMotion, MotionTrace};

/// Positions that differ by less count as equal, mm or rad: controls round arcs differently in the last digit of a
/// program.
const EQUAL_POSITION_MM: f64 = 0.01;

/// Feeds that differ by a smaller fraction of the larger one count as equal.
const EQUAL_FEED_SHARE: f64 = 0.01;

/// What differs between two readings of a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MotionAspect {
    /// The end position on this axis.
    End(usize),
    /// The extent of the cut along this axis.
    Reach(usize),
    /// Whether it is a cut or a rapid, or whether it moves at all.
    Kind,
    /// Only the feed.
    Feed,
}

/// The first difference between two traces; `None` when there is none. A difference in feed is returned only when the
/// paths are equal. The two numbers are the indices of the block in `a` and `b`; `None` where that trace has no such
/// block.
pub fn first_difference(
    a: &MotionTrace,
    b: &MotionTrace,
) -> Option<(MotionAspect, Option<usize>, Option<usize>)> {
    let mut feed = None;
    for index in 0..a.blocks.len().max(b.blocks.len()) {
        let (one, other) = (a.blocks.get(index), b.blocks.get(index));
        let at = |block: Option<&BlockMotion>| block.map(|_| index);
        let (Some(one), Some(other)) = (one, other) else {
            return Some((MotionAspect::Kind, at(one), at(other)));
        };
        if (one.file, one.range.0) != (other.file, other.range.0) {
            // The block that is earlier in the text moves in one reading only.
            let first = one.range.0 <= other.range.0;
            return Some((MotionAspect::Kind, first.then_some(index), (!first).then_some(index)));
        }
        match block_difference(one, other) {
            Some(MotionAspect::Feed) => {
                feed.get_or_insert((MotionAspect::Feed, Some(index), Some(index)));
            }
            Some(aspect) => return Some((aspect, Some(index), Some(index))),
            None => {}
        }
    }
    feed
}

fn block_difference(one: &BlockMotion, other: &BlockMotion) -> Option<MotionAspect> {
    let differs = |a: f64, b: f64| (a - b).abs() > EQUAL_POSITION_MM;
    let known = one.known.and(other.known);
    if let Some(axis) = known.iter().find(|axis| {
        let axis = *axis as usize;
        differs(one.end[axis], other.end[axis])
    }) {
        return Some(MotionAspect::End(axis as usize));
    }
    if one.cuts != other.cuts {
        return Some(MotionAspect::Kind);
    }
    if one.cuts {
        let reach = (0..3).find(|axis| {
            let spans = |block: &BlockMotion| block.low[*axis] <= block.high[*axis];
            spans(one)
                && spans(other)
                && (differs(one.low[*axis], other.low[*axis])
                    || differs(one.high[*axis], other.high[*axis]))
        });
        if let Some(axis) = reach {
            return Some(MotionAspect::Reach(axis));
        }
    }
    match (one.feed, other.feed) {
        (Some(a), Some(b)) if (a - b).abs() > EQUAL_FEED_SHARE * a.abs().max(b.abs()) => {
            Some(MotionAspect::Feed)
        }
        _ => None,
    }
}
