//! What a run does from a block on, to hold it against another run.

use std::f64::consts::TAU;
use std::ops::Range;
use std::rc::Rc;

use chordal::control::{
    ArcShape, AxisMask, CallPath, Feed, Modal, Move, Origin, Position, SpindleState, StateItem,
    StateValue, WrittenOffset,
};
use chordal::machine::{AXES, RolloverRule};
use chordal::{CommandKind, Effect, Job, Severity, SourceMap};

use crate::walk::{BlockOutput, WalkedBlock, walk};

/// Numbers nearer than this are the same: mm, rad, mm/s.
const EQUAL_NUMBER: f64 = 1e-9;

/// What a control keeps that most blocks do not change.
#[derive(Debug, PartialEq)]
struct KeptState {
    codes: Vec<String>,
    spindle: SpindleState,
    /// The spindle keeps a cutting speed.
    follows: bool,
    /// What may be compared, item by item.
    items: Vec<(StateItem, StateValue)>,
}

impl KeptState {
    /// The entry of the tool in the spindle in the table of tools, where the program has written it.
    fn tool_entry(&self) -> Option<&Vec<Option<f64>>> {
        let value = |searched: StateItem| {
            self.items.iter().find(|(item, _)| *item == searched).map(|(_, value)| value)
        };
        let Some(StateValue::Numbers(tool)) = value(StateItem::Tool) else { return None };
        let Some(StateValue::Places(places)) = value(StateItem::Tables) else { return None };
        let name = format!("{:?}", WrittenOffset::Tool(*tool.first()? as u32));
        places.iter().find(|(own, _)| *own == name).map(|(_, values)| values)
    }
}

/// What holds after a block. A run has many of them: what is the same as after the block before is kept once.
#[derive(Debug)]
struct BlockEndState {
    position: Position,
    work_position: Position,
    machine_position: Position,
    known: AxisMask,
    /// The axes that are still where the run began.
    unmoved: AxisMask,
    machine_known: AxisMask,
    kept: Rc<KeptState>,
}

/// A thing that happens.
#[derive(Debug)]
#[allow(clippy::large_enum_variant, reason = "most of them are commands and states")]
enum TraceEvent {
    Command(CommandKind),
    /// A block is done: what holds after it.
    Done(BlockEndState),
    /// An alarm of the control.
    Alarm(&'static str),
    /// A text for the operator.
    Message(String),
}

impl TraceEvent {
    /// A cut, or a move of Z to a place relative to the part: it goes wrong with another length offset.
    fn needs_height(&self) -> bool {
        let TraceEvent::Command(kind) = self else { return false };
        let Some(motion) = kind.motion() else { return false };
        let moves_z =
            motion.to_known.has(2) && (!motion.from_known.has(2) || motion.from[2] != motion.to[2]);
        moves_z || !matches!(kind, CommandKind::Rapid { .. })
    }
}

/// A thing that happens, and where the program says it.
#[derive(Debug)]
struct TraceStep {
    what: TraceEvent,
    /// The block, by its first byte in its file.
    at: (u32, u32),
    line: u32,
}

/// All that happens from a block of the main program on.
#[derive(Debug, Default)]
pub(super) struct EventTrace {
    steps: Vec<TraceStep>,
    /// How many moves there are.
    pub(super) moves: u64,
    /// What holds at its begin.
    begin: Option<Rc<KeptState>>,
    /// The axes that have not moved before it.
    unmoved: AxisMask,
    /// Variables that hold something over the end of the program.
    kept: Vec<(u32, Option<f64>)>,
    /// The rotary axes that reach an angle whatever turn they are in: of their places whole turns do not count.
    pub(super) rolling: AxisMask,
}

/// How much must be the same.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct MatchLevel {
    /// Both programs come from the same place. Otherwise rapids may come from elsewhere, and cuts may not.
    pub(super) exact: bool,
    /// A cut or a move of Z has been made: from there on the length offset counts.
    pub(super) settled: bool,
    /// The spindle keeps a cutting speed: its revolutions follow the diameter, which is another one until both have moved.
    pub(super) follows: bool,
    /// The rotary axes of whose places whole turns do not count.
    pub(super) rolling: AxisMask,
    /// The axes that in one of the programs have not moved yet: nobody knows where they stand when the new one begins.
    pub(super) unmoved: AxisMask,
    /// Items that no block of the language takes from those before it.
    pub(super) free_items: &'static [StateItem],
}

