//! The rows of the table of keys.

use super::{Keys, Place, Row, Sign, Slot, Stamp};
use crate::control::ControlName;
use crate::machine::{AxisLimits, Machine, ProbeHit, RapidShape, Rotary, Tool, Turns, WorkOffset};
use crate::quantity::Dimension;

const fn quantity(
    path: &'static str,
    dimension: Dimension,
    sign: Sign,
    place: Place<Option<f64>>,
    doc: &'static str,
) -> Row {
    Row { path, slot: Slot::Quantity { dimension, sign, place }, doc }
}

const CONTROLS: &[&str] = &{
    let mut words = [""; ControlName::ALL.len()];
    let mut at = 0;
    while at < words.len() {
        words[at] = ControlName::ALL[at].as_str();
        at += 1;
    }
    words
};

pub(crate) const ROWS: &[Row] = &[
    Row {
        path: "inherits",
        slot: Slot::Inherits,
        doc: "a built-in machine, or a file relative to this one; its keys apply where this file does not give them",
    },
    Row {
        path: "name",
        slot: Slot::Text(|m, _| &mut m.name),
        doc: "the short name of the machine; default: the file's name without folder and extension",
    },
    Row { path: "title", slot: Slot::Text(|m, _| &mut m.title), doc: "the full name, for display" },
    Row { path: "notes", slot: Slot::TextList(|m, _| &mut m.notes), doc: "remarks" },
    Row {
        path: "control",
        slot: Slot::Word {
            what: "control",
            words: CONTROLS,
            set: |m, _, word| {
                if let Ok(control) = word.parse() {
                    m.control = control;
                }
            },
        },
        doc: "the control that runs its programs",
    },
    Row {
        path: "axes.<axis>",
        slot: Slot::Axis,
        doc: "an axis of the machine: X, Y, Z, or the rotary A, B, C. A file that names none has X, Y and Z without limits; `A = false` removes an inherited axis",
    },
    Row {
        path: "axes.<axis>.travel",
        slot: Slot::Range { dimension: Dimension::Length, place: |m, k| &mut axis(m, k).travel },
        doc: "the lowest and the highest position, machine coordinates",
    },
    quantity(
        "axes.<axis>.max_velocity",
        Dimension::Velocity,
        Sign::Positive,
        |m, k| &mut axis(m, k).max_velocity,
        "rapid speed",
    ),
    quantity(
        "axes.<axis>.max_acceleration",
        Dimension::Acceleration,
        Sign::Positive,
        |m, k| &mut axis(m, k).max_acceleration,
        "the largest acceleration",
    ),
    quantity(
        "axes.<axis>.max_jerk",
        Dimension::Jerk,
        Sign::Positive,
        |m, k| &mut axis(m, k).max_jerk,
        "the largest jerk, the rate of change of acceleration",
    ),
    quantity(
        "axes.<axis>.rapid_acceleration",
        Dimension::Acceleration,
        Sign::Positive,
        |m, k| &mut axis(m, k).rapid_acceleration,
        "the largest acceleration of rapids, if it differs from that of cuts",
    ),
    quantity(
        "axes.<axis>.rapid_jerk",
        Dimension::Jerk,
        Sign::Positive,
        |m, k| &mut axis(m, k).rapid_jerk,
        "the largest jerk of rapids, if it differs from that of cuts",
    ),
    Row {
        path: "rotary.<rotary>.turns",
        slot: Slot::Word {
            what: "what turns",
            words: &[Turns::Table.as_str(), Turns::Head.as_str()],
            set: |m, k, word| {
                rotary(m, k).turns =
                    [Turns::Table, Turns::Head].into_iter().find(|turns| turns.as_str() == word);
            },
        },
        doc: "what A, B or C turns: the part (`table`) or the tool (`head`); without it this is not known, and pictures do not show the turn. Of several tables A carries B, and B carries C; of several heads C carries B, and B carries A",
    },
    Row {
        path: "rotary.<rotary>.reversed",
        slot: Slot::Flag(|m, k| &mut rotary(m, k).reversed),
        doc: "`true`: its positive direction is opposite to ISO 841, where a positive angle turns the tool about the part like a right-hand screw along X, Y or Z",
    },
    quantity(
        "rotary.<rotary>.center.<axis>",
        Dimension::Length,
        Sign::Any,
        |m, k| &mut rotary(m, k).center_mm[k.axis.map_or(0, |axis| axis as usize % 3)],
        "a point on its axis of rotation: X, Y and Z, program coordinates; default: the program's zero",
    ),
    quantity(
        "feed.max",
        Dimension::Velocity,
        Sign::Positive,
        |m, _| &mut m.feed.max_mm_per_s,
        "the largest feed that may be programmed",
    ),
    quantity(
        "feed.max_rotary",
        Dimension::AngularVelocity,
        Sign::Positive,
        |m, _| &mut m.feed.max_rad_per_s,
        "the same for moves of only rotary axes",
    ),
    Row {
        path: "rapid.shape",
        slot: Slot::Word {
            what: "rapid shape",
            words: &[RapidShape::DogLeg.as_str(), RapidShape::Straight.as_str()],
            set: |m, _, word| {
                m.rapid = [RapidShape::DogLeg, RapidShape::Straight]
                    .into_iter()
                    .find(|s| s.as_str() == word);
            },
        },
        doc: "rapids of several axes: each axis at its own speed (`dog-leg`), or along a straight line (`straight`); default: that of the control",
    },
    quantity(
        "spindle.max",
        Dimension::SpindleSpeed,
        Sign::Positive,
        |m, _| &mut m.spindle_max_rpm,
        "the largest spindle speed",
    ),
    Row {
        path: "tools.<tool>",
        slot: Slot::Table(|m, k| {
            tool(m, k);
        }),
        doc: "a tool, by number",
    },
    quantity(
        "tools.<tool>.diameter",
        Dimension::Length,
        Sign::Any,
        |m, k| &mut tool(m, k).diameter_mm,
        "its diameter; on some controls a negative diameter is for the other side",
    ),
    quantity(
        "tools.<tool>.diameter_wear",
        Dimension::Length,
        Sign::Any,
        |m, k| &mut tool(m, k).diameter_wear_mm,
        "added to the diameter",
    ),
    quantity(
        "tools.<tool>.length",
        Dimension::Length,
        Sign::Any,
        |m, k| &mut tool(m, k).length_mm,
        "its length offset",
    ),
    quantity(
        "tools.<tool>.length_wear",
        Dimension::Length,
        Sign::Any,
        |m, k| &mut tool(m, k).length_wear_mm,
        "added to the length offset",
    ),
    quantity(
        "tools.<tool>.corner_radius",
        Dimension::Length,
        Sign::NotNegative,
        |m, k| &mut tool(m, k).corner_radius_mm,
        "the corner radius, between its side and its end",
    ),
    Row {
        path: "tools.<tool>.kind",
        slot: Slot::OptionalText(|m, k| &mut tool(m, k).kind),
        doc: "free text, such as `end mill`",
    },
    Row {
        path: "tools.<tool>.comment",
        slot: Slot::OptionalText(|m, k| &mut tool(m, k).comment),
        doc: "free text",
    },
    Row {
        path: "work_offsets.<offset>",
        slot: Slot::Table(|m, k| {
            work_offset(m, k);
        }),
        doc: "a work offset: `G54` to `G59`, `\"G59.1\"` to `\"G59.3\"`, `\"G54.1 P1\"`, `\"G154 P1\"` (also `G110`), `E1` to `E48`, `G52`, `EXT`. A name with a point or a space needs quotes",
    },
    quantity(
        "work_offsets.<offset>.<axis>",
        Dimension::Length,
        Sign::Any,
        |m, k| by_axis(&mut work_offset(m, k).values, k),
        "where its zero is, machine coordinates",
    ),
    quantity(
        "home.<axis>",
        Dimension::Length,
        Sign::Any,
        |m, k| by_axis(&mut m.home, k),
        "reference point 1, machine coordinates",
    ),
    quantity(
        "reference_points.<point>.<axis>",
        Dimension::Length,
        Sign::Any,
        |m, k| by_axis(&mut m.reference_points[(k.number as usize).clamp(2, 4) - 2], k),
        "reference points 2, 3 and 4, machine coordinates",
    ),
    Row {
        path: "switches.block_delete",
        slot: Slot::Switches,
        doc: "`true` skips every block that starts with `/`; a list such as `[1, 3]` skips only the blocks with these numbers; a `/` without a number is 1",
    },
    Row {
        path: "switches.optional_stop",
        slot: Slot::Flag(|m, _| &mut m.switches.optional_stop),
        doc: "M01 stops",
    },
    quantity(
        "program.clearance",
        Dimension::Length,
        Sign::Any,
        |m, _| &mut m.clearance_mm,
        "the plane above which rapids may move freely, Z in work coordinates",
    ),
    quantity(
        "motion.servo_period",
        Dimension::Time,
        Sign::Positive,
        |m, _| &mut m.motion.servo_period_s,
        "how often the control sends a position to the axes; default: 1 ms",
    ),
    Row {
        path: "motion.feed_override",
        slot: Slot::Override(|m, _| &mut m.motion.feed_override),
        doc: "the feed override; default: 100 %",
    },
    Row {
        path: "motion.rapid_override",
        slot: Slot::Override(|m, _| &mut m.motion.rapid_override),
        doc: "the rapid override; default: 100 %",
    },
    quantity(
        "motion.corner_tolerance",
        Dimension::Length,
        Sign::NotNegative,
        |m, _| &mut m.motion.corner_tolerance_mm,
        "how far from the path the tool may pass a rounded corner when the control gives no tolerance; default: 0.05 mm (assumed)",
    ),
    quantity(
        "motion.exact_path_tolerance",
        Dimension::Length,
        Sign::NotNegative,
        |m, _| &mut m.motion.exact_path_tolerance_mm,
        "how far from the path the tool may be in exact path mode where a line meets a tangent arc; default: 0, so it stops there",
    ),
    quantity(
        "motion.rapid_corner_tolerance",
        Dimension::Length,
        Sign::NotNegative,
        |m, _| &mut m.motion.rapid_corner_tolerance_mm,
        "how far the bends of a dog-leg rapid, and corners between rapids that do not stop, may be rounded; default: 10 mm (assumed)",
    ),
    quantity(
        "motion.rotary_tolerance",
        Dimension::Angle,
        Sign::NotNegative,
        |m, _| &mut m.motion.rotary_tolerance_rad,
        "how far a rotary axis may be from its angle at a rounded corner; default: 0.01 deg (assumed)",
    ),
    quantity(
        "times.tool_change",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.tool_change_s,
        "the time of a tool change",
    ),
    quantity(
        "times.spindle_per_1000_rpm",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.spindle_per_1000_rpm_s,
        "the time the spindle needs to become 1000 rpm faster or slower",
    ),
    quantity(
        "times.spindle_orient",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.spindle_orient_s,
        "the time the spindle needs to orient (M19), in addition to the time it needs to stop",
    ),
    quantity(
        "times.probe",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.probe_s,
        "the time the machine waits after a probe has touched",
    ),
    quantity(
        "times.m_code",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.m_code_s,
        "the time an M code that switches coolant takes until the control continues",
    ),
    Row {
        path: "macros.variables.<variable>",
        slot: Slot::Number(|m, k| m.macros.variables.entry(k.number).or_default()),
        doc: "the value of a macro variable when the program starts: common variables, inputs, timers and others that do not follow from the program",
    },
    Row {
        path: "macros.date",
        slot: Slot::Stamp { stamp: Stamp::Date, place: |m, _| &mut m.macros.date },
        doc: "the date that macro programs read; Chordal never reads the clock",
    },
    Row {
        path: "macros.time",
        slot: Slot::Stamp { stamp: Stamp::Time, place: |m, _| &mut m.macros.time },
        doc: "the time that macro programs read",
    },
    Row {
        path: "macros.inputs",
        slot: Slot::NumberList(|m, _| &mut m.macros.inputs),
        doc: "what the operator types where the program asks (Fadal INPUT), in order",
    },
    Row {
        path: "shop_codes.<code>",
        slot: Slot::Table(|m, k| {
            m.shop_codes.entry(k.code).or_default();
        }),
        doc: "a custom M code: one that the machine has and its control does not, such as `shop_codes.M120`; it may also be one that the control has and Chordal does not carry out",
    },
    quantity(
        "shop_codes.<code>.time",
        Dimension::Time,
        Sign::NotNegative,
        |m, k| &mut m.shop_codes.entry(k.code).or_default().time_s,
        "the time the machine takes for it",
    ),
    Row {
        path: "shop_codes.<code>.label",
        slot: Slot::OptionalText(|m, k| &mut m.shop_codes.entry(k.code).or_default().label),
        doc: "what it does, for display",
    },
    Row {
        path: "probe.hit",
        slot: Slot::Word {
            what: "hit",
            words: &["end", "none"],
            set: |m, _, word| {
                m.probe.planes = [None; 6];
                m.probe.hit = Some(match word {
                    "none" => ProbeHit::Nothing,
                    _ => ProbeHit::End,
                });
            },
        },
        doc: "what probe and skip moves (G31, G38.2) touch: something where they `end`, nothing (`none`), or a plane; default: `end`",
    },
    quantity(
        "probe.hit.<axis>",
        Dimension::Length,
        Sign::Any,
        |m, k| {
            m.probe.hit = None;
            by_axis(&mut m.probe.planes, k)
        },
        "a plane that probe moves touch, work coordinates; of several planes the nearest one on the move",
    ),
    Row {
        path: "settings.<setting>",
        slot: Slot::Setting,
        doc: "a parameter of the control, with the name that its manual uses",
    },
];

fn axis<'m>(machine: &'m mut Machine, keys: &Keys) -> &'m mut AxisLimits {
    machine.axes[keys.axis.map_or(0, |axis| axis as usize)].get_or_insert_default()
}

fn rotary<'m>(machine: &'m mut Machine, keys: &Keys) -> &'m mut Rotary {
    &mut machine.rotary[(keys.number as usize).min(2)]
}

fn tool<'m>(machine: &'m mut Machine, keys: &Keys) -> &'m mut Tool {
    machine.tools.entry(keys.number).or_default()
}

fn work_offset<'m>(machine: &'m mut Machine, keys: &Keys) -> &'m mut WorkOffset {
    machine.work_offsets.entry(keys.name.clone()).or_default()
}

fn by_axis<'m>(values: &'m mut [Option<f64>; 6], keys: &Keys) -> &'m mut Option<f64> {
    &mut values[keys.axis.map_or(0, |axis| axis as usize)]
}
