//! What the program writes into the control: tool data, settable frames, and values without an effect on the path.

use chordal_diagnostics::TextRange;

use super::frame_chain::{ChainFault, shift_of_chain};
use super::interpreter::Interpreter;
use super::system_variables::{ToolDatum, index_keys, linear_axis, settable_name};
use super::tool_edges::edge_offset_number;
use crate::syntax::{Address, WordValue};
use crate::values::SinumerikValue;

/// Beginnings of system variables that hold frames: what they shift or turn moves the path.
const FRAME_VARIABLES: [&str; 12] = [
    "$P_PFRAME",
    "$P_BFRAME",
    "$P_IFRAME",
    "$P_ACTFRAME",
    "$P_UIFR",
    "$P_UBFR",
    "$P_CHBFR",
    "$P_NCBFR",
    "$P_SETFR",
    "$P_PARTFR",
    "$P_TOOLFR",
    "$P_WPFR",
];

/// What is said of a settable frame that does more than shift.
const MORE_THAN_SHIFT: &str =
    "rotation, scale, mirror and fine shift of a settable frame are not followed";

/// Beginnings of machine data, which may change how the control moves.
const MACHINE_DATA: [&str; 3] = ["$MN_", "$MC_", "$MA_"];

impl Interpreter<'_> {
    /// Writes a system variable.
    pub(super) fn write_system(
        &mut self,
        address: &Address,
        indices: &[i64],
        value: SinumerikValue,
    ) {
        let (name, range) = (&*address.name, address.range);
        let keys = index_keys(address, indices);
        if name.starts_with("$TC_DP")
            && let [tool, edge] = indices
            && let (Ok(tool), Ok(edge)) = (u32::try_from(*tool), u32::try_from(*edge))
        {
            self.listed_edges.insert((tool, edge));
        }
        if let Some(datum) = ToolDatum::named(name) {
            return self.write_tool_datum(datum, indices, range, value);
        }
        if name == "$TC_TP2"
            && let (Some(tool), SinumerikValue::Text(text)) = (indices.first(), &value)
            && let Ok(tool) = u32::try_from(*tool)
        {
            self.tool_names.insert(text.to_string(), tool);
            return;
        }
        if name == "$P_UIFR" && keys.len() == 3 {
            return self.write_settable(&keys, range, value);
        }
        if FRAME_VARIABLES.iter().any(|start| name.starts_with(start)) {
            let what = format!(
                "{name} is written and not followed: where it shifts the axes is not known"
            );
            return self.not_followed(range, what);
        }
        if MACHINE_DATA.iter().any(|start| name.starts_with(start)) {
            self.lose_path(range, "how the control moves", name);
        }
        self.variables.write_system_value(name, keys, value);
    }

    fn write_tool_datum(
        &mut self,
        datum: ToolDatum,
        indices: &[i64],
        range: TextRange,
        value: SinumerikValue,
    ) {
        let number = |place: usize| indices.get(place).and_then(|index| u32::try_from(*index).ok());
        let entry =
            number(0).zip(number(1)).and_then(|(tool, edge)| edge_offset_number(tool, edge));
        let Some(entry) = entry else {
            return self.alarm(
                17020,
                chordal_diagnostics::Code::BadVariable,
                range,
                "there is no such tool edge",
            );
        };
        if let Some(cause) = value.unknown_cause().cloned() {
            return self.lose_path(range, "this datum of a tool", &cause);
        }
        let Ok(mm) = value.to_real() else { return };
        let turns = self.kernel.machine.turns();
        self.kernel
            .state
            .shift_coordinates(|offsets| datum.write(offsets.tool_mut(entry), mm, turns));
        if self.kernel.state.offsets.length().number == Some(entry) {
            self.kernel.emit_tool_length();
        }
    }

    /// `$P_UIFR[1,X,TR]=10`.
    fn write_settable(&mut self, keys: &[String], range: TextRange, value: SinumerikValue) {
        if let Some(cause) = value.unknown_cause().cloned() {
            return self.lose_path(range, "this offset", &cause);
        }
        let Ok(number) = value.to_real() else { return };
        let name = keys[0].parse().ok().and_then(settable_name);
        let (Some(name), Some(axis)) = (name, linear_axis(&keys[1])) else {
            return self.not_followed(range, "this settable frame is not followed");
        };
        let changes_nothing = match keys[2].as_str() {
            "TR" => {
                let key = self.kernel.state.offsets.key(name);
                return self.write_offset(&key, &[(axis, number)]);
            }
            "SC" => number == 1.0,
            _ => number == 0.0,
        };
        if !changes_nothing {
            self.not_followed(range, MORE_THAN_SHIFT);
        }
    }

    fn write_offset(&mut self, key: &str, values: &[(usize, f64)]) {
        self.kernel.state.shift_coordinates(|offsets| {
            values.iter().for_each(|(axis, mm)| offsets.write_work(key, *axis, *mm, false));
        });
        if self.kernel.state.offsets.key(self.kernel.state.offsets.active()) == key {
            self.kernel.emit_work_offset();
        }
    }

    /// `$P_UIFR[1]=CTRANS(X,10,Y,20):CFINE(X,0.1)`: a settable frame that only shifts; false for other assignments.
    pub(super) fn write_settable_shift(&mut self, address: &Address, value: &WordValue) -> bool {
        let WordValue::Plain(chain) = value else { return false };
        if address.name != "$P_UIFR" || address.indices.len() != 1 {
            return false;
        }
        let Some(name) =
            self.number(&address.indices[0]).and_then(|index| settable_name(index as u32))
        else {
            return false;
        };
        match shift_of_chain(chain, &mut |expression| self.number(expression)) {
            Ok(shift) => {
                let key = self.kernel.state.offsets.key(name);
                let [x, y, z] = shift;
                self.write_offset(&key, &[(0, x), (1, y), (2, z)]);
            }
            // The value said already why.
            Err(ChainFault::NoNumber) => {}
            Err(ChainFault::MoreThanShift) => self.not_followed(address.range, MORE_THAN_SHIFT),
            Err(ChainFault::OtherForm) => return false,
        }
        true
    }
}
