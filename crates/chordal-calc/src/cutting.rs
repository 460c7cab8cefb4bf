//! Spindle speed and feed from the cutting speed and the feed of a tooth, and back.

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::error::{CalcError, bounded};
use crate::math::{PI, sqrt};
use crate::numbers::{AnswerUnit, trimmed};

/// How fast the edge goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EdgeSpeed {
    /// Along the circumference, mm/s.
    Surface(f64),
    /// Turns, rpm.
    Spindle(f64),
}

/// How fast the tool goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToolFeed {
    /// For each tooth, mm.
    PerTooth(f64),
    /// Of the tool, mm/s.
    PerTime(f64),
}

/// A cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CuttingData {
    /// Diameter of the tool, mm.
    pub diameter: f64,
    /// How fast the edge goes.
    pub speed: EdgeSpeed,
    /// How fast the tool goes, with the number of its teeth.
    pub feed: Option<(ToolFeed, u32)>,
    /// Depth along the tool's axis, mm.
    pub depth: Option<f64>,
    /// Width across the feed, mm; at most the diameter.
    pub width: Option<f64>,
}

/// Speed of the spindle, feed, thickness of the chip and what is removed in a minute, of what is given.
///
/// # Errors
/// When a number is none of a cut.
pub fn cutting(ask: &CuttingData, units: AnswerUnit) -> Result<WorkedCalculation, CalcError> {
    check(ask, units)?;
    let mut worked = WorkedCalculation::new("Speed and feed of a cut", units);
    let diameter = units.number(ask.diameter);
    worked.input("D", "diameter of the tool", QuantityKind::Length, ask.diameter);
    let rpm = speed(&mut worked, ask, units, &diameter);
    if let Some((feed, teeth)) = ask.feed {
        worked.input("z", "teeth", QuantityKind::Number, f64::from(teeth));
        let (per_tooth, per_second) = feeds(&mut worked, feed, teeth, rpm, units);
        chip(&mut worked, ask, per_tooth, units);
        removal(&mut worked, ask, per_second, units);
    }
    Ok(worked)
}

fn check(ask: &CuttingData, units: AnswerUnit) -> Result<(), CalcError> {
    let (tooth, teeth) = match ask.feed {
        Some((ToolFeed::PerTooth(length), teeth)) => (Some(length), teeth),
        Some((ToolFeed::PerTime(_), teeth)) => (None, teeth),
        None => (None, 1),
    };
    let lengths = [Some(ask.diameter), tooth, ask.depth, ask.width];
    let lengths: Vec<f64> = lengths.into_iter().flatten().collect();
    bounded(&lengths, &[], units)?;
    let rate = match ask.speed {
        EdgeSpeed::Surface(rate) | EdgeSpeed::Spindle(rate) => rate,
    };
    let feed = match ask.feed {
        Some((ToolFeed::PerTime(feed), _)) => feed,
        Some((ToolFeed::PerTooth(_), _)) | None => 1.0,
    };
    let good = |value: f64| value > 0.0 && value < 1e9;
    if lengths.iter().any(|length| !good(*length)) || !good(rate) || !good(feed) || teeth == 0 {
        return Err(CalcError::new(
            "a cut needs numbers above zero",
            "check diameter, speed, feed, teeth, depth and width",
        ));
    }
    match ask.width {
        Some(width) if width > ask.diameter * (1.0 + 1e-9) => Err(CalcError::new(
            format!(
                "a tool of {} cannot cut {} wide",
                units.length(ask.diameter),
                units.length(width)
            ),
            "give a width of at most the diameter",
        )),
        _ => Ok(()),
    }
}

