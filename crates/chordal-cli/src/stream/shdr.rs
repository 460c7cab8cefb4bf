//! SHDR: the lines of an MTConnect adapter, `time|key|value|key|value`.

use std::collections::BTreeMap;
use std::time::{SystemTime, UNIX_EPOCH};

use chordal::{Job, Report, Severity};

/// What was observed last, and what of it has not been sent yet.
#[derive(Default)]
pub struct Observations {
    values: BTreeMap<String, String>,
    changed: Vec<String>,
    /// The condition of the program's logic: a line of its own.
    condition: String,
    condition_is_new: bool,
}

impl Observations {
    /// A value; only one that is new is sent.
    pub fn set(&mut self, key: &str, value: &str) {
        let value = plain(value);
        if self.values.get(key).is_some_and(|known| *known == value) {
            return;
        }
        self.values.insert(key.to_string(), value);
        if !self.changed.iter().any(|known| known == key) {
            self.changed.push(key.to_string());
        }
    }

    /// The gravest problem of a run as a condition: a fault, a warning, or normal.
    pub fn condition(&mut self, job: &Job<'_>, report: &Report) {
        let worst = report.diagnostics.iter().max_by_key(|diagnostic| diagnostic.severity);
        let level = match worst.map(|diagnostic| diagnostic.severity) {
            Some(Severity::Error) => "FAULT",
            Some(Severity::Warning) => "WARNING",
            Some(Severity::Note) | None => "NORMAL",
        };
        self.condition = match worst {
            Some(problem) if level != "NORMAL" => {
                let span = problem.primary.span;
                let source = job.sources().get(span.file);
                let line = source.map_or(0, |source| source.line_of(span.range.start));
                let (code, message) = (problem.code.id(), plain(&problem.message));
                format!("logic|{level}|{code}|||line {line}: {message}")
            }
            _ => "logic|NORMAL||||".to_string(),
        };
        self.condition_is_new = true;
    }

    /// The lines of what is new since the last call; empty where nothing is.
    pub fn new_lines(&mut self) -> String {
        let (keys, condition) = (std::mem::take(&mut self.changed), self.condition_is_new);
        self.condition_is_new = false;
        self.lines(keys.iter(), condition)
    }

    /// The lines of everything: for a client that has just come.
    pub fn all_lines(&self) -> String {
        self.lines(self.values.keys(), true)
    }

    fn lines<'a>(&'a self, keys: impl Iterator<Item = &'a String>, condition: bool) -> String {
        let time = timestamp(SystemTime::now());
        let mut values = String::new();
        for key in keys {
            if let Some(value) = self.values.get(key) {
                values.push_str(&format!("|{key}|{value}"));
            }
        }
        let mut lines = String::new();
        if !values.is_empty() {
            lines.push_str(&format!("{time}{values}\n"));
        }
        if condition {
            lines.push_str(&format!("{time}|{}\n", self.condition));
        }
        lines
    }
}

/// Text as a field can hold it: the bar ends a field and a line its end.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c == '|' || c.is_control() { ' ' } else { c }).collect()
}

/// A time as `2026-03-01T07:05:09.042Z`.
fn timestamp(time: SystemTime) -> String {
    let since = time.duration_since(UNIX_EPOCH).unwrap_or_default();
    let (days, second) = (since.as_secs() / 86_400, since.as_secs() % 86_400);
    let (year, month, day) = date(days);
    let (hour, minute) = (second / 3600, second / 60 % 60);
    let (second, milli) = (second % 60, since.subsec_millis());
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{milli:03}Z")
}

/// The date of the Gregorian calendar so many days after 1 January 1970.
fn date(days: u64) -> (u64, u64, u64) {
    // In years that begin with March the leap day is the last one. 400 of them have 146,097 days.
    let days = days + 719_468;
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1_460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let in_month = day - (153 * month + 2) / 5 + 1;
    let (month, next) = if month < 10 { (month + 3, 0) } else { (month - 9, 1) };
    (400 * era + year + next, month, in_month)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn times_are_those_of_the_calendar() {
        // As `date -u -d @…` says.
        for (seconds, text) in [
            (0, "1970-01-01T00:00:00.042Z"),
            (951_782_400, "2000-02-29T00:00:00.042Z"),
            (951_868_799, "2000-02-29T23:59:59.042Z"),
            (1_709_164_800, "2024-02-29T00:00:00.042Z"),
            (1_709_251_200, "2024-03-01T00:00:00.042Z"),
            (1_772_348_709, "2026-03-01T07:05:09.042Z"),
            (4_107_542_400, "2100-03-01T00:00:00.042Z"),
        ] {
            let time = UNIX_EPOCH + Duration::from_millis(1000 * seconds + 42);
            assert_eq!(timestamp(time), text);
        }
    }

    #[test]
    fn only_what_is_new_is_sent() {
        let mut seen = Observations::default();
        seen.set("Xact", "1");
        seen.set("block", "G1 X1.|Y2.\t(A)");
        let first = seen.new_lines();
        assert!(first.ends_with("Z|Xact|1|block|G1 X1. Y2. (A)\n"), "{first}");
        seen.set("Xact", "1");
        assert_eq!(seen.new_lines(), "");
        seen.set("Xact", "2");
        assert!(seen.new_lines().ends_with("Z|Xact|2\n"));
    }
}
