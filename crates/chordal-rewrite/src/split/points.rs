//! Where a program may be split: before tool changes, and where the tool stands above all cuts.

use chordal::RunSink;
use chordal::control::CodeRow;
use chordal::control::{Action, AfterCode, CallCode, ModeCode, OnceCode, SurfaceCode};
use chordal::machine::AXIS_LETTERS;
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

use chordal::control::{CallPath, CompensationSide, Modal, Origin};
use chordal::syntax::Block;
use chordal::{Command, CommandKind, Control, Diagnostic, Job, Sink};

use crate::source::SourceBlocks;

/// What makes a place safe.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum SafePointKind {
    /// A tool change follows.
    ToolChange,
    /// The tool is above all cuts of its work offset.
    Clear,
}

/// A place between two blocks of the main program.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct SplitPoint {
    /// The block after it.
    pub(super) at: usize,
    /// How many blocks were carried out before it.
    pub(super) ran: u32,
    pub(super) kind: SafePointKind,
    /// Where the tool stands, mm, and in which work offset.
    pub(super) height: (f64, u32),
    /// How many cuts were made before it.
    pub(super) cuts: u32,
}

/// A run, as far as splitting it goes.
#[derive(Debug)]
pub(super) struct SplitSurvey {
    /// In order, each once.
    pub(super) points: Vec<SplitPoint>,
    /// The last block of the main program that was carried out.
    pub(super) end: usize,
    /// How many cuts it makes.
    pub(super) cuts: u32,
    /// M codes that may last and that nothing is known of, with the line of the first.
    pub(super) unknown: BTreeMap<String, u32>,
    /// By subprogram: the blocks of the main program that carry it out, in order.
    pub(super) users: Vec<Vec<usize>>,
}

impl SplitSurvey {
    pub(super) fn of(job: &Job, source: &SourceBlocks, main: &Range<usize>) -> SplitSurvey {
        let mut walk = SplitPointFinder {
            source,
            control: job.control(),
            main: main.clone(),
            survey: SplitSurvey {
                points: Vec::new(),
                end: main.start,
                cuts: 0,
                unknown: BTreeMap::new(),
                users: vec![Vec::new(); source.subs.len()],
            },
            ran: 0,
            cuts: HashMap::new(),
            lowest: None,
            open: SplitObstacles::default(),
            settled: false,
        };
        job.run(&mut walk);
        let SplitPointFinder { mut survey, cuts, .. } = walk;
        let all = survey.cuts;
        survey.points.retain(|point| point.cuts > 0 && point.cuts < all);
        // Between a tool change and the first cut, the change would be made twice.
        let mut changed = None;
        survey.points.retain(|point| {
            let is_change = point.kind == SafePointKind::ToolChange;
            changed = if is_change { Some(point.cuts) } else { changed };
            is_change || changed != Some(point.cuts)
        });
        survey.points.retain(|point| {
            let (height, work) = point.height;
            let highest = cuts.get(&work).copied().unwrap_or(f64::NEG_INFINITY);
            point.kind == SafePointKind::ToolChange || height > highest
        });
        survey
    }
}

/// What keeps a program from being split for as long as it lasts.
#[derive(Debug, Default)]
struct SplitObstacles {
    /// G52, G92: where the program's zero lies is not said again.
    shift: bool,
    /// A modal macro call.
    call: bool,
    /// A code that Chordal does not carry out may be active.
    unknown: bool,
    /// Offsets were written by increments.
    data: bool,
    /// Coordinates are rotated.
    rotation: bool,
    /// Coordinates are scaled.
    scaling: bool,
    /// Coordinates are mirrored.
    mirror: bool,
    /// End points are polar.
    polar: bool,
    /// Coordinates lie on a face or a cylinder.
    surface: bool,
}

struct SplitPointFinder<'s, 'a> {
    source: &'s SourceBlocks<'a>,
    control: &'s Control,
    main: Range<usize>,
    survey: SplitSurvey,
    ran: u32,
    /// By work offset: the highest place of a cut, but for those that lead straight up.
    cuts: HashMap<u32, f64>,
    /// The same in the block under way.
    lowest: Option<f64>,
    open: SplitObstacles,
    /// Neither compensation nor a cycle was active after the last block.
    settled: bool,
}

