//! Limits of unified threads by the formulas of ASME B1.1 (paragraphs 5.8 and 8.3).
//!
//! The standard adds rounded numbers: tolerances and allowance have four decimals before they are
//! added, so its tables come out to the last digit. All formulas are in inches.

use super::series::UnifiedSeries;
use super::{H, INSIDE, MIDDLE, ThreadLocation, ThreadSize};
use crate::calculation::{QuantityKind, WorkedCalculation};
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
    measure(worked, &sizes);
    match place {
        ThreadLocation::Outside => outside(worked, &sizes, grade),
        ThreadLocation::Inside => inside(worked, &sizes, grade),
    }
}

/// What all classes share; a pair of classes shows it once.
fn measure(worked: &mut WorkedCalculation, sizes: &UnifiedThreadSizes) {
    if worked.step("T2").is_some() {
        return;
    }
    let number = |value: f64| trimmed(value, 6);
    let (formula, filled) = if sizes.by_diameter {
        ("D", number(sizes.d))
    } else {
        ("9·P", format!("9·{}", number(sizes.p)))
    };
    let length = QuantityKind::Length;
    worked.intermediate("Le", "length of engagement", length, sizes.le * INCH, formula, filled);
    let filled = format!(
        "0.0015·∛{d} + 0.0015·√{le} + 0.015·∛{p}²",
        d = number(sizes.d),
        le = number(sizes.le),
        p = number(sizes.p)
    );
    worked.intermediate(
        "T2",
        "tolerance of the pitch diameter in class 2A, in inches",
        length,
        sizes.t2 * INCH,
        "0.0015·∛D + 0.0015·√Le + 0.015·∛P², to 6 decimals",
        filled,
    );
}

