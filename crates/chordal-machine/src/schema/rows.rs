//! The rows of the table of keys.

use chordal_kinematics::RolloverRule;

use super::words::WordField;
use super::{DateOrTime, MachineField, PlaceholderKeys, SchemaRow, SchemaSlot, SignRule};
use crate::axis::{Axis, PerAxis};
use crate::control::ControlName;
use crate::machine::{
    AxisLimits, Machine, ProbeHit, RapidShape, RotaryAxis, RotaryTarget, StartingKinematics,
    TcpFrame, Turret, WorkOffset,
};
use crate::quantity::QuantityDimension;
use crate::tool::{Tool, ToolShape};

pub(super) const fn quantity(
    path: &'static str,
    dimension: QuantityDimension,
    sign: SignRule,
    place: MachineField<Option<f64>>,
    doc: &'static str,
) -> SchemaRow {
    SchemaRow { path, slot: SchemaSlot::Quantity { dimension, sign, place }, doc }
}

pub(super) const fn length(
    path: &'static str,
    sign: SignRule,
    place: MachineField<Option<f64>>,
    doc: &'static str,
) -> SchemaRow {
    quantity(path, QuantityDimension::Length, sign, place, doc)
}

const fn position(
    path: &'static str,
    place: MachineField<Option<f64>>,
    doc: &'static str,
) -> SchemaRow {
    SchemaRow { path, slot: SchemaSlot::Position(place), doc }
}

pub(super) const fn word(
    path: &'static str,
    what: &'static str,
    words: &'static [&'static str],
    place: MachineField<dyn WordField>,
    doc: &'static str,
) -> SchemaRow {
    SchemaRow { path, slot: SchemaSlot::Word { what, words, place }, doc }
}

/// The slot for the words of an enum that has `ALL` and `as_str`.
macro_rules! words {
    ($kind:ty) => {{
        const WORDS: [&str; <$kind>::ALL.len()] = {
            let mut words = [""; <$kind>::ALL.len()];
            let mut at = 0;
            while at < words.len() {
                words[at] = <$kind>::ALL[at].as_str();
                at += 1;
            }
            words
        };
        &WORDS
    }};
}
pub(super) use words;

/// The index after the rows of tools.
pub(super) const AFTER_TOOLS: usize = {
    let mut at = 0;
    while at < ROWS.len() && ROWS[at].path.as_bytes()[0] != b'w' {
        at += 1;
    }
    at
};

