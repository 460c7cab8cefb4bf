//! What differs, as plain data.

use chordal::Span;
use chordal::control::{Coolant, Origin, Overrides, PathMode, SpindleState};

use crate::category::Category;

/// What one of the two has.
#[derive(Clone, Debug, PartialEq)]
pub enum DifferenceValue {
    /// Nothing of the kind.
    Nothing,
    /// A number: of a tool, of an offset.
    Number(u32),
    /// A feed, mm/s.
    Feed(f64),
    /// A feed of rotary axes alone, 1/s: one over the time of the move.
    Turn(f64),
    /// A feed for each revolution, mm.
    FeedPerRevolution(f64),
    /// A spindle, and its speed in revolutions a minute.
    Spindle(SpindleState, f64),
    /// Coolant.
    Coolant(Coolant),
    /// A path mode.
    PathMode(PathMode),
    /// Overrides.
    Overrides(Overrides),
    /// A time, s.
    Seconds(f64),
    /// Rotary axes A B C, rad.
    Rotary([f64; 3]),
    /// Said in words.
    Text(String),
}

/// A block of one of the two programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockLocation {
    /// The block, in the sources of its job.
    pub span: Span,
    /// Its line, from 1.
    pub line: u32,
}

impl From<&Origin> for BlockLocation {
    fn from(origin: &Origin) -> BlockLocation {
        BlockLocation { span: origin.span, line: origin.line }
    }
}

/// The first and the last block of a stretch, in the order in which they are run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockRange {
    /// Where it begins.
    pub first: BlockLocation,
    /// Where it ends.
    pub last: BlockLocation,
}

impl Difference {
    /// A difference made once, of which no more is known yet.
    pub(crate) fn new(
        category: Category,
        blocks: [Option<BlockRange>; 2],
        steps: [u64; 2],
        values: Option<[DifferenceValue; 2]>,
    ) -> Difference {
        Difference {
            category,
            blocks,
            steps,
            times: 1,
            values,
            distance_mm: None,
            at_mm: None,
            shift_mm: None,
        }
    }

    /// A difference of one block and another.
    pub(crate) fn at(
        category: Category,
        at: [BlockLocation; 2],
        values: Option<[DifferenceValue; 2]>,
    ) -> Difference {
        Difference::new(category, at.map(|place| Some(BlockRange::at(place))), [1; 2], values)
    }

    /// Goes on to the next blocks.
    pub(crate) fn extend(&mut self, at: [BlockLocation; 2]) {
        for ((blocks, place), steps) in self.blocks.iter_mut().zip(at).zip(&mut self.steps) {
            if let Some(blocks) = blocks
                && blocks.last != place
            {
                blocks.last = place;
                *steps += 1;
            }
        }
    }

    /// Takes the same difference of another turn; false where it is another one.
    fn again(&mut self, other: &Difference) -> bool {
        let key = |one: &Difference| (one.category, one.blocks, one.steps);
        let is_same = key(self) == key(other) && self.values == other.values;
        if is_same {
            self.times += other.times;
            self.distance_mm = self.distance_mm.zip(other.distance_mm).map(|(a, b)| a.max(b));
            self.shift_mm = self.shift_mm.filter(|shift| Some(*shift) == other.shift_mm);
        }
        is_same
    }
}

/// Puts differences in the order of the first program, each once.
pub(crate) fn in_order(differences: &mut Vec<Difference>) {
    let lines = |difference: &Difference| {
        let at = difference.blocks.map(|blocks| blocks.map(|at| at.lines()));
        (at[0].or(at[1]), at[1], difference.category, difference.steps)
    };
    differences.sort_by_key(lines);
    differences.dedup_by(|next, before| before.again(next));
}

impl BlockRange {
    pub(crate) fn at(place: BlockLocation) -> BlockRange {
        BlockRange { first: place, last: place }
    }

    /// The smallest and largest line of its two ends; the line of the first alone where they are in
    /// different files.
    pub fn lines(&self) -> (u32, u32) {
        if self.first.span.file != self.last.span.file {
            return (self.first.line, self.first.line);
        }
        (self.first.line.min(self.last.line), self.first.line.max(self.last.line))
    }
}

/// A difference of two runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// In what.
    pub category: Category,
    /// Where in each of the two; where only one has it, the other says after which block it lacks.
    pub blocks: [Option<BlockRange>; 2],
    /// How many moves, or other steps, it holds in each.
    pub steps: [u64; 2],
    /// How often, where a loop or a subprogram makes the same difference again.
    pub times: u64,
    /// What each has, where that is one value.
    pub values: Option<[DifferenceValue; 2]>,
    /// The two paths are nowhere further apart here, mm.
    pub distance_mm: Option<f64>,
    /// A place on each of the two paths where they are about furthest apart here, in the frame of the
    /// run, mm: where to look, not a measure.
    pub at_mm: Option<[[f64; 3]; 2]>,
    /// The second path is the first moved by this, mm, where it is that.
    pub shift_mm: Option<[f64; 3]>,
}
