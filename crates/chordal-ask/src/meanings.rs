//! What words mean, and the machines.

use chordal::Machine;
use chordal::control::control_title;
use chordal::machine::builtin_names;
use chordal_editor::explain::{UnknownTerm, explain_on};
use chordal_load::machine::own_file;
use serde_json::{Value, json};

use crate::answer::{QuestionAnswer, QuestionFailure};
use crate::load_request::LoadRequest;
use crate::options::{ExplainOptions, MachineOptions, NoOptions};

pub fn explanation(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let ExplainOptions { word, machine } = request.options()?;
    let machine = machine.map(|name| request.machine(&name)).transpose()?;
    match explain_on(&word, machine.as_ref()) {
        Ok(text) => Ok(QuestionAnswer::text(text)),
        Err(UnknownTerm { message, help }) => Err(QuestionFailure::plain(message, help)),
    }
}

pub fn machines(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let NoOptions {} = request.options()?;
    let machines = builtin_names().iter();
    let machines = machines.filter_map(|name| Machine::from_builtin(name).ok());
    let list: Value = machines.map(|machine| about(&machine)).collect();
    Ok(QuestionAnswer::text(list.to_string()))
}

pub fn machine(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let MachineOptions { name } = request.options()?;
    let machine = request.machine(&name)?;
    let mut found = about(&machine);
    found["notes"] = json!(machine.notes);
    found["toml"] = json!(own_file(machine));
    Ok(QuestionAnswer::text(found.to_string()))
}

fn about(machine: &Machine) -> Value {
    json!({
        "name": machine.name,
        "title": machine.title,
        "control": machine.control.as_str(),
        "controlTitle": control_title(machine.control),
    })
}