/// Where two runs are first not the same.
#[derive(Debug)]
pub(super) struct FirstMismatch {
    /// Line of the old program.
    pub(super) line: u32,
    pub(super) what: String,
}

/// How places of the old text are places of the new one.
#[derive(Clone, Debug)]
pub(super) struct ReplacedRange {
    /// The text before this byte is at the same place in both.
    pub(super) kept: u32,
    /// The first byte that is carried out again, in the old text and in the new one.
    pub(super) from: [u32; 2],
    /// Contours of cycles that are elsewhere in the new text: their bytes in the old one, and where they begin.
    pub(super) contours: Vec<(Range<u32>, u32)>,
}

impl ReplacedRange {
    fn new_of(&self, (file, at): (u32, u32)) -> (u32, u32) {
        if file != 0 {
            return (file, at);
        }
        if let Some((old, new)) = self.contours.iter().find(|(old, _)| old.contains(&at)) {
            return (file, at - old.start + new);
        }
        let is_moved = at >= self.kept;
        (file, if is_moved { at.wrapping_sub(self.from[0]).wrapping_add(self.from[1]) } else { at })
    }
}

impl EventTrace {
    /// Runs a job and keeps what happens after so many blocks.
    pub(super) fn of(job: &Job, after: u64) -> EventTrace {
        let mut recorder = EventRecorder {
            sources: job.sources(),
            last: (0, 0),
            line: 0,
            has_ended: false,
            is_on_part: false,
            state: None,
            trace: EventTrace { rolling: rolling_axes(job), ..EventTrace::default() },
        };
        let (_, rest) = walk(job, |visit| {
            if visit.ran >= after {
                recorder.keep_output(visit.output);
                recorder.stand(visit.origin);
                let state = recorder.state_after(visit);
                recorder.keep(TraceEvent::Done(state));
                return;
            }
            visit.output.commands.iter().for_each(|command| recorder.follow_frame(&command.kind));
            if visit.ran + 1 == after {
                let state = recorder.state_after(visit);
                recorder.trace.unmoved = state.unmoved;
                recorder.trace.begin = Some(state.kept);
            }
        });
        recorder.keep_output(&rest);
        recorder.trace
    }

    /// What the head has not brought back as it was, although it may not show in what follows. A head that leaves a
    /// change of tools and the approach to the program brings back the tool made ready alone.
    pub(super) fn begins_otherwise(
        &self,
        new: &EventTrace,
        care: MatchLevel,
    ) -> Option<&'static str> {
        let both = [self.begin.as_deref()?, new.begin.as_deref()?];
        different_item(both, care.free_items, |item| match care.exact {
            true => compared(item).1 && is_compared(item, both, true),
            false => item == StateItem::ReadyTool,
        })
    }

    /// Variables that hold something after this run, and not the same after another one.
    pub(super) fn kept_otherwise(&self, other: &EventTrace) -> Vec<(u32, Option<f64>)> {
        let is_other = |one: &&(u32, Option<f64>)| !other.kept.contains(one);
        self.kept.iter().filter(is_other).copied().collect()
    }

    /// The first thing in which another run is not like this one.
    pub(super) fn unlike(
        &self,
        new: &EventTrace,
        places: &ReplacedRange,
        care: MatchLevel,
    ) -> Option<FirstMismatch> {
        let begins = [&self.begin, &new.begin];
        let follows = begins.iter().all(|begin| begin.as_ref().is_some_and(|kept| kept.follows));
        let unmoved = self.unmoved.or(new.unmoved);
        let mut care = MatchLevel { follows, rolling: self.rolling, unmoved, ..care };
        for (one, other) in self.steps.iter().zip(&new.steps) {
            // An alarm comes before what its block does.
            let is_alarm =
                [one, other].iter().any(|step| matches!(step.what, TraceEvent::Alarm(_)));
            let what = if is_alarm || places.new_of(one.at) == other.at {
                different(&one.what, &other.what, care)
            } else {
                Some("another block is carried out".into())
            };
            care.settled |= one.what.needs_height();
            if let (TraceEvent::Done(one), TraceEvent::Done(other)) = (&one.what, &other.what) {
                care.follows = one.kept.follows && other.kept.follows;
                care.unmoved = one.unmoved.or(other.unmoved);
            }
            if let Some(what) = what {
                return Some(FirstMismatch { line: one.line, what });
            }
        }
        let longer = match self.steps.len().cmp(&new.steps.len()) {
            std::cmp::Ordering::Equal => return None,
            std::cmp::Ordering::Greater => "the new program ends before it",
            std::cmp::Ordering::Less => "the new program goes on after it",
        };
        let at = self.steps.len().min(new.steps.len());
        let line = self.steps.get(at).or(self.steps.last()).map_or(1, |step| step.line);
        Some(FirstMismatch { line, what: longer.into() })
    }
}

