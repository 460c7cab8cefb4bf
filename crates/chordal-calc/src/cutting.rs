//! Spindle speed and feed from the cutting speed and the feed of a tooth, and back.

use crate::error::{CalcError, bounded};
use crate::math::{PI, sqrt};
use crate::numbers::{Units, trimmed};
use crate::worked::{Kind, Worked};

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
pub struct Cutting {
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
pub fn cutting(ask: &Cutting, units: Units) -> Result<Worked, CalcError> {
    check(ask, units)?;
    let mut worked = Worked::new("Speed and feed of a cut", units);
    let diameter = units.number(ask.diameter);
    worked.given("D", "diameter of the tool", Kind::Length, ask.diameter);
    let rpm = speed(&mut worked, ask, units, &diameter);
    if let Some((feed, teeth)) = ask.feed {
        worked.given("z", "teeth", Kind::Number, f64::from(teeth));
        let (per_tooth, per_second) = feeds(&mut worked, feed, teeth, rpm, units);
        chip(&mut worked, ask, per_tooth, units);
        removal(&mut worked, ask, per_second, units);
    }
    Ok(worked)
}

fn check(ask: &Cutting, units: Units) -> Result<(), CalcError> {
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
fn speed(worked: &mut Worked, ask: &Cutting, units: Units, diameter: &str) -> f64 {
    let circumference = PI * ask.diameter;
    // Cutting speeds are in m/min and ft/min, diameters in mm and in.
    let (factor, inverse) = match units {
        Units::Inch => ("12·", "/12"),
        Units::Millimetre => ("1000·", "/1000"),
    };
    match ask.speed {
        EdgeSpeed::Surface(surface) => {
            worked.given("v", "cutting speed", Kind::Surface, surface);
            let rpm = surface * 60.0 / circumference;
            let shown = trimmed(Kind::Surface.shown(surface, units), 3);
            worked.result(
                "n",
                "speed of the spindle",
                Kind::Spindle,
                rpm,
                &format!("{factor}v/(π·D)"),
                format!("{factor}{shown}/(π·{diameter})"),
            );
            rpm
        }
        EdgeSpeed::Spindle(rpm) => {
            worked.given("n", "speed of the spindle", Kind::Spindle, rpm);
            worked.result(
                "v",
                "cutting speed",
                Kind::Surface,
                rpm / 60.0 * circumference,
                &format!("π·D·n{inverse}"),
                format!("π·{diameter}·{}{inverse}", trimmed(rpm, 1)),
            );
            rpm
        }
    }
}

/// Feed of a tooth, mm, and of the tool, mm/s.
fn feeds(worked: &mut Worked, feed: ToolFeed, teeth: u32, rpm: f64, units: Units) -> (f64, f64) {
    let each = f64::from(teeth);
    let turns = trimmed(rpm, 1);
    match feed {
        ToolFeed::PerTooth(tooth) => {
            worked.given("fz", "feed of a tooth", Kind::Length, tooth);
            let per_second = tooth * each * rpm / 60.0;
            let filled = format!("{}·{teeth}·{turns}", units.number(tooth));
            worked.result("F", "feed", Kind::Feed, per_second, "fz·z·n", filled);
            (tooth, per_second)
        }
        ToolFeed::PerTime(per_second) => {
            worked.given("F", "feed", Kind::Feed, per_second);
            let tooth = per_second * 60.0 / (each * rpm);
            let shown = trimmed(Kind::Feed.shown(per_second, units), 3);
            let filled = format!("{shown}/({teeth}·{turns})");
            worked.result("fz", "feed of a tooth", Kind::Length, tooth, "F/(z·n)", filled);
            (tooth, per_second)
        }
    }
}

/// A narrow cut makes the chip thinner than the feed of a tooth.
fn chip(worked: &mut Worked, ask: &Cutting, tooth: f64, units: Units) {
    let Some(width) = ask.width else { return };
    worked.given("ae", "width of the cut", Kind::Length, width);
    if width >= ask.diameter / 2.0 {
        return;
    }
    let ratio = width / ask.diameter;
    let (t, w, d) = (units.number(tooth), units.number(width), units.number(ask.diameter));
    worked.result(
        "h",
        "thickest chip",
        Kind::Length,
        2.0 * tooth * sqrt(ratio * (1.0 - ratio)),
        "2·fz·√(ae/D·(1 − ae/D))",
        format!("2·{t}·√({w}/{d}·(1 − {w}/{d}))"),
    );
    worked.note("The chip is thinner than fz, because the cut is narrower than half the tool.");
}

fn removal(worked: &mut Worked, ask: &Cutting, per_second: f64, units: Units) {
    let (Some(depth), Some(width)) = (ask.depth, ask.width) else { return };
    worked.given("ap", "depth of the cut", Kind::Length, depth);
    let feed = trimmed(Kind::Feed.shown(per_second, units), 3);
    let (formula, end) = match units {
        Units::Inch => ("ap·ae·F", ""),
        Units::Millimetre => ("ap·ae·F/1000", "/1000"),
    };
    worked.result(
        "Q",
        "removed in a minute",
        Kind::Removal,
        depth * width * per_second,
        formula,
        format!("{}·{}·{feed}{end}", units.number(depth), units.number(width)),
    );
}
