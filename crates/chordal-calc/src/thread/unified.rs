//! Limits of unified threads by the formulas of ASME B1.1 (paragraphs 5.8 and 8.3).
//!
//! The standard adds rounded numbers: tolerances and allowance have four decimals before they are
//! added, so its tables come out to the last digit. All formulas are in inches.

use super::formula_rows::FormulaRows;
use super::series::UnifiedSeries;
use super::{H, INSIDE, MIDDLE, ThreadLocation, ThreadSize};
use crate::calculation::WorkedCalculation;
use crate::math::{cbrt, sqrt};
use crate::numbers::trimmed;

/// Diameter from which minor diameters of holes have three decimals: number 6, in.
const THREE_DECIMALS: f64 = 0.138;
const INCH: f64 = 25.4;

/// A thread in inches.
struct UnifiedThreadSizes {
    d: f64,
    p: f64,
    tpi: f64,
    /// Pitch diameter tolerance of class 2A, the measure of all others, to six decimals.
    t2: f64,
    /// Length of engagement.
    le: f64,
    by_diameter: bool,
}

impl UnifiedThreadSizes {
    fn of(thread: &ThreadSize) -> UnifiedThreadSizes {
        let (d, p) = (thread.major / INCH, thread.pitch / INCH);
        let tpi = 1.0 / p;
        let by_diameter = UnifiedSeries::of(d, tpi).engages_by_diameter(tpi);
        let le = if by_diameter { d } else { 9.0 * p };
        let t2 = rounded(0.0015 * cbrt(d) + 0.0015 * sqrt(le) + 0.015 * two_thirds(p), 6);
        UnifiedThreadSizes { d, p, tpi, t2, le, by_diameter }
    }

    /// Tolerance of the minor diameter of a hole.
    fn minor(&self, grade: u8) -> f64 {
        let UnifiedThreadSizes { d, p, tpi, .. } = *self;
        let usual = 0.25 * p - 0.4 * p * p;
        let small = (0.05 * two_thirds(p) + 0.03 * p / d - 0.002).min(0.394 * p);
        match grade {
            3 if tpi > 13.0 - 1e-6 => small.max(0.23 * p - 1.5 * p * p),
            3 => small.max(0.12 * p),
            _ if d < 0.25 - 1e-9 => small.max(usual),
            _ if tpi > 4.0 - 1e-6 => usual,
            _ => 0.15 * p,
        }
    }
}

fn two_thirds(p: f64) -> f64 {
    cbrt(p * p)
}

/// Rounded as the standard does, half up.
fn rounded(value: f64, decimals: i32) -> f64 {
    let shift = 10f64.powi(decimals);
    (value * shift + 0.5 + 1e-6).floor() / shift
}

/// The allowance of classes 1A and 2A. The printed ones come out when T2 has five decimals and a half
/// goes down: 0.0016 for 5/8-11 (0.3·0.00550), 0.0008 for 4-40 (0.3·0.00251), 0.0007 for 5-44.
fn allowance(t2: f64) -> f64 {
    let exact = 0.3 * rounded(t2, 5);
    (exact * 1e4 + 0.5 - 1e-6).floor() / 1e4
}

/// Adds the limits of a class.
pub(super) fn limits(
    worked: &mut WorkedCalculation,
    thread: &ThreadSize,
    grade: u8,
    place: ThreadLocation,
) {
    let sizes = UnifiedThreadSizes::of(thread);
    let is_new = worked.step("T2").is_none();
    let known = [("D", sizes.d), ("P", sizes.p)];
    let mut rows = FormulaRows::new(worked, INCH, &|inches| trimmed(inches, 6), &known);
    measure(&mut rows, &sizes, is_new);
    match place {
        ThreadLocation::Outside => outside(&mut rows, &sizes, grade),
        ThreadLocation::Inside => inside(&mut rows, &sizes, grade),
    }
}

/// What all classes share; a pair of classes shows it once.
fn measure(rows: &mut FormulaRows<'_>, sizes: &UnifiedThreadSizes, is_new: bool) {
    rows.know("Le", sizes.le);
    rows.know("T2", sizes.t2);
    if is_new {
        let formula = if sizes.by_diameter { "D" } else { "9·P" };
        rows.intermediate("Le", "length of engagement", sizes.le, formula);
        let formula = "0.0015·∛D + 0.0015·√Le + 0.015·∛P², to 6 decimals";
        let meaning = "tolerance of the pitch diameter in class 2A, in inches";
        rows.intermediate("T2", meaning, sizes.t2, formula);
    }
}

