//! Checks keys and values against the schema, and stores valid ones in the machine.

mod designations;
mod tools;

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::{ErrorSource, MachineError};
use crate::files::in_folder_of;
use crate::machine::Machine;
use crate::quantity::{QuantityDimension, QuantityError, machine_quantity};
use crate::schema::{self, PlaceholderKeys, ROWS, SchemaRow, SchemaSlot, SignRule, rows};
use crate::suggest;
use crate::toml_text::key_text;
use crate::value::{SettingEntry, SettingValue};

/// The keys that name the file to inherit from: in a machine file, and in a setup file.
pub(crate) const INHERITS: [&str; 2] = ["inherits", "machine"];

/// The largest override on operator panels: 200 %.
const MAX_OVERRIDE: f64 = 2.0;

/// A position in the schema: its path in the schema, and as written in the file.
#[derive(Clone, Default)]
pub(crate) struct SchemaLocation {
    path: String,
    shown: String,
    keys: PlaceholderKeys,
}

impl SchemaLocation {
    /// True before the first key.
    pub(crate) fn is_top(&self) -> bool {
        self.path.is_empty()
    }

    /// True for a key of a tool.
    pub(crate) fn is_of_tool(&self) -> bool {
        self.path.starts_with("tools.")
    }

    /// The location of a key in this one.
    pub(crate) fn step(
        &self,
        key: &str,
        span: Range<usize>,
        source: &ErrorSource,
    ) -> Result<SchemaLocation, MachineError> {
        let children = schema::children(&self.path);
        let mut keys = self.keys.clone();
        let name = match children[..] {
            [name] if name.starts_with('<') => {
                if let Err((message, help)) = schema::bind(name, key, &mut keys) {
                    let help = self.forgotten_quotes(key).unwrap_or(help);
                    return Err(source.error(Some(span), message, Some(help)));
                }
                name
            }
            _ => match children.iter().find(|name| **name == key) {
                Some(name) => name,
                None => return Err(self.unknown(key, span, &children, source)),
            },
        };
        let join = |before: &str, name: &str| match before {
            "" => name.to_string(),
            _ => format!("{before}.{name}"),
        };
        Ok(SchemaLocation {
            path: join(&self.path, name),
            shown: join(&self.shown, &key_text(key)),
            keys,
        })
    }

    /// The row of the schema here, if this is a key or a table that has a row.
    pub(crate) fn row(&self) -> Option<&'static SchemaRow> {
        schema::row(&self.path)
    }

    /// A help text if quotes are missing: `[work_offsets.G59.1]` is a table `1` in a table `G59`.
    fn forgotten_quotes(&self, key: &str) -> Option<String> {
        let digits = key.starts_with(|c: char| c.is_ascii_digit());
        let offset = self.shown.strip_prefix("work_offsets.").filter(|_| digits)?;
        Some(format!("a name with a point needs quotes: `work_offsets.\"{offset}.{key}\"`"))
    }

    fn unknown(
        &self,
        key: &str,
        span: Range<usize>,
        children: &[&'static str],
        source: &ErrorSource,
    ) -> MachineError {
        // `max_velocity` in `[feed]`: the key is `max`, and the rest repeats the table.
        let longer = children
            .iter()
            .copied()
            .find(|name| key.strip_prefix(name).is_some_and(|rest| rest.starts_with(['_', '-'])));
        let near = longer.or_else(|| suggest::nearest(key, children.iter().copied()));
        let near = near.map(|near| {
            if self.shown.is_empty() { near.to_string() } else { format!("{}.{near}", self.shown) }
        });
        // A key at the top of the file is not a table.
        let fits = |path: &&str| self.shown.is_empty() || path.contains('.');
        let near = near.or_else(|| key_of_other_table(key).filter(fits).map(str::to_string));
        let (message, takes) = match self.shown.as_str() {
            "" => (format!("a machine file has no key `{key}`"), "its keys are".to_string()),
            shown => (format!("`{shown}` has no key `{key}`"), "it takes".to_string()),
        };
        let help = match near {
            Some(near) => format!("did you mean `{near}`?"),
            None => {
                let names: Vec<String> = children.iter().map(|name| format!("`{name}`")).collect();
                format!("{takes} {}", names.join(", "))
            }
        };
        source.error(Some(span), message, Some(help))
    }
}

