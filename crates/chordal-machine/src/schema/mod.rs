//! The table of the keys of a machine file: the path of each key, its values, its meaning and the field for its value.
//! The checks, suggestions, assignments, the reference and the writer of machine files use it.

mod bodies;
mod rows;
mod solids;
mod tables;
mod turning;
mod value_text;
mod words;

pub(crate) use self::rows::{ROWS, tool};
pub(crate) use self::tables::{tables, written_tables};
use self::words::WordField;

use crate::axis::Axis;
use crate::machine::{CustomCodeSpec, DiameterProgramming, Machine};
use crate::offset::work_offset_name;
use crate::quantity::QuantityDimension;
use crate::setup::{Body, ContourPoint};
use crate::tool::HolderSegment;

/// The field of a machine that a key fills.
pub(crate) type MachineField<T> = for<'m, 'k> fn(&'m mut Machine, &'k PlaceholderKeys) -> &'m mut T;

/// The values of the `<placeholders>` in the path of a key.
#[derive(Clone, Debug, Default)]
pub(crate) struct PlaceholderKeys {
    pub(crate) axis: Option<Axis>,
    pub(crate) number: u32,
    pub(crate) code: ShopName,
    pub(crate) name: String,
}

/// A key, or a table that has a meaning without keys.
pub(crate) struct SchemaRow {
    /// Its path, with the placeholders `<axis>`, `<rotary>`, `<tool>`, `<offset>`, `<point>`, `<code>` and `<setting>`.
    pub(crate) path: &'static str,
    /// The kind of its value, and the field for it.
    pub(crate) slot: SchemaSlot,
    /// Its meaning.
    pub(crate) doc: &'static str,
}

/// The kind of the value of a key, and the field for it.
pub(crate) enum SchemaSlot {
    Quantity {
        dimension: QuantityDimension,
        sign: SignRule,
        place: MachineField<Option<f64>>,
    },
    /// A position of an axis, which is halved if the axis is programmed as a diameter.
    Position(MachineField<Option<f64>>),
    /// Two positions of an axis, halved in the same case.
    Range(MachineField<Option<(f64, f64)>>),
    /// A whole number in a range.
    Count {
        from: u32,
        to: u32,
        place: MachineField<Option<u32>>,
    },
    /// Cylinders and cones, from bottom to top.
    Solids(MachineField<Vec<HolderSegment>>),
    /// Points: height and radius.
    Profile(MachineField<Vec<[f64; 2]>>),
    /// Corners of a holder: signed distances along X and Z.
    Outline(MachineField<Vec<[f64; 2]>>),
    /// Points of a contour: X as a diameter, Z, and the radius of an arc to the point.
    Contour(MachineField<Vec<ContourPoint>>),
    /// The kind of a tool, in the words of old files.
    Kind,
    /// Whether the words of an axis are radii or diameters.
    Programmed,
    Text(MachineField<String>),
    OptionalText(MachineField<Option<String>>),
    TextList(MachineField<Vec<String>>),
    Word {
        what: &'static str,
        words: &'static [&'static str],
        place: MachineField<dyn WordField>,
    },
    /// A letter or a designation of an insert.
    Insert,
    /// The designation of a holder.
    HolderDesignation,
    Flag(MachineField<bool>),
    /// A number without a unit.
    Number(MachineField<f64>),
    /// A quantity, or a number if there is no dimension, within bounds; `usual` are usual values, for messages.
    Within {
        dimension: Option<QuantityDimension>,
        from: f64,
        to: f64,
        usual: &'static str,
        place: MachineField<Option<f64>>,
    },
    /// The three components of a direction, which is not zero.
    Direction(MachineField<Option<[f64; 3]>>),
    /// Numbers without a unit.
    NumberList(MachineField<Vec<f64>>),
    /// A date or a time, stored as its digits.
    Stamp {
        stamp: DateOrTime,
        place: MachineField<Option<u32>>,
    },
    /// The block delete switches.
    Switches,
    /// An override: `"80 %"` or the fraction 0.8.
    Override(MachineField<Option<f64>>),
    /// The name of a file, relative to the file with the key.
    File(MachineField<Option<String>>),
    /// A setting of the control, stored as written.
    Setting,
    /// The file to inherit from, which is read before all other keys.
    Inherits,
    /// A table that has a meaning even if it is empty.
    Table(fn(&mut Machine, &PlaceholderKeys)),
    /// The same for a custom code, whose position in the file is stored.
    ShopCode,
    /// The same for stock, a fixture or a target, whose position in the file is stored.
    Body(MachineField<Body>),
    /// The same for an axis, which `false` removes.
    Axis,
}

