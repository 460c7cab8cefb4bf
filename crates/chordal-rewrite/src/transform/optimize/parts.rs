//! Blocks written in parts: which can be, and their words.

use std::collections::HashMap;

use chordal::Job;
use chordal::control::{Action, ArcShape, CompensationSide, FeedMode, MotionCode};
use chordal::syntax::{Block, WordValue};

use super::super::arcs::center_words;
use super::super::edit::{WordEdit, with_number};
use super::super::lines::{BlockWords, newline, tail};
use super::super::record::{BlockEffect, BlockPass, RunRecord};
use super::super::roles::actions;
use super::super::writer::WordWriter;
use super::exact::{BlockPoint, CirclePoints, ExactArc, ExactPoints, whole};

pub(super) const REASON: &str = "the block in parts, each with the feed for what the tool meets";

/// Why a block is not split; a clause for people.
pub(super) type SplitObjection = &'static str;

/// No place of the block comes out in the digits of the program, where a split pays.
pub(super) const NO_POINT: SplitObjection =
    "there is no exact point in the digits of the program where it would pay";

/// A block that may be split.
#[derive(Clone, Debug)]
struct SplittableBlock {
    block: Block,
    run: BlockPass,
    from: [i64; 3],
    to: [i64; 3],
    /// Of an arc.
    shape: Option<ArcShape>,
    points: ExactPoints,
}

/// The blocks of a text, as they may be written in parts.
pub(super) struct BlockSplitter<'a> {
    writer: WordWriter<'a>,
    record: RunRecord,
    blocks: HashMap<u32, Block>,
    circles: CirclePoints,
    known: HashMap<u32, Result<SplittableBlock, SplitObjection>>,
}

