//! All variables that the tables of the controls have, one of each row.

use chordal_dialect::macros::{MacroForm, MacroRules, SystemVariable};

use super::lost_line;

/// Machines of the controls with system variables.
const MACHINES: &[&str] = &[
    "fanuc-0i",
    "haas-vf2",
    "mitsubishi-m700",
    "linuxcnc-mill",
    "mach3-mill",
    "fanuc-lathe",
    "haas-lathe",
    "mitsubishi-lathe",
    "linuxcnc-lathe",
];

/// What has a value at the start of every program: constants, the codes of power-on, switches that a reset turns off,
/// the work offset that acts at power-on and no tool offset, the program's own number, and the alarm that there is not.
fn is_known_at_start(what: SystemVariable) -> bool {
    matches!(
        what,
        SystemVariable::Constant(_)
            | SystemVariable::ModalGroup
            | SystemVariable::Suppression
            | SystemVariable::WorkSystem
            | SystemVariable::ActiveToolOffset
            | SystemVariable::ModalWord(b'O')
            | SystemVariable::Alarm
            | SystemVariable::Message
    )
}

fn rules(machine: &str) -> &'static MacroRules {
    let machine = chordal::Machine::from_builtin(machine).expect(machine);
    let table =
        chordal_dialect::CONTROLS.iter().find(|table| table.name == machine.control.as_str());
    table.expect("a control").macros
}

#[test]
fn no_variable_has_a_silent_value_at_the_start() {
    let (mut checked, mut wrong) = (0, Vec::new());
    for machine in MACHINES {
        let rules = rules(machine);
        assert_ne!(rules.form, MacroForm::None, "{machine} has no variables");
        let commons = rules.common.iter().flat_map(|row| [(row.first, false), (row.last, false)]);
        let systems = rules.system.iter().flat_map(|row| {
            [row.first, row.last].map(|number| (number, is_known_at_start(row.variable)))
        });
        for (number, is_known) in commons.chain(systems) {
            checked += 1;
            let (line, said) = lost_line(machine, &[], &format!("G0 X[#{number}*0.0001]"));
            if line.is_some() == is_known {
                wrong.push(format!("{machine} #{number}: known {}: {said:?}", line.is_none()));
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {checked}:\n{}", wrong.len(), wrong.join("\n"));
}
