//! Compares the words of blocks that no run reaches because a condition before them is unknown.

use std::collections::BTreeSet;

use chordal::control::{AfterBlock, Origin, RunSink, Sink};
use chordal::diagnostics::FileId;
use chordal::syntax::{Block, BlockKind, BlockReader};
use chordal::{BlockDeleteRuns, Code, Command, Diagnostic, Job, Report, Span};

use crate::alignment_walker::ComparisonFindings;
use crate::category::Category;
use crate::difference::{BlockLocation, BlockRange, Difference, DifferenceValue};

/// Adds the first difference between the blocks that the two runs, on the same control, have not reached.
pub(crate) fn compare(
    jobs: [&Job; 2],
    reports: [&Report; 2],
    separate_sides: bool,
    found: &mut ComparisonFindings,
) {
    let is_assumed =
        |report: &Report| report.diagnostics.iter().any(|one| one.code == Code::AssumedBranch);
    // A job that takes the other side of a condition needs no such comparison: what it does not reach, the first run
    // or a further one does.
    if separate_sides && jobs.iter().any(|job| job.takes_other_side()) {
        return;
    }
    let titles = jobs.map(|job| job.profile().title);
    if !reports.into_iter().any(is_assumed) || titles[0] != titles[1] {
        return;
    }
    let left =
        [0, 1].map(|side: usize| SkippedBlock::of(jobs[side], reports[side], separate_sides));
    let common = left[0].len().min(left[1].len());
    let first = (0..common).find(|at| left[0][*at].words != left[1][*at].words);
    let Some(at) = first.or((left[0].len() != left[1].len()).then_some(common)) else { return };
    let only = left.each_ref().map(|left| left.get(at));
    let blocks = only.map(|left| left.map(|left| BlockRange::at(left.place)));
    let values = only.map(|left| match left {
        None => DifferenceValue::Nothing,
        Some(left) => DifferenceValue::Text(left.words.clone()),
    });
    let counts = left.map(|left| (left.len() - common.min(at)) as u64);
    found.differences.push(Difference::new(Category::NotRun, blocks, counts, Some(values)));
}

/// A block that was not run, or whose condition was not decided.
struct SkippedBlock {
    words: String,
    place: BlockLocation,
}

impl SkippedBlock {
    fn of(job: &Job, report: &Report, sides_separate: bool) -> Vec<SkippedBlock> {
        let mut ran = ExecutedBlocks::default();
        job.run(&mut ran);
        if sides_separate {
            let as_needed = BlockDeleteRuns::WhereItDecides;
            let (sides, _) = job.other_side_jobs(&report.diagnostics, as_needed);
            for (_, side) in sides {
                side.run(&mut ran);
            }
        }
        let undecided: BTreeSet<(FileId, u32)> = report
            .diagnostics
            .iter()
            .filter(|one| one.code == Code::AssumedBranch)
            .filter_map(|one| {
                let span = one.primary.span;
                Some((span.file, job.sources().get(span.file)?.line_of(span.range.start)))
            })
            .collect();
        let mut files: BTreeSet<FileId> = ran.blocks.iter().map(|(file, _)| *file).collect();
        files.insert(FileId(0));
        let mut left = Vec::new();
        let Some(control) = job.word_address() else { return left };
        for file in files {
            let Some(source) = job.sources().get(file) else { continue };
            let mut reader = BlockReader::new(source.text(), file, control.table.lexicon);
            let mut block = Block::new();
            while reader.read(&mut block) {
                let has_run = ran.blocks.contains(&(file, block.range.start));
                if has_run && !undecided.contains(&(file, block.line)) {
                    continue;
                }
                let words = words(source.text(), &block);
                if !words.is_empty() {
                    let span = Span { file, range: block.range };
                    left.push(SkippedBlock {
                        words,
                        place: BlockLocation { span, line: block.line },
                    });
                }
            }
        }
        left
    }
}

/// The words of a block without its number and spaces, and without comments unless a macro statement displays them.
fn words(text: &[u8], block: &Block) -> String {
    let range = block.range;
    let from = block.word(b'N').map_or(range.start, |word| word.range.end);
    let shows_text = matches!(block.kind, BlockKind::Macro(_));
    let is_remark = |at: u32| {
        !shows_text && block.comments.iter().any(|comment| comment.start <= at && at < comment.end)
    };
    let bytes = (from..range.end).filter(|at| !is_remark(*at)).map(|at| text[at as usize]);
    let kept = bytes.filter(|byte| !byte.is_ascii_whitespace() && *byte != b'%');
    String::from_utf8_lossy(&kept.collect::<Vec<u8>>()).to_ascii_uppercase()
}

/// The blocks that a run has executed.
#[derive(Default)]
struct ExecutedBlocks {
    blocks: BTreeSet<(FileId, u32)>,
}

impl Sink for ExecutedBlocks {
    fn command(&mut self, _: &Command) {}

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for ExecutedBlocks {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, _: &AfterBlock) {
        self.blocks.insert((origin.span.file, origin.span.range.start));
    }
}
