//! The rows of the table of keys.

use super::{Keys, Place, Row, Sign, Slot, Stamp};
use crate::axis::{AXES, Axis, PerAxis};
use crate::control::ControlName;
use crate::machine::{
    AxisLimits, Machine, ProbeHit, RapidShape, Rotary, Turns, Turret, WorkOffset,
};
use crate::quantity::Dimension;
use crate::tool::{Tool, ToolShape};

pub(super) const fn quantity(
    path: &'static str,
    dimension: Dimension,
    sign: Sign,
    place: Place<Option<f64>>,
    doc: &'static str,
) -> Row {
    Row { path, slot: Slot::Quantity { dimension, sign, place }, doc }
}

const fn position(path: &'static str, place: Place<Option<f64>>, doc: &'static str) -> Row {
    Row { path, slot: Slot::Position(place), doc }
}

/// The words of an enum that has `ALL` and `as_str`.
macro_rules! words {
    ($kind:ty) => {{
        let mut words = [""; <$kind>::ALL.len()];
        let mut at = 0;
        while at < words.len() {
            words[at] = <$kind>::ALL[at].as_str();
            at += 1;
        }
        words
    }};
}
pub(super) use words;

const SHAPES: &[&str] = &words!(ToolShape);

const TURRETS: &[&str] = &words!(Turret);

const CONTROLS: &[&str] = &words!(ControlName);

/// Where the rows of tools end.
pub(super) const AFTER_TOOLS: usize = {
    let mut at = 0;
    while at < ROWS.len() && ROWS[at].path.as_bytes()[0] != b'w' {
        at += 1;
    }
    at
};

