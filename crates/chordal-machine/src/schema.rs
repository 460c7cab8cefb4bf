//! The one table of the keys of a machine file: where each is, what it takes, what it means and
//! where its value goes. Checking, suggestions, assignments and the reference read it.

use crate::axis::Axis;
use crate::control::ControlName;
use crate::machine::{AxisLimits, Machine, ProbeHit, RapidShape, Tool, WorkOffset};
use crate::offset::work_offset_name;
use crate::quantity::Dimension;

/// The field of a machine that a key fills.
pub(crate) type Place<T> = for<'m, 'k> fn(&'m mut Machine, &'k Keys) -> &'m mut T;

/// What the `<placeholders>` of a path stand for in a certain key.
#[derive(Clone, Debug, Default)]
pub(crate) struct Keys {
    pub(crate) axis: Option<Axis>,
    pub(crate) number: u32,
    pub(crate) name: String,
}

/// A key, or a table with a meaning of its own.
pub(crate) struct Row {
    /// Where it is; `<axis>`, `<tool>`, `<offset>`, `<point>` and `<setting>` vary.
    pub(crate) path: &'static str,
    /// What it takes and where that goes.
    pub(crate) slot: Slot,
    /// What it means.
    pub(crate) doc: &'static str,
}

/// What a key takes and where that goes.
pub(crate) enum Slot {
    Quantity {
        dimension: Dimension,
        sign: Sign,
        place: Place<Option<f64>>,
    },
    Range {
        dimension: Dimension,
        place: Place<Option<(f64, f64)>>,
    },
    Text(Place<String>),
    OptionalText(Place<Option<String>>),
    TextList(Place<Vec<String>>),
    Word {
        what: &'static str,
        words: &'static [&'static str],
        set: fn(&mut Machine, &str),
    },
    Flag(Place<bool>),
    /// A number without a unit.
    Number(Place<f64>),
    /// Numbers without a unit.
    NumberList(Place<Vec<f64>>),
    /// A date or a time, kept as its digits.
    Stamp {
        stamp: Stamp,
        place: Place<Option<u32>>,
    },
    /// The block delete switches.
    Switches,
    /// An override: `"80 %"` or the fraction 0.8.
    Override(Place<Option<f64>>),
    /// A setting of the control, kept raw.
    Setting,
    /// Read before all other keys.
    Inherits,
    /// A table that exists by being named, empty or not.
    Table(fn(&mut Machine, &Keys)),
    /// The same for an axis, which `false` takes away.
    Axis,
}

/// A date or a time.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stamp {
    Date,
    Time,
}

impl Stamp {
    /// What it is called, and how it is written.
    pub(crate) const fn words(self) -> (&'static str, &'static str) {
        match self {
            Stamp::Date => ("a date", "2024-05-17"),
            Stamp::Time => ("a time", "13:45:00"),
        }
    }

    /// Its digits as one number; `None` when the text is no such thing.
    pub(crate) fn parse(self, text: &str) -> Option<u32> {
        let (separator, widths, limits) = match self {
            Stamp::Date => ('-', [4, 2, 2], [(0, 9999), (1, 12), (1, 31)]),
            Stamp::Time => (':', [2, 2, 2], [(0, 23), (0, 59), (0, 59)]),
        };
        let parts: Vec<&str> = text.split(separator).collect();
        if parts.len() != 3 {
            return None;
        }
        let mut number = 0;
        for ((part, width), (low, high)) in parts.into_iter().zip(widths).zip(limits) {
            let value =
                whole(part).filter(|value| part.len() == width && (low..=high).contains(value))?;
            number = number * 100 + value;
        }
        Some(number)
    }
}