fn outside(worked: &mut WorkedCalculation, sizes: &UnifiedThreadSizes, grade: u8) {
    let UnifiedThreadSizes { d, p, t2, .. } = *sizes;
    let length = QuantityKind::Length;
    let n = |value: f64| trimmed(value, 6);
    let class = format!("{grade}A");
    let allowance = if grade == 3 { 0.0 } else { allowance(t2) };
    let (formula, filled) = match grade {
        3 => ("0", "0".to_string()),
        _ => ("0.3·T2, to 4 decimals", format!("0.3·{}", n(t2))),
    };
    let meaning = format!("allowance of class {class}");
    worked.intermediate("es", &meaning, length, allowance * INCH, formula, filled);

    let (crest, crest_formula) = match grade {
        1 => (0.09, "0.09·∛P², to 4 decimals"),
        _ => (0.06, "0.06·∛P², to 4 decimals"),
    };
    let td = rounded(crest * two_thirds(p), 4);
    let filled = format!("{crest}·∛{}²", n(p));
    worked.intermediate(
        "Td",
        "tolerance of the major diameter",
        length,
        td * INCH,
        crest_formula,
        filled,
    );

    let (share, share_formula) = match grade {
        1 => (1.5, "1.5·T2, to 4 decimals"),
        2 => (1.0, "T2, to 4 decimals"),
        _ => (0.75, "0.75·T2, to 4 decimals"),
    };
    let td2 = rounded(share * t2, 4);
    let filled = format!("{share}·{}", n(t2));
    worked.intermediate(
        "Td2",
        "tolerance of the pitch diameter",
        length,
        td2 * INCH,
        share_formula,
        filled,
    );

    let most = rounded(d - allowance, 4);
    let least = rounded(most - td, 4);
    let pitch_most = rounded(d - allowance - MIDDLE * p, 4);
    let pitch_least = rounded(pitch_most - td2, 4);
    let mut give = |symbol: &str, meaning: &str, value: f64, formula: &str, filled: String| {
        worked.result(symbol, meaning, length, value * INCH, formula, filled);
    };
    give("dmax", "major diameter, most", most, "D − es", format!("{} − {}", n(d), n(allowance)));
    give("dmin", "major diameter, least", least, "dmax − Td", format!("{} − {}", n(most), n(td)));
    give(
        "d2max",
        "pitch diameter, most",
        pitch_most,
        "dmax − 0.649519·P",
        format!("{} − 0.649519·{}", n(most), n(p)),
    );
    give(
        "d2min",
        "pitch diameter, least",
        pitch_least,
        "d2max − Td2",
        format!("{} − {}", n(pitch_most), n(td2)),
    );
    give(
        "d1max",
        "minor diameter, most, flat root (UN)",
        rounded(most - INSIDE * p, 4),
        "dmax − 1.082532·P",
        format!("{} − 1.082532·{}", n(most), n(p)),
    );
    give(
        "d3max",
        "minor diameter, most, round root (UNR)",
        rounded(most - 1.375 * H * p, 4),
        "dmax − 1.190785·P",
        format!("{} − 1.190785·{}", n(most), n(p)),
    );
    give(
        "d1min",
        "minor diameter, least, for reference",
        rounded(pitch_least - MIDDLE * p, 4),
        "d2min − 0.649519·P",
        format!("{} − 0.649519·{}", n(pitch_least), n(p)),
    );
    worked.note(format!(
        "{class}, outside: major {} to {}, pitch {} to {} (in, ASME B1.1).",
        n(most),
        n(least),
        n(pitch_most),
        n(pitch_least)
    ));
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

fn inside(worked: &mut WorkedCalculation, sizes: &UnifiedThreadSizes, grade: u8) {
    let UnifiedThreadSizes { d, p, t2, .. } = *sizes;
    let length = QuantityKind::Length;
    let n = |value: f64| trimmed(value, 6);
    let class = format!("{grade}B");
    let (share, share_formula) = match grade {
        1 => (1.95, "1.95·T2, to 4 decimals"),
        2 => (1.3, "1.3·T2, to 4 decimals"),
        _ => (0.975, "0.975·T2, to 4 decimals"),
    };
    let pitch_tolerance = rounded(share * t2, 4);
    let meaning = format!("tolerance of the pitch diameter in class {class}");
    let filled = format!("{share}·{}", n(t2));
    worked.intermediate("TD2", &meaning, length, pitch_tolerance * INCH, share_formula, filled);
    let minor_tolerance = rounded(sizes.minor(grade), 4);
    let formula = minor_formula(sizes, grade);
    let filled = formula.replace('D', &n(d)).replace('P', &n(p));
    let meaning = "tolerance of the minor diameter";
    worked.intermediate("TD1", meaning, length, minor_tolerance * INCH, formula, filled);

    // Three decimals from number 6 on; the upper limit of class 3B keeps four.
    let coarse = d > THREE_DECIMALS - 1e-9;
    let exact = rounded(d - INSIDE * p, 4);
    let least = rounded(exact, if coarse { 3 } else { 4 });
    let most = rounded(exact + minor_tolerance, if coarse && grade != 3 { 3 } else { 4 });
    let pitch_least = rounded(d - MIDDLE * p, 4);
    let pitch_most = rounded(pitch_least + pitch_tolerance, 4);
    let mut give = |symbol: &str, meaning: &str, value: f64, formula: &str, filled: String| {
        worked.result(symbol, meaning, length, value * INCH, formula, filled);
    };
    let digits = if coarse {
        "D − 1.082532·P, to 3 decimals"
    } else {
        "D − 1.082532·P, to 4 decimals"
    };
    let filled = format!("{} − 1.082532·{}", n(d), n(p));
    give("D1min", "minor diameter, least", least, digits, filled);
    let digits = if coarse && grade != 3 {
        "D − 1.082532·P + TD1, to 3 decimals"
    } else {
        "D − 1.082532·P + TD1, to 4 decimals"
    };
    let filled = format!("{} + {}", n(exact), n(minor_tolerance));
    give("D1max", "minor diameter, most", most, digits, filled);
    let filled = format!("{} − 0.649519·{}", n(d), n(p));
    give("D2min", "pitch diameter, least", pitch_least, "D − 0.649519·P", filled);
    let filled = format!("{} + {}", n(pitch_least), n(pitch_tolerance));
    give("D2max", "pitch diameter, most", pitch_most, "D2min + TD2", filled);
    give("Dmin", "major diameter, least", d, "D", n(d));
    give(
        "Dmax",
        "major diameter, most, for reference",
        rounded(pitch_most + 11.0 / 12.0 * H * p, 4),
        "D2max + 0.793857·P",
        format!("{} + 0.793857·{}", n(pitch_most), n(p)),
    );
    worked.note(format!(
        "{class}, inside: minor {} to {}, pitch {} to {} (in, ASME B1.1).",
        n(least),
        n(most),
        n(pitch_least),
        n(pitch_most)
    ));
}
