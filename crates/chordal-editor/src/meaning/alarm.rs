//! What an alarm of a control means: the messages that stand for it.

use chordal::Code;
use chordal::control::Alarms;

use super::without_places;

/// A text of an alarm that is looked for has at least so many letters.
const MIN_LETTERS: usize = 8;

/// An alarm by its number (`alarm 304`, `PS0010`, `P70`) or by its text, on each control that has it; `None`
/// where no control shows such an alarm for what Chordal finds.
pub fn alarm_text(word: &str, controls: &[Alarms]) -> Option<String> {
    let word = word.trim().to_uppercase();
    let mut text = String::new();
    for control in controls {
        for (alarm, codes) in texts(control) {
            if !is_meant(&word, &alarm.to_uppercase()) {
                continue;
            }
            if !text.is_empty() {
                text.push('\n');
            }
            text.push_str(&format!("{}: {}\n", control.title, without_places(alarm)));
            for code in codes {
                let info = code.info();
                text.push_str(&format!("\n  {} {}: {}\n", info.id, info.name, info.summary));
                for line in info.explanation.trim().lines() {
                    text.push_str(format!("    {line}").trim_end());
                    text.push('\n');
                }
            }
        }
    }
    (!text.is_empty()).then_some(text)
}

/// The alarms of a control, each with the messages that it stands for.
fn texts(control: &Alarms) -> Vec<(&'static str, Vec<Code>)> {
    let mut alarms: Vec<(&str, Vec<Code>)> = Vec::new();
    for &(code, text) in control.texts {
        match alarms.iter_mut().find(|(known, _)| *known == text) {
            Some((_, codes)) => codes.push(code),
            None => alarms.push((text, vec![code])),
        }
    }
    alarms
}

/// The words name the alarm: its number, or a part of its text.
fn is_meant(word: &str, alarm: &str) -> bool {
    match (number(word), number(alarm)) {
        (Some((letters, number)), Some(of)) => {
            // `alarm 70` is said of a P70 too.
            number == of.1 && (letters == of.0 || letters.is_empty() && word.starts_with("ALARM"))
        }
        (Some(_), None) => false,
        (None, _) => word.len() >= MIN_LETTERS && alarm.contains(word),
    }
}

/// `ALARM 304 …` → no letters and 304; `PS0010 …` → `PS` and 10.
fn number(text: &str) -> Option<(&str, u32)> {
    let text = text.strip_prefix("ALARM").unwrap_or(text).trim_start();
    let digits = text.find(|c: char| !c.is_ascii_alphabetic())?;
    let (letters, rest) = text.split_at(digits);
    let rest = rest.trim_start();
    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    (letters.len() <= 2).then_some(())?;
    Some((letters, rest[..end].parse().ok()?))
}

#[cfg(test)]
mod tests {
    use chordal::control::control_profile;
    use chordal::machine::ControlName;

    use super::*;

    #[test]
    fn alarms_are_found_by_number_and_by_text() {
        let profiles = ControlName::all().into_iter().filter_map(control_profile);
        let controls: Vec<Alarms> = profiles.map(|profile| profile.alarms()).collect();
        let found = |word: &str| alarm_text(word, &controls).unwrap_or_default();
        assert!(found("circle end pos").contains("HEIDENHAIN TNC: CIRCLE END POS. INCORRECT"));
        assert!(
            found("PS0010").starts_with("Fanuc: PS0010 IMPROPER G-CODE\n"),
            "{}",
            found("PS0010")
        );
        assert_eq!(found("ps 10"), found("PS0010"));
        assert!(found("alarm 304").contains("CH401 radius-mismatch"), "{}", found("alarm 304"));
        assert!(found("P70").starts_with("Mitsubishi"), "{}", found("P70"));
        assert!(found("tool diameter too large").starts_with("Fadal"));
        assert_eq!(found("alarm 99999"), "");
        assert_eq!(found("TOOL"), "");
    }
}