impl SplitPointFinder<'_, '_> {
    /// Notes what a block opens and closes.
    fn follow(&mut self, block: &Block) {
        for word in &block.words {
            let Some(row) = self.control.row_of(word) else { continue };
            match row.action {
                Action::Once(code) => self.follow_once(block, code),
                Action::Call(code) => {
                    self.open.call |= matches!(code, CallCode::ModalMacroCall { .. });
                }
                Action::Mode(ModeCode::ModalSubroutine) => self.open.call = true,
                Action::Mode(ModeCode::ModalCallOff) => self.open.call = false,
                Action::Mode(ModeCode::RotationOff) => self.open.rotation = false,
                Action::Mode(ModeCode::ScalingOff) => self.open.scaling = false,
                Action::Mode(ModeCode::Polar { on }) => self.open.polar = on,
                Action::NotSimulated | Action::NotFollowed if word.letter == b'G' => {
                    self.open.unknown = true
                }
                Action::NotSimulated | Action::NotFollowed => {
                    self.note_unknown(row, word.letter, block.line)
                }
                Action::After(AfterCode::ShopCode) => {
                    self.note_unknown(row, word.letter, block.line);
                }
                Action::Reading(_)
                | Action::Before(_)
                | Action::Mode(_)
                | Action::Length(_)
                | Action::Motion(_)
                | Action::Cycle(_)
                | Action::After(_)
                | Action::NoEffect => {}
            }
        }
    }

    fn note_unknown(&mut self, row: &CodeRow, letter: u8, line: u32) {
        self.survey.unknown.entry(row.name(letter)).or_insert(line);
    }

    /// Shifts and presets open something that a part must not begin within.
    fn follow_once(&mut self, block: &Block, code: OnceCode) {
        match code {
            OnceCode::LocalShift | OnceCode::PresetPosition | OnceCode::RestorePreset => {
                let axes = block
                    .words
                    .iter()
                    .filter(|word| AXIS_LETTERS.as_bytes().contains(&word.letter));
                let is_zero = |number: chordal::syntax::Decimal| number.is_zero();
                let ends = code == OnceCode::LocalShift
                    && axes.clone().count() > 0
                    && axes.clone().all(|word| word.number().is_some_and(is_zero));
                self.open.shift = !ends;
            }
            OnceCode::ClearPreset { .. } => self.open.shift = false,
            OnceCode::Rotation => self.open.rotation = true,
            OnceCode::Scaling => self.open.scaling = true,
            OnceCode::Mirror { .. } => self.open.mirror = true,
            OnceCode::MirrorOff => self.open.mirror = false,
            OnceCode::Surface(code) => self.open.surface = begins(block, code),
            OnceCode::Dwell
            | OnceCode::SetData
            | OnceCode::ReturnToReference { .. }
            | OnceCode::ReturnFromReference
            | OnceCode::Home
            | OnceCode::MachineCoordinates
            | OnceCode::CircularPocketCw
            | OnceCode::CircularPocketCcw
            | OnceCode::GeneralPocket
            | OnceCode::Engraving
            | OnceCode::Pattern(_)
            | OnceCode::Probe { .. }
            | OnceCode::Turning(_)
            | OnceCode::CornerArcAlone => {}
        }
    }

    fn is_closed(&self) -> bool {
        let SplitObstacles {
            shift,
            call,
            unknown,
            data,
            rotation,
            scaling,
            mirror,
            polar,
            surface,
        } = self.open;
        !(shift || call || unknown || data || rotation || scaling || mirror || polar || surface)
    }