struct EventRecorder<'j> {
    sources: &'j SourceMap<'j>,
    last: (u32, u32),
    line: u32,
    has_ended: bool,
    /// Coordinates are those of the part: a tilted plane, or tool centre point control.
    is_on_part: bool,
    state: Option<Rc<KeptState>>,
    trace: EventTrace,
}

impl EventRecorder<'_> {
    fn keep(&mut self, what: TraceEvent) {
        let (at, line) = (self.last, self.line);
        self.trace.steps.push(TraceStep { what, at, line });
    }

    fn stand(&mut self, origin: &Origin) {
        self.last = (origin.span.file.0, origin.span.range.start);
        // A called program has lines of its own; the reader looks for those of the main one.
        if origin.call == CallPath::default() {
            self.line = origin.line;
        }
    }

    fn follow_frame(&mut self, command: &CommandKind) {
        if let CommandKind::PartFrame { frame, .. } = command {
            self.is_on_part = frame.is_some();
        }
    }

    /// Alarms come before what their block does.
    fn keep_output(&mut self, output: &BlockOutput) {
        for diagnostic in output.diagnostics.iter().filter(|one| one.severity == Severity::Error) {
            self.keep(TraceEvent::Alarm(diagnostic.code.id()));
        }
        for command in &output.commands {
            // What variables hold at last is told after the end.
            if let (true, CommandKind::Effect(effect)) = (self.has_ended, &command.kind)
                && let Effect::Variable { number, value } = **effect
            {
                self.trace.kept.push((number, value));
                continue;
            }
            // In a tilted plane a rapid to where the tip stands may be what rounding leaves.
            if let CommandKind::Rapid { motion, .. } = &command.kind
                && self.is_on_part
                && motion.from_known == motion.to_known
                && same_place(&motion.from, &motion.to, AxisMask::ALL, AxisMask::NONE)
            {
                continue;
            }
            self.has_ended |= command.kind == CommandKind::End;
            self.follow_frame(&command.kind);
            self.stand(&command.origin);
            self.trace.moves += u64::from(command.kind.motion().is_some());
            self.keep(match &command.kind {
                CommandKind::Message(range) => TraceEvent::Message(
                    self.sources.words(range.in_file(command.origin.span.file)).into_owned(),
                ),
                kind => TraceEvent::Command(kind.clone()),
            });
        }
    }

    fn state_after(&mut self, visit: &WalkedBlock) -> BlockEndState {
        let Modal {
            position,
            work_position,
            machine_position,
            known,
            unmoved,
            machine_known,
            codes,
            spindle,
            surface_speed,
            ..
        } = visit.modal();
        let mut items = (visit.after.items)();
        items.retain(|(item, _)| compared(*item).0 != ItemCheck::Never);
        let new = KeptState { codes, spindle, follows: surface_speed.is_some(), items };
        let kept = match self.state.as_ref().filter(|kept| ***kept == new) {
            Some(kept) => kept.clone(),
            None => self.state.insert(Rc::new(new)).clone(),
        };
        BlockEndState {
            position,
            work_position,
            machine_position,
            known,
            unmoved,
            machine_known,
            kept,
        }
    }
}