/// The key of another table that may have been meant.
fn key_of_other_table(key: &str) -> Option<&'static str> {
    let same_name = rows().find(|row| row.name().eq_ignore_ascii_case(key));
    let joined = || {
        let key = key.replace(['-', ' '], "_");
        let paths: Vec<String> = rows().map(|row| row.path.replace('.', "_")).collect();
        let near = suggest::nearest(&key, paths.iter().map(String::as_str))?;
        rows().find(|row| row.path.replace('.', "_") == near)
    };
    same_name.or_else(joined).map(|row| row.path)
}

/// Stores the keys of a table in a machine.
pub(crate) fn put_table(
    machine: &mut Machine,
    at: &SchemaLocation,
    table: &DeTable<'_>,
    source: &ErrorSource,
    errors: &mut Vec<MachineError>,
) {
    for (key, value) in table {
        // The file to inherit from was already read.
        if at.path.is_empty() && INHERITS.contains(&key.get_ref().as_ref()) {
            continue;
        }
        match at.step(key.get_ref(), key.span(), source) {
            Ok(at) => put(machine, &at, value, source, errors),
            Err(error) => errors.push(error),
        }
    }
}

/// Stores a value or a table in a machine.
pub(crate) fn put(
    machine: &mut Machine,
    at: &SchemaLocation,
    value: &Spanned<DeValue<'_>>,
    source: &ErrorSource,
    errors: &mut Vec<MachineError>,
) {
    let children = schema::children(&at.path);
    match (value.get_ref(), at.row()) {
        (DeValue::Table(table), row) if !children.is_empty() => {
            match row.map(|row| &row.slot) {
                Some(SchemaSlot::Table(create)) => create(machine, &at.keys),
                Some(SchemaSlot::Axis) => set_axis(machine, &at.keys, true),
                Some(SchemaSlot::Body(body)) => {
                    body(machine, &at.keys).location = Some(source.location(value.span()));
                }
                Some(SchemaSlot::ShopCode) => {
                    at.keys.code.place(machine).location = Some(source.location(value.span()));
                }
                _ => {}
            }
            put_table(machine, at, table, source, errors);
        }
        (_, Some(row)) => {
            let value = CheckedValue { row, at, value, source };
            if let Err(error) = value.put(machine) {
                errors.push(error);
            }
        }
        (other, None) => errors.push(is_a_table(at, other, value.span(), &children, source)),
    }
}

fn is_a_table(
    at: &SchemaLocation,
    value: &DeValue<'_>,
    span: Range<usize>,
    children: &[&str],
    source: &ErrorSource,
) -> MachineError {
    let message = format!("`{}` is a table; this is {}", at.shown, article(value));
    let first = children.first().copied().unwrap_or("key");
    source.error(Some(span), message, Some(format!("write `{}.{first} = …`", at.shown)))
}

fn set_axis(machine: &mut Machine, keys: &PlaceholderKeys, there: bool) {
    if let Some(axis) = keys.axis {
        let old = machine.axes[axis as usize];
        machine.change_axis(axis, there.then(|| old.unwrap_or_default()));
    }
}

/// A value with the data for error messages about it.
struct CheckedValue<'v> {
    row: &'static SchemaRow,
    at: &'v SchemaLocation,
    value: &'v Spanned<DeValue<'v>>,
    source: &'v ErrorSource,
}

