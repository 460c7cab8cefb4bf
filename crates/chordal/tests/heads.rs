//! Comments at the heads of programs, form by form: `heads/rows.txt` says what must be read of each.

use std::fmt::Write as _;

use chordal::machine::{Axis, ToolShape};
use chordal::tool_comments::{StockPlace, commented_stock, known_tools};
use chordal::{Job, Machine, Source, SourceMap};

/// Values agree within this, mm and degrees.
const TOLERANCE: f64 = 1e-9;

/// A program and what must be read of it.
#[derive(Default)]
struct Case<'t> {
    title: &'t str,
    program: String,
    expected: Vec<&'t str>,
}

fn cases(text: &str) -> Vec<Case<'_>> {
    let mut cases: Vec<Case<'_>> = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some(title) = line.strip_prefix("== ") {
            cases.push(Case { title, ..Case::default() });
            continue;
        }
        let case = cases.last_mut().expect("a title first");
        match line.split_once(' ') {
            Some((">", line)) => writeln!(case.program, "{line}").expect("a text"),
            Some(("=", line)) => case.expected.push(line),
            _ => panic!("neither program nor expectation: {line}"),
        }
    }
    cases
}

fn job(case: &Case<'_>) -> Job<'static> {
    let control = case.title.split(", ").nth(1).expect("a control");
    // A lathe is one by its axes, which its built-in machine has.
    let machine = Machine::from_builtin(control).or_else(|_| {
        let text = format!("control = '{control}'");
        Machine::from_toml("m.toml", &text, &|name| Err(format!("no {name}")))
    });
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", case.program.as_bytes().to_vec()));
    Job::new(sources, machine.expect("a good machine")).expect("good settings")
}

fn same(value: Option<f64>, expected: &str) -> bool {
    match expected {
        "none" => value.is_none(),
        number => {
            let expected: f64 = number.parse().expect("a number");
            value.is_some_and(|value| (value - expected).abs() < TOLERANCE)
        }
    }
}

fn is_shape(shape: Option<ToolShape>, expected: &str) -> bool {
    let expected = match expected {
        "spot" => ToolShape::Drill,
        "face" => ToolShape::Flat,
        word => *ToolShape::ALL.iter().find(|shape| shape.as_str() == word).expect("a shape"),
    };
    shape == Some(expected)
}

/// What is not as it must be.
fn wrong_tool(job: &Job, words: &[&str]) -> Vec<String> {
    let number: u32 = words[0].parse().expect("a number");
    let tool = known_tools(job).remove(&number).map(|known| known.tool).unwrap_or_default();
    let is_right = |pair: &&[&str]| match pair[0] {
        "diameter" => same(tool.diameter_mm, pair[1]),
        "corner" => same(tool.corner_radius_mm, pair[1]),
        "angle" => same(tool.point_angle_rad.map(f64::to_degrees), pair[1]),
        "nose" => same(tool.nose_radius_mm, pair[1]),
        "tip" => same(tool.tip.map(f64::from), pair[1]),
        "length" => same(tool.offset[Axis::Z as usize], pair[1]),
        "kind" => is_shape(tool.shape, pair[1]),
        key => panic!("no key {key}"),
    };
    let wrong = words[1..].chunks(2).filter(|pair| !is_right(pair));
    wrong.map(|pair| format!("tool {number} {}: {tool:?}", pair.join(" "))).collect()
}

/// The sides that differ, of a box, a bar about Z or a size alone.
fn wrong_stock(job: &Job, words: &[&str]) -> Option<String> {
    let said = commented_stock(job);
    let number = |at: usize| words[at].parse::<f64>().expect("a number");
    let near = |value: Option<f64>, expected: f64| {
        value.is_some_and(|value| (value - expected).abs() < TOLERANCE)
    };
    let is_right = match (words[0], said.as_ref().map(|said| &said.place)) {
        ("none", place) => place.is_none(),
        ("size", Some(StockPlace::Size(size))) => {
            (0..3).all(|axis| near(Some(size[axis]), number(1 + axis)))
        }
        ("X", Some(StockPlace::Body(body))) => (0..3).all(|axis| {
            near(body.from[axis], number(3 * axis + 1)) && near(body.to[axis], number(3 * axis + 2))
        }),
        ("diameter", Some(StockPlace::Body(body))) => {
            let length = body.to[2].zip(body.from[2]).map(|(to, from)| to - from);
            near(body.diameter_mm, number(1)) && near(length, number(3))
        }
        _ => false,
    };
    (!is_right).then(|| format!("stock {}: {said:?}", words.join(" ")))
}

fn wrong(case: &Case<'_>) -> Vec<String> {
    let job = job(case);
    let mut wrong = Vec::new();
    for line in &case.expected {
        let words: Vec<&str> = line.split(' ').collect();
        match words[0] {
            "tool" => wrong.extend(wrong_tool(&job, &words[1..])),
            "stock" => wrong.extend(wrong_stock(&job, &words[1..])),
            key => panic!("no key {key}"),
        }
    }
    wrong
}

#[test]
fn every_form_is_read() {
    look_at(include_str!("heads/rows.txt"));
}

#[test]
fn what_posts_and_people_write_is_read() {
    look_at(include_str!("heads/found.txt"));
}

fn look_at(text: &str) {
    let cases = cases(text);
    let failures: Vec<String> = cases
        .iter()
        .map(|case| (case, wrong(case)))
        .filter(|(_, wrong)| !wrong.is_empty())
        .map(|(case, wrong)| format!("{}\n  {}", case.title, wrong.join("\n  ")))
        .collect();
    println!(
        "{} of {} programs are read as they must be",
        cases.len() - failures.len(),
        cases.len()
    );
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
