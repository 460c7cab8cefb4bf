//! The blocks of a program with the heights in their Z words.
//!
//! Rapids go to the Z of the program and as much above it as the map is high anywhere: they are never nearer to
//! the surface than they were. Cuts follow the surface.

use std::collections::{HashMap, HashSet};

use chordal::Job;
use chordal::control::{Action, ArcShape, MotionCode, Units};
use chordal::diagnostics::TextRange;
use chordal::geometry::Plane;
use chordal::syntax::{Block, Word};

use super::super::arcs::center_words;
use super::super::edit::{TransformRefusal, WordEdit, line_end, replace_words, with_number};
use super::super::fit::center;
use super::super::lines::{BlockWords, newline};
use super::super::record::{BlockEffect, BlockPass, BlockRuns, RunRecord};
use super::super::roles::{NumberRole, actions, roles};
use super::super::writer::WordWriter;
use super::HeightOptions;
use super::checks;
use super::grid::HeightMap;
use super::levels::{ZLevel, is_machine, levels};
use super::plane_path::PlanePath;

const REASON: &str = "the height of the map";
/// Steps of the last digit that rounding the ends of a piece may take it off.
const ROUNDING_STEPS: f64 = 2.0;

/// What was written, for the proof: by the first byte of an old block.
#[derive(Debug, Default)]
pub(super) struct WrittenTrail {
    /// Blocks that became several, and how many.
    pub(super) pieces: HashMap<u32, u32>,
    /// Blocks that go to places of the machine, or aside from one: they stay.
    pub(super) level: HashSet<u32>,
}

pub(super) struct HeightEdits {
    pub(super) edits: Vec<WordEdit>,
    pub(super) notes: Vec<String>,
    pub(super) trail: WrittenTrail,
}

/// The edits that bend a program over a map.
pub(super) fn write(
    job: &Job,
    map: &HeightMap,
    warp: &HeightOptions,
) -> Result<HeightEdits, TransformRefusal> {
    let writer = WordWriter::new(job);
    let record = RunRecord::of(job);
    if let Some((file, line)) = record.in_other_text {
        let name = job.sources().get(file).map_or("", |source| source.name());
        return Err(TransformRefusal {
            line,
            text: String::new(),
            what: format!("line {line} of {name} moves, and only the first file is changed"),
            help: "copy the subprogram into the program".into(),
        });
    }
    let blocks: Vec<Block> = writer.word_blocks().collect();
    let levels = levels(&writer, &record, &blocks);
    let written =
        HeightEdits { edits: Vec::new(), notes: Vec::new(), trail: WrittenTrail::default() };
    let mut bender = HeightWriter {
        writer,
        map,
        rise: map.rise(),
        warp,
        levels,
        written,
        work: None,
        units: None,
    };
    let mut idle = Vec::new();
    for (index, block) in blocks.iter().enumerate() {
        let alone = blocks.get(index + 1).is_none_or(|next| next.line > block.line);
        match record.blocks.get(&block.range.start) {
            Some(runs) => bender.block(block, runs, alone)?,
            None if b"XYZ".iter().any(|axis| block.letters().has(*axis)) => idle.push(block.line),
            None => {}
        }
    }
    if let [first, ..] = idle[..] {
        let count = idle.len();
        let runs = if count == 1 { "block never runs" } else { "blocks never run" };
        let note = format!("{count} {runs}, left unchanged, the first on line {first}");
        bender.written.notes.push(note);
    }
    Ok(bender.written)
}

struct HeightWriter<'a> {
    writer: WordWriter<'a>,
    map: &'a HeightMap,
    /// How far rapids are raised, mm.
    rise: f64,
    warp: &'a HeightOptions,
    levels: HashMap<u32, ZLevel>,
    written: HeightEdits,
    /// The work offset of the program, and its units.
    work: Option<String>,
    units: Option<Units>,
}

/// The end of a piece: as it is written.
struct CorrectedPiece {
    to: [f64; 3],
    sweep: f64,
}

