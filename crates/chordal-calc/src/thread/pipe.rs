//! Pipe threads: NPT and NPTF (ASME B1.20.1, B1.20.3), G (ISO 228-1) and R (ISO 7-1).

use super::class::{self, FitClass};
use super::designation::{ThreadDesignation, ThreadForm, no_thread};
use super::formula_rows::FormulaRows;
use super::pipe_sizes::{G, NPT, PipeSize, TOLERANCES};
use super::words::diameter;
use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::error::CalcError;
use crate::figure::{Figure, LineStyle};
use crate::math::{atan, tan};
use crate::numbers::{AnswerUnit, trimmed};
use chordal_geometry::Vec2;

const INCH: f64 = 25.4;
/// Height of the rounded 55° thread over the pitch (ISO 228-1).
const WHITWORTH: f64 = 0.640_327;

/// The form, when one of the words is a pipe thread's.
pub(super) fn form(words: &[String]) -> Option<ThreadForm> {
    words.iter().find_map(|word| read_form(word))
}

fn read_form(word: &str) -> Option<ThreadForm> {
    match word.to_ascii_uppercase().as_str() {
        "NPT" => Some(ThreadForm::Npt),
        "NPTF" => Some(ThreadForm::Nptf),
        "G" | "BSPP" | "BSP" => Some(ThreadForm::G),
        "R" | "RC" | "BSPT" => Some(ThreadForm::R),
        _ => None,
    }
}

/// What the form is called, and where its sizes are.
const fn source(form: ThreadForm) -> (&'static str, &'static str) {
    match form {
        ThreadForm::Npt => ("NPT", "ASME B1.20.1"),
        ThreadForm::Nptf => ("NPTF", "ASME B1.20.3"),
        ThreadForm::R => ("R", "ISO 7-1"),
        _ => ("G", "ISO 228-1"),
    }
}

/// Reads the name of a pipe thread: its size, threads per inch where they are given, class A or B.
pub(super) fn read(text: &str, words: &[String]) -> Result<ThreadDesignation, CalcError> {
    let form = form(words).ok_or_else(|| no_thread(text))?;
    let rest = without_form(words, form);
    let (requested, used) = diameter(&rest).ok_or_else(|| no_thread(text))?;
    let found = find(form, requested)?;
    let inch = matches!(form, ThreadForm::Npt | ThreadForm::Nptf);
    let (unit, units) = if inch { (INCH, AnswerUnit::Inch) } else { (1.0, AnswerUnit::Millimetre) };
    let mut name = ThreadDesignation::new(found.major * unit, INCH / found.tpi, units, form);
    name.pipe = Some(found);
    let mut at = used;
    if let Some((tpi, words)) = diameter(&rest[used..]) {
        at += words;
        if (tpi - found.tpi).abs() > 1e-9 {
            let (kind, standard) = source(form);
            return Err(CalcError::new(
                format!("{} {kind} has {} threads per inch, not {tpi}", found.name, found.tpi),
                format!("leave them out: {standard} has one pitch for each size"),
            ));
        }
    }
    for word in &rest[at..] {
        let upper = word.to_ascii_uppercase();
        match upper.as_str() {
            _ if name.take_hand(&upper)? => {}
            "TPI" => {}
            "A" | "B" if form == ThreadForm::G => {
                class::add(&mut name.classes, FitClass::Pipe { wide: upper == "B" })?;
            }
            _ => {
                return Err(CalcError::new(
                    format!("`{word}` is not part of the name of a pipe thread"),
                    "the classes of G threads are A and B outside; NPT and R have none; a hand is LH or RH",
                ));
            }
        }
    }
    Ok(name)
}

/// The words without those of the form; `1/2A` of a G thread becomes two.
fn without_form(words: &[String], form: ThreadForm) -> Vec<String> {
    let mut rest = Vec::new();
    for word in words.iter().filter(|word| read_form(word).is_none()) {
        if form != ThreadForm::G {
            rest.push(word.clone());
            continue;
        }
        let end = word.trim_end_matches(['A', 'B', 'a', 'b']).len();
        let (size, class) = word.split_at(end);
        rest.extend([size, class].into_iter().filter(|part| !part.is_empty()).map(String::from));
    }
    rest
}

