//! Compares everything in addition to the path: the state of the moves, and the events between them.

use std::ops::Range;

use imara_diff::{Algorithm, Diff, InternedInput};

use chordal::control::{CompensationSide, Position, RotarySurface, SurfaceShape, number_text};

use crate::ComparisonOptions;
use crate::category::Category;
use crate::course::{
    BlockDeleteUse, ComparedMove, ComparedMoveKind, ComparedRun, CutSpeed, MoveState, RunEvent,
    RunStep,
};
use crate::difference::{BlockLocation, BlockRange, Difference, DifferenceValue};
use crate::values::are_same_values;

/// Dwells whose relative difference is at most this are equal: no control measures time that finely.
const EQUAL_DWELL_SHARE: f64 = 1e-5;

/// Collects differences; consecutive equal differences of one category are merged.
pub(crate) struct DifferenceCollector<'a> {
    courses: [&'a ComparedRun; 2],
    feed_tolerance: f64,
    speed_tolerance: f64,
    rotary_tolerance: f64,
    /// For each category, the difference at the preceding moves that may continue.
    open: [Option<Difference>; Category::ALL.len()],
    done: Vec<Difference>,
}

impl<'a> DifferenceCollector<'a> {
    pub(crate) fn new(
        courses: [&'a ComparedRun; 2],
        options: &ComparisonOptions,
    ) -> DifferenceCollector<'a> {
        DifferenceCollector {
            courses,
            feed_tolerance: options.feed_tolerance,
            speed_tolerance: options.speed_tolerance,
            rotary_tolerance: options.rotary_tolerance_rad,
            open: [const { None }; Category::ALL.len()],
            done: Vec::new(),
        }
    }

    pub(crate) fn finish(&mut self) -> Vec<Difference> {
        for open in &mut self.open {
            self.done.extend(open.take());
        }
        std::mem::take(&mut self.done)
    }

    /// Records the values of a category at two corresponding moves; `None` when they are equal.
    fn note(
        &mut self,
        category: Category,
        values: Option<[DifferenceValue; 2]>,
        at: [BlockLocation; 2],
    ) {
        let open = &mut self.open[category as usize];
        let Some(values) = values else {
            self.done.extend(open.take());
            return;
        };
        match open {
            Some(open) if open.values.as_ref() == Some(&values) => open.extend(at),
            _ => {
                self.done.extend(open.take());
                *open = Some(Difference::at(category, at, Some(values)));
            }
        }
    }

    /// Compares the state, the kind and the feed of two corresponding moves.
    pub(crate) fn moves(&mut self, one: &ComparedMove, other: &ComparedMove) {
        let at = [BlockLocation::from(&one.origin), BlockLocation::from(&other.origin)];
        let both = (one.kind, other.kind);
        let is_cut = |kind: ComparedMoveKind| kind == ComparedMoveKind::Cut;
        let rapid = (is_cut(both.0) != is_cut(both.1)).then(|| [word(both.0), word(both.1)]);
        // From an unknown position it is unknown how many axes move.
        let is_known = one.known && other.known;
        let is_path = rapid.is_none() && is_known && both.0 != both.1;
        self.note(Category::Rapid, rapid, at);
        self.note(Category::RapidPath, is_path.then(|| [word(both.0), word(both.1)]), at);
        if both == (ComparedMoveKind::Cut, ComparedMoveKind::Cut) {
            let feed = (!self.is_feed_same(one.feed, other.feed))
                .then(|| [feed_value(one.feed), feed_value(other.feed)]);
            self.note(Category::Feed, feed, at);
        }
        let states = (self.courses[0].state(one), self.courses[1].state(other));
        // With constant surface speed, the spindle speed follows the diameter, which is unknown there.
        let speed_tolerance = if is_known { self.speed_tolerance } else { 1.0 };
        for (category, values) in differences(states.0, states.1, speed_tolerance) {
            self.note(category, values, at);
        }
    }

    /// Records two rapids between the same points with different dog-legs.
    pub(crate) fn bend(&mut self, one: &ComparedMove, other: &ComparedMove) {
        let at = [BlockLocation::from(&one.origin), BlockLocation::from(&other.origin)];
        let values = Some([word(one.kind), word(other.kind)]);
        self.done.push(Difference::at(Category::RapidPath, at, values));
    }

