use chordal::diagnostics::{Applicability, Collector, FileId, Fix};
use chordal::{Code, Diagnostic, Machine, ProgramReading, Report, Source, SourceMap, Span};
use chordal_export::{machine_error_text, report};

use crate::common::{WRONG, job};

#[test]
fn text_of_wrong_blocks() {
    let job = job("haas-vf2", "wrong.nc", WRONG);
    insta::assert_snapshot!(report::text(
        &job.report(),
        job.sources(),
        false,
        report::ReportDetail::All
    ));
}

#[test]
fn json_of_wrong_blocks() {
    let job = job("haas-vf2", "wrong.nc", WRONG);
    let reading = ProgramReading {
        machine: Some("haas-vf2"),
        control: "haas",
        from: "given",
        recognition: None,
        choices: None,
    };
    let text = report::json(&job.report(), job.sources(), "wrong.nc", &reading);
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(value["schema"], "chordal.diagnostics/1");
    insta::assert_snapshot!(text);
}

#[test]
fn github_of_wrong_blocks() {
    let job = job("haas-vf2", "wrong.nc", WRONG);
    insta::assert_snapshot!(report::github(&job.report(), job.sources()));
}

/// A problem in a line too long for any screen, with bytes that are not UTF-8.
fn long_line() -> (SourceMap<'static>, Diagnostic) {
    let mut text = b"O1\nM98 P2\n".to_vec();
    text.extend(vec![b'('; 500]);
    text.extend(b") G1 X10 Y\xD810. F5");
    text.extend(vec![b' '; 1_000_000]);
    let mut sources = SourceMap::new();
    sources.add(Source::new("long.nc", text));
    let at = |start, end| Span::new(FileId(0), start, end);
    let mut diagnostic =
        Diagnostic::new(Code::MissingDecimalPoint, at(515, 518), "`X10` is 0.001 in")
            .label("ten increments")
            .also(at(519, 524), "here it has one")
            .note("a note")
            .help("write a point")
            .fix(Fix {
                title: "write `X10.`".into(),
                span: at(515, 518),
                replacement: "X10.".into(),
                applicability: Applicability::Safe,
            });
    diagnostic.calls.push(at(3, 9));
    (sources, diagnostic)
}

#[test]
fn long_lines_are_cut_around_the_words() {
    let (sources, diagnostic) = long_line();
    let text = report::one(&diagnostic, &sources, false);
    assert!(text.lines().all(|line| line.chars().count() < 200));
    insta::assert_snapshot!(text);
}

#[test]
fn colors_change_no_words() {
    let (sources, diagnostic) = long_line();
    let colored = report::one(&diagnostic, &sources, true);
    let mut plain = String::new();
    let mut escape = false;
    for character in colored.chars() {
        match character {
            '\u{1b}' => escape = true,
            'm' if escape => escape = false,
            other if !escape => plain.push(other),
            _ => {}
        }
    }
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let expected = report::one(&diagnostic, &sources, false);
    // The colours of a fix stand for the sign below it.
    assert!(words(&plain).starts_with(&words(&expected)[..200]));
}

#[test]
fn a_problem_of_the_whole_program_has_no_snippet() {
    let (sources, _) = long_line();
    let diagnostic =
        Diagnostic::new(Code::EmptyProgram, Span::default(), "there is no block to run")
            .help("write one");
    insta::assert_snapshot!(report::one(&diagnostic, &sources, false), @r"
    warning[CH108]: there is no block to run
    --> long.nc
     = help: write one
    ");
}

#[test]
fn what_was_dropped_is_counted() {
    let (sources, diagnostic) = long_line();
    let mut collector = Collector::new(1);
    for start in 10..10_000 {
        let mut diagnostic = diagnostic.clone();
        diagnostic.primary.span = Span::new(FileId(0), start, start + 1);
        collector.push(diagnostic);
    }
    let report = Report {
        output: Vec::new(),
        summary: Default::default(),
        dropped: collector.dropped().collect(),
        counts: collector.counts(),
        not_verified_from: collector.lost(),
        path_lost_from: None,
        other_sides: Default::default(),
        diagnostics: collector.into_sorted(),
        outcomes: Vec::new(),
    };
    let text = report::text(&report, &sources, false, report::ReportDetail::First);
    let tail: Vec<&str> = text.lines().rev().take(3).collect();
    assert_eq!(tail, ["9,990 warnings", "", "  = also CH305: 9,989 more places"]);
}

#[test]
fn words_cannot_steer_the_terminal() {
    let (sources, mut diagnostic) = long_line();
    diagnostic.message = "a\u{1b}[31mb".into();
    diagnostic.primary.text = "c\u{7}".into();
    let text = report::one(&diagnostic, &sources, false);
    assert!(!text.contains(['\u{1b}', '\u{7}']));
}

#[test]
fn sarif_has_the_keys_that_consumers_ask() {
    let job = job("haas-vf2", "nc/wrong part.nc", WRONG);
    let (sources, diagnostic) = long_line();
    let mut long = job.report();
    long.diagnostics = vec![diagnostic];
    let mut sarif = report::SarifReport::new();
    sarif.add(&job.report(), job.sources());
    sarif.add(&long, &sources);
    let log: serde_json::Value = serde_json::from_str(&sarif.finish()).unwrap();
    assert_eq!(log["version"], "2.1.0");
    let run = &log["runs"][0];
    let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
    assert_eq!(rules.len(), Code::all().len());
    for rule in rules {
        assert!(rule["id"].is_string() && rule["name"].is_string());
        assert!(rule["shortDescription"]["text"].is_string() && rule["help"]["text"].is_string());
    }
    let results = run["results"].as_array().unwrap();
    assert_eq!(results.len(), job.report().diagnostics.len() + 1);
    for result in results {
        let index = result["ruleIndex"].as_u64().unwrap() as usize;
        assert_eq!(rules[index]["id"], result["ruleId"]);
        let place = &result["locations"][0]["physicalLocation"];
        assert!(place["artifactLocation"]["uri"].is_string());
        assert!(place["region"]["startLine"].is_u64());
    }
    let uri = &results[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
    assert_eq!(uri, "nc/wrong%20part.nc");
    let fixed = results.last().unwrap();
    let replacement = &fixed["fixes"][0]["artifactChanges"][0]["replacements"][0];
    assert_eq!(replacement["insertedContent"]["text"], "X10.");
    assert_eq!(replacement["deletedRegion"]["startColumn"], 506);
}

#[test]
fn machine_files_are_underlined() {
    let text = "inherits = 'haas-vf2'\n[feed]\nmax = 300\n";
    let none = |_: &str| Err("no such file".to_string());
    let errors = Machine::from_toml("mine.toml", text, &none).unwrap_err();
    insta::assert_snapshot!(machine_error_text(&errors[0], false), @r#"
    error: `feed.max` takes a velocity; `300` has no unit
     --> mine.toml:3:7
      |
    3 | max = 300
      |       ^^^
      |
      = help: write it with its unit: "300 in/min", "300 mm/min", "300 m/min" or "300 mm/s"
    "#);
}
