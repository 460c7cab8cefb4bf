//! The possible readings of a program whose control is not certain, as a page shows them, and the machine that the
//! user's answer names.

use chordal::{AssumedSetting, Machine, ReadingChoices, SourceMap};
use serde_json::{Value, json};

/// A machine as the page names it: `haas-vf2`, or with settings after it `haas-vf2 in inch`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChosenMachine<'n> {
    /// The name as in `chordal machines`, or a file.
    pub name: &'n str,
    /// The settings that the choice names.
    settings: Vec<&'static AssumedSetting>,
}

impl<'n> ChosenMachine<'n> {
    /// Splits the choice of a page into the machine and its settings.
    pub fn of(choice: &'n str) -> ChosenMachine<'n> {
        let mut chosen = ChosenMachine { name: choice, settings: Vec::new() };
        while let Some((name, setting)) = AssumedSetting::ALL.iter().find_map(|setting| {
            Some((chosen.name.strip_suffix(setting.words)?.strip_suffix(' ')?, *setting))
        }) {
            chosen.name = name;
            chosen.settings.insert(0, setting);
        }
        chosen
    }

    /// The machine settings that the choice implies.
    pub fn assignments(&self) -> Vec<String> {
        self.settings.iter().map(|setting| setting.assignment.to_string()).collect()
    }
}

/// The question that the page shows: the readings in words, the machine of each, and the first difference; null when
/// all readings move the program equally.
pub fn question(choices: Option<&ReadingChoices>, sources: &SourceMap<'_>) -> Value {
    let Some((choices, at)) = choices.and_then(|all| Some((all, all.difference.as_ref()?))) else {
        return Value::Null;
    };
    let shown = choices.shown().iter().map(|reading| {
        let with_settings = |name: &str| AssumedSetting::after(name, &reading.settings);
        let title = Machine::from_builtin(reading.machine).map(|machine| machine.title);
        json!({
            "title": reading.title,
            "size": reading.size,
            "motion": reading.motion,
            "machine": {
                "name": with_settings(reading.machine),
                "title": with_settings(title.as_deref().unwrap_or(reading.machine)),
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
    fn a_choice_may_name_settings_after_the_machine() {
        let plain = ChosenMachine::of("haas-vf2");
        assert_eq!((plain.name, plain.assignments()), ("haas-vf2", vec![]));
        let inch = ChosenMachine::of("haas-vf2 in inch");
        assert_eq!(inch.name, "haas-vf2");
        assert_eq!(inch.assignments(), ["settings.units=\"inch\""]);
        assert_eq!(ChosenMachine::of("op in mm").name, "op");
        let both = ChosenMachine::of("haas-vf2 in inch with whole numbers in full units");
        assert_eq!(both.name, "haas-vf2");
        assert_eq!(
            both.assignments(),
            ["settings.units=\"inch\"", "settings.decimal_point=\"calculator\""]
        );
        assert_eq!(ChosenMachine::of("in mm.toml").name, "in mm.toml");
    }
}