    fn is_feed_same(&self, a: Option<CutSpeed>, b: Option<CutSpeed>) -> bool {
        let is_near = |a: f64, b: f64| is_part(a, b, self.feed_tolerance);
        match (a, b) {
            (None, None) => true,
            (Some(CutSpeed::Path(a)), Some(CutSpeed::Path(b)))
            | (Some(CutSpeed::Turn(a)), Some(CutSpeed::Turn(b)))
            | (Some(CutSpeed::PerRevolution(a)), Some(CutSpeed::PerRevolution(b))) => is_near(a, b),
            _ => false,
        }
    }

    /// Compares the rotary axes at both ends of two parts that are traversed together.
    pub(crate) fn rotary(&mut self, moves: [&ComparedMove; 2], parts: [[f64; 2]; 2]) {
        let [one, other] = moves;
        if one.turn == 0 && other.turn == 0 {
            return;
        }
        let turns = [self.courses[0].turn(one), self.courses[1].turn(other)];
        let at_end = |end: usize| -> [[f64; 3]; 2] {
            [0, 1].map(|side: usize| {
                let ([from, to], fraction) = (turns[side], parts[side][end]);
                [0, 1, 2].map(|axis: usize| from[axis] + (to[axis] - from[axis]) * fraction)
            })
        };
        let is_off = |[a, b]: &[[f64; 3]; 2]| {
            let most = self.rotary_tolerance;
            a.iter().zip(b).any(|(a, b)| (a - b).abs() > most || (a - b).is_nan())
        };
        let off = [at_end(1), at_end(0)].into_iter().find(is_off);
        let values = off.map(|both| both.map(DifferenceValue::Rotary));
        self.note(Category::Rotary, values, moves.map(|moved| BlockLocation::from(&moved.origin)));
    }

    /// Compares two corresponding events.
    pub(crate) fn events(&mut self, at: [usize; 2]) {
        let [Some((one, a)), Some((other, b))] =
            [0, 1].map(|side| event(self.courses[side], at[side]))
        else {
            return;
        };
        let is_same = match (one, other) {
            (RunEvent::Dwell(a), RunEvent::Dwell(b)) => is_part(*a, *b, EQUAL_DWELL_SHARE),
            (
                RunEvent::Written { name: a, values: x },
                RunEvent::Written { name: b, values: y },
            ) => a == b && are_same_values(x, y),
            (
                RunEvent::Variable { number: a, value: x },
                RunEvent::Variable { number: b, value: y },
            ) => a == b && are_same_values(&[*x], &[*y]),
            _ => one == other,
        };
        let marks = [0, 1].map(|side: usize| deletable(self.courses[side], at[side]));
        if marks[0] != marks[1] {
            let values = Some(marks.map(deletable_value));
            self.done.push(Difference::at(Category::BlockDelete, [a, b], values));
        }
        if !is_same {
            let values = Some([event_value(one), event_value(other)]);
            self.done.push(Difference::at(category(one), [a, b], values));
        }
    }

    /// Compares the events of a gap, which are matched by kind and order.
    pub(crate) fn gap_events(&mut self, ranges: &[Range<usize>; 2]) {
        let events = [0, 1].map(|side: usize| -> Vec<usize> {
            let course = self.courses[side];
            ranges[side].clone().filter(|at| event(course, *at).is_some()).collect()
        });
        if events.iter().all(Vec::is_empty) {
            return;
        }
        let kind = |side: usize, at: &usize| {
            event(self.courses[side], *at).map(|(event, _)| (category(event), name(event)))
        };
        let mut input = InternedInput::default();
        input.update_before(events[0].iter().map(|at| kind(0, at)));
        input.update_after(events[1].iter().map(|at| kind(1, at)));
        let diff = Diff::compute(Algorithm::Myers, &input);
        let mut at = [0usize; 2];
        let together = |steps: &mut Self, at: &mut [usize; 2], to: [usize; 2]| {
            while at[0] < to[0] && at[1] < to[1] {
                steps.events([events[0][at[0]], events[1][at[1]]]);
                *at = at.map(|at| at + 1);
            }
        };
        for hunk in diff.hunks() {
            together(self, &mut at, [hunk.before.start as usize, hunk.after.start as usize]);
            for (side, range) in [&hunk.before, &hunk.after].into_iter().enumerate() {
                for event in &events[side][range.start as usize..range.end as usize] {
                    self.only_one(ranges, side, *event);
                }
                at[side] = range.end as usize;
            }
        }
        together(self, &mut at, events.each_ref().map(Vec::len));
    }

