//! Problems as a SARIF 2.1.0 log.

use chordal::diagnostics::{Applicability, CodeInfo, Fix};
use chordal::{Code, Diagnostic, Report, Severity, SourceMap, Span};
use serde_json::{Value, json};

use super::place::{call_text, place};

/// A SARIF 2.1.0 log of any number of programs: one run, with the whole registry as its
/// rules.
#[derive(Debug, Default)]
pub struct SarifReport {
    results: Vec<Value>,
    notifications: Vec<Value>,
}

impl SarifReport {
    /// An empty log.
    pub fn new() -> SarifReport {
        SarifReport::default()
    }

    /// Adds the problems of a program.
    pub fn add(&mut self, report: &Report, sources: &SourceMap) {
        let results = report.diagnostics.iter().map(|diagnostic| result(diagnostic, sources));
        self.results.extend(results);
        if let Some(span) = report.not_verified_from {
            self.notifications.push(json!({
                "level": "error",
                "message": { "text": "the path from here on is not known: it is not verified" },
                "locations": [location(span, "", sources)],
            }));
        }
        for (code, count) in &report.dropped {
            let text = format!("{count} more problems of {} are not listed", code.id());
            self.notifications.push(json!({
                "level": "note",
                "message": { "text": text },
                "associatedRule": { "id": code.id() },
            }));
        }
    }

    /// The log as text.
    pub fn finish(self) -> String {
        let rules: Vec<Value> = Code::all().map(|code| rule(code.info())).collect();
        let log = json!({
            "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
            "version": "2.1.0",
            "runs": [{
                "tool": { "driver": {
                    "name": "Chordal",
                    "version": env!("CARGO_PKG_VERSION"),
                    "semanticVersion": env!("CARGO_PKG_VERSION"),
                    "rules": rules,
                } },
                "invocations": [{
                    "executionSuccessful": true,
                    "toolExecutionNotifications": self.notifications,
                }],
                "columnKind": "unicodeCodePoints",
                "results": self.results,
            }],
        });
        format!("{log:#}\n")
    }
}

fn level(severity: Severity) -> &'static str {
    // SARIF's three words are ours.
    severity.word()
}

fn rule(info: &CodeInfo) -> Value {
    json!({
        "id": info.id,
        "name": info.name,
        "shortDescription": { "text": info.summary },
        "fullDescription": { "text": info.summary },
        "help": { "text": info.explanation.trim() },
        "defaultConfiguration": { "level": level(info.severity) },
    })
}

fn result(diagnostic: &Diagnostic, sources: &SourceMap) -> Value {
    let index = Code::all().position(|code| code == diagnostic.code);
    let mut object = json!({
        "ruleId": diagnostic.code.id(),
        "ruleIndex": index,
        "level": level(diagnostic.severity),
        "message": { "text": message(diagnostic) },
        "locations": [location(diagnostic.primary.span, &diagnostic.primary.text, sources)],
    });
    let related: Vec<Value> = related(diagnostic, sources);
    if !related.is_empty() {
        object["relatedLocations"] = related.into();
    }
    // Only what may be done without asking: consumers offer to do it at a click.
    if let Some(fix) = &diagnostic.fix
        && fix.applicability == Applicability::Safe
        && let Some(fix) = fix_object(fix, sources)
    {
        object["fixes"] = json!([fix]);
    }
    object
}

fn message(diagnostic: &Diagnostic) -> String {
    let mut text = diagnostic.message.clone();
    if let Some(alarm) = &diagnostic.alarm {
        text.push_str(&format!("\nalarm: {alarm}"));
    }
    for note in &diagnostic.notes {
        text.push_str(&format!("\nnote: {note}"));
    }
    if let Some(help) = &diagnostic.help {
        text.push_str(&format!("\nhelp: {help}"));
    }
    text
}

/// Secondary labels, and the calls through which the block was reached.
fn related(diagnostic: &Diagnostic, sources: &SourceMap) -> Vec<Value> {
    let labels =
        diagnostic.secondary.iter().map(|label| location(label.span, &label.text, sources));
    let calls = diagnostic.calls.iter().map(|call| {
        location(*call, &format!("called from here: {}", call_text(*call, sources)), sources)
    });
    labels.chain(calls).collect()
}

fn location(span: Span, text: &str, sources: &SourceMap) -> Value {
    let name = sources.get(span.file).map_or("", |source| source.name());
    let mut physical = json!({ "artifactLocation": { "uri": uri(name) } });
    if let Some(region) = region(span, sources) {
        physical["region"] = region;
    }
    let mut object = json!({ "physicalLocation": physical });
    if !text.is_empty() {
        object["message"] = json!({ "text": text });
    }
    object
}

fn region(span: Span, sources: &SourceMap) -> Option<Value> {
    let at = place(span, sources)?;
    Some(json!({
        "startLine": at.start.line,
        "startColumn": at.start.column,
        "endLine": at.end.line,
        "endColumn": at.end.column,
    }))
}

fn fix_object(fix: &Fix, sources: &SourceMap) -> Option<Value> {
    let name = sources.get(fix.span.file)?.name();
    Some(json!({
        "description": { "text": fix.title },
        "artifactChanges": [{
            "artifactLocation": { "uri": uri(name) },
            "replacements": [{
                "deletedRegion": region(fix.span, sources)?,
                "insertedContent": { "text": fix.replacement },
            }],
        }],
    }))
}

/// A file's name as a URI reference.
fn uri(name: &str) -> String {
    let name = name.replace('\\', "/");
    let drive = name.as_bytes().get(1) == Some(&b':');
    let prefix = match (drive, name.starts_with('/')) {
        (true, _) => "file:///",
        (_, true) => "file://",
        _ => "",
    };
    let mut out = String::from(prefix);
    for (index, byte) in name.bytes().enumerate() {
        let colon_of_drive = drive && index == 1;
        if byte.is_ascii_alphanumeric() || b"/-._~".contains(&byte) || colon_of_drive {
            out.push(byte as char);
        } else {
            out.push_str(&format!("%{byte:02X}"));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_uris() {
        assert_eq!(uri("parts/a b.nc"), "parts/a%20b.nc");
        assert_eq!(uri("/nc/Ø.nc"), "file:///nc/%C3%98.nc");
        assert_eq!(uri("C:\\nc\\a.nc"), "file:///C:/nc/a.nc");
    }
}
