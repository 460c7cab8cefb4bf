//! The first block that two readings of a text move differently.

use super::trace::{BlockMotion, MotionTrace};

/// Positions that differ by less are the same, mm and rad: controls round arcs within the last digit of a
/// program.
const EQUAL_POSITION_MM: f64 = 0.01;

/// Feeds that differ by less, as a share of the larger, are the same.
const EQUAL_FEED_SHARE: f64 = 0.01;

/// What differs in a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MotionAspect {
    /// Where it ends, on this axis.
    End(usize),
    /// How far its cut goes, on this axis.
    Reach(usize),
    /// It cuts or it is a rapid, or it moves at all.
    Kind,
    /// Its feed alone.
    Feed,
}

/// The first difference of two traces; first those of the path, and only where there is none one of the feed.
/// The place is the index of the block in each.
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
            // The earlier one moves on one control alone.
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