/// Which signs a quantity may have.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sign {
    Any,
    NotNegative,
    Positive,
}

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
        doc: "a built-in machine, or a file relative to this one, whose keys hold where this file says nothing else",
    },
    Row {
        path: "name",
        slot: Slot::Text(|m, _| &mut m.name),
        doc: "the name it is called by; otherwise the file's name without folder and ending",
    },
    Row { path: "title", slot: Slot::Text(|m, _| &mut m.title), doc: "a name for people" },
    Row { path: "notes", slot: Slot::TextList(|m, _| &mut m.notes), doc: "remarks" },
    Row {
        path: "control",
        slot: Slot::Word {
            what: "control",
            words: CONTROLS,
            set: |m, word| {
                if let Ok(control) = word.parse() {
                    m.control = control;
                }
            },
        },
        doc: "whose rules its programs are read by",
    },
    Row {
        path: "axes.<axis>",
        slot: Slot::Axis,
        doc: "an axis of the machine: X, Y, Z, or the rotary A, B, C. A file that names none has X, Y and Z without limits; `A = false` takes an inherited axis away",
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
        "the largest change of acceleration",
    ),
    quantity(
        "axes.<axis>.rapid_acceleration",
        Dimension::Acceleration,
        Sign::Positive,
        |m, k| &mut axis(m, k).rapid_acceleration,
        "the largest acceleration of rapids, where it is not that of cuts",
    ),
    quantity(
        "axes.<axis>.rapid_jerk",
        Dimension::Jerk,
        Sign::Positive,
        |m, k| &mut axis(m, k).rapid_jerk,
        "the largest change of acceleration of rapids, where it is not that of cuts",
    ),
    quantity(
        "feed.max",
        Dimension::Velocity,
        Sign::Positive,
        |m, _| &mut m.feed.max_mm_per_s,
        "the fastest feed that may be programmed",
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
            set: |m, word| {
                m.rapid = [RapidShape::DogLeg, RapidShape::Straight]
                    .into_iter()
                    .find(|s| s.as_str() == word);
            },
        },
        doc: "rapids of several axes: each axis at its own speed (`dog-leg`), or along the line (`straight`); otherwise the control's default",
    },
    quantity(
        "spindle.max",
        Dimension::SpindleSpeed,
        Sign::Positive,
        |m, _| &mut m.spindle_max_rpm,
        "the fastest spindle speed",
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
        "its diameter; some controls take a negative one for the other side",
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
        "the radius between its side and its end",
    ),
    Row {
        path: "tools.<tool>.kind",
        slot: Slot::OptionalText(|m, k| &mut tool(m, k).kind),
        doc: "free text, as `end mill`",
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
        doc: "a work offset: `G54` to `G59`, `\"G59.1\"` to `\"G59.3\"`, `\"G54.1 P1\"`, `\"G154 P1\"` (also `G110`), `E1` to `E48`, `G52`, `EXT`. A name with a point or a space needs its quotes",
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
        doc: "`true` skips every block that starts with `/`; a list as `[1, 3]` only those of these numbers, of which a bare `/` is 1",
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
        "how often the control sends a place to the axes; otherwise 1 ms",
    ),
    Row {
        path: "motion.feed_override",
        slot: Slot::Override(|m, _| &mut m.motion.feed_override),
        doc: "where the feed override stands; otherwise 100 %",
    },
    Row {
        path: "motion.rapid_override",
        slot: Slot::Override(|m, _| &mut m.motion.rapid_override),
        doc: "where the rapid override stands; otherwise 100 %",
    },
    quantity(
        "motion.corner_tolerance",
        Dimension::Length,
        Sign::NotNegative,
        |m, _| &mut m.motion.corner_tolerance_mm,
        "how far from the path a corner may be passed where corners are rounded and the control names no tolerance; otherwise 0.05 mm, which is a choice",
    ),
    quantity(
        "motion.exact_path_tolerance",
        Dimension::Length,
        Sign::NotNegative,
        |m, _| &mut m.motion.exact_path_tolerance_mm,
        "how far from the path the tool may be in exact path mode where a line meets a tangent arc; otherwise 0: it stops there",
    ),
    quantity(
        "motion.rapid_corner_tolerance",
        Dimension::Length,
        Sign::NotNegative,
        |m, _| &mut m.motion.rapid_corner_tolerance_mm,
        "how far the bends of a dog-leg rapid, and corners between rapids that do not stop, may be rounded; otherwise 10 mm, which is a choice",
    ),
    quantity(
        "motion.rotary_tolerance",
        Dimension::Angle,
        Sign::NotNegative,
        |m, _| &mut m.motion.rotary_tolerance_rad,
        "how far a rotary axis may be from its angle at a rounded corner; otherwise 0.01 deg, which is a choice",
    ),
    quantity(
        "times.tool_change",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.tool_change_s,
        "how long a change of tool takes",
    ),
    quantity(
        "times.spindle_per_1000_rpm",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.spindle_per_1000_rpm_s,
        "how long the spindle takes to become 1000 rpm faster or slower",
    ),
    quantity(
        "times.spindle_orient",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.spindle_orient_s,
        "how long the spindle takes to find its mark (M19), beside its slowing down",
    ),
    quantity(
        "times.probe",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.probe_s,
        "how long the machine stands when a probe has touched",
    ),
    quantity(
        "times.m_code",
        Dimension::Time,
        Sign::NotNegative,
        |m, _| &mut m.times.m_code_s,
        "how long an M code that switches coolant takes until the control goes on",
    ),
    Row {
        path: "macros.variables.<variable>",
        slot: Slot::Number(|m, k| m.macros.variables.entry(k.number).or_default()),
        doc: "value of a macro variable when the program starts: common variables, inputs, timers and others that a program alone does not tell",
    },
    Row {
        path: "macros.date",
        slot: Slot::Stamp { stamp: Stamp::Date, place: |m, _| &mut m.macros.date },
        doc: "the date that macro programs read; a run never asks a clock",
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
        path: "probe.hit",
        slot: Slot::Word {
            what: "hit",
            words: &["end", "none"],
            set: |m, word| {
                m.probe.planes = [None; 6];
                m.probe.hit = Some(match word {
                    "none" => ProbeHit::Nothing,
                    _ => ProbeHit::End,
                });
            },
        },
        doc: "what probe and skip moves (G31, G38.2) touch: something where they `end`, `none`, or a plane; without it they touch where they end",
    },
    quantity(
        "probe.hit.<axis>",
        Dimension::Length,
        Sign::Any,
        |m, k| {
            m.probe.hit = None;
            by_axis(&mut m.probe.planes, k)
        },
        "a plane that probe moves touch, work coordinates; of several the nearest on the way",
    ),
    Row {
        path: "settings.<setting>",
        slot: Slot::Setting,
        doc: "a parameter of the control, by the name its manual uses",
    },
];

