//! Records the sections of a run while it is cut.

use std::collections::BTreeMap;

use chordal_geometry::Vec2;
use chordal_stock::lathe::{LatheStock, OutlineSegment, Region};

use super::gather::TurnMove;
use super::replay::{TurnedPiece, TurnedReplay, TurnedShape};
use super::report::CutOffPart;
use super::tools::{LatheTool, NoOutline};

/// Most segments of a run that are compared with those of the section before; after that only the section after each
/// tool is kept.
const MAX_SEGMENTS: usize = 20_000_000;

/// The identity of a segment: its coordinates, bit by bit, and its tag.
type SegmentKey = ([u64; 7], u32);

fn key(segment: &OutlineSegment) -> SegmentKey {
    let (center, sense) = match segment.bend {
        None => (Vec2::ZERO, 0),
        Some(bend) => (bend.center, 1 + u64::from(bend.counterclockwise)),
    };
    let [a, b, c] = [segment.start, segment.end, center].map(|p| [p.a.to_bits(), p.b.to_bits()]);
    ([a[0], a[1], b[0], b[1], c[0], c[1], sense], segment.tag)
}

/// Records the sections of a run.
#[derive(Debug)]
pub(super) struct SectionRecorder {
    replay: TurnedReplay,
    /// The indices of the pieces of the last section.
    now: BTreeMap<SegmentKey, usize>,
    loose: usize,
    compared: usize,
    has_cut: bool,
    /// Path segment and tool of the last pass whose section is not recorded yet.
    due: Option<(u32, u32)>,
}

impl SectionRecorder {
    pub fn new(stock: &Region) -> SectionRecorder {
        let mut recorder = SectionRecorder {
            replay: TurnedReplay { is_whole: true, ..TurnedReplay::default() },
            now: BTreeMap::new(),
            loose: 0,
            compared: 0,
            has_cut: false,
            due: None,
        };
        recorder.keep(stock, 0);
        recorder
    }

    pub fn fixture(&mut self, name: &str, section: &Region) {
        self.replay.fixtures.push((name.to_string(), section.clone()));
    }

    /// Called before a move.
    pub fn begin(&mut self, move_: &TurnMove, stock: &LatheStock) {
        if self.due.is_some_and(|(_, tool)| tool != move_.tool) {
            self.settle(&stock.region());
        }
    }

    /// Called where the move removes something.
    pub fn cuts(&mut self) {
        self.has_cut = true;
    }

    /// Called after a move.
    pub fn end(&mut self, move_: &TurnMove, stock: &LatheStock, loose: &[CutOffPart]) {
        let comes_off = loose.len() > self.loose;
        if !std::mem::take(&mut self.has_cut) && !comes_off {
            return;
        }
        self.due = Some((move_.row, move_.tool));
        if self.compared <= MAX_SEGMENTS || comes_off {
            self.settle(&stock.region());
        } else {
            self.replay.is_whole = false;
        }
        for part in &loose[self.loose..] {
            let from = self.replay.rows.len() as u32;
            let pieces = part.section.outline().into_iter().flatten();
            let pieces = pieces.map(|segment| TurnedPiece {
                segment,
                from,
                until: u32::MAX,
                is_loose: true,
            });
            self.replay.pieces.extend(pieces);
        }
        self.loose = loose.len();
    }

    /// Records the section after the pass that is due.
    fn settle(&mut self, section: &Region) {
        let Some((row, _)) = self.due.take() else { return };
        self.replay.rows.push(row);
        self.keep(section, self.replay.rows.len() as u32);
    }

    fn keep(&mut self, section: &Region, number: u32) {
        let mut now = BTreeMap::new();
        for segment in section.outline().into_iter().flatten() {
            self.compared += 1;
            let key = key(&segment);
            let at = self.now.remove(&key).unwrap_or_else(|| {
                let piece = TurnedPiece { segment, from: number, until: u32::MAX, is_loose: false };
                self.replay.pieces.push(piece);
                self.replay.pieces.len() - 1
            });
            now.insert(key, at);
        }
        for at in std::mem::replace(&mut self.now, now).into_values() {
            self.replay.pieces[at].until = number;
        }
    }

    /// Completes the replay after the run; `section` is what is left in the chuck.
    pub fn finish(
        mut self,
        section: &Region,
        tools: &BTreeMap<u32, Result<LatheTool, NoOutline>>,
        moves: &[TurnMove],
    ) -> TurnedReplay {
        self.settle(section);
        for piece in &mut self.replay.pieces {
            let made_by = (piece.segment.tag as usize).checked_sub(1);
            let tool = made_by.and_then(|number| moves.get(number)).map_or(0, |move_| move_.tool);
            piece.segment.tag = tool;
        }
        let tools = tools.iter().filter_map(|(number, tool)| {
            let tool = tool.as_ref().ok()?;
            let bodies = [&tool.shank, &tool.holder].into_iter().flatten();
            let body = bodies.flat_map(|body| body.outlines()).collect();
            Some((*number, TurnedShape { edges: tool.edges.outlines(), body }))
        });
        self.replay.tools = tools.collect();
        self.replay
    }
}