/// A date or a time.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum DateOrTime {
    Date,
    Time,
}

impl DateOrTime {
    /// Its name and its format, for messages.
    pub(crate) const fn words(self) -> (&'static str, &'static str) {
        match self {
            DateOrTime::Date => ("a date", "2024-05-17"),
            DateOrTime::Time => ("a time", "13:45:00"),
        }
    }

    /// Its digits as one number; `None` if the text has another format.
    pub(crate) fn parse(self, text: &str) -> Option<u32> {
        let (separator, widths, limits) = match self {
            DateOrTime::Date => ('-', [4, 2, 2], [(0, 9999), (1, 12), (1, 31)]),
            DateOrTime::Time => (':', [2, 2, 2], [(0, 23), (0, 59), (0, 59)]),
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
pub(crate) enum SignRule {
    Any,
    NotNegative,
    Positive,
}

/// Every row, in the order of the reference.
pub(crate) fn rows() -> impl Iterator<Item = &'static SchemaRow> {
    let bodies = [
        &bodies::STOCK[..],
        &bodies::FIXTURE,
        &bodies::TARGET,
        &bodies::OWN,
        &bodies::MATERIALS,
        &solids::LINEAR,
        &solids::SOLIDS,
    ];
    let (tools, others) = ROWS.split_at(rows::AFTER_TOOLS);
    tools.iter().chain(&turning::ROWS).chain(others).chain(bodies.into_iter().flatten())
}

/// The row with a path, including its placeholders.
pub(crate) fn row(path: &str) -> Option<&'static SchemaRow> {
    rows().find(|row| row.path == path)
}

/// The names that may follow a path, or its placeholder.
pub(crate) fn children(path: &str) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = Vec::new();
    for row in rows() {
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

/// Uses a key as the value of a placeholder. The error has the expected values and their format.
pub(crate) fn bind(
    placeholder: &str,
    key: &str,
    keys: &mut PlaceholderKeys,
) -> Result<(), (String, String)> {
    match placeholder {
        "<axis>" => {
            let found = Axis::ALL.into_iter().find(|axis| axis.letter().to_string() == key);
            keys.axis = Some(found.ok_or_else(|| {
                let help = match key.as_bytes() {
                    [letter] => Axis::from_letter(*letter).map(|axis| {
                        format!("did you mean `{axis}`? Axes are written in capital letters")
                    }),
                    _ => None,
                };
                let all = || "the axes are X, Y, Z, A, B and C".to_string();
                (format!("`{key}` is not an axis"), help.unwrap_or_else(all))
            })?);
        }
        "<rotary>" => {
            let place = ["A", "B", "C"].iter().position(|letter| *letter == key);
            keys.number = place.map(|place| place as u32).ok_or_else(|| {
                let help = "the rotary axes are A, B and C, in capital letters".to_string();
                (format!("`{key}` is not a rotary axis"), help)
            })?;
        }
        "<tool>" => {
            keys.number = whole(key).ok_or_else(|| {
                let help = "a tool is named by its number, such as `tools.5`".to_string();
                (format!("`{key}` is not a tool number"), help)
            })?;
        }
        "<variable>" => {
            let name = key.strip_prefix('#').unwrap_or(key);
            if let Some(name) = variable_name(name) {
                keys.name = name;
                return Ok(());
            }
            keys.number = whole(name).filter(|number| *number > 0).ok_or_else(|| {
                let help = "a variable is named by its number, such as `macros.variables.500`, or by the name that a \
                            control gives it, such as `macros.variables.\"<_hal[spindle.0.at-speed]>\"`";
                (format!("`{key}` is not a variable"), help.to_string())
            })?;
        }
        "<code>" => {
            keys.code = ShopName::of(key).ok_or_else(|| {
                let help = "an M code is named by letter and number, such as `shop_codes.M120`, and a \
                            program by O and its number, such as `shop_codes.O9810`";
                (format!("`{key}` is not an M code or a program"), help.to_string())
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
                            P300, \"G54.2 P1\" to P8, \"G154 P1\" to P99, \"G59 P7\" to P254, E1 to E48, G52 and \
                            EXT";
                (format!("`{key}` is not a work offset"), help.to_string())
            })?;
        }
        _ => keys.name = key.to_string(),
    }
    Ok(())
}

/// The name of a variable in angle brackets, in lower case without blanks, as controls compare names.
fn variable_name(key: &str) -> Option<String> {
    let name = key.strip_prefix('<')?.strip_suffix('>')?;
    let name: String = name.chars().filter(|letter| !letter.is_whitespace()).collect();
    (!name.is_empty()).then(|| name.to_lowercase())
}

/// The largest number of a custom M code: ten times it fits into 16 bits, and controls have at most four digits.
const MAX_M_CODE: u16 = 6553;

/// What a table of `shop_codes` describes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ShopName {
    M(u16),
    Program(u32),
}

impl Default for ShopName {
    fn default() -> ShopName {
        ShopName::M(0)
    }
}

impl ShopName {
    /// Reads `M120`, `O9810`, or a call: `G65 P9810`. `None` for other keys.
    fn of(key: &str) -> Option<ShopName> {
        let key = key.trim().to_ascii_uppercase();
        if let Some(number) = ["G65", "G66", "G66.1", "M98"]
            .iter()
            .find_map(|code| whole(key.strip_prefix(code)?.trim_start().strip_prefix('P')?))
        {
            return Some(ShopName::Program(number));
        }
        let number = whole(key.get(1..)?)?;
        match key.as_bytes()[0] {
            b'M' => {
                let number = u16::try_from(number).ok()?;
                (number <= MAX_M_CODE).then_some(ShopName::M(number))
            }
            b'O' => Some(ShopName::Program(number)),
            _ => None,
        }
    }