/// Z goes to a place relative to the part.
fn moves_z(motion: &Move) -> bool {
    motion.to_known.has(2) && (!motion.from_known.has(2) || motion.from[2] != motion.to[2])
}

/// Where a cut, or a rapid down, ends depends on where the machine stands.
fn goes_by_distance(motion: &Move, is_rapid: bool) -> bool {
    let is_open = |axis: usize| !motion.to_known.has(axis);
    if is_rapid {
        return is_open(2) && motion.to[2] < motion.from[2];
    }
    (0..AXES).any(|axis| is_open(axis) && motion.from[axis] != motion.to[axis])
}

fn near(one: f64, other: f64) -> bool {
    (one - other).abs() <= EQUAL_NUMBER * one.abs().max(1.0)
}

/// The same on every axis of which both know the place; whole turns of `rolling` axes do not count.
fn same_place(one: &Position, other: &Position, known: AxisMask, rolling: AxisMask) -> bool {
    (0..AXES).all(|axis| {
        let turns = match rolling.has(axis) {
            true => TAU * ((one[axis] - other[axis]) / TAU).round(),
            false => 0.0,
        };
        !known.has(axis) || near(one[axis], other[axis] + turns)
    })
}

/// The rotary axes that turn without end and by the rule of the machine file reach an angle from any turn.
fn rolling_axes(job: &Job) -> AxisMask {
    let mut rolling = AxisMask::NONE;
    for (axis, rotary) in AxisMask::ROTARY.iter().zip(&job.machine().rotary) {
        if matches!(rotary.rollover, Some(RolloverRule::Shortest | RolloverRule::Sign)) {
            rolling.insert(axis as usize);
        }
    }
    rolling
}

/// The axes move by the same distances, where both ends are known.
fn same_distance(one: &Move, other: &Move, axes: AxisMask) -> bool {
    let distance = |motion: &Move, axis: usize| motion.to[axis] - motion.from[axis];
    (0..AXES).all(|axis| !axes.has(axis) || near(distance(one, axis), distance(other, axis)))
}

fn different(one: &TraceEvent, other: &TraceEvent, care: MatchLevel) -> Option<String> {
    match (one, other) {
        (TraceEvent::Command(one), TraceEvent::Command(other)) => {
            different_command(one, other, care)
        }
        (TraceEvent::Done(one), TraceEvent::Done(other)) => {
            different_state(one, other, care).map(|name| format!("{name} is another one after it"))
        }
        (TraceEvent::Alarm(one), TraceEvent::Alarm(other)) if one == other => None,
        (TraceEvent::Message(one), TraceEvent::Message(other)) if one == other => None,
        (TraceEvent::Message(_), TraceEvent::Message(_)) => {
            Some("the message is another one".into())
        }
        (_, TraceEvent::Alarm(code)) => {
            Some(format!("the new program has an error there ({code})"))
        }
        (TraceEvent::Alarm(code), _) => Some(format!("only the old program has the error {code}")),
        _ => Some("the block does something else".into()),
    }
}

