//! The blocks that take the most time, found without keeping every block of a long program.

use chordal_command::Origin;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use super::report::{BlockTime, Reason};

/// How many blocks are held while a program goes by. When there are more, those in the lower
/// half of both rankings are forgotten: a block is lost to the lists only when it costs so
/// little in each of its runs that thousands cost more in between.
const HELD: usize = 1 << 15;

/// What one run of a block comes to.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockRun {
    pub origin: Origin,
    pub time_s: f64,
    pub lost_s: f64,
    pub reason: Reason,
}

/// A run of which more may come.
#[derive(Clone, Copy, Debug)]
struct Open {
    run: BlockRun,
    /// Its longest move, s.
    longest_s: f64,
    /// What its costliest move loses, s, and why.
    worst: (f64, Reason),
}

/// Adds up runs of blocks and ranks them.
#[derive(Debug, Default)]
pub(super) struct Blocks {
    held: HashMap<Key, BlockTime, BuildHasherDefault<KeyHasher>>,
    /// The run that goes on: several moves of one block, one after the other.
    open: Option<Open>,
}

/// File and first byte of a block.
type Key = u64;

fn key(origin: &Origin) -> Key {
    u64::from(origin.span.file.0) << 32 | u64::from(origin.span.range.start)
}

/// Spreads the places of blocks; the order of the table goes into no output.
#[derive(Default)]
pub(super) struct KeyHasher(u64);

impl Hasher for KeyHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.write_u64((*byte).into()));
    }

    fn write_u64(&mut self, value: u64) {
        let mixed = (self.0 ^ value).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = mixed ^ mixed >> 32;
    }
}

impl Blocks {
    /// Takes a move or a wait of a block. Moves that follow each other in one block are one
    /// run: a drilling cycle, or the legs of a rapid.
    pub fn push(&mut self, run: BlockRun) {
        match &mut self.open {
            Some(open) if key(&open.run.origin) == key(&run.origin) => {
                open.run.time_s += run.time_s;
                open.run.lost_s += run.lost_s;
                // The longest move gives the reason.
                if run.time_s > open.longest_s {
                    open.longest_s = run.time_s;
                    open.run.reason = run.reason;
                }
                if run.lost_s > open.worst.0 {
                    open.worst = (run.lost_s, run.reason);
                }
            }
            open => {
                let worst = (run.lost_s, run.reason);
                let next = Open { run, longest_s: run.time_s, worst };
                if let Some(done) = open.replace(next) {
                    self.add(&done);
                }
            }
        }
    }

    fn add(&mut self, done: &Open) {
        let Open { run, worst, .. } = done;
        if self.held.len() >= HELD && !self.held.contains_key(&key(&run.origin)) {
            self.forget();
        }
        let block = self.held.entry(key(&run.origin)).or_insert(BlockTime {
            origin: run.origin,
            runs: 0,
            time_s: 0.0,
            lost_s: 0.0,
            reason: run.reason,
            longest_s: 0.0,
            loses: worst.1,
            largest_loss_s: 0.0,
        });
        block.runs += 1;
        block.time_s += run.time_s;
        block.lost_s += run.lost_s;
        // The longest of its runs gives the reason.
        if run.time_s > block.longest_s {
            block.longest_s = run.time_s;
            block.reason = run.reason;
        }
        if worst.0 > block.largest_loss_s {
            (block.largest_loss_s, block.loses) = *worst;
        }
    }

    /// Keeps the upper halves of both rankings, or less.
    fn forget(&mut self) {
        let middle = |value: fn(&BlockTime) -> f64| {
            let mut values: Vec<f64> = self.held.values().map(value).collect();
            let half = values.len() / 4 * 3;
            *values.select_nth_unstable_by(half, f64::total_cmp).1
        };
        let (time_s, lost_s) = (middle(|block| block.time_s), middle(|block| block.lost_s));
        self.held.retain(|_, block| block.time_s > time_s || block.lost_s > lost_s);
    }

    /// The blocks with the most of a value above zero, most first, at most so many.
    fn top(&self, most: usize, value: fn(&BlockTime) -> f64) -> Vec<BlockTime> {
        let mut blocks: Vec<BlockTime> =
            self.held.values().filter(|block| value(block) > 0.0).copied().collect();
        blocks.sort_by(|a, b| {
            value(b).total_cmp(&value(a)).then(key(&a.origin).cmp(&key(&b.origin)))
        });
        blocks.truncate(most);
        blocks
    }

    /// The blocks that take the longest, and those that lose the most.
    pub fn finish(&mut self, most: usize) -> (Vec<BlockTime>, Vec<BlockTime>) {
        if let Some(done) = self.open.take() {
            self.add(&done);
        }
        (self.top(most, |block| block.time_s), self.top(most, |block| block.lost_s))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal_diagnostics::{FileId, Span, TextRange};

    fn run(line: u32, time_s: f64, lost_s: f64) -> BlockRun {
        let range = TextRange::new(line * 10, line * 10 + 9);
        let span = Span { file: FileId(0), range };
        let origin = Origin { span, line, ..Origin::default() };
        BlockRun { origin, time_s, lost_s, reason: Reason::Feed }
    }

    #[test]
    fn a_block_in_a_loop_is_one_with_its_count() {
        let mut blocks = Blocks::default();
        for _ in 0..3 {
            blocks.push(run(1, 1.0, 0.5));
            blocks.push(run(1, 1.0, 0.25));
            blocks.push(run(2, 4.0, 0.0));
        }
        let (longest, costliest) = blocks.finish(10);
        let lines = |blocks: &[BlockTime]| {
            blocks.iter().map(|b| (b.origin.line, b.runs, b.time_s, b.lost_s)).collect::<Vec<_>>()
        };
        assert_eq!(lines(&longest), [(2, 3, 12.0, 0.0), (1, 3, 6.0, 2.25)]);
        assert_eq!(lines(&costliest), [(1, 3, 6.0, 2.25)]);
    }

    #[test]
    fn the_loss_of_a_block_has_its_own_reason() {
        let mut blocks = Blocks::default();
        blocks.push(BlockRun { reason: Reason::Rapid, ..run(1, 1.0, 0.5) });
        blocks.push(BlockRun {
            reason: Reason::Wait(crate::motion::WaitKind::Coolant),
            ..run(1, 2.0, 0.0)
        });
        let (longest, _) = blocks.finish(1);
        assert_eq!(longest[0].reason.word(), "coolant");
        assert_eq!(longest[0].loses, Reason::Rapid);
    }

    #[test]
    fn memory_is_bounded_and_the_top_is_kept() {
        let mut blocks = Blocks::default();
        for line in 0..200_000u32 {
            blocks.push(run(
                line,
                if line % 20_000 == 7 { 10.0 + f64::from(line) } else { 0.1 },
                0.0,
            ));
            assert!(blocks.held.len() <= HELD);
        }
        let (longest, _) = blocks.finish(10);
        let lines: Vec<u32> = longest.iter().map(|block| block.origin.line).collect();
        let want: Vec<u32> = (0..10).rev().map(|at| at * 20_000 + 7).collect();
        assert_eq!(lines, want);
    }
}