/// The spindle's speed, rpm, and the other of the two.
fn speed(
    worked: &mut WorkedCalculation,
    ask: &CuttingData,
    units: AnswerUnit,
    diameter: &str,
) -> f64 {
    let circumference = PI * ask.diameter;
    // Cutting speeds are in m/min and ft/min, diameters in mm and in.
    let (factor, inverse) = match units {
        AnswerUnit::Inch => ("12·", "/12"),
        AnswerUnit::Millimetre => ("1000·", "/1000"),
    };
    match ask.speed {
        EdgeSpeed::Surface(surface) => {
            worked.input("v", "cutting speed", QuantityKind::Surface, surface);
            let rpm = surface * 60.0 / circumference;
            let shown = trimmed(QuantityKind::Surface.shown(surface, units), 3);
            worked.result(
                "n",
                "speed of the spindle",
                QuantityKind::Spindle,
                rpm,
                &format!("{factor}v/(π·D)"),
                format!("{factor}{shown}/(π·{diameter})"),
            );
            rpm
        }
        EdgeSpeed::Spindle(rpm) => {
            worked.input("n", "speed of the spindle", QuantityKind::Spindle, rpm);
            worked.result(
                "v",
                "cutting speed",
                QuantityKind::Surface,
                rpm / 60.0 * circumference,
                &format!("π·D·n{inverse}"),
                format!("π·{diameter}·{}{inverse}", trimmed(rpm, 1)),
            );
            rpm
        }
    }
}

/// Feed of a tooth, mm, and of the tool, mm/s.
fn feeds(
    worked: &mut WorkedCalculation,
    feed: ToolFeed,
    teeth: u32,
    rpm: f64,
    units: AnswerUnit,
) -> (f64, f64) {
    let each = f64::from(teeth);
    let turns = trimmed(rpm, 1);
    match feed {
        ToolFeed::PerTooth(tooth) => {
            worked.input("fz", "feed of a tooth", QuantityKind::Length, tooth);
            let per_second = tooth * each * rpm / 60.0;
            let filled = format!("{}·{teeth}·{turns}", units.number(tooth));
            worked.result("F", "feed", QuantityKind::Feed, per_second, "fz·z·n", filled);
            (tooth, per_second)
        }
        ToolFeed::PerTime(per_second) => {
            worked.input("F", "feed", QuantityKind::Feed, per_second);
            let tooth = per_second * 60.0 / (each * rpm);
            let shown = trimmed(QuantityKind::Feed.shown(per_second, units), 3);
            let filled = format!("{shown}/({teeth}·{turns})");
            worked.result("fz", "feed of a tooth", QuantityKind::Length, tooth, "F/(z·n)", filled);
            (tooth, per_second)
        }
    }
}

/// A narrow cut makes the chip thinner than the feed of a tooth.
fn chip(worked: &mut WorkedCalculation, ask: &CuttingData, tooth: f64, units: AnswerUnit) {
    let Some(width) = ask.width else { return };
    worked.input("ae", "width of the cut", QuantityKind::Length, width);
    if width >= ask.diameter / 2.0 {
        return;
    }
    let ratio = width / ask.diameter;
    let (t, w, d) = (units.number(tooth), units.number(width), units.number(ask.diameter));
    worked.result(
        "h",
        "thickest chip",
        QuantityKind::Length,
        2.0 * tooth * sqrt(ratio * (1.0 - ratio)),
        "2·fz·√(ae/D·(1 − ae/D))",
        format!("2·{t}·√({w}/{d}·(1 − {w}/{d}))"),
    );
    worked.note("The chip is thinner than fz, because the cut is narrower than half the tool.");
}

fn removal(worked: &mut WorkedCalculation, ask: &CuttingData, per_second: f64, units: AnswerUnit) {
    let (Some(depth), Some(width)) = (ask.depth, ask.width) else { return };
    worked.input("ap", "depth of the cut", QuantityKind::Length, depth);
    let feed = trimmed(QuantityKind::Feed.shown(per_second, units), 3);
    let (formula, end) = match units {
        AnswerUnit::Inch => ("ap·ae·F", ""),
        AnswerUnit::Millimetre => ("ap·ae·F/1000", "/1000"),
    };
    worked.result(
        "Q",
        "removed in a minute",
        QuantityKind::Removal,
        depth * width * per_second,
        formula,
        format!("{}·{}·{feed}{end}", units.number(depth), units.number(width)),
    );
}