fn different_command(one: &CommandKind, other: &CommandKind, care: MatchLevel) -> Option<String> {
    use CommandKind as Kind;
    if std::mem::discriminant(one) != std::mem::discriminant(other) {
        return Some("the block does something else".into());
    }
    if let (Some(a), Some(b)) = (one.motion(), other.motion()) {
        let is_rapid = matches!(one, Kind::Rapid { .. });
        if !same_move(a, b, care.exact || care.settled || !is_rapid, care) {
            return Some("the move is another one".into());
        }
        if !care.exact && !is_rapid && (0..3).any(|axis| !a.to_known.has(axis)) {
            return Some("the cut is at a place that is not known".into());
        }
        if !(care.exact || care.settled && is_rapid) && goes_by_distance(a, is_rapid) {
            return Some("the move goes by a distance from a place that is not known".into());
        }
    }
    if let (Some(a), Some(b)) = (one.feed(), other.feed())
        && !same_feed(a, b)
    {
        return Some("the feed is another one".into());
    }
    let is_same = match (one, other) {
        (Kind::Rapid { path: a, .. }, Kind::Rapid { path: b, .. }) => a == b,
        (Kind::Line { .. }, Kind::Line { .. }) => true,
        (Kind::Arc { shape: a, .. }, Kind::Arc { shape: b, .. })
        | (Kind::Spiral { shape: a, .. }, Kind::Spiral { shape: b, .. }) => same_shape(a, b),
        (Kind::Spindle { state: a, rpm: x }, Kind::Spindle { state: b, rpm: y }) => {
            a == b && (near(*x, *y) || care.follows && !care.exact && !care.settled)
        }
        (Kind::FeedRate { value: x, mode: a }, Kind::FeedRate { value: y, mode: b }) => {
            a == b && near(*x, *y)
        }
        (
            Kind::WorkOffset { name: a, offset: x, known: k, .. },
            Kind::WorkOffset { name: b, offset: y, known: l, .. },
        ) => a == b && k == l && same_place(x, y, AxisMask::ALL, AxisMask::NONE),
        // Where the tip is then, the state after the block says as far as it is known.
        (Kind::PartFrame { frame: a, .. }, Kind::PartFrame { frame: b, .. }) => a == b,
        _ => one == other,
    };
    (!is_same).then(|| "the block says the control another value".into())
}

/// Without `strict` only the axes that both know are compared, and the new move may come from elsewhere.
fn same_move(one: &Move, other: &Move, strict: bool, care: MatchLevel) -> bool {
    let MatchLevel { rolling, unmoved, .. } = care;
    if strict {
        return one.from_known == other.from_known
            && one.to_known == other.to_known
            && same_place(&one.from, &other.from, one.from_known, rolling)
            && same_place(&one.to, &other.to, one.to_known, rolling)
            && same_distance(one, other, one.from_known.and(one.to_known).and(rolling));
    }
    let from = one.from_known.and(other.from_known).without(unmoved);
    let mut stays = AxisMask::NONE;
    let stay = unmoved.iter().map(|axis| axis as usize);
    stay.filter(|axis| other.from[*axis] == other.to[*axis]).for_each(|axis| stays.insert(axis));
    let to = one.to_known.and(other.to_known).without(stays);
    // Down at another place would be into something.
    let is_there = !moves_z(one) || one.to_known == other.to_known;
    is_there
        && same_place(&one.from, &other.from, from, rolling)
        && same_place(&one.to, &other.to, to, rolling)
}

fn same_feed(one: &Feed, other: &Feed) -> bool {
    one.mode == other.mode
        && one.along == other.along
        && near(one.value, other.value)
        && near(one.spindle_rev_per_s, other.spindle_rev_per_s)
}

fn same_shape(one: &ArcShape, other: &ArcShape) -> bool {
    one.plane == other.plane
        && near(one.center[0], other.center[0])
        && near(one.center[1], other.center[1])
        && near(one.sweep, other.sweep)
        && near(one.radius_from, other.radius_from)
        && near(one.radius_to, other.radius_to)
}

/// The first part of the state that is not the same.
fn different_state(
    one: &BlockEndState,
    other: &BlockEndState,
    care: MatchLevel,
) -> Option<&'static str> {
    let settled = care.exact || care.settled;
    // Before it is settled, nobody knows where axes stand that have not moved yet.
    let unmoved = if settled { AxisMask::NONE } else { one.unmoved.or(other.unmoved) };
    let known = one.known.and(other.known).without(unmoved);
    let machine = one.machine_known.and(other.machine_known).without(unmoved);
    let kept = [&*one.kept, &*other.kept];
    if let Some(name) =
        different_item(kept, care.free_items, |item| is_compared(item, kept, settled))
    {
        return Some(name);
    }
    let same = |one, other, known| same_place(one, other, known, care.rolling);
    let checks = [
        (same(&one.position, &other.position, known), "the position"),
        (same(&one.work_position, &other.work_position, known), "the work position"),
        (same(&one.machine_position, &other.machine_position, machine), "the machine position"),
        (!care.exact || one.known == other.known, "what is known of the position"),
        (!settled || kept[0].codes == kept[1].codes, "a modal code"),
    ];
    checks.into_iter().find(|(is_same, _)| !is_same).map(|(_, name)| name)
}

