//! Limits of metric threads by the tables of ISO 965-1, for a normal length of engagement.
//!
//! The tables follow formulas whose results are rounded to a number of the series R40, with
//! exceptions for a smooth progression; so the tables of grade 6 stand here. The other grades of the
//! standard are whole steps of the series away: four for each grade, and five more inside.

use super::formula_rows::FormulaRows;
use super::{INSIDE, MIDDLE, OUTSIDE, ThreadLocation, ThreadSize, ToleranceZone};
use crate::calculation::WorkedCalculation;
use crate::error::CalcError;
use crate::numbers::AnswerUnit;

/// What ISO 965-1 says for a pitch, in µm: table 1 (deviations), 3 and 4 (tolerances of grade 6).
struct MetricThreadRow {
    /// mm.
    pitch: f64,
    /// Deviation of g, and of G to the other side.
    g: f64,
    /// Deviation of e.
    e: Option<f64>,
    /// Deviation of f.
    f: Option<f64>,
    /// Td of grade 6, the major diameter outside.
    major: f64,
    /// TD1 of grade 6, the minor diameter inside.
    minor: Option<f64>,
}

const fn row(pitch: f64, g: f64, e: f64, f: f64, major: f64, minor: f64) -> MetricThreadRow {
    const fn some(value: f64) -> Option<f64> {
        if value > 0.0 { Some(value) } else { None }
    }
    MetricThreadRow { pitch, g, e: some(e), f: some(f), major, minor: some(minor) }
}

/// 0 where the standard has none.
const ROWS: [MetricThreadRow; 25] = [
    row(0.2, 17.0, 0.0, 0.0, 56.0, 0.0),
    row(0.25, 18.0, 0.0, 0.0, 67.0, 0.0),
    row(0.3, 18.0, 0.0, 0.0, 75.0, 85.0),
    row(0.35, 19.0, 0.0, 34.0, 85.0, 100.0),
    row(0.4, 19.0, 0.0, 34.0, 95.0, 112.0),
    row(0.45, 20.0, 0.0, 35.0, 100.0, 125.0),
    row(0.5, 20.0, 50.0, 36.0, 106.0, 140.0),
    row(0.6, 21.0, 53.0, 36.0, 125.0, 160.0),
    row(0.7, 22.0, 56.0, 38.0, 140.0, 180.0),
    row(0.75, 22.0, 56.0, 38.0, 140.0, 190.0),
    row(0.8, 24.0, 60.0, 38.0, 150.0, 200.0),
    row(1.0, 26.0, 60.0, 40.0, 180.0, 236.0),
    row(1.25, 28.0, 63.0, 42.0, 212.0, 265.0),
    row(1.5, 32.0, 67.0, 45.0, 236.0, 300.0),
    row(1.75, 34.0, 71.0, 48.0, 265.0, 335.0),
    row(2.0, 38.0, 71.0, 52.0, 280.0, 375.0),
    row(2.5, 42.0, 80.0, 58.0, 335.0, 450.0),
    row(3.0, 48.0, 85.0, 63.0, 375.0, 500.0),
    row(3.5, 53.0, 90.0, 70.0, 425.0, 560.0),
    row(4.0, 60.0, 95.0, 75.0, 475.0, 600.0),
    row(4.5, 63.0, 100.0, 80.0, 500.0, 670.0),
    row(5.0, 71.0, 106.0, 85.0, 530.0, 710.0),
    row(5.5, 75.0, 112.0, 90.0, 560.0, 750.0),
    row(6.0, 80.0, 118.0, 95.0, 600.0, 800.0),
    row(8.0, 100.0, 140.0, 118.0, 710.0, 1000.0),
];

