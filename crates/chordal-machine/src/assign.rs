//! Assignments: set one key of a machine, in the form of a line of its file.

use std::borrow::Cow;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeArray, DeValue};

use crate::check::{SchemaLocation, put};
use crate::designated_tool::contradictions;
use crate::error::{ErrorSource, MachineError};
use crate::machine::Machine;
use crate::schema::SchemaSlot;

/// The file name for errors in an assignment.
const NAME: &str = "assignment";

impl Machine {
    /// Sets a key with `key = value`, as in a machine file: `tools.5.diameter = "0.5 in"`. A text needs no quotes
    /// (`tools.5.diameter=0.5 in`, `control=haas`), and neither does a key with spaces or points
    /// (`settings.Setting 58=fanuc`, `work_offsets.G59.1.X=1 in`), because a shell removes them. `#500=1.5` is short for
    /// `macros.variables.500=1.5`. On an error the machine is not changed.
    pub fn set(&mut self, assignment: &str) -> Result<(), MachineError> {
        let source = ErrorSource::new(NAME, assignment);
        let form = || Some("write `key=value`, such as `tools.5.diameter=0.5 in`".to_string());
        let Some(equals) = find_equals(assignment) else {
            let span = Some(0..assignment.len());
            return Err(source.error(span, "an assignment needs a `=`", form()));
        };
        let mut at = SchemaLocation::default();
        for (key, span) in keys(&assignment[..equals], &source)? {
            // `#500=1.5` is a macro variable, as programs write it.
            if key.starts_with('#') && at.is_top() {
                for table in ["macros", "variables"] {
                    at = at.step(table, span.clone(), &source)?;
                }
            }
            at = at.step(&key, span, &source)?;
        }
        let written = &assignment[equals + 1..];
        let start = equals + 1 + (written.len() - written.trim_start().len());
        let written = written.trim();
        if written.is_empty() {
            let span = Some(0..assignment.len());
            return Err(source.error(span, "the assignment has no value", form()));
        }
        // A macro variable may have its number as programs write it: `.5`, `1.`.
        let as_program = |written: &str| written.parse::<f64>().ok().filter(|n| n.is_finite());
        let normal = match assignment.trim_start().starts_with('#').then(|| as_program(written)) {
            Some(Some(number)) => format!("{number:?}"),
            _ => written.to_string(),
        };
        let written = normal.as_str();
        // From here, spans are relative to the start of the value.
        let source = ErrorSource { shift: start, ..source };
        let wants_text = matches!(
            at.row().map(|row| &row.slot),
            Some(
                SchemaSlot::Text(_)
                    | SchemaSlot::OptionalText(_)
                    | SchemaSlot::Word { .. }
                    | SchemaSlot::Insert
                    | SchemaSlot::HolderDesignation
                    | SchemaSlot::Quantity { .. }
                    | SchemaSlot::Within { dimension: Some(_), .. }
                    | SchemaSlot::Position(_)
                    | SchemaSlot::Kind
                    | SchemaSlot::File(_)
                    | SchemaSlot::Programmed
            )
        );
        let value = value(written, wants_text, &source)?;
        let mut changed = self.clone();
        let mut errors = Vec::new();
        put(&mut changed, &at, &value, &source, &mut errors);
        if errors.is_empty() && at.is_of_tool() {
            errors = contradictions(&changed);
        }
        match errors.into_iter().next() {
            Some(error) => Err(error),
            None => {
                *self = changed;
                Ok(())
            }
        }
    }
}

/// The position of the first `=` outside of quotes; if there is an unmatched quote, of the first `=`.
fn find_equals(text: &str) -> Option<usize> {
    let mut quote = None;
    for (at, byte) in text.bytes().enumerate() {
        match (byte, quote) {
            (b'=', None) => return Some(at),
            (b'"' | b'\'', None) => quote = Some(byte),
            (byte, Some(open)) if byte == open => quote = None,
            _ => {}
        }
    }
    text.find('=')
}