pub(crate) const ROWS: &[SchemaRow] = &[
    SchemaRow {
        path: "inherits",
        slot: SchemaSlot::Inherits,
        doc: "a built-in machine, or a file relative to this one; its keys apply unless this file sets them",
    },
    SchemaRow {
        path: "machine",
        slot: SchemaSlot::Inherits,
        doc: "the same for a setup file or the `chordal.toml` of a folder: the name of the machine stays",
    },
    SchemaRow {
        path: "name",
        slot: SchemaSlot::Text(|m, _| &mut m.name),
        doc: "the short name of the machine; default: the file's name without folder and extension",
    },
    SchemaRow {
        path: "title",
        slot: SchemaSlot::Text(|m, _| &mut m.title),
        doc: "the full name, for display",
    },
    SchemaRow {
        path: "notes",
        slot: SchemaSlot::TextList(|m, _| &mut m.notes),
        doc: "notes for people",
    },
    word(
        "control",
        "control",
        words!(ControlName),
        |m, _| &mut m.control,
        "the control that runs its programs",
    ),
    word(
        "turret",
        "side of a turret",
        words!(Turret),
        |m, _| &mut m.turret,
        "the side of the axis on which the turret of a lathe stands. The page of `chordal view` draws X up for `rear` and down for `front`, programs mean the same; otherwise `rear`",
    ),
    length(
        "turret_clearance",
        SignRule::Positive,
        |m, _| &mut m.turret_clearance_mm,
        "how near the tip of a tool may be to what the program cuts while the turret of a lathe turns; otherwise only a turn inside of what is cut is reported",
    ),
    SchemaRow {
        path: "axes.<axis>",
        slot: SchemaSlot::Axis,
        doc: "an axis of the machine: X, Y, Z, or the rotary A, B, C. A file that names none has X, Y and Z without limits; `A = false` removes an inherited axis",
    },
    SchemaRow {
        path: "axes.<axis>.travel",
        slot: SchemaSlot::Range(|m, k| &mut axis(m, k).travel),
        doc: "the lowest and the highest position, machine coordinates",
    },
    SchemaRow {
        path: "axes.<axis>.programmed",
        slot: SchemaSlot::Programmed,
        doc: "what the words of the axis say: how far the slide is from zero (`radius`, the default), or twice that (`diameter`), as X of a lathe. Every position on a diameter axis in this file is a diameter too, as on the control's pages: `travel`, `home`, `reference_points`, `work_offsets`, `tools.<tool>.offset` with its wear, `probe.hit`. Speeds, accelerations, `I` and `R` of arcs are never doubled. Linear axes only",
    },
    quantity(
        "axes.<axis>.max_velocity",
        QuantityDimension::Velocity,
        SignRule::Positive,
        |m, k| &mut axis(m, k).max_velocity,
        "rapid speed",
    ),
    quantity(
        "axes.<axis>.max_acceleration",
        QuantityDimension::Acceleration,
        SignRule::Positive,
        |m, k| &mut axis(m, k).max_acceleration,
        "the largest acceleration",
    ),
    quantity(
        "axes.<axis>.max_jerk",
        QuantityDimension::Jerk,
        SignRule::Positive,
        |m, k| &mut axis(m, k).max_jerk,
        "the largest jerk, the rate of change of acceleration",
    ),
    quantity(
        "axes.<axis>.rapid_acceleration",
        QuantityDimension::Acceleration,
        SignRule::Positive,
        |m, k| &mut axis(m, k).rapid_acceleration,
        "the largest acceleration of rapids, if it differs from that of cuts",
    ),
    quantity(
        "axes.<axis>.rapid_jerk",
        QuantityDimension::Jerk,
        SignRule::Positive,
        |m, k| &mut axis(m, k).rapid_jerk,
        "the largest jerk of rapids, if it differs from that of cuts",
    ),
    word(
        "rotary.<rotary>.turns",
        "what turns",
        words!(RotaryTarget),
        |m, k| &mut rotary(m, k).turns,
        "what A, B or C turns: the part (`table`) or the tool (`head`). Of several tables A carries B, and B carries C; of several heads C carries B, and B carries A; otherwise it is not known, and pictures are drawn without rotation",
    ),
    SchemaRow {
        path: "rotary.<rotary>.reversed",
        slot: SchemaSlot::Flag(|m, k| &mut rotary(m, k).reversed),
        doc: "`true`: its positive direction is opposite to ISO 841, where a positive angle turns the tool about the part like a right-hand screw along X, Y or Z",
    },
    position(
        "rotary.<rotary>.center.<axis>",
        |m, k| &mut rotary(m, k).center_mm[k.axis.map_or(0, |axis| axis as usize % 3)],
        "a point on its axis for pictures: X, Y and Z, program coordinates; otherwise the program's zero",
    ),
    position(
        "rotary.<rotary>.point.<axis>",
        |m, k| &mut rotary(m, k).point_mm[k.axis.map_or(0, |axis| axis as usize % 3)],
        "a point on its axis with A, B and C at zero, for the kinematics of the machine: of a table in machine coordinates, of a head from the gauge point, at which the spindle holds tools. A coordinate along which the axis is directed is not needed; otherwise the kinematics are not known",
    ),
    SchemaRow {
        path: "rotary.<rotary>.direction",
        slot: SchemaSlot::Direction(|m, k| &mut rotary(m, k).direction),
        doc: "the direction of its axis with A, B and C at zero, of any length: parts along X, Y and Z, such as `[0, 1, 1]` for a nutating axis; otherwise along X for A, Y for B, Z for C",
    },
    word(
        "rotary.<rotary>.on",
        "rotary axis",
        &["A", "B", "C"],
        |m, k| &mut rotary(m, k).on,
        "the table that carries this table, or the head that carries this head; otherwise as `turns` says",
    ),
    word(
        "rotary.<rotary>.rollover",
        "rule of rollover",
        words!(RolloverRule),
        |m, k| &mut rotary(m, k).rollover,
        "how a programmed absolute angle is reached: in the short direction (`shortest`), in the direction of its sign (`sign`), or through every turn (`linear`); otherwise `linear`",
    ),
    word(
        "kinematics.tcp_frame",
        "frame of tool centre point control",
        words!(TcpFrame),
        |m, _| &mut m.tcp_frame,
        "the frame of tool centre point control on tables: as it lies on the part with the tables at zero (`zero`), or as they are where it is switched on (`activation`); otherwise `zero`",
    ),
    word(
        "kinematics.at_start",
        "kinematics",
        words!(StartingKinematics),
        |m, _| &mut m.starting_kinematics,
        "what X, Y and Z of a program are where it begins, on a control that switches its kinematics (LinuxCNC): positions of the axes, or the tip on the part; `M68 E3 Q0` is this one, `Q1` the other; otherwise they are those of the axes, and M68 switches nothing",
    ),
    quantity(
        "feed.max",
        QuantityDimension::Velocity,
        SignRule::Positive,
        |m, _| &mut m.feed.max_mm_per_s,
        "the largest feed that may be programmed",
    ),
    quantity(
        "feed.max_rotary",
        QuantityDimension::AngularVelocity,
        SignRule::Positive,
        |m, _| &mut m.feed.max_rad_per_s,
        "the same for moves of rotary axes alone",
    ),
    word(
        "rapid.shape",
        "rapid shape",
        words!(RapidShape),
        |m, _| &mut m.rapid,
        "rapids of several axes: each axis at its own speed (`dog-leg`), or along a straight line (`straight`); default: that of the control",
    ),
    quantity(
        "spindle.max",
        QuantityDimension::SpindleSpeed,
        SignRule::Positive,
        |m, _| &mut m.spindle_max_rpm,
        "the largest spindle speed",
    ),
    quantity(
        "spindle.live_max",
        QuantityDimension::SpindleSpeed,
        SignRule::Positive,
        |m, _| &mut m.live_tool_max_rpm,
        "the largest speed of live tools in the turret of a lathe",
    ),
    quantity(
        "spindle.power",
        QuantityDimension::Power,
        SignRule::Positive,
        |m, _| &mut m.spindle_power_kw,
        "the power that the spindle has for a cut, as `\"15 kW\"` or `\"20 hp\"`; otherwise no cut is compared with it",
    ),
    SchemaRow {
        path: "tools.<tool>",
        slot: SchemaSlot::Table(|m, k| {
            tool(m, k);
        }),
        doc: "a tool, by number",
    },
    length(
        "tools.<tool>.diameter",
        SignRule::Any,
        |m, k| &mut tool(m, k).diameter_mm,
        "its diameter; on some controls a negative diameter is for the other side",
    ),
    length(
        "tools.<tool>.diameter_wear",
        SignRule::Any,
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
    word(
        "tools.<tool>.shape",
        "tool shape",
        words!(ToolShape),
        |m, k| &mut tool(m, k).shape,
        "what it is. A shape needs its dimensions: `flat` and `ball` the diameter, `bull` also the corner radius, `chamfer` and `drill` the point angle, `tap` the pitch, `thread mill` pitch and teeth, `t-slot` the flute length (its thickness) and the shank diameter (its neck), `lollipop` the shank diameter, `form` the profile, `insert` nose radius and tip (on its stock also the insert and its approach angle), `groove` width and tip. Nothing is guessed for one that is missing",
    ),
    length(
        "tools.<tool>.shank_diameter",
        SignRule::Positive,
        |m, k| &mut tool(m, k).shank_diameter_mm,
        "the diameter of a round shank from the cutting edges up; `shank` says more",
    ),
    length(
        "tools.<tool>.corner_radius",
        SignRule::NotNegative,
        |m, k| &mut tool(m, k).corner_radius_mm,
        "the corner radius, between its side and its end",
    ),
    quantity(
        "tools.<tool>.point_angle",
        QuantityDimension::Angle,
        SignRule::Positive,
        |m, k| &mut tool(m, k).point_angle_rad,
        "the included angle of the point of a drill or chamfer mill",
    ),
    length(
        "tools.<tool>.tip_diameter",
        SignRule::NotNegative,
        |m, k| &mut tool(m, k).tip_diameter_mm,
        "the flat at the end of a chamfer mill; otherwise it has a sharp point",
    ),
    length(
        "tools.<tool>.pitch",
        SignRule::Positive,
        |m, k| &mut tool(m, k).pitch_mm,
        "the pitch of a tap or thread mill",
    ),
    SchemaRow {
        path: "tools.<tool>.teeth",
        slot: SchemaSlot::Count { from: 1, to: 1000, place: |m, k| &mut tool(m, k).teeth },
        doc: "number of teeth around it; for a thread mill, along its axis",
    },
    length(
        "tools.<tool>.max_chip",
        SignRule::Positive,
        |m, k| &mut tool(m, k).max_chip_mm,
        "the thickest chip that a tooth may take; otherwise none is too thick",
    ),
    length(
        "tools.<tool>.min_chip",
        SignRule::Positive,
        |m, k| &mut tool(m, k).min_chip_mm,
        "the thinnest chip that its edges cut, below which they rub; otherwise none is too thin",
    ),
    length(
        "tools.<tool>.nose_radius",
        SignRule::NotNegative,
        |m, k| &mut tool(m, k).nose_radius_mm,
        "the nose radius of an insert",
    ),
    SchemaRow {
        path: "tools.<tool>.tip",
        slot: SchemaSlot::Count { from: 0, to: 9, place: |m, k| &mut tool(m, k).tip },
        doc: "direction from the centre of the nose radius of an insert to the imaginary tool tip (the programmed point): the number of that direction on the control",
    },
    SchemaRow {
        path: "tools.<tool>.profile",
        slot: SchemaSlot::Profile(|m, k| &mut tool(m, k).profile),
        doc: "the outline of a form tool: heights above its end with the radius there",
    },
    length(
        "tools.<tool>.flute_length",
        SignRule::Positive,
        |m, k| &mut tool(m, k).flute_length_mm,
        "length of the cutting edges, from its end upwards",
    ),
    SchemaRow {
        path: "tools.<tool>.shank",
        slot: SchemaSlot::Solids(|m, k| &mut tool(m, k).shank),
        doc: "the shank above the cutting edges: cylinders and cones, the lowest first",
    },
    SchemaRow {
        path: "tools.<tool>.holder",
        slot: SchemaSlot::Solids(|m, k| &mut tool(m, k).holder),
        doc: "the holder above the shank, in the same form",
    },
    SchemaRow {
        path: "tools.<tool>.kind",
        slot: SchemaSlot::Kind,
        doc: "the old way to say what it is. A word for a shape is read as `shape`, any other text as `description`",
    },
    SchemaRow {
        path: "tools.<tool>.description",
        slot: SchemaSlot::OptionalText(|m, k| &mut tool(m, k).description),
        doc: "a name for people, such as `roughing end mill`",
    },
    SchemaRow {
        path: "tools.<tool>.comment",
        slot: SchemaSlot::OptionalText(|m, k| &mut tool(m, k).comment),
        doc: "free text",
    },
    SchemaRow {
        path: "work_offsets.<offset>",
        slot: SchemaSlot::Table(|m, k| {
            work_offset(m, k);
        }),
        doc: "a work offset: `G54` to `G59`, `\"G59.1\"` to `\"G59.3\"`, `\"G54.1 P1\"`, `\"G154 P1\"` (also `G110`), `\"G59 P7\"`, `E1` to `E48`, `G52`, `EXT`; `\"G54.2 P1\"` is the error of a clamped part, with A, B and C at which it was measured. A name with a point or a space needs quotes",
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
    SchemaRow {
        path: "switches.block_delete",
        slot: SchemaSlot::Switches,
        doc: "`true` skips every block that starts with `/`; a list such as `[1, 3]` skips only the blocks with these numbers; a `/` without a number is 1",
    },
    SchemaRow {
        path: "switches.optional_stop",
        slot: SchemaSlot::Flag(|m, _| &mut m.switches.optional_stop),
        doc: "M01 stops",
    },
    length(
        "program.clearance",
        SignRule::Any,
        |m, _| &mut m.clearance_mm,
        "the plane above which rapids may move freely, Z in work coordinates",
    ),
    quantity(
        "motion.servo_period",
        QuantityDimension::Time,
        SignRule::Positive,
        |m, _| &mut m.motion.servo_period_s,
        "how often the control sends a position to the axes; otherwise 1 ms",
    ),
    SchemaRow {
        path: "motion.feed_override",
        slot: SchemaSlot::Override(|m, _| &mut m.motion.feed_override),
        doc: "the feed override; default: 100 %",
    },
    SchemaRow {
        path: "motion.rapid_override",
        slot: SchemaSlot::Override(|m, _| &mut m.motion.rapid_override),
        doc: "the rapid override; default: 100 %",
    },
    length(
        "motion.corner_tolerance",
        SignRule::NotNegative,
        |m, _| &mut m.motion.corner_tolerance_mm,
        "how far from the path the tool may pass a corner if corners are rounded and the control gives no tolerance; otherwise 0.05 mm (assumed)",
    ),
    length(
        "motion.exact_path_tolerance",
        SignRule::NotNegative,
        |m, _| &mut m.motion.exact_path_tolerance_mm,
        "how far from the path the tool may be in exact path mode where a line meets a tangent arc; default: 0, so it stops there",
    ),
    length(
        "motion.rapid_corner_tolerance",
        SignRule::NotNegative,
        |m, _| &mut m.motion.rapid_corner_tolerance_mm,
        "how far the bends of a dog-leg rapid, and corners between rapids that do not stop, may be rounded; default: 10 mm (assumed)",
    ),
    quantity(
        "motion.rotary_tolerance",
        QuantityDimension::Angle,
        SignRule::NotNegative,
        |m, _| &mut m.motion.rotary_tolerance_rad,
        "how far a rotary axis may be from its angle at a rounded corner; default: 0.01 deg (assumed)",
    ),
    quantity(
        "times.tool_change",
        QuantityDimension::Time,
        SignRule::NotNegative,
        |m, _| &mut m.times.tool_change_s,
        "the time of a tool change",
    ),
    quantity(
        "times.spindle_per_1000_rpm",
        QuantityDimension::Time,
        SignRule::NotNegative,
        |m, _| &mut m.times.spindle_per_1000_rpm_s,
        "how long the spindle takes to change its speed by 1000 rpm",
    ),
    quantity(
        "times.spindle_orient",
        QuantityDimension::Time,
        SignRule::NotNegative,
        |m, _| &mut m.times.spindle_orient_s,
        "how long the spindle takes to orient (M19), in addition to slowing down",
    ),
    quantity(
        "times.probe",
        QuantityDimension::Time,
        SignRule::NotNegative,
        |m, _| &mut m.times.probe_s,
        "how long the machine stops after the probe has touched",
    ),
    quantity(
        "times.m_code",
        QuantityDimension::Time,
        SignRule::NotNegative,
        |m, _| &mut m.times.m_code_s,
        "the time an M code that switches coolant takes until the control continues",
    ),
    SchemaRow {
        path: "macros.variables.<variable>",
        slot: SchemaSlot::Number(|m, k| match k.name.as_str() {
            "" => m.macros.variables.entry(k.number).or_default(),
            name => m.macros.named_variables.entry(name.to_string()).or_default(),
        }),
        doc: "value of a macro variable when the program starts, by its number or by the name that the control gives it (`<_hal[spindle.0.at-speed]>`): common variables, inputs, timers and others that the program does not set",
    },
    SchemaRow {
        path: "macros.date",
        slot: SchemaSlot::Stamp { stamp: DateOrTime::Date, place: |m, _| &mut m.macros.date },
        doc: "the date that macro programs read; Chordal never reads the clock",
    },
    SchemaRow {
        path: "macros.time",
        slot: SchemaSlot::Stamp { stamp: DateOrTime::Time, place: |m, _| &mut m.macros.time },
        doc: "the time that macro programs read",
    },
    SchemaRow {
        path: "macros.inputs",
        slot: SchemaSlot::NumberList(|m, _| &mut m.macros.inputs),
        doc: "what the operator types where the program asks (Fadal INPUT), in order",
    },
    SchemaRow {
        path: "shop_codes.<code>",
        slot: SchemaSlot::ShopCode,
        doc: "a custom M code: one that the machine has and its control does not, such as `shop_codes.M120`; it may also be one that the control has and Chordal does not carry out. Or a called program that no file holds, such as `shop_codes.O9810` for `G65 P9810`; a table without `blocks` says that it moves nothing",
    },
    quantity(
        "shop_codes.<code>.time",
        QuantityDimension::Time,
        SignRule::NotNegative,
        |m, k| &mut k.code.place(m).time_s,
        "the time the machine takes for it",
    ),
    SchemaRow {
        path: "shop_codes.<code>.label",
        slot: SchemaSlot::OptionalText(|m, k| &mut k.code.place(m).label),
        doc: "what it does, for display",
    },
    SchemaRow {
        path: "shop_codes.<code>.blocks",
        slot: SchemaSlot::OptionalText(|m, k| &mut k.code.place(m).blocks),
        doc: "the NC blocks that it runs, as a subprogram would; a macro call gives them its arguments as #1 to #33",
    },
    word(
        "probe.hit",
        "hit",
        words!(ProbeHit),
        |m, _| &mut m.probe,
        "what probe and skip moves (G31, G38.2) touch: something where they end (`end`), nothing (`none`), or a plane; otherwise they touch where they end",
    ),
    position(
        "probe.hit.<axis>",
        |m, k| {
            m.probe.hit = None;
            by_axis(&mut m.probe.planes, k)
        },
        "a plane that probe moves touch, work coordinates; of several planes the nearest on the move",
    ),
    SchemaRow {
        path: "settings.<setting>",
        slot: SchemaSlot::Setting,
        doc: "a parameter of the control, with the name that its manual uses",
    },
];

fn axis<'m>(machine: &'m mut Machine, keys: &PlaceholderKeys) -> &'m mut AxisLimits {
    machine.axes[keys.axis.map_or(0, |axis| axis as usize)].get_or_insert_default()
}

fn rotary<'m>(machine: &'m mut Machine, keys: &PlaceholderKeys) -> &'m mut RotaryAxis {
    &mut machine.rotary[(keys.number as usize).min(2)]
}

pub(crate) fn tool<'m>(machine: &'m mut Machine, keys: &PlaceholderKeys) -> &'m mut Tool {
    machine.tools.entry(keys.number).or_default()
}

fn work_offset<'m>(machine: &'m mut Machine, keys: &PlaceholderKeys) -> &'m mut WorkOffset {
    machine.work_offsets.entry(keys.name.clone()).or_default()
}

fn by_axis<'m>(
    values: &'m mut PerAxis<Option<f64>>,
    keys: &PlaceholderKeys,
) -> &'m mut Option<f64> {
    &mut values[keys.axis.map_or(0, |axis| axis as usize)]
}