/// Td2 of grade 6 (table 6): up to this diameter, mm, the pitches, mm, with their tolerance, µm.
const PITCH_DIAMETER: [(f64, &[(f64, f64)]); 9] = [
    (1.4, &[(0.2, 48.0), (0.25, 53.0), (0.3, 56.0)]),
    (2.8, &[(0.2, 50.0), (0.25, 56.0), (0.35, 63.0), (0.4, 67.0), (0.45, 71.0)]),
    (5.6, &[(0.35, 67.0), (0.5, 75.0), (0.6, 85.0), (0.7, 90.0), (0.75, 90.0), (0.8, 95.0)]),
    (11.2, &[(0.75, 100.0), (1.0, 112.0), (1.25, 118.0), (1.5, 132.0)]),
    (22.4, &[(1.0, 118.0), (1.25, 132.0), (1.5, 140.0), (1.75, 150.0), (2.0, 160.0), (2.5, 170.0)]),
    (
        45.0,
        &[
            (1.0, 125.0),
            (1.5, 150.0),
            (2.0, 170.0),
            (3.0, 200.0),
            (3.5, 212.0),
            (4.0, 224.0),
            (4.5, 236.0),
        ],
    ),
    (
        90.0,
        &[
            (1.5, 160.0),
            (2.0, 180.0),
            (3.0, 212.0),
            (4.0, 236.0),
            (5.0, 250.0),
            (5.5, 265.0),
            (6.0, 280.0),
        ],
    ),
    (180.0, &[(2.0, 190.0), (3.0, 224.0), (4.0, 250.0), (6.0, 300.0), (8.0, 335.0)]),
    (355.0, &[(3.0, 250.0), (4.0, 280.0), (6.0, 315.0), (8.0, 355.0)]),
];

/// The smallest diameter of the tables, mm.
const MIN_DIAMETER_MM: f64 = 0.99;

/// The series R40 of ISO 3, as the standard uses it.
const R40: [f64; 40] = [
    1.0, 1.06, 1.12, 1.18, 1.25, 1.32, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.12, 2.24, 2.36, 2.5,
    2.65, 2.8, 3.0, 3.15, 3.35, 3.55, 3.75, 4.0, 4.25, 4.5, 4.75, 5.0, 5.3, 5.6, 6.0, 6.3, 6.7,
    7.1, 7.5, 8.0, 8.5, 9.0, 9.5,
];

