//! A calculation as text and as JSON.

use chordal_calc::{AnswerUnit, Quantity, WorkedCalculation};
use serde_json::{Map, Value, json};

/// A calculation as it would stand on paper: what is given, each formula with its numbers, notes.
pub fn worked_text(worked: &WorkedCalculation) -> String {
    let units = worked.units;
    let mut text = format!("{}\n\n", worked.title);
    let symbols = worked.inputs.iter().chain(worked.steps.iter().map(|step| &step.quantity));
    let wide = symbols.map(|quantity| quantity.symbol.chars().count()).max().unwrap_or(0);
    let pad = |symbol: &str| {
        let missing = wide - symbol.chars().count();
        format!("{symbol}{}", " ".repeat(missing))
    };
    for quantity in &worked.inputs {
        let line = format!(
            "  {} = {:<14} {}",
            pad(&quantity.symbol),
            quantity.text(units),
            quantity.meaning
        );
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text.push('\n');
    let indent = " ".repeat(wide + 2);
    for step in &worked.steps {
        let quantity = &step.quantity;
        text.push_str(&format!(
            "  {} = {:<44} {}\n",
            pad(&quantity.symbol),
            step.formula,
            quantity.meaning
        ));
        if step.filled != step.formula {
            text.push_str(&format!("{indent} = {}\n", step.filled));
        }
        text.push_str(&format!("{indent} = {}\n", quantity.text(units)));
    }
    for note in &worked.notes {
        text.push_str(&format!("\n  {note}"));
    }
    if !worked.notes.is_empty() {
        text.push('\n');
    }
    text
}

/// The same for programs: numbers in the unit that `unit` names, exact to the last digit. An NC
/// program that belongs to it is added as `program`.
pub fn worked_json(worked: &WorkedCalculation, program: Option<&str>) -> String {
    let units = worked.units;
    let quantity = |quantity: &Quantity| {
        let (value, unit) = value(quantity, units);
        let mut object = Map::new();
        object.insert("symbol".into(), json!(quantity.symbol));
        object.insert("meaning".into(), json!(quantity.meaning));
        object.insert("value".into(), json!(value));
        object.insert("unit".into(), unit.map_or(Value::Null, |unit| json!(unit)));
        object
    };
    let provided: Vec<_> = worked.inputs.iter().map(quantity).collect();
    let steps: Vec<_> = worked
        .steps
        .iter()
        .map(|step| {
            let mut object = quantity(&step.quantity);
            object.insert("formula".into(), json!(step.formula));
            object.insert("filled".into(), json!(step.filled));
            object.insert("result".into(), json!(step.result));
            object
        })
        .collect();
    let mut whole = json!({
        "title": worked.title,
        "given": provided,
        "steps": steps,
        "notes": worked.notes,
    });
    if let (Some(program), Some(object)) = (program, whole.as_object_mut()) {
        object.insert("program".into(), json!(program));
    }
    crate::pretty_json(whole)
}

fn value(quantity: &Quantity, units: AnswerUnit) -> (f64, Option<&'static str>) {
    (quantity.kind.shown(quantity.value, units), quantity.kind.unit(units))
}