    /// The place before a tool change, remarks before it included.
    fn before(&mut self, at: usize, modal: &Modal) {
        let is_remark = |at: &usize| {
            let block = &self.source.blocks[*at];
            block.words.is_empty() && block.kind == chordal::syntax::BlockKind::Words
        };
        let remarks = (self.main.start..at).rev().take_while(is_remark).count();
        let at = at - remarks;
        self.forget(at);
        if self.settled && self.is_closed() && self.ran > 0 {
            let height = (f64::INFINITY, modal.work.ordinal());
            let (ran, cuts) = (self.ran, self.survey.cuts);
            self.survey.points.push(SplitPoint {
                at,
                ran,
                kind: SafePointKind::ToolChange,
                height,
                cuts,
            });
        }
    }

    /// Takes back the places from a block on.
    fn forget(&mut self, from: usize) {
        while self.survey.points.last().is_some_and(|point| point.at >= from) {
            self.survey.points.pop();
        }
    }

    fn after_block(&mut self, at: usize, modal: &Modal) {
        self.forget(at + 1);
        let is_known = (0..3).all(|axis| modal.known.has(axis));
        if is_known && self.settled && self.is_closed() && at + 1 < self.main.end {
            let height = (modal.position[2], modal.work.ordinal());
            let (ran, cuts) = (self.ran + 1, self.survey.cuts);
            self.survey.points.push(SplitPoint {
                at: at + 1,
                ran,
                kind: SafePointKind::Clear,
                height,
                cuts,
            });
        }
    }
}

impl Sink for SplitPointFinder<'_, '_> {
    fn command(&mut self, command: &Command) {
        if matches!(command.kind, CommandKind::Rapid { .. }) {
            return;
        }
        let Some(motion) = command.kind.motion() else { return };
        self.survey.cuts += 1;
        let leads_up = motion.from[..2] == motion.to[..2]
            && motion.to[2] > motion.from[2]
            && command.kind.shape().is_none();
        if !leads_up {
            let height = self.lowest.unwrap_or(f64::NEG_INFINITY);
            self.lowest = Some(height.max(motion.to[2]));
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for SplitPointFinder<'_, '_> {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, modal: &dyn Fn() -> Modal) {
        let modal = modal();
        if let Some(height) = self.lowest.take() {
            let highest = self.cuts.entry(modal.work.ordinal()).or_insert(f64::NEG_INFINITY);
            *highest = highest.max(height);
        }
        let block = self.source.block_at(origin.span);
        let is_main = origin.call == CallPath::default();
        if let Some(at) = block {
            let block = &self.source.blocks[at];
            if is_main && self.main.contains(&at) && self.source.changes_tool(at, self.control) {
                self.before(at, &modal);
            }
            self.follow(block);
            self.open.data |= modal.incremental
                && self.source.has_action(at, self.control, |action| {
                    action == Action::Once(OnceCode::SetData)
                });
        }
        // `,R` and `,C` need the next move.
        let corner = block.is_some_and(|at| self.source.blocks[at].commas);
        self.settled = modal.side == CompensationSide::Off && modal.cycle.is_none() && !corner;
        match block {
            Some(at) if is_main && self.main.contains(&at) => {
                self.after_block(at, &modal);
                self.survey.end = self.survey.end.max(at);
            }
            Some(at) => {
                // The place after the calling block lies within the call.
                self.survey
                    .points
                    .pop_if(|point| point.kind == SafePointKind::Clear && point.ran == self.ran);
                let main = self.survey.end;
                if let Some(sub) = self.source.sub_of(at) {
                    let users = &mut self.survey.users[sub];
                    if users.last() != Some(&main) {
                        users.push(main);
                    }
                }
            }
            None => {}
        }
        self.ran += 1;
    }
}

/// Whether a code begins polar or cylindrical interpolation: a cylinder without a radius ends it.
fn begins(block: &Block, code: SurfaceCode) -> bool {
    match code {
        SurfaceCode::Face => true,
        SurfaceCode::FaceOff => false,
        SurfaceCode::Cylinder => block
            .words
            .iter()
            .filter(|word| AXIS_LETTERS.as_bytes().contains(&word.letter) || word.letter == b'R')
            .any(|word| word.number().is_none_or(|number| !number.is_zero())),
    }
}