pub(crate) const ROWS: &[Row] = &[
    Row {
        path: "inherits",
        slot: Slot::Inherits,
        doc: "a built-in machine, or a file relative to this one; its keys apply unless this file sets them",
    },
    Row {
        path: "machine",
        slot: Slot::Inherits,
        doc: "the same for a setup file or the `chordal.toml` of a folder: the name of the machine stays",
    },
    Row {
        path: "name",
        slot: Slot::Text(|m, _| &mut m.name),
        doc: "the short name of the machine; default: the file's name without folder and extension",
    },
    Row { path: "title", slot: Slot::Text(|m, _| &mut m.title), doc: "the full name, for display" },
    Row { path: "notes", slot: Slot::TextList(|m, _| &mut m.notes), doc: "notes for people" },
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
        path: "turret",
        slot: Slot::Word {
            what: "side of a turret",
            words: TURRETS,
            set: |m, _, word| {
                if let Some(side) = Turret::ALL.into_iter().find(|side| side.as_str() == word) {
                    m.turret = side;
                }
            },
        },
        doc: "the side of the axis on which the turret of a lathe stands. The page of `chordal view` draws X up for `rear` and down for `front`, programs mean the same; otherwise `rear`",
    },
    quantity(
        "turret_clearance",
        Dimension::Length,
        Sign::Positive,
        |m, _| &mut m.turret_clearance_mm,
        "how near the tip of a tool may be to what the program cuts while the turret of a lathe turns; otherwise only a turn inside of what is cut is reported",
    ),
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
    Row {
        path: "axes.<axis>.programmed",
        slot: Slot::Programmed,
        doc: "what the words of the axis say: how far the slide is from zero (`radius`, the default), or twice that (`diameter`), as X of a lathe. Every position on a diameter axis in this file is a diameter too, as on the control's pages: `travel`, `home`, `reference_points`, `work_offsets`, `tools.<tool>.offset` with its wear, `probe.hit`. Speeds, accelerations, `I` and `R` of arcs are never doubled. Linear axes only",
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
        doc: "what A, B or C turns: the part (`table`) or the tool (`head`). Of several tables A carries B, and B carries C; of several heads C carries B, and B carries A; otherwise it is not known, and pictures are drawn without rotation",
    },
    Row {
        path: "rotary.<rotary>.reversed",
        slot: Slot::Flag(|m, k| &mut rotary(m, k).reversed),
        doc: "`true`: its positive direction is opposite to ISO 841, where a positive angle turns the tool about the part like a right-hand screw along X, Y or Z",
    },
    position(
        "rotary.<rotary>.center.<axis>",
        |m, k| &mut rotary(m, k).center_mm[k.axis.map_or(0, |axis| axis as usize % 3)],
        "a point on its axis: X, Y and Z, program coordinates; otherwise the program's zero",
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
        "the same for moves of rotary axes alone",
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
    quantity(
        "spindle.live_max",
        Dimension::SpindleSpeed,
        Sign::Positive,
        |m, _| &mut m.live_tool_max_rpm,
        "the largest speed of live tools in the turret of a lathe",
    ),
    quantity(
        "spindle.power",
        Dimension::Power,
        Sign::Positive,
        |m, _| &mut m.spindle_power_kw,
        "the power that the spindle has for a cut, as `\"15 kW\"` or `\"20 hp\"`; otherwise no cut is compared with it",
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
    position(
        "tools.<tool>.length",
        |m, k| &mut tool(m, k).offset[Axis::Z as usize],
        "its length offset: the same as `offset.Z`",
    ),
    position(
        "tools.<tool>.length_wear",
        |m, k| &mut tool(m, k).offset_wear[Axis::Z as usize],
        "added to the length offset: the same as `offset_wear.Z`",
    ),
    position(
        "tools.<tool>.offset.<axis>",
        |m, k| by_axis(&mut tool(m, k).offset, k),
        "its geometry offset along an axis: X and Z of a turning tool; a diameter on an axis that is programmed in diameters",
    ),
    position(
        "tools.<tool>.offset_wear.<axis>",
        |m, k| by_axis(&mut tool(m, k).offset_wear, k),
        "added to the geometry offset; a diameter if that is one",
    ),
    Row {
        path: "tools.<tool>.shape",
        slot: Slot::Word {
            what: "tool shape",
            words: SHAPES,
            set: |m, k, word| {
                tool(m, k).shape = ToolShape::ALL.into_iter().find(|shape| shape.as_str() == word);
            },
        },
        doc: "what it is. A shape needs its dimensions: `flat` and `ball` the diameter, `bull` also the corner radius, `chamfer` and `drill` the point angle, `tap` the pitch, `thread mill` pitch and teeth, `t-slot` the flute length (its thickness) and the shank diameter (its neck), `lollipop` the shank diameter, `form` the profile, `insert` nose radius and tip (on its stock also the insert and its approach angle), `groove` width and tip. Nothing is guessed for one that is missing",
    },
    quantity(
        "tools.<tool>.shank_diameter",
        Dimension::Length,
        Sign::Positive,
        |m, k| &mut tool(m, k).shank_diameter_mm,
        "the diameter of a round shank from the cutting edges up; `shank` says more",
    ),
    quantity(
        "tools.<tool>.corner_radius",
        Dimension::Length,
        Sign::NotNegative,
        |m, k| &mut tool(m, k).corner_radius_mm,
        "the corner radius, between its side and its end",
    ),
    quantity(
        "tools.<tool>.point_angle",
        Dimension::Angle,
        Sign::Positive,
        |m, k| &mut tool(m, k).point_angle_rad,
        "the included angle of the point of a drill or chamfer mill",
    ),
    quantity(
        "tools.<tool>.tip_diameter",
        Dimension::Length,
        Sign::NotNegative,
        |m, k| &mut tool(m, k).tip_diameter_mm,
        "the flat at the end of a chamfer mill; otherwise it has a sharp point",
    ),
    quantity(
        "tools.<tool>.pitch",
        Dimension::Length,
        Sign::Positive,
        |m, k| &mut tool(m, k).pitch_mm,
        "the pitch of a tap or thread mill",
    ),
    Row {
        path: "tools.<tool>.teeth",
        slot: Slot::Count { from: 1, to: 1000, place: |m, k| &mut tool(m, k).teeth },
        doc: "number of teeth around it; for a thread mill, along its axis",
    },
    quantity(
        "tools.<tool>.max_chip",
        Dimension::Length,
        Sign::Positive,
        |m, k| &mut tool(m, k).max_chip_mm,
        "the thickest chip that a tooth may take; otherwise none is too thick",
    ),
    quantity(
        "tools.<tool>.min_chip",
        Dimension::Length,
        Sign::Positive,
        |m, k| &mut tool(m, k).min_chip_mm,
        "the thinnest chip that its edges cut, below which they rub; otherwise none is too thin",
    ),
    quantity(
        "tools.<tool>.nose_radius",
        Dimension::Length,
        Sign::NotNegative,
        |m, k| &mut tool(m, k).nose_radius_mm,
        "the nose radius of an insert",
    ),
    Row {
        path: "tools.<tool>.tip",
        slot: Slot::Count { from: 0, to: 9, place: |m, k| &mut tool(m, k).tip },
        doc: "direction from the centre of the nose radius of an insert to the imaginary tool tip (the programmed point): the number of that direction on the control",
    },
    Row {
        path: "tools.<tool>.profile",
        slot: Slot::Profile(|m, k| &mut tool(m, k).profile),
        doc: "the outline of a form tool: heights above its end with the radius there",
    },
    quantity(
        "tools.<tool>.flute_length",
        Dimension::Length,
        Sign::Positive,
        |m, k| &mut tool(m, k).flute_length_mm,
        "length of the cutting edges, from its end upwards",
    ),
    Row {
        path: "tools.<tool>.shank",
        slot: Slot::Solids(|m, k| &mut tool(m, k).shank),
        doc: "the shank above the cutting edges: cylinders and cones, the lowest first",
    },
    Row {
        path: "tools.<tool>.holder",
        slot: Slot::Solids(|m, k| &mut tool(m, k).holder),
        doc: "the holder above the shank, in the same form",
    },
    Row {
        path: "tools.<tool>.kind",
        slot: Slot::Kind,
        doc: "the old way to say what it is. A word for a shape is read as `shape`, any other text as `description`",
    },
    Row {
        path: "tools.<tool>.description",
        slot: Slot::OptionalText(|m, k| &mut tool(m, k).description),
        doc: "a name for people, such as `roughing end mill`",
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
        doc: "a work offset: `G54` to `G59`, `\"G59.1\"` to `\"G59.3\"`, `\"G54.1 P1\"`, `\"G154 P1\"` (also `G110`), `\"G59 P7\"`, `E1` to `E48`, `G52`, `EXT`. A name with a point or a space needs quotes",
    },
    position(
        "work_offsets.<offset>.<axis>",
        |m, k| by_axis(&mut work_offset(m, k).values, k),
        "where its zero is, machine coordinates; a diameter on an axis that is programmed in diameters",
    ),
    position(
        "home.<axis>",
        |m, k| by_axis(&mut m.home, k),
        "reference point 1, machine coordinates",
    ),
    position(
        "reference_points.<point>.<axis>",
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
        "how often the control sends a position to the axes; otherwise 1 ms",
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
        "how far from the path the tool may pass a corner if corners are rounded and the control gives no tolerance; otherwise 0.05 mm (assumed)",
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
        "how long the spindle takes to change its speed by 1000 rpm",
    ),
    quantity(
        "times.spindle_orient",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.spindle_orient_s,
        "how long the spindle takes to orient (M19), in addition to slowing down",
    ),
    quantity(
        "times.probe",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.probe_s,
        "how long the machine stops after the probe has touched",
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
        slot: Slot::Number(|m, k| match k.name.as_str() {
            "" => m.macros.variables.entry(k.number).or_default(),
            name => m.macros.named_variables.entry(name.to_string()).or_default(),
        }),
        doc: "value of a macro variable when the program starts, by its number or by the name that the control gives it (`<_hal[spindle.0.at-speed]>`): common variables, inputs, timers and others that the program does not set",
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
        slot: Slot::ShopCode,
        doc: "a custom M code: one that the machine has and its control does not, such as `shop_codes.M120`; it may also be one that the control has and Chordal does not carry out. Or a called program that no file holds, such as `shop_codes.O9810` for `G65 P9810`; a table without `blocks` says that it moves nothing",
    },
    quantity(
        "shop_codes.<code>.time",
        Dimension::Time,
        Sign::NotNegative,
        |m, k| &mut k.code.place(m).time_s,
        "the time the machine takes for it",
    ),
    Row {
        path: "shop_codes.<code>.label",
        slot: Slot::OptionalText(|m, k| &mut k.code.place(m).label),
        doc: "what it does, for display",
    },
    Row {
        path: "shop_codes.<code>.blocks",
        slot: Slot::OptionalText(|m, k| &mut k.code.place(m).blocks),
        doc: "the NC blocks that it runs, as a subprogram would; a macro call gives them its arguments as #1 to #33",
    },
    Row {
        path: "probe.hit",
        slot: Slot::Word {
            what: "hit",
            words: &["end", "none"],
            set: |m, _, word| {
                m.probe.planes = [None; AXES];
                m.probe.hit = Some(match word {
                    "none" => ProbeHit::Nothing,
                    _ => ProbeHit::End,
                });
            },
        },
        doc: "what probe and skip moves (G31, G38.2) touch: something where they end (`end`), nothing (`none`), or a plane; otherwise they touch where they end",
    },
    position(
        "probe.hit.<axis>",
        |m, k| {
            m.probe.hit = None;
            by_axis(&mut m.probe.planes, k)
        },
        "a plane that probe moves touch, work coordinates; of several planes the nearest on the move",
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

pub(crate) fn tool<'m>(machine: &'m mut Machine, keys: &Keys) -> &'m mut Tool {
    machine.tools.entry(keys.number).or_default()
}

fn work_offset<'m>(machine: &'m mut Machine, keys: &Keys) -> &'m mut WorkOffset {
    machine.work_offsets.entry(keys.name.clone()).or_default()
}

fn by_axis<'m>(values: &'m mut PerAxis<Option<f64>>, keys: &Keys) -> &'m mut Option<f64> {
    &mut values[keys.axis.map_or(0, |axis| axis as usize)]
}