    fn only_one(&mut self, ranges: &[Range<usize>; 2], side: usize, at: usize) {
        let Some((what, _)) = event(self.courses[side], at) else { return };
        let mut steps: [&[usize]; 2] = [&[]; 2];
        let only = [at];
        steps[side] = &only;
        let mut difference = lacking(self.courses, ranges, steps, category(what));
        let mut values = [DifferenceValue::Nothing, DifferenceValue::Nothing];
        values[side] = event_value(what);
        difference.values = Some(values);
        self.done.push(difference);
    }
}

/// A difference in the number of steps. When a side has none, its block is the one before the gap.
pub(crate) fn lacking(
    courses: [&ComparedRun; 2],
    ranges: &[Range<usize>; 2],
    steps: [&[usize]; 2],
    category: Category,
) -> Difference {
    let blocks = [0, 1].map(|side: usize| {
        let place =
            |at: usize| courses[side].steps.get(at).map(|step| BlockLocation::from(step.origin()));
        match steps[side] {
            [] => place(ranges[side].start.saturating_sub(1)).map(BlockRange::at),
            [first, .., last] => {
                place(*first).zip(place(*last)).map(|(first, last)| BlockRange { first, last })
            }
            [only] => place(*only).map(BlockRange::at),
        }
    });
    let steps = steps.map(|steps| steps.len() as u64);
    Difference::new(category, blocks, steps, None)
}

fn event(course: &ComparedRun, at: usize) -> Option<(&RunEvent, BlockLocation)> {
    match course.steps.get(at)? {
        RunStep::Event { what, origin, .. } => Some((what, BlockLocation::from(origin))),
        RunStep::Move(_) => None,
    }
}

fn deletable(course: &ComparedRun, at: usize) -> Option<BlockDeleteUse> {
    match course.steps.get(at)? {
        RunStep::Event { deletable, .. } => *deletable,
        RunStep::Move(_) => None,
    }
}

fn deletable_value(deletable: Option<BlockDeleteUse>) -> DifferenceValue {
    deletable.map_or(DifferenceValue::Nothing, |deletable| {
        let mark = match deletable.switch {
            1 => "/".to_string(),
            switch => format!("/{switch}"),
        };
        DifferenceValue::Text(if deletable.partly { format!("{mark} in the block") } else { mark })
    })
}

fn written_text(name: &str, values: &[Option<f64>]) -> String {
    let values: Vec<String> = values.iter().flatten().map(|value| number_text(*value, 4)).collect();
    format!("{name} = {}", if values.is_empty() { "nothing".into() } else { values.join(", ") })
}

fn category(event: &RunEvent) -> Category {
    match event {
        RunEvent::Tool(_) => Category::Tool,
        RunEvent::Dwell(_) => Category::Dwell,
        RunEvent::Stop { .. } => Category::Stop,
        RunEvent::Probed { .. } => Category::Probe,
        RunEvent::Output(_) => Category::Output,
        RunEvent::ReadyTool(_) => Category::ReadyTool,
        RunEvent::Code(_) => Category::Code,
        RunEvent::Written { .. } => Category::Written,
        RunEvent::Variable { .. } => Category::Variable,
        RunEvent::Message(_) => Category::Message,
        RunEvent::Alarm { .. } => Category::Alarm,
        RunEvent::Deletable(_) => Category::BlockDelete,
    }
}