/// A key with its position in the assignment.
type AssignedKey = (String, Range<usize>);

/// The dotted keys before the `=`.
fn keys(text: &str, source: &ErrorSource) -> Result<Vec<AssignedKey>, MachineError> {
    // The name of a variable may have points in it.
    if text.trim_start().starts_with("#<") {
        return Ok(vec![(text.trim().to_string(), 0..text.len())]);
    }
    let mut keys = Vec::new();
    let mut start = 0;
    for end in ends(text) {
        let part = &text[start..end];
        let from = start + (part.len() - part.trim_start().len());
        let part = part.trim();
        let span = from..from + part.len();
        if part.is_empty() {
            return Err(source.error(Some(start..end), "a key is missing here", None));
        }
        let key = match part.as_bytes()[0] {
            b'"' | b'\'' => match DeValue::parse(part).map(Spanned::into_inner) {
                Ok(DeValue::String(key)) => key.into_owned(),
                _ => {
                    return Err(source.error(
                        Some(span),
                        format!("{part} is not a quoted key"),
                        None,
                    ));
                }
            },
            _ => part.to_string(),
        };
        keys.push((key, span));
        start = end + 1;
    }
    // The name of a setting is the rest of the key, that of a work offset all but the axis at the end.
    let first = keys.first().map(|(key, _)| key.as_str());
    let last = match first {
        Some("settings") => keys.len(),
        Some("work_offsets") if keys.len() > 3 => keys.len() - 1,
        _ => return Ok(keys),
    };
    if last > 2 {
        let span = keys[1].1.start..keys[last - 1].1.end;
        let name = text[span.clone()].to_string();
        keys.splice(1..last, [(name, span)]);
    }
    Ok(keys)
}

/// Where each part of a dotted key ends: at the points outside of quotes, and at the end.
fn ends(text: &str) -> Vec<usize> {
    let mut ends = Vec::new();
    let mut quote = None;
    let mut fresh = true;
    for (at, byte) in text.bytes().enumerate() {
        match (byte, quote) {
            (b'.', None) => {
                ends.push(at);
                fresh = true;
                continue;
            }
            (b'"' | b'\'', None) if fresh => quote = Some(byte),
            (byte, Some(open)) if byte == open => quote = None,
            _ => {}
        }
        fresh &= byte == b' ';
    }
    ends.push(text.len());
    ends
}

/// The value: a TOML value, or else the bare text.
fn value<'t>(
    text: &'t str,
    wants_text: bool,
    source: &ErrorSource,
) -> Result<Spanned<DeValue<'t>>, MachineError> {
    let bare = |text: &'t str, from: usize| {
        Spanned::new(from..from + text.len(), DeValue::String(Cow::Borrowed(text)))
    };
    let quoted = text.starts_with(['"', '\'']);
    if wants_text && !quoted && !text.starts_with(['[', '{']) {
        return Ok(bare(text, 0));
    }
    match DeValue::parse(text) {
        Ok(value) if matches!(value.get_ref(), DeValue::Datetime(_)) => Ok(bare(text, 0)),
        Ok(value) => Ok(value),
        Err(error) if quoted => Err(source.error(error.span(), error.message(), None)),
        Err(_) => match text.strip_prefix('[').and_then(|text| text.strip_suffix(']')) {
            Some(items) => {
                let mut list = DeArray::new();
                let mut from = 1;
                for item in items.split(',') {
                    let at = from + (item.len() - item.trim_start().len());
                    let trimmed = item.trim();
                    let inner = trimmed
                        .strip_prefix('"')
                        .and_then(|inner| inner.strip_suffix('"'))
                        .unwrap_or(trimmed);
                    list.push(bare(inner, at + usize::from(inner.len() < trimmed.len())));
                    from += item.len() + 1;
                }
                Ok(Spanned::new(0..text.len(), DeValue::Array(list)))
            }
            None => Ok(bare(text, 0)),
        },
    }
}
