//! Compares what a program expects with what happened.

use chordal::Severity;
use chordal::machine::{AXES, AXIS_LETTERS, PerAxis};

use crate::grammar::{self, Motion, Number, Place, Program};
use crate::runner::{Made, Ran, Told, run, short};

/// Reads a program, runs it, and says what is not as expected; `Ok` when all is.
pub fn check(name: &str, text: &str) -> Result<(), String> {
    let program = grammar::read(text).map_err(|error| format!("{name}: {error}"))?;
    let ran = run(&program, &program.machine).map_err(|error| format!("{name}: {error}"))?;
    let mut wrong = Vec::new();
    check_lines(&program, &ran, &mut wrong);
    check_events(&program, &ran, &mut wrong);
    check_printed(&program, &ran, &mut wrong);
    check_diagnostics(&program, &ran, &mut wrong);
    check_whole(&program, &ran, &mut wrong);
    for other in &program.same_on {
        let there = run(&program, other).map_err(|error| format!("{name}: {error}"))?;
        check_same(other, &ran, &there, &mut wrong);
    }
    if wrong.is_empty() {
        return Ok(());
    }
    let lines = wrong.into_iter().map(|(line, text)| format!("{name}:{line}: {text}"));
    Err(lines.collect::<Vec<_>>().join("\n"))
}

type Wrong = Vec<(u32, String)>;

fn check_lines(program: &Program, ran: &Ran, wrong: &mut Wrong) {
    for made in &ran.made {
        if let Some(contradiction) = made.contradiction() {
            wrong.push((made.line, contradiction));
        }
    }
    for (&line, expected) in &program.lines {
        let Some(motions) = &expected.motions else { continue };
        let made: Vec<usize> = (0..ran.made.len()).filter(|&i| ran.made[i].line == line).collect();
        for (at, motion) in motions.iter().enumerate() {
            let Some(&index) = made.get(at) else {
                wrong.push((line, format!("expected `{}`, and nothing moved", motion.text)));
                continue;
            };
            let before = index.checked_sub(1).map(|before| &ran.made[before]);
            for difference in differences(motion, before, &ran.made[index], ran.unit) {
                let happened = ran.made[index].describe(ran.unit);
                let expected = &motion.text;
                wrong.push((
                    line,
                    format!("{difference}\n    expected {expected}\n    made     {happened}"),
                ));
            }
        }
        for &index in made.iter().skip(motions.len()) {
            wrong.push((line, format!("not expected: {}", ran.made[index].describe(ran.unit))));
        }
    }
}

fn check_events(program: &Program, ran: &Ran, wrong: &mut Wrong) {
    for (&line, expected) in program.lines.iter().filter(|(_, line)| !line.events.is_empty()) {
        let words = |events: &[(usize, String)]| {
            let words =
                events.iter().map(|(before, text)| format!("{text} after {before} motions"));
            words.collect::<Vec<_>>().join(", ")
        };
        let happened: Vec<(usize, String)> = ran
            .events
            .iter()
            .filter(|(at, _, _)| *at == line)
            .map(|(_, before, text)| (*before, text.clone()))
            .collect();
        if happened != expected.events {
            let (happened, expected) = (words(&happened), words(&expected.events));
            wrong.push((line, format!("{happened}\n    expected {expected}")));
        }
    }
}

fn check_printed(program: &Program, ran: &Ran, wrong: &mut Wrong) {
    for (&line, expected) in &program.lines {
        let Some(prints) = &expected.prints else { continue };
        let printed: Vec<&str> =
            ran.printed.iter().filter(|(at, _)| *at == line).map(|(_, text)| &**text).collect();
        if printed != *prints {
            wrong.push((line, format!("printed {printed:?}, not {prints:?}")));
        }
    }
}

/// A value that is no number differs from everything.
fn differs(expected: f64, is: f64, by: f64) -> bool {
    is.is_nan() || (expected - is).abs() > by
}

