//! Ranks the blocks that take the most time without keeping every block of a long program.

use chordal_command::Origin;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use super::report::{BlockTime, TimeReason};

/// How many blocks are kept during a run. When there are more, those in the lower three quarters of both rankings are
/// dropped: a block is missing from the lists only if it costs so little in each of its runs that thousands of others
/// cost more in between.
const MAX_TRACKED_BLOCKS: usize = 1 << 15;

/// Time and reason of one run of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockRun {
    pub origin: Origin,
    pub time_s: f64,
    pub lost_s: f64,
    pub reason: TimeReason,
}

/// A run of a block that further moves may continue.
#[derive(Clone, Copy, Debug)]
struct OpenRun {
    run: BlockRun,
    /// Its longest move, s.
    longest_s: f64,
    /// The loss of its costliest move, s, and the reason.
    worst: (f64, TimeReason),
}

/// Adds up runs of blocks and ranks them.
#[derive(Debug, Default)]
pub(super) struct BlockRanking {
    /// Blocks that came after all earlier ones in the text, as most do: sorted by key.
    in_order: Vec<BlockTime>,
    /// The others, such as those of a subprogram further up.
    out_of_order: HashMap<BlockKey, BlockTime, BuildHasherDefault<KeyHasher>>,
    /// The largest key so far.
    highest: Option<BlockKey>,
    /// The current run: consecutive moves of one block.
    open: Option<OpenRun>,
}

/// File and first byte of a block.
type BlockKey = u64;

fn key(origin: &Origin) -> BlockKey {
    u64::from(origin.span.file.0) << 32 | u64::from(origin.span.range.start)
}

/// Hashes the keys of blocks. The order of the table has no influence on the output.
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

impl BlockRanking {
    /// Takes a move or a wait of a block. Consecutive moves of one block are one run: a drilling cycle, or the legs
    /// of a rapid.
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
                let next = OpenRun { run, longest_s: run.time_s, worst };
                if let Some(done) = open.replace(next) {
                    self.add(&done);
                }
            }
        }
    }

    fn add(&mut self, done: &OpenRun) {
        let key = key(&done.run.origin);
        if self.highest.is_none_or(|highest| key > highest) {
            self.highest = Some(key);
            self.make_room();
            self.in_order.push(BlockTime::of(done));
        } else if let Some(block) = self.find(key) {
            block.add(done);
        } else {
            self.make_room();
            self.out_of_order.insert(key, BlockTime::of(done));
        }
    }

    fn find(&mut self, key_of_block: BlockKey) -> Option<&mut BlockTime> {
        match self.in_order.binary_search_by_key(&key_of_block, |block| key(&block.origin)) {
            Ok(at) => self.in_order.get_mut(at),
            Err(_) => self.out_of_order.get_mut(&key_of_block),
        }
    }

    fn len(&self) -> usize {
        self.in_order.len() + self.out_of_order.len()
    }

    fn all(&self) -> impl Iterator<Item = &BlockTime> {
        self.in_order.iter().chain(self.out_of_order.values())
    }

    /// Keeps the upper quarters of both rankings, or less, where there are too many.
    fn make_room(&mut self) {
        if self.len() < MAX_TRACKED_BLOCKS {
            return;
        }
        let quarter = |value: fn(&BlockTime) -> f64| {
            let mut values: Vec<f64> = self.all().map(value).collect();
            let at = values.len() / 4 * 3;
            *values.select_nth_unstable_by(at, f64::total_cmp).1
        };
        let (time_s, lost_s) = (quarter(|block| block.time_s), quarter(|block| block.lost_s));
        let keeps = |block: &BlockTime| block.time_s > time_s || block.lost_s > lost_s;
        self.in_order.retain(keeps);
        self.out_of_order.retain(|_, block| keeps(block));
    }

    /// The blocks with the largest values above zero, largest first, at most `most` of them.
    fn top(&self, most: usize, value: fn(&BlockTime) -> f64) -> Vec<BlockTime> {
        let mut blocks: Vec<BlockTime> =
            self.all().filter(|block| value(block) > 0.0).copied().collect();
        let before = |a: &BlockTime, b: &BlockTime| {
            value(b).total_cmp(&value(a)).then(key(&a.origin).cmp(&key(&b.origin)))
        };
        if blocks.len() > most {
            blocks.select_nth_unstable_by(most, before);
            blocks.truncate(most);
        }
        blocks.sort_by(before);
        blocks
    }

    /// The blocks that take the most time, and those that lose the most.
    pub fn finish(&mut self, most: usize) -> (Vec<BlockTime>, Vec<BlockTime>) {
        if let Some(done) = self.open.take() {
            self.add(&done);
        }
        (self.top(most, |block| block.time_s), self.top(most, |block| block.lost_s))
    }
}

impl BlockTime {
    fn of(done: &OpenRun) -> BlockTime {
        let mut block = BlockTime {
            origin: done.run.origin,
            runs: 0,
            time_s: 0.0,
            lost_s: 0.0,
            reason: done.run.reason,
            longest_s: 0.0,
            loses: done.worst.1,
            largest_loss_s: 0.0,
        };
        block.add(done);
        block
    }

    fn add(&mut self, OpenRun { run, worst, .. }: &OpenRun) {
        self.runs += 1;
        self.time_s += run.time_s;
        self.lost_s += run.lost_s;
        // The longest of its runs gives the reason.
        if run.time_s > self.longest_s {
            self.longest_s = run.time_s;
            self.reason = run.reason;
        }
        if worst.0 > self.largest_loss_s {
            (self.largest_loss_s, self.loses) = *worst;
        }
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
        BlockRun { origin, time_s, lost_s, reason: TimeReason::Feed }
    }

    #[test]
    fn a_block_in_a_loop_is_one_with_its_count() {
        let mut blocks = BlockRanking::default();
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
        let mut blocks = BlockRanking::default();
        blocks.push(BlockRun { reason: TimeReason::Rapid, ..run(1, 1.0, 0.5) });
        blocks.push(BlockRun {
            reason: TimeReason::Wait(crate::motion::WaitKind::Coolant),
            ..run(1, 2.0, 0.0)
        });
        let (longest, _) = blocks.finish(1);
        assert_eq!(longest[0].reason.word(), "coolant");
        assert_eq!(longest[0].loses, TimeReason::Rapid);
    }

    #[test]
    fn memory_is_bounded_and_the_top_stays() {
        let mut blocks = BlockRanking::default();
        for line in 0..200_000u32 {
            blocks.push(run(
                line,
                if line % 20_000 == 7 { 10.0 + f64::from(line) } else { 0.1 },
                0.0,
            ));
            assert!(blocks.len() <= MAX_TRACKED_BLOCKS);
        }
        let (longest, _) = blocks.finish(10);
        let lines: Vec<u32> = longest.iter().map(|block| block.origin.line).collect();
        let want: Vec<u32> = (0..10).rev().map(|at| at * 20_000 + 7).collect();
        assert_eq!(lines, want);
    }
}
