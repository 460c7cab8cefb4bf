//! The differences between two runs as plain data.

use chordal::Span;
use chordal::control::{Coolant, Origin, Overrides, PathMode, SpindleState};

use crate::category::Category;

/// The value on one of the two sides of a difference.
#[derive(Clone, Debug, PartialEq)]
pub enum DifferenceValue {
    /// No such value.
    Nothing,
    /// A number of a tool or an offset.
    Number(u32),
    /// A feed, mm/s.
    Feed(f64),
    /// The feed of a move of rotary axes only, 1/s: the reciprocal of its duration.
    Turn(f64),
    /// A feed per revolution, mm.
    FeedPerRevolution(f64),
    /// A spindle state and speed, revolutions per minute.
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
    /// Any other value, in words.
    Text(String),
}

/// The location of a block in one of the two programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockLocation {
    /// Its text range in the sources of its job.
    pub span: Span,
    /// Its line number, from 1.
    pub line: u32,
}

impl From<&Origin> for BlockLocation {
    fn from(origin: &Origin) -> BlockLocation {
        BlockLocation { span: origin.span, line: origin.line }
    }
}

/// The first and the last block of a sequence, in the order of execution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockRange {
    /// The first block.
    pub first: BlockLocation,
    /// The last block.
    pub last: BlockLocation,
}

impl Difference {
    /// A difference that occurs once, without distance and shift.
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

    /// A difference between two single blocks.
    pub(crate) fn at(
        category: Category,
        at: [BlockLocation; 2],
        values: Option<[DifferenceValue; 2]>,
    ) -> Difference {
        Difference::new(category, at.map(|place| Some(BlockRange::at(place))), [1; 2], values)
    }

    /// Extends the difference to further blocks.
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

    /// Merges an equal difference of another loop iteration or call; `false` when it is not equal.
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

/// Sorts differences by their place in the first program and merges equal ones.
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

    /// The smallest and the largest line of its two ends; the line of the first block twice when the ends are in
    /// different files.
    pub fn lines(&self) -> (u32, u32) {
        if self.first.span.file != self.last.span.file {
            return (self.first.line, self.first.line);
        }
        (self.first.line.min(self.last.line), self.first.line.max(self.last.line))
    }
}

/// A difference between two runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// What differs.
    pub category: Category,
    /// The blocks in each program. When only one program has the step, the other entry is the block after which it is
    /// missing, or `None` when there is none.
    pub blocks: [Option<BlockRange>; 2],
    /// The number of moves or other steps in each program.
    pub steps: [u64; 2],
    /// How often the difference occurs, in a loop or a subprogram.
    pub times: u64,
    /// The values on both sides; `None` when the difference is not in a single value.
    pub values: Option<[DifferenceValue; 2]>,
    /// An upper bound of the distance between the two paths here, mm; `None` when it is not known or not a difference
    /// of paths.
    pub distance_mm: Option<f64>,
    /// A point on each path near their largest distance here, in the frame of the run, mm. It shows where to look and
    /// is not exact. `None` as for `distance_mm`.
    pub at_mm: Option<[[f64; 3]; 2]>,
    /// The translation from the first path to the second, mm; `None` when they differ by more than a translation.
    pub shift_mm: Option<[f64; 3]>,
}