impl CheckedValue<'_> {
    fn put(&self, machine: &mut Machine) -> Result<(), MachineError> {
        let keys = &self.at.keys;
        let value = self.value.get_ref();
        match &self.row.slot {
            SchemaSlot::Quantity { dimension, sign, place } => {
                *place(machine, keys) = Some(self.quantity(self.value, *dimension, *sign)?);
            }
            SchemaSlot::Position(place) => {
                let written =
                    self.quantity(self.value, QuantityDimension::Length, SignRule::Any)?;
                *place(machine, keys) = Some(written / self.written_factor(machine));
            }
            SchemaSlot::Range(place) => {
                let (low, high) = self.range()?;
                let factor = self.written_factor(machine);
                *place(machine, keys) = Some((low / factor, high / factor));
            }
            SchemaSlot::Count { from, to, place } => {
                *place(machine, keys) = Some(self.count(*from, *to)?);
            }
            SchemaSlot::Solids(place) => *place(machine, keys) = self.solids()?,
            SchemaSlot::Profile(place) => *place(machine, keys) = self.profile()?,
            SchemaSlot::Outline(place) => *place(machine, keys) = self.outline()?,
            SchemaSlot::Contour(place) => *place(machine, keys) = self.contour()?,
            SchemaSlot::Kind => self.take_kind(machine)?,
            SchemaSlot::Programmed => self.take_programmed(machine)?,
            SchemaSlot::Text(place) => *place(machine, keys) = self.text(self.value)?,
            SchemaSlot::OptionalText(place) => *place(machine, keys) = Some(self.text(self.value)?),
            SchemaSlot::File(place) => {
                let name = self.text(self.value)?;
                *place(machine, keys) = Some(in_folder_of(&self.source.file, &name));
            }
            SchemaSlot::TextList(place) => {
                *place(machine, keys) = match value {
                    DeValue::Array(items) => {
                        items.iter().map(|item| self.text(item)).collect::<Result<_, _>>()?
                    }
                    _ => vec![self.text(self.value)?],
                };
            }
            SchemaSlot::Word { what, words, place } => {
                let field = place(machine, keys);
                let words = [*words, &field.registered_words()].concat();
                field.set_word(self.word(what, &words)?);
            }
            SchemaSlot::Insert => self.take_insert(machine)?,
            SchemaSlot::HolderDesignation => self.take_holder(machine)?,
            SchemaSlot::Flag(place) => match value {
                DeValue::Boolean(flag) => *place(machine, keys) = *flag,
                _ => return Err(self.takes("`true` or `false`", None)),
            },
            SchemaSlot::Number(place) => match value {
                DeValue::Integer(_) | DeValue::Float(_) => {
                    *place(machine, keys) = self.plain_number()?;
                }
                _ => return Err(self.takes("a number", None)),
            },
            SchemaSlot::Within { dimension, from, to, usual, place } => {
                *place(machine, keys) = Some(self.within(*dimension, [*from, *to], usual)?);
            }
            SchemaSlot::Direction(place) => *place(machine, keys) = Some(self.direction()?),
            SchemaSlot::NumberList(place) => {
                let DeValue::Array(items) = value else {
                    let help = Some("write it as `[1.5, 2]`".to_string());
                    return Err(self.takes("a list of numbers", help));
                };
                let number = |item| CheckedValue { value: item, ..*self }.plain_number();
                *place(machine, keys) = items.iter().map(number).collect::<Result<_, _>>()?;
            }
            SchemaSlot::Stamp { stamp, place } => {
                let (what, form) = stamp.words();
                let help = Some(format!("write it as `\"{form}\"`"));
                let text = match value {
                    DeValue::String(text) => text.to_string(),
                    DeValue::Datetime(stamp) => stamp.to_string(),
                    _ => return Err(self.takes(what, help)),
                };
                let Some(number) = stamp.parse(&text) else {
                    let message = format!("`{}` takes {what}; this is `{text}`", self.name());
                    return Err(self.error(message, help));
                };
                *place(machine, keys) = Some(number);
            }
            SchemaSlot::Override(place) => *place(machine, keys) = Some(self.percentage()?),
            SchemaSlot::Switches => machine.switches.block_delete = self.switches()?,
            SchemaSlot::Setting => {
                let location = Some(self.source.location(self.value.span()));
                let setting = SettingEntry { value: self.setting()?, location };
                // A later spelling replaces an earlier one, because names are compared without case.
                machine.settings.retain(|name, _| !name.eq_ignore_ascii_case(&keys.name));
                machine.settings.insert(keys.name.clone(), setting);
            }
            SchemaSlot::Axis => match value {
                DeValue::Boolean(there) => set_axis(machine, keys, *there),
                _ => return Err(self.is_a_table()),
            },
            SchemaSlot::Table(_) | SchemaSlot::ShopCode | SchemaSlot::Body(_) => {
                return Err(self.is_a_table());
            }
            SchemaSlot::Inherits => {
                let message = "`inherits` belongs in a machine file and cannot be changed later";
                return Err(self.error(message, None));
            }
        }
        Ok(())
    }

    /// An override as a fraction of 1.
    fn percentage(&self) -> Result<f64, MachineError> {
        let help = || Some("write it as `\"80 %\"` or `0.8`".to_string());
        let target = "a percentage or a fraction";
        let fraction = match self.value.get_ref() {
            DeValue::String(text) => match text.trim().strip_suffix('%') {
                Some(number) => number.trim().parse::<f64>().ok().map(|percent| percent / 100.0),
                None => None,
            },
            DeValue::Integer(_) | DeValue::Float(_) => Some(self.plain_number()?),
            _ => None,
        };
        let Some(fraction) = fraction.filter(|fraction| fraction.is_finite()) else {
            return Err(self.takes(target, help()));
        };
        if fraction > 0.0 && fraction <= MAX_OVERRIDE {
            return Ok(fraction);
        }
        let message = format!(
            "`{}` is {} %: it must be above 0 and at most {} %",
            self.name(),
            fraction * 100.0,
            MAX_OVERRIDE * 100.0
        );
        let bare = !matches!(self.value.get_ref(), DeValue::String(_));
        let meant = bare && fraction > MAX_OVERRIDE && fraction <= MAX_OVERRIDE * 100.0;
        let help = if meant { Some(format!("did you mean \"{fraction} %\"?")) } else { help() };
        Err(self.error(message, help))
    }

    /// A quantity or a number, checked against bounds.
    fn within(
        &self,
        dimension: Option<QuantityDimension>,
        [from, to]: [f64; 2],
        usual: &str,
    ) -> Result<f64, MachineError> {
        let (number, unit) = match dimension {
            Some(dimension) => (
                self.quantity(self.value, dimension, SignRule::Any)?,
                format!(" {}", dimension.inside().replace("^2", "²").replace("^3", "³")),
            ),
            None => (self.plain_number()?, String::new()),
        };
        if (from..=to).contains(&number) {
            return Ok(number);
        }
        let message =
            format!("`{}` is {number}{unit}: it must be from {from} to {to}{unit}", self.at.shown);
        Err(self.error(message, Some(format!("give a published value, {usual}"))))
    }

    /// The three components of a direction.
    fn direction(&self) -> Result<[f64; 3], MachineError> {
        let help = || Some("write it as `[0, 1, 1]`: its parts along X, Y and Z".to_string());
        let DeValue::Array(items) = self.value.get_ref() else {
            return Err(self.takes("three numbers", help()));
        };
        if items.len() != 3 {
            let message = format!("`{}` takes three numbers, not {}", self.name(), items.len());
            return Err(self.error(message, help()));
        }
        let mut direction = [0.0; 3];
        for (number, item) in direction.iter_mut().zip(items) {
            *number = CheckedValue { value: item, ..*self }.plain_number()?;
        }
        if direction == [0.0; 3] {
            return Err(
                self.error(format!("`{}` has no direction: it is zero", self.name()), help())
            );
        }
        Ok(direction)
    }

    fn plain_number(&self) -> Result<f64, MachineError> {
        let number = match self.setting()? {
            SettingValue::Integer(number) => number as f64,
            SettingValue::Float(number) => number,
            _ => f64::NAN,
        };
        if number.is_finite() { Ok(number) } else { Err(self.takes("a number", None)) }
    }

    fn error(&self, message: impl Into<String>, help: Option<String>) -> MachineError {
        self.source.error(Some(self.value.span()), message, help)
    }

    fn is_a_table(&self) -> MachineError {
        let children = schema::children(&self.at.path);
        is_a_table(self.at, self.value.get_ref(), self.value.span(), &children, self.source)
    }

    /// An error such as "`travel` takes two lengths; this is a whole number".
    fn takes(&self, what: &str, help: Option<String>) -> MachineError {
        let found = article(self.value.get_ref());
        self.error(format!("`{}` takes {what}; this is {found}", self.name()), help)
    }

    /// The name of the key in messages, or its whole path if the name is not clear alone.
    fn name(&self) -> &str {
        let name = self.row.name();
        let alone = ROWS.iter().filter(|row| row.name() == name).count() == 1;
        if alone && !self.row.path.ends_with('>') { name } else { &self.at.shown }
    }

    fn quantity(
        &self,
        value: &Spanned<DeValue<'_>>,
        dimension: QuantityDimension,
        sign: SignRule,
    ) -> Result<f64, MachineError> {
        let rotary = self.at.keys.axis.is_some_and(|axis| axis.is_rotary());
        let dimension = if rotary { dimension.of_rotary() } else { dimension };
        let result = match value.get_ref() {
            DeValue::String(text) => machine_quantity(text, dimension),
            DeValue::Integer(number) => {
                Err(QuantityError::NoUnit { text: number.to_string(), dimension })
            }
            DeValue::Float(number) => {
                Err(QuantityError::NoUnit { text: number.to_string(), dimension })
            }
            other => {
                let (noun, units) = (dimension.noun(), dimension.units());
                let help = format!("{noun} is a number with a unit: {}", suggest::or_list(units));
                let found = article(other);
                let message = format!("`{}` takes {noun}; this is {found}", self.name());
                return Err(self.source.error(Some(value.span()), message, Some(help)));
            }
        };
        let fault = |message: String, help: Option<String>| {
            Err(self.source.error(Some(value.span()), message, help))
        };
        match result {
            Err(error) => fault(
                format!("`{}` takes {}; {}", self.name(), dimension.noun(), error.fault()),
                error.help(),
            ),
            Ok(number) if sign == SignRule::Positive && number <= 0.0 => {
                fault(format!("`{}` must be more than zero", self.name()), None)
            }
            Ok(number) if sign == SignRule::NotNegative && number < 0.0 => {
                fault(format!("`{}` cannot be negative", self.name()), None)
            }
            Ok(number) => Ok(number),
        }
    }

    fn range(&self) -> Result<(f64, f64), MachineError> {
        let rotary = self.at.keys.axis.is_some_and(|axis| axis.is_rotary());
        let (what, example) = match rotary {
            true => ("two angles", "[\"-110 deg\", \"30 deg\"]"),
            false => ("two lengths", "[\"0 mm\", \"762 mm\"]"),
        };
        let help = Some(format!("write the lower and the higher end: `{example}`"));
        let DeValue::Array(items) = self.value.get_ref() else {
            return Err(self.takes(what, help));
        };
        let (Some(low), Some(high), 2) = (items.first(), items.get(1), items.len()) else {
            let message = format!("`{}` takes {what}, not {}", self.name(), items.len());
            return Err(self.error(message, help));
        };
        let from = self.quantity(low, QuantityDimension::Length, SignRule::Any)?;
        let to = self.quantity(high, QuantityDimension::Length, SignRule::Any)?;
        if from < to {
            return Ok((from, to));
        }
        let written = |item: &Spanned<DeValue<'_>>| match item.get_ref() {
            DeValue::String(text) => text.to_string(),
            _ => String::new(),
        };
        let (low, high) = (written(low), written(high));
        if from > to {
            let message = format!("`{}` is reversed: `{low}` is above `{high}`", self.name());
            return Err(self.error(message, Some(format!("write `[\"{high}\", \"{low}\"]`"))));
        }
        Err(self.error(format!("`{}` is empty: both ends are `{low}`", self.name()), None))
    }

    fn text(&self, value: &Spanned<DeValue<'_>>) -> Result<String, MachineError> {
        match value.get_ref() {
            DeValue::String(text) => Ok(text.to_string()),
            other => {
                let message = format!("`{}` takes a text; this is {}", self.name(), article(other));
                let help = "put it in quotes".to_string();
                Err(self.source.error(Some(value.span()), message, Some(help)))
            }
        }
    }

    fn word(&self, what: &str, words: &[&'static str]) -> Result<&'static str, MachineError> {
        let quoted: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
        let all = suggest::or_list(&quoted);
        let DeValue::String(text) = self.value.get_ref() else {
            return Err(self.takes(&all, None));
        };
        if let Some(word) = words.iter().find(|word| word.eq_ignore_ascii_case(text)) {
            return Ok(word);
        }
        let help = match suggest::nearest(text, words.iter().copied()) {
            Some(near) => format!("did you mean \"{near}\"?"),
            None => format!("it is one of {all}"),
        };
        Err(self.error(format!("`{text}` is not a {what}"), Some(help)))
    }

    fn switches(&self) -> Result<[bool; 10], MachineError> {
        let expected = "`true`, `false` or a list of switch numbers from 1 to 9";
        match self.value.get_ref() {
            DeValue::Boolean(all) => Ok([*all; 10]),
            DeValue::Array(items) => {
                let mut switches = [false; 10];
                for item in items {
                    let number = match item.get_ref() {
                        DeValue::Integer(_) => integer(item.get_ref()),
                        _ => None,
                    };
                    match number.and_then(|number| usize::try_from(number).ok()) {
                        Some(number @ 1..=9) => switches[number] = true,
                        _ => {
                            let message = format!("`{}` takes {expected}", self.name());
                            return Err(self.source.error(Some(item.span()), message, None));
                        }
                    }
                }
                switches[0] = switches[1];
                Ok(switches)
            }
            _ => Err(self.takes(expected, None)),
        }
    }

    fn setting(&self) -> Result<SettingValue, MachineError> {
        match self.value.get_ref() {
            DeValue::String(text) => Ok(SettingValue::Text(text.to_string())),
            DeValue::Boolean(flag) => Ok(SettingValue::Bool(*flag)),
            value @ DeValue::Integer(number) => integer(value)
                .map(SettingValue::Integer)
                .ok_or_else(|| self.error(format!("`{number}` is out of range"), None)),
            DeValue::Float(number) => number
                .as_str()
                .parse::<f64>()
                .ok()
                .filter(|number| number.is_finite())
                .map(SettingValue::Float)
                .ok_or_else(|| {
                    self.error(
                        format!("a control cannot hold the number `{}`", number.as_str()),
                        None,
                    )
                }),
            DeValue::Table(_) => {
                let help =
                    "a name with a point needs quotes, such as `\"No. 3410\" = 5`".to_string();
                Err(self.takes("a text, a number or `true`/`false`", Some(help)))
            }
            _ => Err(self.takes("a text, a number or `true`/`false`", None)),
        }
    }
}

fn integer(value: &DeValue<'_>) -> Option<i64> {
    let number = value.as_integer()?;
    i64::from_str_radix(number.as_str(), number.radix()).ok()
}

fn article(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) => "a whole number",
        DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
