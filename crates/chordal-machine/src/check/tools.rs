//! Reads the values of keys of tools and of diameter axes.

use std::ops::RangeInclusive;

use toml::Spanned;
use toml::de::DeValue;

use super::{CheckedValue, integer};
use crate::axis::Axis;
use crate::error::MachineError;
use crate::machine::{AxisLimits, DiameterProgramming, Machine};
use crate::quantity::QuantityDimension;
use crate::schema::{self, SignRule};
use crate::setup::ContourPoint;
use crate::suggest;
use crate::tool::{HolderSegment, ToolShape};

impl CheckedValue<'_> {
    /// The divisor of a written position: 2 on an axis that is programmed as a diameter, otherwise 1.
    pub(super) fn written_factor(&self, machine: &Machine) -> f64 {
        let keys = &self.at.keys;
        // `length` of a tool names no axis: it is along Z.
        machine.written_factor(keys.axis.unwrap_or(Axis::Z) as usize)
    }

    pub(super) fn take_programmed(&self, machine: &mut Machine) -> Result<(), MachineError> {
        let words = [DiameterProgramming::Radius.as_str(), DiameterProgramming::Diameter.as_str()];
        let word = self.word("way to program an axis", &words)?;
        let diameter = word == DiameterProgramming::Diameter.as_str();
        let Some(axis) = self.at.keys.axis else { return Ok(()) };
        if diameter && axis.is_rotary() {
            let message = format!("{axis} turns: its words are angles, not diameters");
            return Err(self.error(message, Some("take the key out".to_string())));
        }
        let programmed =
            if diameter { DiameterProgramming::Diameter } else { DiameterProgramming::Radius };
        let old = machine.axes[axis as usize].unwrap_or_default();
        machine.change_axis(axis, Some(AxisLimits { programmed, ..old }));
        Ok(())
    }

    /// Reads the old key `kind`. If it names no shape there is a notice, because functions that need one do not know
    /// this tool.
    pub(super) fn take_kind(&self, machine: &mut Machine) -> Result<(), MachineError> {
        let text = self.text(self.value)?;
        if !schema::tool(machine, &self.at.keys).take_kind(&text) {
            let shapes: Vec<String> =
                ToolShape::ALL.iter().map(|shape| format!("\"{}\"", shape.as_str())).collect();
            let message = format!("`{text}` names no tool shape; it is kept as the description");
            let help = format!("a shape is `shape = …` with {}", suggest::or_list(&shapes));
            machine.notices.0.push(self.error(message, Some(help)));
        }
        Ok(())
    }

    pub(super) fn count(&self, from: u32, to: u32) -> Result<u32, MachineError> {
        let what = format!("a whole number from {from} to {to}");
        let DeValue::Integer(_) = self.value.get_ref() else { return Err(self.takes(&what, None)) };
        let number = integer(self.value.get_ref()).and_then(|number| u32::try_from(number).ok());
        number.filter(|number| (from..=to).contains(number)).ok_or_else(|| {
            let written = self.value.get_ref().as_integer().map(|number| number.as_str());
            let written = written.unwrap_or_default();
            self.error(format!("`{}` takes {what}; this is {written}", self.name()), None)
        })
    }

    /// A list of lists with this number of lengths each.
    fn lengths(
        &self,
        counts: RangeInclusive<usize>,
        sign: SignRule,
        form: &str,
    ) -> Result<Vec<Vec<f64>>, MachineError> {
        let help = Some(format!("write it as `{form}`"));
        let DeValue::Array(rows) = self.value.get_ref() else {
            return Err(self.takes("a list of lists of lengths", help));
        };
        let row = |row: &Spanned<DeValue<'_>>| match row.get_ref() {
            DeValue::Array(items) if counts.contains(&items.len()) => items
                .iter()
                .map(|item| self.quantity(item, QuantityDimension::Length, sign))
                .collect(),
            _ => {
                let message = format!("`{}` takes a list of lists of lengths", self.name());
                Err(self.source.error(Some(row.span()), message, help.clone()))
            }
        };
        rows.iter().map(row).collect()
    }

    pub(super) fn solids(&self) -> Result<Vec<HolderSegment>, MachineError> {
        let form = "[[\"30 mm\", \"12 mm\"], [\"20 mm\", \"12 mm\", \"40 mm\"]]";
        let rows = self.lengths(2..=3, SignRule::NotNegative, form)?;
        let solid = |row: Vec<f64>| HolderSegment {
            height_mm: row[0],
            lower_mm: row[1],
            upper_mm: row.get(2).copied().unwrap_or(row[1]),
        };
        Ok(rows.into_iter().map(solid).collect())
    }

    pub(super) fn outline(&self) -> Result<Vec<[f64; 2]>, MachineError> {
        let form = "[[\"2 mm\", \"3 mm\"], [\"22 mm\", \"3 mm\"], [\"22 mm\", \"80 mm\"]]";
        let rows = self.lengths(2..=2, SignRule::Any, form)?;
        if rows.len() < 3 {
            let message = format!("`{}` needs three corners or more", self.name());
            return Err(self.error(message, Some(format!("write it as `{form}`"))));
        }
        Ok(rows.into_iter().map(|row| [row[0], row[1]]).collect())
    }

    pub(super) fn contour(&self) -> Result<Vec<ContourPoint>, MachineError> {
        let form = "[[\"20 mm\", \"0 mm\"], [\"24 mm\", \"-2 mm\", \"2 mm\"]]";
        let rows = self.lengths(2..=3, SignRule::Any, form)?;
        let point = |row: Vec<f64>| ContourPoint {
            radius_mm: 0.5 * row[0],
            z_mm: row[1],
            arc_mm: row.get(2).copied(),
        };
        Ok(rows.into_iter().map(point).collect())
    }

    pub(super) fn profile(&self) -> Result<Vec<[f64; 2]>, MachineError> {
        let rows = self.lengths(
            2..=2,
            SignRule::NotNegative,
            "[[\"0 mm\", \"3 mm\"], [\"5 mm\", \"8 mm\"]]",
        )?;
        if let Some(at) = rows.windows(2).position(|pair| pair[1][0] < pair[0][0]) {
            let message = format!("`{}` goes down after its point {}", self.name(), at + 1);
            return Err(self.error(message, Some("begin at the end and go up".to_string())));
        }
        Ok(rows.into_iter().map(|row| [row[0], row[1]]).collect())
    }
}
