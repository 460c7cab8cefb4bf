//! The possible readings of a program whose control is not certain, as a page shows them, and the machine that the
//! user's answer names.

use chordal::{Machine, ReadingChoices, SourceMap};
use serde_json::{Value, json};

/// A machine as the page names it: `haas-vf2`, or with units at power-on `haas-vf2 in inch`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChosenMachine<'n> {
    /// The name as in `chordal machines`, or a file.
    pub name: &'n str,
    /// Units at power-on; `None` when the choice does not name them.
    units: Option<&'static str>,
}

impl<'n> ChosenMachine<'n> {
    /// Splits the choice of a page into the machine and its units.
    pub fn of(choice: &'n str) -> ChosenMachine<'n> {
        let with_units = ["inch", "mm"].into_iter().find_map(|units| {
            let name = choice.strip_suffix(units)?.strip_suffix(" in ")?;
            Some(ChosenMachine { name, units: Some(units) })
        });
        with_units.unwrap_or(ChosenMachine { name: choice, units: None })
    }

    /// The machine settings that the choice implies.
    pub fn assignments(&self) -> Vec<String> {
        self.units.iter().map(|units| format!("settings.units={units:?}")).collect()
    }
}

/// The question that the page shows: the readings in words, the machine of each, and the first difference; null when
/// all readings move the program equally.
pub fn question(choices: Option<&ReadingChoices>, sources: &SourceMap<'_>) -> Value {
    let Some((choices, at)) = choices.and_then(|all| Some((all, all.difference.as_ref()?))) else {
        return Value::Null;
    };
    let shown = choices.shown().iter().map(|reading| {
        let with_units = |name: &str| match reading.units {
            Some(units) => format!("{name} in {units}"),
            None => name.to_string(),
        };
        let title = Machine::from_builtin(reading.machine).map(|machine| machine.title);
        json!({
            "title": reading.title,
            "size": reading.size,
            "motion": reading.motion,
            "machine": {
                "name": with_units(reading.machine),
                "title": with_units(title.as_deref().unwrap_or(reading.machine)),
            },
        })
    });
    let source = sources.get(at.span.file);
    let block = source.map(|source| {
        let (start, end) = (at.span.range.start as usize, at.span.range.end as usize);
        let bytes = source.text().get(start..end).unwrap_or_default();
        String::from_utf8_lossy(bytes).trim().to_string()
    });
    json!({
        "message": at.message,
        "line": source.map(|source| source.line_column(at.span.range.start).line),
        "block": block,
        "shown": shown.collect::<Value>(),
        "more": choices.more(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_choice_may_name_units_after_the_machine() {
        let plain = ChosenMachine::of("haas-vf2");
        assert_eq!((plain.name, plain.assignments()), ("haas-vf2", vec![]));
        let inch = ChosenMachine::of("haas-vf2 in inch");
        assert_eq!(inch.name, "haas-vf2");
        assert_eq!(inch.assignments(), ["settings.units=\"inch\""]);
        assert_eq!(ChosenMachine::of("op in mm").name, "op");
        assert_eq!(ChosenMachine::of("in mm.toml").name, "in mm.toml");
    }
}