impl HeightWriter<'_> {
    fn refuse(&self, block: &Block, what: impl Into<String>, help: &str) -> TransformRefusal {
        TransformRefusal::new(self.writer.text, block, what, help)
    }

    fn block(
        &mut self,
        block: &Block,
        runs: &BlockRuns,
        alone: bool,
    ) -> Result<(), TransformRefusal> {
        let start = block.range.start;
        let run = &runs.first;
        checks::codes(&self.writer, block, &mut self.work)?;
        if run.context.did == BlockEffect::Nothing || run.moves == 0 {
            return Ok(());
        }
        if is_machine(&self.writer, block) {
            self.written.trail.level.insert(start);
            return Ok(());
        }
        checks::of_move(&self.writer, block, runs)?;
        let units = *self.units.get_or_insert(run.context.units);
        if units != run.context.units {
            return Err(self.refuse(
                block,
                "the program moves in inches and in millimetres, and the map is in one of them",
                "write it in one of them first: --units mm or --units inch in the same command",
            ));
        }
        let level = self.levels.get(&start).copied().unwrap_or_default();
        if run.context.did == BlockEffect::Rapid {
            self.rapid(block, run, level);
            return Ok(());
        }
        let moves_aside = run.from[..2] != run.to[..2] || run.context.did == BlockEffect::Arc;
        let knows = (0..3).all(|axis| run.known[1].has(axis));
        if !knows || (moves_aside && level == ZLevel::Machine) {
            return Err(self.refuse(
                block,
                "the height that the cut begins at is not given by the program",
                "program X and Y, then Z, before the first cut",
            ));
        }
        self.cut(block, run, level, alone)
    }

    fn number(&self, run: &BlockPass, mm: f64) -> (String, f64) {
        let units = run.context.units;
        let number = self.writer.length(mm, units, None, 0);
        let value = number.parse::<f64>().unwrap_or(f64::NAN) * units.mm();
        (number, value)
    }

    /// The Z of a cut at a place, as it is written, mm.
    fn on_surface(&self, run: &BlockPass, at: [f64; 3]) -> f64 {
        self.number(run, at[2] + self.map.height([at[0], at[1]])).1
    }

    /// A rapid: its Z above the whole map; aside from a cut it is lifted to there before.
    fn rapid(&mut self, block: &Block, run: &BlockPass, level: ZLevel) {
        let rise = self.rise;
        let aside = run.from[..2] != run.to[..2] || !run.known[0].has(0) || !run.known[0].has(1);
        if level == ZLevel::Cut && aside {
            let (number, value) = self.number(run, run.from[2] + rise);
            if value != self.on_surface(run, [run.from[0], run.from[1], run.from[2]]) {
                let code =
                    self.writer.g_code(Action::Motion(MotionCode::Rapid)).unwrap_or_default();
                let gap = self.writer.style.gap();
                let line = format!("{code}{gap}Z{number}{}", newline(self.writer.text));
                self.written.edits.push(WordEdit::insert(block.range.start, line, REASON));
                self.written.trail.pieces.insert(block.range.start, 2);
            }
        }
        match block.last(b'Z') {
            Some(word) => self.put_z(run, word, run.to[2] + rise),
            None if level == ZLevel::Machine => {
                self.written.trail.level.insert(block.range.start);
            }
            None => {}
        }
    }

    /// Another Z in the place of one that is written.
    fn put_z(&mut self, run: &BlockPass, word: &Word, mm: f64) {
        if self.number(run, mm).1 == run.to[2] {
            return;
        }
        let number = self.writer.length(mm, run.context.units, word.number(), 0);
        let text = with_number(self.writer.text, word, &number);
        self.written.edits.push(WordEdit::new(word.range, text, REASON));
    }

    fn cut(
        &mut self,
        block: &Block,
        run: &BlockPass,
        level: ZLevel,
        alone: bool,
    ) -> Result<(), TransformRefusal> {
        let path = plane_path(run);
        if !self.warp.clamp {
            checks::inside(&self.writer, self.map, block, run, &path)?;
        }
        let step = run.context.units.mm()
            * 0.1f64.powi(i32::from(self.writer.style.digits(run.context.units)));
        // On a slope a place that is rounded aside has another height as well.
        let [low, high] = path.bounds();
        let rounded = ROUNDING_STEPS * step * (1.0 + self.map.steepest(low, high));
        let left = self.warp.tolerance_mm - rounded;
        if left < step {
            let unit = run.context.units.mm();
            let what = format!(
                "the numbers of the program are rounded to {}, which takes up {:.4} of the tolerance of {:.4}",
                step / unit,
                rounded / unit,
                self.warp.tolerance_mm / unit
            );
            return Err(self.refuse(block, what, "allow a larger tolerance: --heights-tolerance"));
        }
        let ends = path.pieces(self.map, left).map_err(|_| {
            self.refuse(block, "the move crosses too many points of the map", "use fewer points")
        })?;
        let mut pieces = self.rounded(run, &path, &ends);
        let begin = [run.from[0], run.from[1], self.on_surface(run, point(run))];
        let is_aside = run.from[..2] != run.to[..2] || run.context.did == BlockEffect::Arc;
        if level == ZLevel::Rapid
            && is_aside
            && begin[2] != self.number(run, run.from[2] + self.rise).1
        {
            if run.context.did == BlockEffect::Arc {
                return Err(self.refuse(
                    block,
                    "the arc begins at the height of a rapid",
                    "go down to its height with G1 before",
                ));
            }
            // From the level of rapids down to the surface first, at the feed of the cut.
            pieces.insert(0, CorrectedPiece { to: begin, sweep: 0.0 });
        }
        if let [only] = &pieces[..] {
            self.one(block, run, only.to[2], begin[2]);
            return Ok(());
        }
        checks::several(&self.writer, block, run, alone)?;
        self.several(block, run, &pieces);
        Ok(())
    }

    /// The ends of pieces as they are written; those that come to nothing are left out.
    fn rounded(&self, run: &BlockPass, path: &PlanePath, ends: &[f64]) -> Vec<CorrectedPiece> {
        let sweep = run.shape.map_or(0.0, |shape| shape.sweep);
        let mut pieces: Vec<CorrectedPiece> = Vec::new();
        let (mut at, mut before) = (point(run), 0.0);
        for (index, end) in ends.iter().enumerate() {
            let is_last = index + 1 == ends.len();
            let [x, y] = match is_last {
                true => [run.to[0], run.to[1]],
                false => path.at(*end).map(|value| self.number(run, value).1),
            };
            if [x, y] == at[..2] && !is_last {
                continue;
            }
            let rise = (run.to[2] - run.from[2]) * end;
            let to = [x, y, self.on_surface(run, [x, y, run.from[2] + rise])];
            pieces.push(CorrectedPiece { to, sweep: sweep * (end - before) });
            (at, before) = (to, *end);
        }
        pieces
    }

    /// A cut that stays one block, from one Z to another.
    fn one(&mut self, block: &Block, run: &BlockPass, z: f64, before: f64) {
        if let Some(word) = block.last(b'Z') {
            self.put_z(run, word, z);
            return;
        }
        if z == before {
            return;
        }
        let (number, _) = self.number(run, z);
        let gap = self.writer.style.gap();
        let last = block.words.iter().rposition(|word| b"XY".contains(&word.letter));
        let edit = match last {
            Some(at) => {
                WordEdit::insert(block.words[at].range.end, format!("{gap}Z{number}"), REASON)
            }
            None => {
                let center = block.words.iter().find(|word| b"IJKR".contains(&word.letter));
                let Some(word) = center else { return };
                WordEdit::insert(word.range.start, format!("Z{number}{gap}"), REASON)
            }
        };
        self.written.edits.push(edit);
    }

    fn several(&mut self, block: &Block, run: &BlockPass, pieces: &[CorrectedPiece]) {
        let text = self.writer.text;
        let lines = self.lines(run, pieces);
        let roles = roles(block, &run.context, self.writer.control);
        let is_shape = |(word, role): &(&Word, &NumberRole)| {
            matches!(role, NumberRole::Place(_) | NumberRole::Center(_) | NumberRole::Spoke(_))
                || (word.letter == b'R' && **role == NumberRole::Length)
        };
        let both = block.words.iter().zip(&roles).filter(is_shape);
        let old: Vec<Word> = both.map(|(word, _)| *word).collect();
        self.written.edits.extend(replace_words(text, &old, &lines[0], REASON));
        let end = line_end(text, block.range.end);
        let rest = TextRange::new(block.range.end, end).slice(text);
        let tail = if rest.trim_ascii_end().ends_with(b";") { ";" } else { "" };
        let line_feed = newline(text);
        let code = self.code_of(block, run);
        let gap = self.writer.style.gap();
        let more: String = lines[1..]
            .iter()
            .map(|line| match &code {
                Some(code) => format!("{line_feed}{code}{gap}{line}{tail}"),
                None => format!("{line_feed}{line}{tail}"),
            })
            .collect();
        self.written.edits.push(WordEdit::insert(end, more, REASON));
        self.written.trail.pieces.insert(block.range.start, pieces.len() as u32);
    }

    /// The code that each further piece begins with: not every control goes on with an arc.
    fn code_of(&self, block: &Block, run: &BlockPass) -> Option<String> {
        if run.context.did != BlockEffect::Arc {
            return None;
        }
        let own = actions(block, self.writer.control)
            .find(|(_, action)| matches!(action, Action::Motion(_)))
            .map(|(word, _)| self.writer.word(word));
        own.or_else(|| {
            let is_ccw = run.shape.is_some_and(|shape| shape.sweep > 0.0);
            let code = if is_ccw { MotionCode::ArcCcw } else { MotionCode::ArcCw };
            self.writer.g_code(Action::Motion(code))
        })
    }

    /// The words of each piece.
    fn lines(&self, run: &BlockPass, pieces: &[CorrectedPiece]) -> Vec<String> {
        let mut at = [run.from[0], run.from[1], f64::NAN];
        let units = run.context.units;
        let gap = self.writer.style.gap();
        let mut lines = Vec::new();
        for piece in pieces {
            let mut words = BlockWords::default();
            for (axis, (to, from)) in piece.to.into_iter().zip(at).enumerate() {
                let is_arc_end = run.shape.is_some() && axis < 2;
                if is_arc_end || to != from {
                    let number = self.writer.length(to, units, None, 0);
                    words.push(format!("{}{number}", char::from(b"XYZ"[axis])));
                }
            }
            if let Some(shape) = run.shape {
                let shape = ArcShape {
                    center: center(Plane::Xy, at, piece.to, piece.sweep),
                    sweep: piece.sweep,
                    ..shape
                };
                let from = [at[0], at[1], at[2], 0.0, 0.0, 0.0];
                let rule = run.context.arc_center;
                words.push(center_words(&self.writer, &shape, from, rule, units).join(gap));
            }
            lines.push(words.join(gap));
            at = piece.to;
        }
        lines
    }
}

/// Where a move begins.
fn point(run: &BlockPass) -> [f64; 3] {
    [run.from[0], run.from[1], run.from[2]]
}

/// The way of a cut in X and Y.
fn plane_path(run: &BlockPass) -> PlanePath {
    let [from, to] = [run.from, run.to].map(|at| [at[0], at[1]]);
    match run.shape.filter(|_| run.context.did == BlockEffect::Arc) {
        Some(shape) => arc(&shape, from),
        None => PlanePath::Line { from, to },
    }
}

/// The way of an arc from a place.
pub(super) fn arc(shape: &ArcShape, from: [f64; 2]) -> PlanePath {
    let out = [from[0] - shape.center[0], from[1] - shape.center[1]];
    PlanePath::Arc {
        center: shape.center,
        radius: out[0].hypot(out[1]),
        start: libm::atan2(out[1], out[0]),
        sweep: shape.sweep,
    }
}