fn find(form: ThreadForm, requested: f64) -> Result<&'static PipeSize, CalcError> {
    let table: &'static [PipeSize] = match form {
        ThreadForm::Npt | ThreadForm::Nptf => &NPT,
        _ => &G,
    };
    let has = |own: &&PipeSize| form != ThreadForm::R || own.gauge > 0.0;
    let found = table.iter().filter(has).find(|own| (own.size - requested).abs() < 1e-6);
    found.ok_or_else(|| {
        let names: Vec<&str> = table.iter().filter(has).map(|own| own.name).collect();
        let (kind, standard) = source(form);
        CalcError::new(
            format!("there is no {kind} thread of size {}", trimmed(requested, 4)),
            format!("the sizes of {standard} here are {}", names.join(", ")),
        )
    })
}

/// Sizes of a pipe thread.
pub(super) fn worked(
    name: &ThreadDesignation,
    starts: u32,
    units: AnswerUnit,
) -> Result<WorkedCalculation, CalcError> {
    let found = name.pipe.ok_or_else(|| no_thread("the size of the pipe thread is missing"))?;
    if starts != 1 {
        return Err(CalcError::new(
            format!("a pipe thread cannot have {starts} starts"),
            "leave --starts out",
        ));
    }
    let (kind, standard) = source(name.form);
    let mut worked =
        WorkedCalculation::new(format!("Pipe thread {} {kind} ({standard})", found.name), units);
    let inch = matches!(name.form, ThreadForm::Npt | ThreadForm::Nptf);
    let meaning = match name.form {
        ThreadForm::Npt | ThreadForm::Nptf => "outside diameter of the pipe",
        ThreadForm::R => "major diameter at the gauge plane",
        _ => "major diameter",
    };
    worked.input("D", meaning, QuantityKind::Length, name.major);
    worked.input("TPI", "threads per inch", QuantityKind::Number, found.tpi);
    let filled = format!("1/{} in", trimmed(found.tpi, 3));
    worked.result("P", "pitch", QuantityKind::Length, name.pitch, "1/TPI", filled);
    if name.form != ThreadForm::G {
        taper(&mut worked);
    }
    if inch {
        npt(&mut worked, found);
    } else {
        whitworth(&mut worked, name, found);
    }
    if name.form == ThreadForm::Nptf {
        worked.note(
            "NPTF has the diameters, pitch and taper of NPT; its crests and roots are cut to seal (ASME \
             B1.20.3), so h and the minor diameters differ a little. Check with gauges.",
        );
    }
    worked.note("thread-mill writes no program for it: only for parallel 60° threads.");
    let (height, half) = if inch { (0.8, 30f64) } else { (WHITWORTH, 27.5) };
    let slope = if name.form == ThreadForm::G { 0.0 } else { 1.0 / 32.0 };
    worked.figure = profile(name.pitch, height, half.to_radians(), slope, units);
    Ok(worked)
}

fn taper(worked: &mut WorkedCalculation) {
    let value = 1.0 / 16.0;
    worked.result("k", "taper on the diameter", QuantityKind::Number, value, "1:16", "1/16".into());
    let angle = atan(1.0 / 32.0);
    worked.result(
        "α",
        "angle to the axis",
        QuantityKind::Angle,
        angle,
        "atan(k/2)",
        "atan(1/32)".into(),
    );
}

/// Sizes of NPT by the formulas of ASME B1.20.1, which are in inches.
fn npt(worked: &mut WorkedCalculation, found: &PipeSize) {
    let PipeSize { major: d, tpi, gauge, .. } = *found;
    let p = 1.0 / tpi;
    let small = d - (0.05 * d + 1.1) * p;
    let large = small + gauge / 16.0;
    let height = 0.8 * p;
    let mut rows =
        FormulaRows::new(worked, INCH, &|inches| trimmed(inches, 5), &[("D", d), ("P", p)]);
    rows.result("L1", "engagement by hand", gauge, "ASME B1.20.1, table 2");
    let effective = (0.8 * d + 6.8) * p;
    rows.result("L2", "length of effective thread", effective, "(0.8·D + 6.8)·P");
    let formula = "D − (0.05·D + 1.1)·P";
    rows.result("E0", "pitch diameter at the end of the pipe", small, formula);
    rows.result("E1", "pitch diameter at the mouth of the hole", large, "E0 + L1/16");
    rows.result("h", "height of the thread", height, "0.8·P");
    rows.result("K0", "minor diameter at the end of the pipe", small - height, "E0 − h");
    rows.result("K1", "minor diameter at the mouth of the hole", large - height, "E1 − h");
    worked.note("The formulas are in inches. Basic sizes: the gauge may be off by one turn.");
}