fn axis<'m>(machine: &'m mut Machine, keys: &Keys) -> &'m mut AxisLimits {
    machine.axes[keys.axis.map_or(0, |axis| axis as usize)].get_or_insert_default()
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

/// The row of a path, placeholders and all.
pub(crate) fn row(path: &str) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.path == path)
}

/// The names that may follow a path, or its one placeholder.
pub(crate) fn children(path: &str) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = Vec::new();
    for row in ROWS {
        let rest = match path {
            "" => Some(row.path),
            _ => row.path.strip_prefix(path).and_then(|rest| rest.strip_prefix('.')),
        };
        if let Some(name) = rest.and_then(|rest| rest.split('.').next())
            && !names.contains(&name)
        {
            names.push(name);
        }
    }
    names
}

/// Takes a key for a placeholder; the error says what the placeholder takes, and how to write it.
pub(crate) fn bind(placeholder: &str, key: &str, keys: &mut Keys) -> Result<(), (String, String)> {
    match placeholder {
        "<axis>" => {
            let found = Axis::ALL.into_iter().find(|axis| axis.letter().to_string() == key);
            keys.axis = Some(found.ok_or_else(|| {
                let help = match key.as_bytes() {
                    [letter] => Axis::from_letter(*letter)
                        .map(|axis| format!("did you mean `{axis}`? Axes are written in capitals")),
                    _ => None,
                };
                let all = || "the axes are X, Y, Z, A, B and C".to_string();
                (format!("`{key}` is not an axis"), help.unwrap_or_else(all))
            })?);
        }
        "<tool>" => {
            keys.number = whole(key).ok_or_else(|| {
                let help = "a tool is named by its number, as `tools.5`".to_string();
                (format!("`{key}` is not a tool number"), help)
            })?;
        }
        "<variable>" => {
            let digits = key.strip_prefix('#').unwrap_or(key);
            keys.number = whole(digits).filter(|number| *number > 0).ok_or_else(|| {
                let help =
                    "a variable is named by its number, as `macros.variables.500`".to_string();
                (format!("`{key}` is not the number of a variable"), help)
            })?;
        }
        "<point>" => {
            keys.number = whole(key).filter(|n| (2..=4).contains(n)).ok_or_else(|| {
                let help = match key {
                    "1" => "reference point 1 is written as `[home]`",
                    _ => "the reference points are 2, 3 and 4",
                };
                (format!("`{key}` is not a reference point"), help.to_string())
            })?;
        }
        "<offset>" => {
            keys.name = work_offset_name(key).ok_or_else(|| {
                let help = "work offsets are G54 to G59, \"G59.1\" to \"G59.3\", \"G54.1 P1\" to \
                            P300, \"G154 P1\" to P99, E1 to E48, G52 and EXT";
                (format!("`{key}` is not a work offset"), help.to_string())
            })?;
        }
        _ => keys.name = key.to_string(),
    }
    Ok(())
}