fn outside(rows: &mut FormulaRows<'_>, sizes: &UnifiedThreadSizes, grade: u8) {
    let UnifiedThreadSizes { d, p, t2, .. } = *sizes;
    let class = format!("{grade}A");
    let (allowance, formula) =
        if grade == 3 { (0.0, "0") } else { (allowance(t2), "0.3·T2, to 4 decimals") };
    rows.intermediate("es", &format!("allowance of class {class}"), allowance, formula);
    let crest = if grade == 1 { 0.09 } else { 0.06 };
    let td = rounded(crest * two_thirds(p), 4);
    let formula = format!("{crest}·∛P², to 4 decimals");
    rows.intermediate("Td", "tolerance of the major diameter", td, &formula);
    let share = [1.5, 1.0, 0.75][usize::from(grade.clamp(1, 3) - 1)];
    let td2 = rounded(share * t2, 4);
    let filled = format!("{share}·T2");
    let formula =
        if grade == 2 { "T2, to 4 decimals" } else { &format!("{filled}, to 4 decimals") };
    rows.intermediate_of("Td2", "tolerance of the pitch diameter", td2, [formula, &filled]);

    let most = rounded(d - allowance, 4);
    let least = rounded(most - td, 4);
    let pitch_most = rounded(d - allowance - MIDDLE * p, 4);
    let pitch_least = rounded(pitch_most - td2, 4);
    let (flat, round) = (rounded(most - INSIDE * p, 4), rounded(most - 1.375 * H * p, 4));
    let reference = rounded(pitch_least - MIDDLE * p, 4);
    rows.result("dmax", "major diameter, most", most, "D − es");
    rows.result("dmin", "major diameter, least", least, "dmax − Td");
    rows.result("d2max", "pitch diameter, most", pitch_most, "dmax − 0.649519·P");
    rows.result("d2min", "pitch diameter, least", pitch_least, "d2max − Td2");
    rows.result("d1max", "minor diameter, most, flat root (UN)", flat, "dmax − 1.082532·P");
    rows.result("d3max", "minor diameter, most, round root (UNR)", round, "dmax − 1.190785·P");
    rows.result("d1min", "minor diameter, least, for reference", reference, "d2min − 0.649519·P");
    let words = ["major", "in, ASME B1.1"];
    rows.note_limits(&format!("{class}, outside"), words, [most, least], [pitch_most, pitch_least]);
}

/// The formula of the minor diameter's tolerance, for people.
fn minor_formula(sizes: &UnifiedThreadSizes, grade: u8) -> &'static str {
    match grade {
        3 if sizes.tpi > 13.0 - 1e-6 => {
            "0.05·∛P² + 0.03·P/D − 0.002, at most 0.394·P, at least 0.23·P − 1.5·P²"
        }
        3 => "0.05·∛P² + 0.03·P/D − 0.002, at most 0.394·P, at least 0.12·P",
        _ if sizes.d < 0.25 - 1e-9 => {
            "0.05·∛P² + 0.03·P/D − 0.002, at most 0.394·P, at least 0.25·P − 0.4·P²"
        }
        _ if sizes.tpi > 4.0 - 1e-6 => "0.25·P − 0.4·P²",
        _ => "0.15·P",
    }
}

fn inside(rows: &mut FormulaRows<'_>, sizes: &UnifiedThreadSizes, grade: u8) {
    let UnifiedThreadSizes { d, p, t2, .. } = *sizes;
    let class = format!("{grade}B");
    let share = [1.95, 1.3, 0.975][usize::from(grade.clamp(1, 3) - 1)];
    let pitch_tolerance = rounded(share * t2, 4);
    let meaning = format!("tolerance of the pitch diameter in class {class}");
    rows.intermediate("TD2", &meaning, pitch_tolerance, &format!("{share}·T2, to 4 decimals"));
    let minor_tolerance = rounded(sizes.minor(grade), 4);
    let formula = minor_formula(sizes, grade);
    rows.intermediate("TD1", "tolerance of the minor diameter", minor_tolerance, formula);

    // Three decimals from number 6 on; the upper limit of class 3B keeps four.
    let coarse = d > THREE_DECIMALS - 1e-9;
    let (digits, most_digits) =
        (if coarse { 3 } else { 4 }, if coarse && grade != 3 { 3 } else { 4 });
    let exact = rounded(d - INSIDE * p, 4);
    let (least, most) = (rounded(exact, digits), rounded(exact + minor_tolerance, most_digits));
    let pitch_least = rounded(d - MIDDLE * p, 4);
    let pitch_most = rounded(pitch_least + pitch_tolerance, 4);
    let reference = rounded(pitch_most + 11.0 / 12.0 * H * p, 4);
    let formula = format!("D − 1.082532·P, to {digits} decimals");
    rows.result("D1min", "minor diameter, least", least, &formula);
    rows.know("exact", exact);
    let formula = format!("D − 1.082532·P + TD1, to {most_digits} decimals");
    rows.result_of("D1max", "minor diameter, most", most, [&formula, "exact + TD1"]);
    rows.result("D2min", "pitch diameter, least", pitch_least, "D − 0.649519·P");
    rows.result("D2max", "pitch diameter, most", pitch_most, "D2min + TD2");
    rows.result("Dmin", "major diameter, least", d, "D");
    rows.result("Dmax", "major diameter, most, for reference", reference, "D2max + 0.793857·P");
    let words = ["minor", "in, ASME B1.1"];
    rows.note_limits(&format!("{class}, inside"), words, [least, most], [pitch_least, pitch_most]);
}