/// The name that events of one category must share to be matched: two different codes do not correspond, but one code
/// with different words does.
fn name(event: &RunEvent) -> &str {
    match event {
        RunEvent::Code(words) => words.split(' ').next().unwrap_or_default(),
        RunEvent::Written { name, .. } => name,
        // These are matched by category alone.
        RunEvent::Variable { .. }
        | RunEvent::Tool(_)
        | RunEvent::ReadyTool(_)
        | RunEvent::Dwell(_)
        | RunEvent::Stop { .. }
        | RunEvent::Probed { .. }
        | RunEvent::Output(_)
        | RunEvent::Message(_)
        | RunEvent::Alarm { .. }
        | RunEvent::Deletable(_) => "",
    }
}

fn event_value(event: &RunEvent) -> DifferenceValue {
    match event {
        RunEvent::Tool(number) => DifferenceValue::Number(*number),
        RunEvent::Dwell(seconds) => DifferenceValue::Seconds(*seconds),
        RunEvent::Stop { optional: true } => DifferenceValue::Text("optional stop".into()),
        RunEvent::Stop { optional: false } => DifferenceValue::Text("stop".into()),
        RunEvent::Probed { hit: true } => DifferenceValue::Text("touched".into()),
        RunEvent::Probed { hit: false } => DifferenceValue::Text("not touched".into()),
        RunEvent::Output(text) | RunEvent::Code(text) | RunEvent::Message(text) => {
            DifferenceValue::Text(text.clone())
        }
        RunEvent::ReadyTool(number) => DifferenceValue::Number(*number),
        RunEvent::Written { name, values } => DifferenceValue::Text(written_text(name, values)),
        RunEvent::Variable { number, value } => {
            DifferenceValue::Text(written_text(&format!("#{number}"), &[*value]))
        }
        RunEvent::Alarm { number, text } => {
            DifferenceValue::Text(format!("{number} {text}").trim().into())
        }
        RunEvent::Deletable(mark) => deletable_value(Some(*mark)),
    }
}

fn word(kind: ComparedMoveKind) -> DifferenceValue {
    DifferenceValue::Text(
        match kind {
            ComparedMoveKind::Cut => "cut",
            ComparedMoveKind::Rapid => "rapid",
            ComparedMoveKind::DogLeg => "dog-leg rapid",
        }
        .into(),
    )
}

fn feed_value(feed: Option<CutSpeed>) -> DifferenceValue {
    match feed {
        None => DifferenceValue::Nothing,
        Some(CutSpeed::Path(speed)) => DifferenceValue::Feed(speed),
        Some(CutSpeed::Turn(speed)) => DifferenceValue::Turn(speed),
        Some(CutSpeed::PerRevolution(feed)) => DifferenceValue::FeedPerRevolution(feed),
    }
}

/// Whether two values differ by at most this fraction of the larger.
fn is_part(a: f64, b: f64, part: f64) -> bool {
    (a - b).abs() <= part * a.abs().max(b.abs())
}

/// Angles and lengths of a surface that differ by at most this are equal, rad or mm.
const EQUAL_SURFACE: f64 = 1e-6;

fn is_same_surface(a: Option<RotarySurface>, b: Option<RotarySurface>) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= EQUAL_SURFACE;
    let (a, b) = match (a, b) {
        (None, None) => return true,
        (Some(a), Some(b)) if a.rotary == b.rotary && a.across == b.across => (a, b),
        _ => return false,
    };
    match (a.shape, b.shape) {
        (
            SurfaceShape::Face { along, zero, negative, .. },
            SurfaceShape::Face { along: other, zero: other_zero, negative: other_side, .. },
        ) => along == other && near(zero, other_zero) && negative == other_side,
        (SurfaceShape::Cylinder { radius_mm }, SurfaceShape::Cylinder { radius_mm: other }) => {
            near(radius_mm, other)
        }
        (SurfaceShape::Face { .. }, SurfaceShape::Cylinder { .. })
        | (SurfaceShape::Cylinder { .. }, SurfaceShape::Face { .. }) => false,
    }
}

fn side_value(side: CompensationSide) -> DifferenceValue {
    match side {
        CompensationSide::Off => DifferenceValue::Nothing,
        CompensationSide::Left => DifferenceValue::Text("left of the contour".into()),
        CompensationSide::Right => DifferenceValue::Text("right of the contour".into()),
    }
}