fn whole(text: &str) -> Option<u32> {
    let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    digits.then(|| text.parse().ok()).flatten()
}

impl Row {
    /// The key's own name, or the one before a placeholder.
    pub(crate) fn name(&self) -> &'static str {
        self.path.rsplit('.').find(|name| !name.starts_with('<')).unwrap_or(self.path)
    }

    /// What it takes, in words, with an example.
    fn takes(&self) -> String {
        let by_axis = self.path.contains("<axis>");
        let kind = |dimension: Dimension| {
            let mut text = format!("{}: `\"{}\"`", dimension.noun(), example(dimension));
            if by_axis {
                let rotary = dimension.of_rotary();
                text += &format!("; on A, B, C {}: `\"{}\"`", rotary.noun(), example(rotary));
            }
            text
        };
        match &self.slot {
            Slot::Quantity { dimension, sign, .. } => {
                kind(*dimension)
                    + match sign {
                        Sign::Any => "",
                        Sign::NotNegative => "; not negative",
                        Sign::Positive => "; more than zero",
                    }
            }
            Slot::Range { .. } => {
                "two lengths, the lower first: `[\"0 mm\", \"762 mm\"]`; on A, B, C two angles"
                    .into()
            }
            Slot::Text(_) | Slot::OptionalText(_) | Slot::Inherits => "a text".into(),
            Slot::TextList(_) => "a list of texts".into(),
            Slot::Word { words, .. } => {
                let words: Vec<String> = words.iter().map(|word| format!("`\"{word}\"`")).collect();
                crate::suggest::or_list(&words)
            }
            Slot::Flag(_) => "`true` or `false`".into(),
            Slot::Number(_) => "a number".into(),
            Slot::NumberList(_) => "a list of numbers".into(),
            Slot::Stamp { stamp, .. } => {
                let (what, form) = stamp.words();
                format!("{what}: `\"{form}\"`")
            }
            Slot::Switches => "`true`, `false` or a list of 1 to 9".into(),
            Slot::Override(_) => {
                "a text with `%` or a fraction: `\"80 %\"`, `0.8`; above 0, at most 200 %".into()
            }
            Slot::Setting => "a text, a number or `true`/`false`, as the control takes it".into(),
            Slot::Table(_) => "a table".into(),
            Slot::Axis => "a table, or `false`".into(),
        }
    }
}

const fn example(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Length => "0.5 in",
        Dimension::Angle => "90 deg",
        Dimension::Time => "1.5 s",
        Dimension::Velocity => "900 in/min",
        Dimension::AngularVelocity => "3600 deg/min",
        Dimension::Acceleration => "2000 mm/s^2",
        Dimension::AngularAcceleration => "360 deg/s^2",
        Dimension::Jerk => "100 m/s^3",
        Dimension::AngularJerk => "7200 deg/s^3",
        Dimension::SpindleSpeed => "6000 rpm",
    }
}

/// The keys of a machine file, as a table in Markdown.
pub fn schema_reference() -> String {
    let mut text = String::from(
        "A quantity is a text with its unit. Lengths: `mm`, `cm`, `m`, `um`, `in` (also `inch` or \
         `\"`), `ft`. Times: `s`, `ms`, `min`. Angles: `deg`, `rad`, `rev`. Rates are per `s` or \
         `min` (`in/min`, `mm/s^2`, `m/s³`), with `ipm` and `rpm` for short.\n\n\
         | key | takes | meaning |\n|---|---|---|\n",
    );
    for row in ROWS {
        let (path, takes, doc) = (row.path, row.takes(), row.doc);
        text.push_str(&format!("| `{path}` | {takes} | {doc} |\n"));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_has_names_or_one_placeholder() {
        let mut paths = vec![String::new()];
        for row in ROWS {
            assert_eq!(
                ROWS.iter().filter(|other| other.path == row.path).count(),
                1,
                "{}",
                row.path
            );
            let ends = row.path.match_indices('.').map(|(at, _)| at);
            paths.extend(ends.map(|at| row.path[..at].to_string()));
        }
        for path in paths {
            let children = children(&path);
            let varying = children.iter().filter(|name| name.starts_with('<')).count();
            assert!(varying == 0 || children.len() == 1, "{path}: {children:?}");
        }
    }

    #[test]
    fn the_reference_names_every_key() {
        let text = schema_reference();
        assert!(ROWS.iter().all(|row| text.contains(&format!("| `{}` |", row.path))));
    }
}
