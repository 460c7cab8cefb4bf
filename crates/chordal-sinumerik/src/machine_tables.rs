//! Tools and work offsets of the control's tables as a machine file has them.

use chordal_command::WorkNaming;
use chordal_machine::{Machine, Tool, ToolShape};

use crate::run::{ToolDatum, axis_of, settable_name, shift_of_chain};
use crate::syntax::{
    AddressWord, BlockReader, Expression, ExpressionKind, StatementKind, UnaryOperator, WordValue,
};

/// Takes the tools and the work offsets of a table over into a machine: what the control holds wins, what it does not say
/// stays. `naming` is that of the control's work offsets.
pub fn take_table(text: &[u8], naming: WorkNaming, machine: &mut Machine) {
    for block in BlockReader::new(text) {
        for statement in &block.statements {
            if let StatementKind::Word(word) = &statement.kind {
                take_entry(word, naming, machine);
            }
        }
    }
}

fn take_entry(word: &AddressWord, naming: WorkNaming, machine: &mut Machine) -> Option<()> {
    let WordValue::Plain(value) = &word.value else { return None };
    let name = &*word.address.name;
    let index = |place: usize| number(word.address.indices.get(place)?);
    if name == "$P_UIFR" {
        return take_offset(word, value, naming, machine);
    }
    if !name.starts_with("$TC_") {
        return None;
    }
    let (turns, tool) = (machine.turns(), index(0)? as u32);
    if name == "$TC_TP2" {
        if let ExpressionKind::Text(text) = &value.kind {
            machine.tools.entry(tool).or_default().description = Some(text.clone());
        }
        return Some(());
    }
    // A machine file has one edge for each tool.
    if index(1)? != 1.0 {
        return None;
    }
    let entry = machine.tools.entry(tool).or_default();
    let value = number(value)?;
    match name {
        "$TC_DP1" => entry.shape = entry.shape.or(shape_of(value as u32)),
        "$TC_DP7" if value > 0.0 => entry.corner_radius_mm = Some(value),
        _ => ToolDatum::named(name)?.write(entry, value, turns),
    }
    keep_plausible(entry);
    Some(())
}

/// A radius of 0 is that of an entry nobody filled.
fn keep_plausible(tool: &mut Tool) {
    tool.diameter_mm = tool.diameter_mm.filter(|diameter| *diameter != 0.0);
}

/// The shape of a tool type (Fundamentals 11/2006, 8.4); `None` for types with a form that more data give.
fn shape_of(kind: u32) -> Option<ToolShape> {
    match kind {
        110 | 111 => Some(ToolShape::Ball),
        120 | 140 => Some(ToolShape::Flat),
        121 => Some(ToolShape::Bull),
        200 => Some(ToolShape::Drill),
        _ => None,
    }
}

/// `$P_UIFR[1]=CTRANS(X,10,Y,20):CFINE(…)` or `$P_UIFR[1,X,TR]=10`.
fn take_offset(
    word: &AddressWord,
    value: &Expression,
    naming: WorkNaming,
    machine: &mut Machine,
) -> Option<()> {
    let indices = &word.address.indices;
    let name = settable_name(number(indices.first()?)? as u32)?;
    let key = name.table_key(naming);
    let values: Vec<(usize, f64)> = match indices.as_slice() {
        // What the run refuses leaves the offset as it was: the run says so.
        [_] => shift_of_chain(value, &mut number).ok()?.into_iter().enumerate().collect(),
        [_, axis, part] if is_name(part, "TR") => vec![(axis_of(axis)?, number(value)?)],
        _ => return None,
    };
    let offset = machine.work_offsets.entry(key).or_default();
    for (axis, mm) in values {
        offset.values[axis] = Some(mm);
    }
    Some(())
}

fn is_name(expression: &Expression, name: &str) -> bool {
    matches!(&expression.kind, ExpressionKind::Variable(address) if address.name == name)
}

/// The number that an expression is; `None` for anything that is computed.
fn number(expression: &Expression) -> Option<f64> {
    match &expression.kind {
        ExpressionKind::Integer(value) => Some(*value as f64),
        ExpressionKind::Real(value) => Some(*value),
        ExpressionKind::Unary(UnaryOperator::Minus, inner) => number(inner).map(|value| -value),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dump_gives_tools_and_offsets() {
        let mut machine = Machine::from_builtin("haas-vf2").expect("a machine");
        let text = b"$TC_TP2[3]=\"MILL\"\n$TC_DP1[3,1]=120\n$TC_DP3[3,1]=112.5\n$TC_DP6[3,1]=5\n\
            $TC_DP6[3,2]=4\n$P_UIFR[1]=CTRANS(X,-400,Y,20.5,Z,-1):CROT(X,0):CFINE(Y,0.25)\n\
            $P_UIFR[2]=CTRANS(X,1):CROT(Z,30)\n$P_UIFR[5,Z,TR]=-7\nM17\n";
        take_table(text, crate::control::PROFILE.work_names, &mut machine);
        let tool = &machine.tools[&3];
        assert_eq!(tool.description.as_deref(), Some("MILL"));
        assert_eq!((tool.length_mm(), tool.diameter_mm), (Some(112.5), Some(10.0)));
        assert_eq!(tool.shape, Some(ToolShape::Flat));
        assert_eq!(
            machine.work_offsets["G54"].values[..3],
            [Some(-400.0), Some(20.75), Some(-1.0)]
        );
        assert!(!machine.work_offsets.contains_key("G55"), "a rotated frame is no offset");
        assert_eq!(machine.work_offsets["G505"].values[2], Some(-7.0));
    }
}