impl<'a> BlockSplitter<'a> {
    pub fn new(job: &'a Job<'_>) -> BlockSplitter<'a> {
        let writer = WordWriter::new(job);
        let blocks = writer.word_blocks().map(|block| (block.range.start, block)).collect();
        let (circles, known) = (CirclePoints::default(), HashMap::new());
        BlockSplitter { writer, record: RunRecord::of(job), blocks, circles, known }
    }

    /// The line of a block.
    pub fn line(&self, start: u32) -> u32 {
        self.blocks.get(&start).map_or(0, |block| block.line)
    }

    /// The points at which a block may be split, by the byte that it begins at.
    ///
    /// # Errors
    /// Why it may not be.
    pub fn points(&mut self, start: u32) -> Result<&ExactPoints, SplitObjection> {
        if !self.known.contains_key(&start) {
            let whole = self.whole(start);
            self.known.insert(start, whole);
        }
        match &self.known[&start] {
            Ok(whole) => Ok(&whole.points),
            Err(why) => Err(why),
        }
    }

    fn whole(&mut self, start: u32) -> Result<SplittableBlock, SplitObjection> {
        const OTHER: SplitObjection = "other words than those of a line or an arc";
        let (Some(block), Some(runs)) = (self.blocks.get(&start), self.record.blocks.get(&start))
        else {
            return Err(OTHER);
        };
        let run = runs.first;
        if runs.count > 1 {
            return Err("it runs several times");
        }
        if run.context.side != CompensationSide::Off {
            return Err("cutter compensation is active");
        }
        let is_line = run.context.did == BlockEffect::Line;
        if run.moves != 1 || !(is_line || run.context.did == BlockEffect::Arc) {
            return Err("several moves, or a spiral");
        }
        let letters: &[u8] = if is_line { b"XYZNGF" } else { b"XYZIJKRNGF" };
        let has_words = block
            .words
            .iter()
            .all(|word| !word.comma && word.register.is_none() && letters.contains(&word.letter));
        let codes = actions(block, self.writer.control);
        let has_codes = codes
            .map(|(_, action)| action)
            .all(|action| matches!(action, Action::Reading(_)) || is_motion(action));
        let is_all = block.all(b'G').count() == actions(block, self.writer.control).count();
        let is_plain = block.delete.is_none()
            && block.problems.is_empty()
            && block.polar.is_empty()
            && tail(self.writer.text, block).is_some();
        if !(has_words && has_codes && is_all && is_plain)
            || run.context.feed_mode != FeedMode::PerTime
            || run.context.incremental != run.context.incremental_before
        {
            return Err(OTHER);
        }
        if block.words.iter().any(|word| !matches!(word.value, WordValue::Number(_))) {
            return Err("its position is computed");
        }
        if block.word(b'R').is_some() {
            return Err("an arc by R");
        }
        self.exact(block.clone(), run)
    }

    /// The block by whole increments.
    fn exact(&mut self, block: Block, run: BlockPass) -> Result<SplittableBlock, SplitObjection> {
        const BETWEEN: SplitObjection = "its ends are not exact in the digits of the program";
        let increment = self.increment(&run);
        let coordinates = |position: [f64; 6]| -> Option<[i64; 3]> {
            let [x, y, z] = [0, 1, 2].map(|axis| whole(position[axis], increment));
            Some([x?, y?, z?])
        };
        let is_known = run.known.iter().all(|known| (0..3).all(|axis| known.has(axis)));
        let ends = coordinates(run.from).zip(coordinates(run.to)).filter(|_| is_known);
        let Some((from, to)) = ends else { return Err(BETWEEN) };
        for axis in 0..3 {
            let Some(word) = block.last(b"XYZ"[axis]) else {
                if from[axis] != to[axis] {
                    return Err("an axis moves that it does not name");
                }
                continue;
            };
            // A word that says something else is scaled, turned or polar.
            let stated = word.number().map(|n| self.writer.length_mm(run.context.units, n));
            let stated = stated.and_then(|mm| whole(mm, increment));
            let path = if run.context.incremental { to[axis] - from[axis] } else { to[axis] };
            if stated != Some(path) {
                return Err("its words are turned, scaled or polar");
            }
        }
        if run.context.did == BlockEffect::Line {
            let points = ExactPoints::of_line(from, to);
            return Ok(SplittableBlock { block, run, from, to, shape: None, points });
        }
        let Some(shape) = run.shape else { return Err(BETWEEN) };
        let (a, b, normal) = shape.plane.axes();
        if from[normal] != to[normal] {
            return Err("a helix");
        }
        let [first, second] = shape.center.map(|place| whole(place, increment));
        let round = first.zip(second).map(|(first, second)| ExactArc {
            axes: [a, b],
            center: [first, second],
            from,
            to,
            sweep: shape.sweep,
        });
        let points = round.and_then(|round| self.circles.points(&round));
        let Some(points) = points else {
            return Err("its centre or its ends are not exactly on a circle");
        };
        Ok(SplittableBlock { block, run, from, to, shape: Some(shape), points })
    }

    /// The last digit of the program, mm.
    fn increment(&self, run: &BlockPass) -> f64 {
        let units = run.context.units;
        units.mm() / 10f64.powi(i32::from(self.writer.style.digits(units)))
    }

    /// The edits that write a block in parts.
    pub fn edits(&self, start: u32, joints: &[BlockPoint]) -> Vec<WordEdit> {
        let Some(Ok(whole)) = self.known.get(&start) else { return Vec::new() };
        let Some((first, more)) = joints.split_first() else { return Vec::new() };
        let mut edits = self.first(whole, first.at);
        let ends = more.iter().map(|joint| joint.at).chain([whole.to]);
        let mut from = first.at;
        let (end, tail) =
            (newline(self.writer.text), tail(self.writer.text, &whole.block).unwrap_or_default());
        let mut text = String::new();
        for to in ends {
            text += &format!("{end}{}{tail}", self.words(whole, from, to));
            from = to;
        }
        let at = whole.block.range.end + tail.len() as u32;
        edits.push(WordEdit::insert(at, text, REASON));
        edits
    }

    /// What a word of an axis says on the way from one point to another.
    fn number(&self, whole: &SplittableBlock, axis: usize, from: [i64; 3], to: [i64; 3]) -> String {
        let BlockPass { context, .. } = &whole.run;
        let path = if context.incremental { to[axis] - from[axis] } else { to[axis] };
        let old = whole.block.last(b"XYZ"[axis]).and_then(|word| word.number());
        self.writer.length(path as f64 * self.increment(&whole.run), context.units, old, 0)
    }

    /// The edits of the block's own words, for its first part.
    fn first(&self, whole: &SplittableBlock, to: [i64; 3]) -> Vec<WordEdit> {
        let mut edits = Vec::new();
        let mut put_in = BlockWords::default();
        for axis in 0..3 {
            let number = self.number(whole, axis, whole.from, to);
            match whole.block.last(b"XYZ"[axis]) {
                Some(word) => {
                    let new = with_number(self.writer.text, word, &number);
                    edits.push(WordEdit::new(word.range, new, REASON));
                }
                None if to[axis] != whole.from[axis] => {
                    put_in.push(format!("{}{number}", char::from(b"XYZ"[axis])));
                }
                None => {}
            }
        }
        let (gap, words) = (self.writer.style.gap(), put_in.join(self.writer.style.gap()));
        if !words.is_empty() {
            let letters = whole.block.words.iter();
            // An axis that an arc comes back to may have no word: before the centre.
            let center = letters.clone().find(|word| b"IJK".contains(&word.letter));
            let at = center.map_or(whole.block.range.start, |word| word.range.start);
            edits.push(WordEdit::insert(at, format!("{words}{gap}"), REASON));
        }
        edits
    }

    /// The words of a further part.
    fn words(&self, whole: &SplittableBlock, from: [i64; 3], to: [i64; 3]) -> String {
        let mut words = BlockWords::default();
        let is_arc = |axis: usize| {
            whole.shape.is_some_and(|shape| {
                let (a, b, _) = shape.plane.axes();
                axis == a || axis == b
            })
        };
        if let Some(shape) = &whole.shape {
            let code = if shape.sweep > 0.0 { MotionCode::ArcCcw } else { MotionCode::ArcCw };
            let own = actions(&whole.block, self.writer.control)
                .find(|(_, action)| *action == Action::Motion(code));
            let own = own.map(|(word, _)| self.writer.word(word));
            words
                .push(own.or_else(|| self.writer.g_code(Action::Motion(code))).unwrap_or_default());
        }
        for axis in 0..3 {
            if is_arc(axis) || from[axis] != to[axis] {
                let number = self.number(whole, axis, from, to);
                words.push(format!("{}{number}", char::from(b"XYZ"[axis])));
            }
        }
        let gap = self.writer.style.gap();
        if let Some(shape) = &whole.shape {
            let increment = self.increment(&whole.run);
            let mut start = whole.run.from;
            for axis in 0..3 {
                start[axis] = from[axis] as f64 * increment;
            }
            let context = &whole.run.context;
            let centers =
                center_words(&self.writer, shape, start, context.arc_center, context.units);
            words.push(centers.join(gap));
        }
        words.join(gap)
    }
}

fn is_motion(action: Action) -> bool {
    let line = MotionCode::Linear;
    let all = [line, MotionCode::ArcCw, MotionCode::ArcCcw];
    all.into_iter().any(|code| action == Action::Motion(code))
}