/// A tolerance so many steps of the series away, in whole µm.
fn steps(tolerance: f64, by: i32) -> f64 {
    let mut decade = 1.0;
    while tolerance >= 9.75 * decade {
        decade *= 10.0;
    }
    let near = |value: &f64| (value - tolerance / decade).abs() < 0.01;
    let at = R40.iter().position(near).unwrap_or(0) as i32 + by;
    let value = R40[at.rem_euclid(40) as usize] * decade * 10f64.powi(at.div_euclid(40));
    value.round()
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

/// The numbers of a thread in the standard, mm.
struct MetricThreadSizes {
    d: f64,
    p: f64,
    row: &'static MetricThreadRow,
    /// Td2 of grade 6, µm.
    pitch_diameter: f64,
}

impl MetricThreadSizes {
    fn of(thread: &ThreadSize) -> Result<MetricThreadSizes, CalcError> {
        let ThreadSize { major: d, pitch: p, .. } = *thread;
        let units = AnswerUnit::Millimetre;
        let row = ROWS.iter().find(|row| same(row.pitch, p)).ok_or_else(|| {
            no_limits(format!("ISO 965-1 has no tolerances for a pitch of {}", units.length(p)))
        })?;
        let range = PITCH_DIAMETER.iter().find(|(most, _)| d <= most + 1e-6 && d > MIN_DIAMETER_MM);
        let found = range.and_then(|(_, row)| row.iter().find(|(pitch, _)| same(*pitch, p)));
        let (_, pitch_diameter) = *found.ok_or_else(|| {
            no_limits(format!(
                "ISO 965-1 has no tolerance of the pitch diameter for a pitch of {} on a diameter of {}",
                units.length(p),
                units.length(d)
            ))
        })?;
        Ok(MetricThreadSizes { d, p, row, pitch_diameter })
    }

    /// Distance of a field from the basic size, mm, below it outside and above it inside.
    fn deviation(&self, zone: ToleranceZone) -> Result<f64, CalcError> {
        let found = match zone.position {
            'e' => self.row.e,
            'f' => self.row.f,
            'g' | 'G' => Some(self.row.g),
            _ => Some(0.0),
        };
        let pitch = AnswerUnit::Millimetre.length(self.p);
        let missing = || {
            no_limits(format!("ISO 965-1 has no position {} for a pitch of {pitch}", zone.position))
        };
        found.map(|value| value / 1000.0).ok_or_else(missing)
    }

    /// A tolerance of grade 6, µm, as one of another grade, mm.
    fn graded(&self, six: Option<f64>, zone: ToleranceZone, inside: i32) -> Result<f64, CalcError> {
        let least = match (zone.place(), zone.grade) {
            (_, 8 | 9) => 0.8,
            (ThreadLocation::Inside, 7) => 0.5,
            (ThreadLocation::Inside, 6) => 0.3,
            (ThreadLocation::Inside, 5) => 0.25,
            (ThreadLocation::Outside, 7) => 0.35,
            _ => 0.0,
        };
        match six {
            Some(six) if self.p > least - 1e-6 => {
                Ok(steps(six, 4 * (i32::from(zone.grade) - 6) + inside) / 1000.0)
            }
            _ => Err(no_limits(format!(
                "ISO 965-1 has no grade {} for a pitch of {}",
                zone.grade,
                AnswerUnit::Millimetre.length(self.p)
            ))),
        }
    }
}

fn no_limits(message: String) -> CalcError {
    CalcError::new(message, "leave the class out: the basic sizes need none")
}

/// Rounded to a micrometre, as ISO 724 and ISO 965-2 print it.
fn micron(mm: f64) -> f64 {
    (mm * 1000.0 + 0.5 + 1e-6).floor() / 1000.0
}

/// Adds the limits of a class.
///
/// # Errors
/// When the standard has none for this pitch, diameter, grade or position.
pub(super) fn limits(
    worked: &mut WorkedCalculation,
    thread: &ThreadSize,
    pitch: ToleranceZone,
    crest: ToleranceZone,
) -> Result<(), CalcError> {
    let sizes = MetricThreadSizes::of(thread)?;
    match pitch.place() {
        ThreadLocation::Outside => outside(worked, &sizes, pitch, crest),
        ThreadLocation::Inside => inside(worked, &sizes, pitch, crest),
    }
}

fn millimetres(mm: f64) -> String {
    AnswerUnit::Millimetre.number(mm)
}

fn outside(
    worked: &mut WorkedCalculation,
    sizes: &MetricThreadSizes,
    pitch: ToleranceZone,
    crest: ToleranceZone,
) -> Result<(), CalcError> {
    let MetricThreadSizes { d, p, .. } = *sizes;
    let (es, es_crest) = (sizes.deviation(pitch)?, sizes.deviation(crest)?);
    // The one number of table 4 that is a step off.
    let td = match crest.grade {
        8 if same(p, 8.0) => 1.18,
        _ => sizes.graded(Some(sizes.row.major), crest, 0)?,
    };
    let td2 = sizes.graded(Some(sizes.pitch_diameter), pitch, 0)?;
    let d2 = micron(d - MIDDLE * p);
    let (most, pitch_most) = (micron(d - es_crest), micron(d2 - es));
    let (least, pitch_least) = (micron(most - td), micron(pitch_most - td2));
    // The roundest root that the standard allows has a radius of P/8: H/2 − P/8 below the middle.
    let root = micron(pitch_least - (super::H - 0.25) * p);

    let mut rows = FormulaRows::new(worked, 1.0, &millimetres, &[("D", d), ("P", p), ("D2", d2)]);
    let of_pitch = tolerances(
        &mut rows,
        ["es", "Td", "Td2"],
        "major",
        [crest, pitch],
        [es_crest, es, td, td2],
    );
    rows.result("dmax", "major diameter, most", most, "D − es");
    rows.result("dmin", "major diameter, least", least, "dmax − Td");
    rows.result("d2max", "pitch diameter, most", pitch_most, &format!("D2 − {of_pitch}"));
    rows.result("d2min", "pitch diameter, least", pitch_least, "d2max − Td2");
    rows.know("es", es);
    let round = micron(d - es - OUTSIDE * p);
    rows.result("d3max", "root diameter, most, round root", round, "D − es − 1.226869·P");
    rows.result("d3min", "root diameter, least, root radius P/8", root, "d2min − 0.616025·P");
    let class = super::FitClass::Metric { pitch, crest };
    let words = ["major", "mm, ISO 965-1"];
    rows.note_limits(&format!("{class}, outside"), words, [most, least], [pitch_most, pitch_least]);
    Ok(())
}

fn inside(
    worked: &mut WorkedCalculation,
    sizes: &MetricThreadSizes,
    pitch: ToleranceZone,
    crest: ToleranceZone,
) -> Result<(), CalcError> {
    let MetricThreadSizes { d, p, .. } = *sizes;
    let (ei, ei_crest) = (sizes.deviation(pitch)?, sizes.deviation(crest)?);
    let td1 = sizes.graded(sizes.row.minor.or(fine_minor(p)), crest, 0)?;
    let td2 = sizes.graded(Some(sizes.pitch_diameter), pitch, 5)?;
    let (d1, d2) = (micron(d - INSIDE * p), micron(d - MIDDLE * p));
    let (least, pitch_least) = (micron(d1 + ei_crest), micron(d2 + ei));
    let (most, pitch_most) = (micron(least + td1), micron(pitch_least + td2));

    let known = [("D", d), ("D1", d1), ("D2", d2)];
    let mut rows = FormulaRows::new(worked, 1.0, &millimetres, &known);
    let of_pitch = tolerances(
        &mut rows,
        ["EI", "TD1", "TD2"],
        "minor",
        [crest, pitch],
        [ei_crest, ei, td1, td2],
    );
    rows.result("D1min", "minor diameter, least", least, "D1 + EI");
    rows.result("D1max", "minor diameter, most", most, "D1min + TD1");
    rows.result("D2min", "pitch diameter, least", pitch_least, &format!("D2 + {of_pitch}"));
    rows.result("D2max", "pitch diameter, most", pitch_most, "D2min + TD2");
    rows.know("EI", ei);
    rows.result("Dmin", "major diameter, least", micron(d + ei), "D + EI");
    let class = super::FitClass::Metric { pitch, crest };
    let words = ["minor", "mm, ISO 965-1"];
    rows.note_limits(&format!("{class}, inside"), words, [least, most], [pitch_least, pitch_most]);
    Ok(())
}

/// What the tables say of the crests and of the pitch diameter: positions, then tolerances. The symbol of the position of
/// the pitch diameter.
fn tolerances(
    rows: &mut FormulaRows<'_>,
    [position, crest_symbol, pitch_symbol]: [&str; 3],
    diameter: &str,
    [crest, pitch]: [ToleranceZone; 2],
    [of_crest, of_pitch, crest_tolerance, pitch_tolerance]: [f64; 4],
) -> String {
    let mut distance = |symbol: &str, zone: ToleranceZone, value: f64| {
        let meaning = format!("distance of {} from the basic size", zone.position);
        rows.intermediate(symbol, &meaning, value, "ISO 965-1, table 1");
    };
    distance(position, crest, of_crest);
    let own = if same(of_pitch, of_crest) { position.into() } else { format!("{position}2") };
    if own != position {
        distance(&own, pitch, of_pitch);
    }
    let mut tolerance = |symbol: &str, diameter: &str, zone: ToleranceZone, value: f64| {
        let meaning = format!("tolerance of the {diameter} diameter, grade {}", zone.grade);
        rows.intermediate(symbol, &meaning, value, &format!("ISO 965-1, tolerances {symbol}"));
    };
    tolerance(crest_symbol, diameter, crest, crest_tolerance);
    tolerance(pitch_symbol, "pitch", pitch, pitch_tolerance);
    own
}

/// What grade 6 would be where the standard has only grades 4 and 5: 60 and 71 µm from grade 4.
fn fine_minor(pitch: f64) -> Option<f64> {
    if same(pitch, 0.2) {
        Some(60.0)
    } else if same(pitch, 0.25) {
        Some(71.0)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of ISO 965-1: Td2 of 132 µm is 67, 85, 106, 132, 170, 212 and 265 in grades 3 to 9;
    /// TD2 of the same is 112, 140, 180, 224 and 280 in grades 4 to 8.
    #[test]
    fn grades_are_steps_of_the_series() {
        let outside: Vec<f64> = (-3..=3).map(|grade| steps(132.0, 4 * grade)).collect();
        assert_eq!(outside, [67.0, 85.0, 106.0, 132.0, 170.0, 212.0, 265.0]);
        let inside: Vec<f64> = (-2..=2).map(|grade| steps(132.0, 4 * grade + 5)).collect();
        assert_eq!(inside, [112.0, 140.0, 180.0, 224.0, 280.0]);
        // Over the end of a decade: TD1 of a pitch of 8 is 630, 800, 1000, 1250 and 1600.
        let wide: Vec<f64> = (-2..=2).map(|grade| steps(1000.0, 4 * grade)).collect();
        assert_eq!(wide, [630.0, 800.0, 1000.0, 1250.0, 1600.0]);
    }
}
