//! Blocks split where it pays: the places are chosen by the slices of their moves, the text in parts is proved to make
//! the same path, and then feeds are written as for any other text.

use std::collections::{BTreeMap, HashMap};

use chordal::Job;
use chordal::diagnostics::{FileId, Source, TextRange};
use chordal::stock::{EngagementReport, MoveEngagement};
use chordal_compare::{ComparisonOptions, ComparisonVerdict};

use super::super::edit::{apply, changes, line_end};
use super::super::edit_proof::old_text;
use super::exact::BlockPoint;
use super::parts::{BlockSplitter, NO_POINT, SplitObjection};
use super::profile::FeedProfile;
use super::proof::same_within;
use super::shares::ShareInputs;
use super::slices::MoveSlices;
use super::{FeedEdits, OptimizeError, OptimizeOptions, SetupFiles, feed, is_known};
use crate::source::first_text;
use crate::{Change, prove};

/// Splits whose sides have the same feed are taken out, and the rest is measured again, so many times.
const MAX_SPLIT_ROUNDS: usize = 4;

/// What was split.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SplitResult {
    /// Blocks that were split.
    pub blocks: usize,
    /// What they are now.
    pub parts: usize,
    /// The new path is nowhere further from the old one, mm.
    pub off_mm: f64,
    /// Columns of the stock that are the same to the bit; the bounds of all others overlap.
    pub same_cells: u64,
}

/// Blocks that would be split, and why they are not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotSplit {
    /// How many.
    pub blocks: usize,
    /// The line of the first.
    pub line: u32,
    /// Why, as a clause for people.
    pub why: &'static str,
}

/// The joints of each block, by the byte that it begins at.
type BlockJoints = BTreeMap<u32, Vec<BlockPoint>>;

/// A text in parts with its feeds.
pub(super) struct InParts {
    pub fed: FeedEdits,
    pub splits: SplitResult,
    pub changes: Vec<Change>,
}

/// What the joints are chosen by.
pub(super) struct JointChoice<'a> {
    pub job: &'a Job<'a>,
    pub before: &'a EngagementReport,
    pub slices: &'a MoveSlices,
    pub limits: &'a BTreeMap<u32, f64>,
    pub options: &'a OptimizeOptions,
    pub files: SetupFiles<'a>,
}

impl JointChoice<'_> {
    /// The text in parts, where any block is worth it, and which blocks are not split that would be.
    pub fn in_parts(&self) -> Result<(Option<InParts>, Vec<NotSplit>), OptimizeError> {
        let mut parts = BlockSplitter::new(self.job);
        let (mut joints, why) = self.joints(&mut parts);
        for round in 0..MAX_SPLIT_ROUNDS {
            if joints.is_empty() {
                break;
            }
            let mut edits = Vec::new();
            for (block, joints) in &joints {
                edits.extend(parts.edits(*block, joints));
            }
            let new = self.job.with_text(apply(first_text(self.job), &mut edits));
            let options = ComparisonOptions { kept: 100_000, ..ComparisonOptions::default() };
            let certificate = prove(self.job, &new, &options, &[]);
            let off_mm = certificate.comparison.max_distance_mm;
            let Some(off_mm) =
                off_mm.filter(|_| certificate.comparison.verdict == ComparisonVerdict::Same)
            else {
                let hits = certificate.comparison.differences.iter().filter_map(old_text);
                let hits: Vec<[u32; 2]> = hits.collect();
                let count = joints.len();
                joints.retain(|block, _| {
                    hits.iter().all(|[first, last]| block < first || block > last)
                });
                if joints.len() == count {
                    break;
                }
                continue;
            };
            let before = new.engagement(&self.options.engagement, self.files)?;
            is_known(&before, new.sources())?;
            let same_cells = same_within(self.before, &before)?;
            let fed = feed(&new, &before, self.limits, self.options, self.files)?;
            let lines = PartLines::new(&parts, &joints);
            if lines.without_same(&mut joints, &fed, &before.moves) && round + 1 < MAX_SPLIT_ROUNDS
            {
                continue;
            }
            let parts = lines.split.iter().map(|&(_, _, count)| count as usize).sum();
            let splits = SplitResult { blocks: lines.split.len(), parts, off_mm, same_cells };
            let changes = lines.changes(first_text(self.job), &new, &fed);
            return Ok((Some(InParts { fed, splits, changes }), why));
        }
        Ok((None, why))
    }

    /// Where blocks are split.
    fn joints(&self, parts: &mut BlockSplitter) -> (BlockJoints, Vec<NotSplit>) {
        let shares = ShareInputs::new(self.job, self.before, self.limits, self.options);
        let teeth: HashMap<u32, u32> =
            self.before.tools.iter().filter_map(|tool| Some((tool.number, tool.teeth?))).collect();
        let mut moves: HashMap<u32, u32> = HashMap::new();
        for each in self.before.moves.iter().filter(|each| each.origin.span.file == FileId(0)) {
            *moves.entry(each.origin.span.range.start).or_default() += 1;
        }
        let mut joints = BlockJoints::new();
        let mut why: BTreeMap<SplitObjection, NotSplit> = BTreeMap::new();
        for (number, each) in self.before.moves.iter().enumerate() {
            let start = each.origin.span.range.start;
            if !shares.is_changeable(each) || moves.get(&start) != Some(&1) {
                continue;
            }
            let feed_per_tooth =
                teeth.get(&each.tool).and_then(|teeth| each.feed_per_tooth(*teeth));
            let Some(feed_per_tooth) = feed_per_tooth.filter(|_| self.slices.has(number)) else {
                continue;
            };
            let profile = self.profile(&shares, number, each, feed_per_tooth);
            if profile.joints(each.feed_mm_per_s, None).is_empty() {
                continue;
            }
            let found = match parts.points(start) {
                Ok(points) => match profile.joints(each.feed_mm_per_s, Some(points)) {
                    found if found.is_empty() => Err(NO_POINT),
                    found => Ok(found),
                },
                Err(why) => Err(why),
            };
            match found {
                Ok(found) => {
                    joints.insert(start, found);
                }
                Err(reason) => {
                    let line = parts.line(start);
                    let one = NotSplit { blocks: 0, line, why: reason };
                    why.entry(reason).or_insert(one).blocks += 1;
                }
            }
        }
        (joints, why.into_values().collect())
    }

    /// The shares that a move may have along its length: of each slice also on the slices next to it, so that a part
    /// that ends between two keeps its share.
    fn profile(
        &self,
        shares: &ShareInputs,
        number: usize,
        each: &MoveEngagement,
        feed_per_tooth: f64,
    ) -> FeedProfile {
        let air = MoveEngagement { chip: None, effort: None, ..*each };
        let mut profile =
            FeedProfile::new(each.length_mm, self.before.resolution_mm, shares.share(&air));
        let material = self.before.material.as_ref();
        for ([from, to], there) in self.slices.of(number, each, feed_per_tooth, material) {
            let more = to - from;
            profile.lower(from - more, to + more, shares.share(&there));
        }
        profile
    }
}