/// The first item of those that count which is not the same. Of tables that are free the entry of the tool in the spindle
/// counts all the same.
fn different_item(
    both: [&KeptState; 2],
    free: &[StateItem],
    counts: impl Fn(StateItem) -> bool,
) -> Option<&'static str> {
    let [one, other] = both;
    let mut items = one.items.iter().zip(&other.items);
    let is_other =
        |((item, a), (_, b)): &(&(StateItem, StateValue), &(StateItem, StateValue))| match (
            free.contains(item),
            item,
        ) {
            _ if !counts(*item) => false,
            (true, StateItem::Tables) => one.tool_entry() != other.tool_entry(),
            (true, _) => false,
            (false, _) => !is_same_value(a, b),
        };
    items.find(is_other).map(|((item, _), _)| item.word())
}

/// When an item must be the same after a block.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ItemCheck {
    Always,
    /// A length that is not in force yet moves nothing.
    Settled,
    /// With a cutting speed the revolutions follow the diameter, at rapids: they come by themselves.
    Spinning,
    /// Whatever comes of it is in what both programs do from here on, which is compared.
    Never,
}

/// When an item must be the same, and whether the head brings it back: what that leaves to the block that it begins at
/// shows in what follows.
fn compared(item: StateItem) -> (ItemCheck, bool) {
    match item {
        StateItem::Units
        | StateItem::Plane
        | StateItem::FeedMode
        | StateItem::Spindle
        | StateItem::LiveTool
        | StateItem::SurfaceSpeed
        | StateItem::SpeedLimit
        | StateItem::Coolant
        | StateItem::Tool
        | StateItem::Side
        | StateItem::WorkOffset
        | StateItem::Shift
        | StateItem::Tables
        | StateItem::Frames
        | StateItem::ReadyTool
        | StateItem::PathMode
        | StateItem::Overrides => (ItemCheck::Always, true),
        StateItem::Motion
        | StateItem::Distance
        | StateItem::ArcCenter
        | StateItem::Cycle
        | StateItem::Feed => (ItemCheck::Always, false),
        StateItem::LengthOffset => (ItemCheck::Settled, true),
        StateItem::SpindleSpeed => (ItemCheck::Spinning, true),
        // The position is compared as far as both know it.
        StateItem::CycleWords
        | StateItem::RadiusOffset
        | StateItem::NamedLength
        | StateItem::Position => (ItemCheck::Never, false),
    }
}

/// Whether an item must be the same after a block.
fn is_compared(item: StateItem, both: [&KeptState; 2], settled: bool) -> bool {
    match compared(item).0 {
        ItemCheck::Always => true,
        ItemCheck::Settled => settled,
        ItemCheck::Spinning => {
            let spins = both.iter().any(|kept| kept.spindle != SpindleState::Off);
            spins && !both.iter().all(|kept| kept.follows)
        }
        ItemCheck::Never => false,
    }
}

fn is_same_value(one: &StateValue, other: &StateValue) -> bool {
    let are_near =
        |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(*a, *b));
    match (one, other) {
        (StateValue::Numbers(a), StateValue::Numbers(b)) => are_near(a, b),
        (StateValue::Places(a), StateValue::Places(b)) => {
            a.len() == b.len()
                && a.iter().zip(b).all(|((name, a), (other, b))| {
                    name == other && chordal_compare::are_same_values(a, b)
                })
        }
        (one, other) => one == other,
    }
}
