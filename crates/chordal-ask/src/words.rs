//! What words mean, and the machines.

use chordal::Machine;
use chordal::control::Control;
use chordal::machine::builtin_names;
use chordal_editor::explain::{UnknownTerm, explain};
use chordal_editor::meaning::ControlView;
use chordal_load::machine::own_file;
use serde_json::{Value, json};

use crate::answer::{Answer, Failure};
use crate::loading::Asked;
use crate::options::{ExplainOptions, MachineOptions, Nothing};

pub fn explained(asked: &mut Asked) -> Result<Answer, Failure> {
    let ExplainOptions { word, machine } = asked.options()?;
    let views = match machine {
        Some(name) => vec![ControlView::of(&Control::of(&asked.machine(&name)?).0)],
        None => ControlView::all(),
    };
    match explain(&word, &views) {
        Ok(text) => Ok(Answer::text(text)),
        Err(UnknownTerm { message, help }) => Err(Failure::plain(message, help)),
    }
}

pub fn machines(asked: &mut Asked) -> Result<Answer, Failure> {
    let Nothing {} = asked.options()?;
    let machines = builtin_names().iter();
    let machines = machines.filter_map(|name| Machine::from_builtin(name).ok());
    let list: Value = machines.map(|machine| about(&machine)).collect();
    Ok(Answer::text(list.to_string()))
}

pub fn machine(asked: &mut Asked) -> Result<Answer, Failure> {
    let MachineOptions { name } = asked.options()?;
    let machine = asked.machine(&name)?;
    let mut found = about(&machine);
    found["notes"] = json!(machine.notes);
    found["toml"] = json!(own_file(machine));
    Ok(Answer::text(found.to_string()))
}

fn about(machine: &Machine) -> Value {
    let (control, _) = Control::of(machine);
    json!({
        "name": machine.name,
        "title": machine.title,
        "control": machine.control.as_str(),
        "controlTitle": control.table.title,
    })
}
