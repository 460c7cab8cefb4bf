//! What a G or M code does on a control, from its row of the table.

use chordal::control::Field;
use chordal::control::table::{
    ArcTurns, CodeRow, ControlTable, DataTarget, DwellWord, Group, MotionModality, code_name,
};
use chordal::control::{Action, CallCode, LengthCode, ModeCode, MotionCode, OnceCode, ReadingCode};
use chordal::control::{CycleKind, ToolValue};
use chordal::syntax::Letters;

use crate::meaning::{Facts, View, own_value, sections, settings, some};

/// The codes of a table under a letter.
pub fn codes(table: &ControlTable, letter: u8) -> &'static [CodeRow] {
    if letter == b'G' { table.g_codes } else { table.m_codes }
}

/// The code on each control; `None` when it is nowhere.
pub fn code_text(letter: u8, code: u16, views: &[View]) -> Option<String> {
    let on = |view: &View| {
        let row = codes(view.table, letter).iter().find(|row| row.code == code)?;
        Some(row_text(letter, row, view, views.len() > 1))
    };
    sections(&code_name(letter, code), views, on)
}

/// The code on one control in few words; `None` when it has none.
pub fn code_brief(letter: u8, code: u16, view: &View) -> Option<String> {
    let row = codes(view.table, letter).iter().find(|row| row.code == code)?;
    let title = view.table.title;
    Some(format!("{} on {title}:{}", code_name(letter, code), row_text(letter, row, view, true)))
}

/// What a code does on a control; in few words where there are `several`.
fn row_text(letter: u8, row: &CodeRow, view: &View, several: bool) -> String {
    let mut facts = Facts::new(row.title);
    if row.action.is_left_out() {
        let note = match row.action == Action::NotFollowed {
            true => {
                "the control carries it out and Chordal does not: an error, from there on the path is not known"
            }
            false => "the control carries it out; Chordal does not, and reports each use",
        };
        facts.add("note", note);
        return facts.text;
    }
    if row.action == Action::NoEffect {
        facts.add("effect", "none on the path or the time");
    }
    if row.words != Letters::NONE {
        let letters: Vec<String> = row.words.iter().map(String::from).collect();
        facts.add("takes", &format!("{}, with the axes and F", letters.join(" ")));
    }
    let arc = matches!(
        row.action,
        Action::Motion(MotionCode::ArcCw) | Action::Motion(MotionCode::ArcCcw)
    );
    match row.group {
        Group::OneShot => facts.add("holds", "only in its own block"),
        Group::Auxiliary | Group::Stopping | Group::Calling | Group::ToolChange => {}
        Group::Motion if arc && view.table.motion == MotionModality::Armed => {
            facts.add(
                "holds",
                "as the direction of every block with a centre or a radius; other blocks move as G1",
            );
        }
        group => {
            let others: Vec<String> = codes(view.table, letter)
                .iter()
                .filter(|other| other.group == group && other.code != row.code)
                .map(|other| code_name(letter, other.code))
                .collect();
            let ended = if others.is_empty() {
                String::new()
            } else {
                format!(", until {}", some(&others))
            };
            facts.add("group", &format!("{}{ended}", group_name(group)));
        }
    }
    facts_of_action(row.action, view, &mut facts);
    for setting in settings(view.table, fields_of(row.action)) {
        let value = own_value(setting, &view.parameters);
        let meaning = if several { String::new() } else { format!(": {}", setting.text) };
        facts.add("settings", &format!("{} = {value}{meaning}", setting.name));
    }
    facts.text
}

/// What the table says of an action in addition to its settings.
fn facts_of_action(action: Action, view: &View, facts: &mut Facts) {
    if action == Action::Once(OnceCode::Dwell) {
        for word in view.table.dwell {
            facts.add("time", &dwell_text(word));
        }
        if view.table.dwell_alone_stops {
            facts.add("alone", "an exact stop");
        }
    }
    if action == Action::Once(OnceCode::SetData) {
        // One line for all numbers that write the same.
        let mut targets: Vec<(&str, Vec<String>)> = Vec::new();
        for (number, target) in view.table.set_data {
            let (name, number) = (target_name(*target), format!("L{number}"));
            match targets.iter_mut().find(|(other, _)| *other == name) {
                Some((_, numbers)) => numbers.push(number),
                None => targets.push((name, vec![number])),
            }
        }
        for (name, numbers) in targets {
            facts.add("writes", &format!("{}: {name}", numbers.join(" ")));
        }
    }
    if matches!(action, Action::Motion(MotionCode::ArcCw | MotionCode::ArcCcw)) {
        match view.table.arc_turns {
            ArcTurns::None => {}
            ArcTurns::Extra => facts.add("turns", "P: full turns in addition to the arc itself"),
            ArcTurns::Total => facts.add("turns", "P: all turns, the arc itself counted as one"),
        }
    }
}

/// `P1 is 0.001 s, P1. is 1 s`.
pub fn dwell_text(word: &DwellWord) -> String {
    let (letter, whole, point) = (char::from(word.letter), word.integer_s, word.point_s);
    if !word.takes_point {
        format!("{letter}1 is {whole} s; a point is an alarm")
    } else if whole == point {
        format!("{letter}1 is {whole} s, with a point or without")
    } else {
        format!("{letter}1 is {whole} s, {letter}1. is {point} s")
    }
}

