//! The text of the values of a machine in its file.

use super::{DateOrTime, PlaceholderKeys, SchemaSlot, tool};
use crate::axis::Axis;
use crate::designation::InsertLetter;
use crate::machine::{DiameterProgramming, Machine};
use crate::quantity::QuantityDimension;
use crate::toml_text::string_text;
use crate::value::SettingValue;

impl SchemaSlot {
    /// The text of the value of the key in a machine, in millimetres, seconds and radians; `None` if the file does not
    /// need the key. It uses the same accessors as reading, which may create missing entries, so `machine` is a mutable
    /// copy.
    pub(crate) fn written(&self, machine: &mut Machine, keys: &PlaceholderKeys) -> Option<String> {
        let is_rotary = keys.axis.is_some_and(Axis::is_rotary);
        let factor = keys.axis.map_or(1.0, |axis| machine.written_factor(axis as usize));
        let quantity = |value: f64, dimension: QuantityDimension| {
            let dimension = if is_rotary { dimension.of_rotary() } else { dimension };
            format!("\"{value} {}\"", dimension.inside())
        };
        let text = |text: &String| string_text(text);
        match self {
            SchemaSlot::Quantity { dimension, place, .. }
            | SchemaSlot::Within { dimension: Some(dimension), place, .. } => {
                place(machine, keys).map(|value| quantity(value, *dimension))
            }
            SchemaSlot::Position(place) => place(machine, keys)
                .map(|value| quantity(value * factor, QuantityDimension::Length)),
            SchemaSlot::Range(place) => place(machine, keys).map(|(low, high)| {
                list([low, high].map(|end| quantity(end * factor, QuantityDimension::Length)))
            }),
            SchemaSlot::Within { dimension: None, place, .. } => {
                place(machine, keys).map(|number| number.to_string())
            }
            // `1.0`, not `1`, so that it remains a number with a fraction.
            SchemaSlot::Override(place) => place(machine, keys).map(|number| format!("{number:?}")),
            SchemaSlot::Number(place) => Some(format!("{:?}", place(machine, keys))),
            SchemaSlot::Direction(place) => place(machine, keys)
                .map(|direction| list(direction.map(|number| format!("{number:?}")))),
            SchemaSlot::NumberList(place) => {
                some_list(place(machine, keys).iter().map(|number| format!("{number:?}")))
            }
            SchemaSlot::Count { place, .. } => place(machine, keys).map(|count| count.to_string()),
            SchemaSlot::Solids(place) => {
                let solids = place(machine, keys).iter();
                some_list(solids.map(|s| lengths([s.height_mm, s.lower_mm, s.upper_mm])))
            }
            SchemaSlot::Profile(place) | SchemaSlot::Outline(place) => {
                some_list(place(machine, keys).iter().map(|corner| lengths(*corner)))
            }
            SchemaSlot::Contour(place) => some_list(place(machine, keys).iter().map(|point| {
                let corner = [2.0 * point.radius_mm, point.z_mm];
                lengths(corner.into_iter().chain(point.arc_mm))
            })),
            SchemaSlot::Programmed => {
                let programmed = machine.axis(keys.axis?)?.programmed;
                (programmed != DiameterProgramming::default())
                    .then(|| string_text(programmed.as_str()))
            }
            SchemaSlot::Text(place) => Some(text(place(machine, keys))),
            SchemaSlot::OptionalText(place) | SchemaSlot::File(place) => {
                place(machine, keys).as_ref().map(text)
            }
            SchemaSlot::TextList(place) => some_list(place(machine, keys).iter().map(text)),
            SchemaSlot::Word { place, .. } => place(machine, keys).word().map(string_text),
            SchemaSlot::Insert => {
                let turning = &tool(machine, keys).turning;
                let designation = turning.insert_designation.as_ref().map(|one| one.text.as_str());
                designation.or(turning.insert.map(InsertLetter::as_str)).map(string_text)
            }
            SchemaSlot::HolderDesignation => {
                let holder = tool(machine, keys).turning.holder_designation.as_ref();
                holder.map(|one| string_text(&one.text))
            }
            SchemaSlot::Flag(place) => place(machine, keys).then(|| "true".to_string()),
            SchemaSlot::Stamp { stamp, place } => place(machine, keys).map(|at| stamp.written(at)),
            SchemaSlot::Switches => {
                let switches = &machine.switches.block_delete;
                match (1..10).all(|number| switches[number]) {
                    true => Some("true".to_string()),
                    false => some_list((1..10).filter(|number| switches[*number])),
                }
            }
            SchemaSlot::Setting => {
                machine.settings.get(&keys.name).map(|entry| match &entry.value {
                    SettingValue::Text(setting) => text(setting),
                    SettingValue::Integer(number) => number.to_string(),
                    SettingValue::Float(number) => format!("{number:?}"),
                    SettingValue::Bool(flag) => flag.to_string(),
                })
            }
            SchemaSlot::Kind
            | SchemaSlot::Inherits
            | SchemaSlot::Table(_)
            | SchemaSlot::ShopCode
            | SchemaSlot::Body(_)
            | SchemaSlot::Axis => None,
        }
    }
}

impl DateOrTime {
    /// The text with the digits of the number.
    fn written(self, number: u32) -> String {
        let (first, second, third) = (number / 10_000, number / 100 % 100, number % 100);
        match self {
            DateOrTime::Date => format!("\"{first:04}-{second:02}-{third:02}\""),
            DateOrTime::Time => format!("\"{first:02}:{second:02}:{third:02}\""),
        }
    }
}

fn lengths(values: impl IntoIterator<Item = f64>) -> String {
    list(values.into_iter().map(|mm| format!("\"{mm} mm\"")))
}

fn list(items: impl IntoIterator<Item = impl ToString>) -> String {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    format!("[{}]", items.join(", "))
}

/// The text of a list; `None` if it is empty.
fn some_list(items: impl Iterator<Item = impl ToString>) -> Option<String> {
    let mut items = items.peekable();
    items.peek().is_some().then(|| list(items))
}