    /// Its entry in a machine, which is created if missing.
    pub(crate) fn place(self, machine: &mut Machine) -> &mut CustomCodeSpec {
        match self {
            ShopName::M(number) => machine.shop_codes.entry(number).or_default(),
            ShopName::Program(number) => machine.shop_programs.entry(number).or_default(),
        }
    }
}

fn whole(text: &str) -> Option<u32> {
    let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    digits.then(|| text.parse().ok()).flatten()
}

impl SchemaSlot {
    /// Whether it is a table with keys, not a value.
    fn is_table(&self) -> bool {
        matches!(
            self,
            SchemaSlot::Table(_) | SchemaSlot::ShopCode | SchemaSlot::Body(_) | SchemaSlot::Axis
        )
    }
}

impl SchemaRow {
    /// The name of the key, or the name before its placeholder.
    pub(crate) fn name(&self) -> &'static str {
        self.path.rsplit('.').find(|name| !name.starts_with('<')).unwrap_or(self.path)
    }

    /// Its values in words, with an example.
    fn takes(&self) -> String {
        let by_axis = self.path.contains("<axis>");
        let kind = |dimension: QuantityDimension| {
            let mut text = format!("{}: `\"{}\"`", dimension.noun(), example(dimension));
            if by_axis {
                let rotary = dimension.of_rotary();
                text += &format!("; on A, B, C {}: `\"{}\"`", rotary.noun(), example(rotary));
            }
            text
        };
        match &self.slot {
            SchemaSlot::Quantity { dimension, sign, .. } => {
                kind(*dimension)
                    + match sign {
                        SignRule::Any => "",
                        SignRule::NotNegative => "; not negative",
                        SignRule::Positive => "; more than zero",
                    }
            }
            SchemaSlot::Position(_) => kind(QuantityDimension::Length),
            SchemaSlot::Count { from, to, .. } => format!("a whole number from {from} to {to}"),
            SchemaSlot::Solids(_) => "a list of `[\"height\", \"diameter\"]`, of a cone `[\"height\", \"lower diameter\", \"upper diameter\"]`".into(),
            SchemaSlot::Profile(_) => "a list of `[\"height\", \"radius\"]`, from the end up".into(),
            SchemaSlot::Outline(_) => "a list of `[\"X\", \"Z\"]`".into(),
            SchemaSlot::Contour(_) => "a list of `[\"X\", \"Z\"]`, of an arc `[\"X\", \"Z\", \"radius\"]`".into(),
            SchemaSlot::Kind => "a text".into(),
            SchemaSlot::Programmed => {
                let [radius, diameter] = [DiameterProgramming::Radius, DiameterProgramming::Diameter];
                format!("`\"{}\"` or `\"{}\"`", radius.as_str(), diameter.as_str())
            }
            SchemaSlot::Range(_) => {
                "two lengths, the lower first: `[\"0 mm\", \"762 mm\"]`; on A, B, C two angles"
                    .into()
            }
            SchemaSlot::Text(_) | SchemaSlot::OptionalText(_) | SchemaSlot::File(_) | SchemaSlot::Inherits => "a text".into(),
            SchemaSlot::TextList(_) => "a list of texts".into(),
            SchemaSlot::Word { words, .. } => {
                let words: Vec<String> = words.iter().map(|word| format!("`\"{word}\"`")).collect();
                crate::suggest::or_list(&words)
            }
            SchemaSlot::Insert => "a text: `\"CNMG120408\"`, `\"C\"`".into(),
            SchemaSlot::HolderDesignation => "a text: `\"PCLNR2525M12\"`".into(),
            SchemaSlot::Flag(_) => "`true` or `false`".into(),
            SchemaSlot::Number(_) => "a number".into(),
            SchemaSlot::Within { dimension: Some(dimension), from, to, .. } => {
                format!("{}; from {from} to {to} {}", kind(*dimension), dimension.inside())
            }
            SchemaSlot::Within { dimension: None, from, to, .. } => format!("a number from {from} to {to}"),
            SchemaSlot::Direction(_) => "three numbers, not all zero: `[0, 1, 1]`".into(),
            SchemaSlot::NumberList(_) => "a list of numbers".into(),
            SchemaSlot::Stamp { stamp, .. } => {
                let (what, form) = stamp.words();
                format!("{what}: `\"{form}\"`")
            }
            SchemaSlot::Switches => "`true`, `false` or a list of 1 to 9".into(),
            SchemaSlot::Override(_) => {
                "a text with `%` or a fraction: `\"80 %\"`, `0.8`; above 0, at most 200 %".into()
            }
            SchemaSlot::Setting => "a text, a number or `true`/`false`, depending on the setting".into(),
            SchemaSlot::Table(_) | SchemaSlot::ShopCode | SchemaSlot::Body(_) => "a table".into(),
            SchemaSlot::Axis => "a table, or `false`".into(),
        }
    }
}