fn differences(expected: &Motion, before: Option<&Made>, made: &Made, unit: f64) -> Vec<String> {
    let mut found = Vec::new();
    let mut compare = |what: &str, number: Number, is: f64| {
        // A correctly rounded number is off by half a unit of its last digit at most.
        if differs(number.value, is, number.step / 2.0 + 1e-9) {
            found.push(format!("{what} is {}, not {}", short(is), short(number.value)));
        }
    };
    let place = |place: &Place,
                 is: &PerAxis<f64>,
                 what: &str,
                 compare: &mut dyn FnMut(&str, Number, f64)| {
        for (&letter, &number) in place {
            let axis = AXIS_LETTERS.find(letter).unwrap_or(0);
            let is = if axis < 3 { is[axis] / unit } else { is[axis].to_degrees() };
            compare(&format!("{what} {letter}"), number, is);
        }
    };
    place(&expected.from, &made.from, "start", &mut compare);
    place(&expected.to, &made.to, "end", &mut compare);
    if let Some(length) = expected.length {
        compare("length", length, made.length / unit);
    }
    if let Some(feed) = expected.feed {
        let unit = if made.feed_has_length { unit } else { 1.0 };
        compare("feed", feed, made.feed.map_or(f64::NAN, |feed| feed / unit));
    }
    if let (Some(tangent), Some(before)) = (expected.tangent, before) {
        let (a, b) = (before.tangents.1, made.tangents.0);
        let kink = a.cross(b).length().atan2(a.dot(b)).to_degrees();
        if differs(kink, 0.0, tangent.value) {
            compare("the turn against the motion before", Number { value: 0.0, ..tangent }, kink);
        }
    }
    match made.shape {
        Some(shape) => {
            let (a, b, _) = shape.plane.axes();
            let mut center = [f64::NAN; AXES];
            (center[a], center[b]) = (shape.center[0], shape.center[1]);
            place(&expected.center, &center, "centre", &mut compare);
            if let Some((from, to)) = expected.radius {
                compare("radius at the start", from, shape.radius_from / unit);
                compare("radius at the end", to, shape.radius_to / unit);
            }
            if let Some(sweep) = expected.sweep {
                compare("sweep", sweep, shape.sweep.to_degrees().abs());
            }
            if expected.ccw.is_some_and(|ccw| ccw != (shape.sweep > 0.0)) {
                found.push("it turns the other way".into());
            }
        }
        None if expected.radius.is_some() || expected.sweep.is_some() || expected.ccw.is_some() => {
            found.push("it is straight".into());
        }
        None => {}
    }
    if let Some((word, distance)) = &expected.corner {
        let (is, mm) = made.corner();
        let off = differs(distance.value, mm / unit, 1e-6);
        if is != word || off {
            found.push(format!("corner is {is} {}", short(mm / unit)));
        }
    }
    let kind_fits = match expected.kind.as_str() {
        "helix" => made.is_helix(),
        kind => kind == made.kind,
    };
    if !kind_fits {
        found.insert(0, format!("it is no {}", expected.kind));
    }
    for (what, expected, is) in
        [("plane", &expected.plane, made.plane()), ("feed along", &expected.along, made.along)]
    {
        if expected.as_deref().is_some_and(|expected| is != Some(expected)) {
            found.push(format!("{what} is {}", is.unwrap_or("nothing")));
        }
    }
    found
}

fn check_diagnostics(program: &Program, ran: &Ran, wrong: &mut Wrong) {
    let fits = |told: &Told, line: u32, problem: &grammar::Problem| {
        told.line == line
            && told.id == problem.code
            && problem.texts.iter().all(|text| told.text.contains(text))
    };
    for (&line, expected) in &program.lines {
        for problem in &expected.problems {
            if !ran.told.iter().any(|told| fits(told, line, problem)) {
                let texts = problem.texts.join("` and `");
                wrong.push((line, format!("expected {} with `{texts}`, not told", problem.code)));
            }
        }
    }
    for told in &ran.told {
        let problems = program.lines.get(&told.line).map_or(&[][..], |line| &line.problems);
        let expected = program.expect.iter().any(|code| code == told.id)
            || problems.iter().any(|problem| fits(told, told.line, problem));
        if told.severity > Severity::Note && !expected {
            let word = told.severity.word();
            wrong.push((told.line, format!("{word} not expected: {} {}", told.id, told.text)));
        }
    }
    for code in &program.expect {
        if !ran.told.iter().any(|told| told.id == code) {
            wrong.push((1, format!("expected {code} somewhere, not told")));
        }
    }
}

fn check_whole(program: &Program, ran: &Ran, wrong: &mut Wrong) {
    let summary = &ran.report.summary;
    for (name, number) in &program.total {
        let is = match name.as_str() {
            "rapids" => summary.rapids as f64,
            "lines" => summary.lines as f64,
            "arcs" => summary.arcs as f64,
            "helices" => summary.helices as f64,
            "spirals" => summary.spirals as f64,
            "splines" => summary.splines as f64,
            "dwells" => summary.dwells as f64,
            "feed_length" => summary.feed_length_mm / ran.unit,
            _ => summary.rapid_length_mm / ran.unit,
        };
        let count = !name.ends_with("length");
        let step = if count { 0.0 } else { number.step };
        if differs(number.value, is, step / 2.0 + 1e-9) {
            wrong.push((1, format!("total {name} is {}, not {}", short(is), short(number.value))));
        }
    }
    let Some(last) = ran.made.last() else { return };
    let end = Motion { kind: last.kind.into(), to: program.ends_at.clone(), ..Motion::default() };
    for difference in differences(&end, None, last, ran.unit) {
        wrong.push((last.line, format!("at the end of the program: {difference}")));
    }
}

fn check_same(machine: &str, here: &Ran, there: &Ran, wrong: &mut Wrong) {
    let near = |a: f64, b: f64| (a - b).abs() < 1e-6;
    for index in 0..here.made.len().max(there.made.len()) {
        let (a, b) = (here.made.get(index), there.made.get(index));
        let same = a.zip(b).is_some_and(|(a, b)| {
            let shape = match (a.shape, b.shape) {
                (Some(a), Some(b)) => {
                    let centers = a.center.iter().zip(b.center);
                    near(a.sweep, b.sweep) && centers.into_iter().all(|(a, b)| near(*a, b))
                }
                (a, b) => a.is_none() && b.is_none(),
            };
            a.kind == b.kind && shape && a.to.iter().zip(b.to).all(|(a, b)| near(*a, b))
        });
        if !same {
            let words = |made: Option<&Made>| {
                made.map_or("nothing".into(), |made| made.describe(here.unit))
            };
            let line = a.or(b).map_or(1, |made| made.line);
            let text = format!("on {machine}: {}\n    here {}", words(b), words(a));
            return wrong.push((line, text));
        }
    }
}