/// Where the parts of blocks stand in the text in parts.
struct PartLines {
    /// Of each split block: the byte that it begins at, its line in the old text, and how many parts it has.
    split: Vec<(u32, u32, u32)>,
}

impl PartLines {
    fn new(parts: &BlockSplitter, joints: &BlockJoints) -> PartLines {
        let one = |(start, joints): (&u32, &Vec<BlockPoint>)| {
            (*start, parts.line(*start), joints.len() as u32 + 1)
        };
        PartLines { split: joints.iter().map(one).collect() }
    }

    /// The split blocks with the line of their first part in the new text.
    fn first_lines(&self) -> impl Iterator<Item = (u32, u32, u32)> {
        let mut more = 0;
        self.split.iter().map(move |&(start, line, count)| {
            let first = line + more;
            more += count - 1;
            (start, first, count)
        })
    }

    /// Takes out the joints between parts of one feed; says whether there were any.
    fn without_same(
        &self,
        joints: &mut BlockJoints,
        fed: &FeedEdits,
        moves: &[MoveEngagement],
    ) -> bool {
        let starts: HashMap<u32, u32> = moves
            .iter()
            .filter(|each| each.origin.span.file == FileId(0))
            .map(|each| (each.origin.line, each.origin.span.range.start))
            .collect();
        let share = |line: u32| starts.get(&line).and_then(|start| fed.shares.get(start)).copied();
        let mut any = false;
        for (start, first, _) in self.first_lines() {
            let Some(own) = joints.get_mut(&start) else { continue };
            let mut line = first;
            own.retain(|_| {
                line += 1;
                let is_other = share(line - 1) != share(line);
                any |= !is_other;
                is_other
            });
        }
        joints.retain(|_, joints| !joints.is_empty());
        any
    }

    /// What was changed of the old text, by its lines.
    fn changes(&self, old: &[u8], parted: &Job, fed: &FeedEdits) -> Vec<Change> {
        let text = first_text(&fed.new);
        let [old_source, source] = [old, text].map(|text| Source::new("", text));
        let words = |text: &[u8], source: &Source, first: u32, count: u32| {
            let from = source.line_start(first);
            let last = source.line_start(first + count - 1);
            let range = TextRange::new(from, line_end(text, last));
            String::from_utf8_lossy(range.slice(text)).replace('\r', "").trim_end().to_string()
        };
        let mut all: Vec<Change> = self
            .first_lines()
            .zip(&self.split)
            .map(|((_, first, count), &(_, line, _))| Change {
                line,
                before: words(old, &old_source, line, 1),
                after: words(text, &source, first, count),
                reason: super::parts::REASON.into(),
            })
            .collect();
        let blocks: Vec<(u32, u32, u32)> = self.first_lines().collect();
        for change in changes(first_text(parted), &fed.edits) {
            // Lines that the parts before it have put in.
            let before = blocks.iter().take_while(|(_, first, _)| *first <= change.line);
            let (mut more, mut is_part) = (0, false);
            for (_, first, count) in before {
                is_part = change.line < first + count;
                more += count - 1;
            }
            if !is_part {
                all.push(Change { line: change.line - more, ..change });
            }
        }
        all.sort_by_key(|change| change.line);
        all
    }
}