pub(crate) fn target_name(target: DataTarget) -> &'static str {
    match target {
        DataTarget::WorkOffset => "work offset P",
        DataTarget::WorkOffsetFromPosition => {
            "work offset P, so that the current position becomes these numbers"
        }
        DataTarget::ExtendedWorkOffset => "extended work offset P",
        DataTarget::Tool(ToolValue::Length) => "length of tool P",
        DataTarget::Tool(ToolValue::LengthWear) => "wear of the length of tool P",
        DataTarget::Tool(ToolValue::Radius) => "radius or diameter of tool P",
        DataTarget::Tool(ToolValue::RadiusWear) => "wear of the radius or diameter of tool P",
        DataTarget::ToolTable => "length and radius of tool P",
        DataTarget::ToolFromPosition => {
            "offsets of tool P, so that the current position becomes these numbers"
        }
        DataTarget::ToolFromFixture => {
            "offsets of tool P, so that the current position becomes these numbers in the last work offset"
        }
        DataTarget::Reload => "nothing: the tool table is read again",
        DataTarget::Register => "a register R",
        DataTarget::Other => "not carried out",
        DataTarget::IntoRegister => "a register R, with a value of the control: not followed",
        DataTarget::Lines => "parameters of the control, by the lines up to G11: not carried out",
    }
}

/// The settings that change what an action does.
fn fields_of(action: Action) -> &'static [Field] {
    use Field as F;
    match action {
        Action::Motion(code) => match code {
            MotionCode::Rapid => &[F::Rapid],
            MotionCode::Linear | MotionCode::Thread | MotionCode::RigidTap => &[],
            MotionCode::ArcCw | MotionCode::ArcCcw => &[
                F::ArcCenter,
                F::RadiusErrorTolerance,
                F::ArcMismatch,
                F::SemicircleTolerance,
                F::CenterAndRadius,
                F::FullCircleByRadius,
                F::HelixFeed,
                F::MaxRadius,
                F::Spiral,
            ],
            MotionCode::SpiralCw | MotionCode::SpiralCcw => &[F::Spiral, F::SpiralEndTolerance],
            MotionCode::Spline(_) | MotionCode::SplineEnd => &[],
        },
        Action::Reading(code) => match code {
            ReadingCode::Inch | ReadingCode::Millimetre => &[F::Units, F::UnitCodes],
            ReadingCode::Absolute | ReadingCode::Incremental => &[F::StartDistance],
            ReadingCode::ArcCenterAbsolute
            | ReadingCode::ArcCenterIncremental
            | ReadingCode::FeedPerTime
            | ReadingCode::FeedInverseTime
            | ReadingCode::FeedPerRevolution => &[],
        },
        Action::Mode(code) => settings_of_mode(code),
        Action::Length(code) => match code {
            LengthCode::Plus | LengthCode::Minus => &[F::LengthMustMatchTool, F::LengthByHAlone],
            LengthCode::Cancel | LengthCode::FromAxes | LengthCode::Add => &[],
        },
        Action::Cycle(CycleKind::ChipBreak) => &[F::ChipBreak],
        Action::Cycle(CycleKind::Peck) => &[F::PeckClearance],
        Action::Cycle(_) => &[],
        Action::Call(code) => match code {
            CallCode::CallProgram | CallCode::CallLabel => &[F::Nesting, F::PackedCalls],
            CallCode::Return => &[F::ReturnLabelInCallee],
            CallCode::SubroutineEnd | CallCode::MacroCall | CallCode::ModalMacroCall { .. } => &[],
        },
        Action::Before(_)
        | Action::Once(_)
        | Action::After(_)
        | Action::NoEffect
        | Action::NotSimulated
        | Action::NotFollowed => &[],
    }
}

fn settings_of_mode(code: ModeCode) -> &'static [Field] {
    match code {
        ModeCode::PlaneXy | ModeCode::PlaneZx | ModeCode::PlaneYz => &[Field::PlaneCodes],
        ModeCode::CompensationLeft | ModeCode::CompensationRight => {
            &[Field::RadiusOffsets, Field::MaxRadiusCompensated]
        }
        ModeCode::CompensationOff
        | ModeCode::CompensationLeftBy
        | ModeCode::CompensationRightBy
        | ModeCode::StoreReference { .. }
        | ModeCode::CornerArc
        | ModeCode::WorkOffset(_)
        | ModeCode::WorkOffsetPoint(_)
        | ModeCode::WorkOffsetExtended
        | ModeCode::WorkOffsetNumbered(_)
        | ModeCode::ReturnInitial
        | ModeCode::ReturnToR
        | ModeCode::CancelCycle
        | ModeCode::Path(_)
        | ModeCode::Overrides { .. }
        | ModeCode::OverridesByP
        | ModeCode::RotationOff
        | ModeCode::ScalingOff
        | ModeCode::Polar { .. }
        | ModeCode::ModalSubroutine
        | ModeCode::ModalCallOff
        | ModeCode::DataLinesOff => &[],
    }
}

/// `ToolLength` → `tool length`.
pub fn group_name(group: Group) -> String {
    let mut name = String::new();
    for letter in format!("{group:?}").chars() {
        if letter.is_uppercase() && !name.is_empty() {
            name.push(' ');
        }
        name.extend(letter.to_lowercase());
    }
    name
}