fn surface_value(surface: Option<RotarySurface>) -> DifferenceValue {
    DifferenceValue::Text(match surface.map(|surface| surface.shape) {
        None => "the axes themselves".into(),
        Some(SurfaceShape::Face { zero, .. }) => {
            format!("on the face from {} degrees", number_text(zero.to_degrees(), 3))
        }
        Some(SurfaceShape::Cylinder { radius_mm }) => {
            format!("on a cylinder of radius {} mm", number_text(radius_mm, 3))
        }
    })
}

fn coordinates_text(on_part: bool) -> String {
    match on_part {
        true => "coordinates of the tip on the part".into(),
        false => "coordinates of the axes".into(),
    }
}

/// Whether two tool offsets set directly by programs (G43.1) are equal.
fn is_same_length(a: Option<Position>, b: Option<Position>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => are_same_values(&a.map(Some), &b.map(Some)),
        (a, b) => a == b,
    }
}

/// The axes that have an offset, such as `Z 25 mm`.
fn own_length_text(values: &Position) -> String {
    let linear = values.iter().zip("XYZ".chars()).filter(|(value, _)| **value != 0.0);
    let texts: Vec<String> =
        linear.map(|(value, letter)| format!("{letter} {} mm", number_text(*value, 4))).collect();
    texts.join(", ")
}

/// The values of each category that differs between two states; `None` for categories that are equal.
fn differences(
    a: &MoveState,
    b: &MoveState,
    tolerance: f64,
) -> [(Category, Option<[DifferenceValue; 2]>); 10] {
    let number =
        |number: Option<u32>| number.map_or(DifferenceValue::Nothing, DifferenceValue::Number);
    let length = |state: &MoveState| match state.own_length {
        Some(values) => DifferenceValue::Text(own_length_text(&values)),
        None => number(state.length_offset),
    };
    let is_spindle_same = a.spindle == b.spindle && is_part(a.rpm, b.rpm, tolerance);
    let spindle =
        [DifferenceValue::Spindle(a.spindle, a.rpm), DifferenceValue::Spindle(b.spindle, b.rpm)];
    let of = |is_other: bool, values: [DifferenceValue; 2]| is_other.then_some(values);
    [
        (Category::Spindle, of(!is_spindle_same, spindle)),
        (
            Category::LengthOffset,
            of(
                a.length_offset != b.length_offset || !is_same_length(a.own_length, b.own_length),
                [length(a), length(b)],
            ),
        ),
        (
            Category::RadiusOffset,
            match a.side != b.side {
                true => Some([a.side, b.side].map(side_value)),
                false => of(
                    a.radius_offset != b.radius_offset,
                    [number(a.radius_offset), number(b.radius_offset)],
                ),
            },
        ),
        (
            Category::WorkOffset,
            of(
                a.work_offset != b.work_offset,
                [DifferenceValue::Number(a.work_offset), DifferenceValue::Number(b.work_offset)],
            ),
        ),
        (
            Category::Coolant,
            of(
                a.coolant != b.coolant,
                [DifferenceValue::Coolant(a.coolant), DifferenceValue::Coolant(b.coolant)],
            ),
        ),
        (
            Category::PathMode,
            of(
                a.path_mode != b.path_mode,
                [DifferenceValue::PathMode(a.path_mode), DifferenceValue::PathMode(b.path_mode)],
            ),
        ),
        (
            Category::Overrides,
            of(
                a.overrides != b.overrides,
                [DifferenceValue::Overrides(a.overrides), DifferenceValue::Overrides(b.overrides)],
            ),
        ),
        (
            Category::Rotary,
            (!is_same_surface(a.surface, b.surface))
                .then(|| [surface_value(a.surface), surface_value(b.surface)]),
        ),
        (
            Category::Rotary,
            of(
                a.on_part != b.on_part,
                [a, b].map(|state| DifferenceValue::Text(coordinates_text(state.on_part))),
            ),
        ),
        (
            Category::BlockDelete,
            of(
                a.deletable != b.deletable,
                [deletable_value(a.deletable), deletable_value(b.deletable)],
            ),
        ),
    ]
}