/// Sizes of G and R, which have one profile.
fn whitworth(worked: &mut WorkedCalculation, name: &ThreadDesignation, found: &PipeSize) {
    let (d, p) = (name.major, name.pitch);
    let units = worked.units;
    // The standards round the depth to a micrometre, and take it off once and twice.
    let height = (WHITWORTH * p * 1000.0).round() / 1000.0;
    let (middle, minor) = (d - height, d - 2.0 * height);
    let number = |mm: f64| units.number(mm);
    let mut rows = FormulaRows::new(worked, 1.0, &number, &[("D", d), ("P", p)]);
    rows.result("h", "depth of the thread", height, "0.640327·P, to 0.001 mm");
    rows.result("D2", "pitch diameter", middle, "D − h");
    rows.result("D1", "minor diameter", minor, "D − 2·h");
    if name.form == ThreadForm::R {
        let small = |large: f64| large - found.gauge / 16.0;
        rows.result("L", "gauge length", found.gauge, "ISO 7-1, table 1");
        rows.result("D0", "major diameter at the small end", small(d), "D − L/16");
        rows.result("D20", "pitch diameter at the small end", small(middle), "D2 − L/16");
        rows.result("D10", "minor diameter at the small end", small(minor), "D1 − L/16");
        return;
    }
    parallel_limits(worked, name, found, [middle, minor]);
}

/// Limits of a G thread: the hole's always, the pipe's of the class that is named.
fn parallel_limits(
    worked: &mut WorkedCalculation,
    name: &ThreadDesignation,
    found: &PipeSize,
    [middle, minor]: [f64; 2],
) {
    let range = TOLERANCES.iter().find(|(most, ..)| found.size <= most + 1e-6);
    let Some((_, pitch, crest, hole)) = range.copied() else { return };
    let units = worked.units;
    let d = name.major;
    let mut give = |symbol: &str, meaning: &str, base: f64, add: f64, formula: &str| {
        let sign = if add < 0.0 { '−' } else { '+' };
        let filled = format!("{} {sign} {}", units.number(base), units.number(add.abs()));
        worked.result(symbol, meaning, QuantityKind::Length, base + add, formula, filled);
    };
    give("D1max", "minor diameter of the hole, most", minor, hole, "D1 + TD1 (ISO 228-1)");
    give("D2max", "pitch diameter of the hole, most", middle, pitch, "D2 + TD2 (ISO 228-1)");
    for class in &name.classes {
        let FitClass::Pipe { wide } = class else { continue };
        let tolerance = if *wide { 2.0 * pitch } else { pitch };
        give("dmin", "major diameter outside, least", d, -crest, "D − Td (ISO 228-1)");
        let meaning = format!("pitch diameter outside, least, class {class}");
        give("d2min", &meaning, middle, -tolerance, "D2 − Td2 (ISO 228-1)");
    }
}

/// Two pitches of a thread so many pitches high, with its slope to the axis.
fn profile(pitch: f64, height: f64, half: f64, slope: f64, units: AnswerUnit) -> Figure {
    let mut figure = Figure::default();
    let depth = height * pitch;
    let flank = depth * tan(half);
    let crest = (pitch / 2.0 - flank) / 2.0;
    let at = |x: f64, y: f64| Vec2::new(x, y + slope * x);
    let mut last: Option<Vec2> = None;
    for turn in 0..3 {
        let middle = f64::from(turn) * pitch;
        let points = [
            at(middle - crest - flank, -depth),
            at(middle - crest, 0.0),
            at(middle + crest, 0.0),
            at(middle + crest + flank, -depth),
        ];
        if let Some(last) = last {
            figure.line(last, points[0], LineStyle::Part);
        }
        for pair in points.windows(2) {
            figure.line(pair[0], pair[1], LineStyle::Part);
        }
        last = Some(points[3]);
    }
    let (left, right) = (-0.75 * pitch, 2.75 * pitch);
    figure.line(at(left, -depth / 2.0), at(right, -depth / 2.0), LineStyle::Path);
    let up = 0.42 * pitch;
    figure.width(at(0.0, 0.0), at(pitch, 0.0), up, format!("P {}", units.number(pitch)));
    let text = format!("h {}", units.number(depth));
    figure.height(at(0.0, 0.0), at(-crest - flank, -depth), left - 0.22 * pitch, text);
    let root = at(pitch / 2.0, -height * pitch - crest / tan(half));
    let start = std::f64::consts::FRAC_PI_2 - half;
    let opening = trimmed(2.0 * half.to_degrees(), 0);
    figure.angle(root, 0.75 * pitch, start, 2.0 * half, format!("{opening}°"));
    figure
}