const fn example(dimension: QuantityDimension) -> &'static str {
    match dimension {
        QuantityDimension::Length => "0.5 in",
        QuantityDimension::Angle => "90 deg",
        QuantityDimension::Time => "1.5 s",
        QuantityDimension::Velocity => "900 in/min",
        QuantityDimension::AngularVelocity => "3600 deg/min",
        QuantityDimension::Acceleration => "2000 mm/s^2",
        QuantityDimension::AngularAcceleration => "360 deg/s^2",
        QuantityDimension::Jerk => "100 m/s^3",
        QuantityDimension::AngularJerk => "7200 deg/s^3",
        QuantityDimension::SpindleSpeed => "6000 rpm",
        QuantityDimension::Power => "15 kW",
        QuantityDimension::Stress => "1500 N/mm^2",
    }
}

/// A key of a machine file, for the reference.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SchemaKey {
    /// Its path, with placeholders in angle brackets: `axes.<axis>.travel`.
    pub path: &'static str,
    /// Its values in words, with an example.
    pub takes: String,
    /// Its meaning.
    pub meaning: &'static str,
    /// Its default; `None` if its row gives none.
    pub default: Option<&'static str>,
    /// It is a table with keys, not a value.
    pub is_table: bool,
}

/// The keys of a machine file, in the order of the reference.
pub fn schema_keys() -> Vec<SchemaKey> {
    let key = |row: &SchemaRow| {
        let (meaning, default) = match row.doc.split_once("; otherwise ") {
            Some((meaning, default)) => (meaning, Some(default)),
            None => (row.doc, None),
        };
        let is_table = row.slot.is_table();
        SchemaKey { path: row.path, takes: row.takes(), meaning, default, is_table }
    };
    rows().map(key).collect()
}

/// The keys of a machine file, as a table in Markdown.
pub fn schema_reference() -> String {
    let mut text = String::from(
        "A quantity is a text with its unit. Lengths: `mm`, `cm`, `m`, `um`, `in` (also `inch` or \
         `\"`), `ft`. Times: `s`, `ms`, `min`. Angles: `deg`, `rad`, `rev`. Rates are per `s` or \
         `min` (`in/min`, `mm/s^2`, `m/s³`); `ipm` and `rpm` are short forms.\n\n\
         || key | value | meaning \n|---|---|---|\n",
    );
    for row in rows() {
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
        for row in rows() {
            assert_eq!(rows().filter(|other| other.path == row.path).count(), 1, "{}", row.path);
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
        assert!(rows().all(|row| text.contains(&format!("| `{}` |", row.path))));
    }
}
