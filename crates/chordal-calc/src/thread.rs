//! The 60° profile of unified and ISO metric threads, in numbers.

use chordal_geometry::Vec2;

use crate::error::{CalcError, bounded};
use crate::figure::{Figure, Style};
use crate::math::{PI, atan};
use crate::numbers::{Units, trimmed};
use crate::worked::{Kind, Worked};

/// Height of the sharp profile over the pitch: √3/2.
const H: f64 = 0.866_025_403_784_438_6;
/// Minor diameter of an inside thread: 2·5/8·H below the major (ISO 68-1, ASME B1.1).
pub(crate) const INSIDE: f64 = 1.25 * H;
/// Pitch diameter: 2·3/8·H below the major.
const MIDDLE: f64 = 0.75 * H;
/// Root of an outside thread: 2·17/24·H below the major, the rounded root of the design profile.
pub(crate) const OUTSIDE: f64 = 17.0 / 12.0 * H;

/// Where a thread is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Where {
    /// In a hole.
    Inside,
    /// On a boss.
    Outside,
}

/// A thread of the 60° profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thread {
    /// Nominal diameter, mm.
    pub major: f64,
    /// Distance of neighbouring crests, mm.
    pub pitch: f64,
    /// Number of starts.
    pub starts: u32,
}

/// A thread by its name: `M30x2`, `1.5-8`, `1 1/16-28`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Designation {
    /// Nominal diameter, mm.
    pub major: f64,
    /// Pitch, mm.
    pub pitch: f64,
    /// The unit it is named in.
    pub units: Units,
}

impl Designation {
    /// Reads a name: `M` diameter `x` pitch in millimetres, or inches `-` threads per inch; what
    /// stands after (`UNC`, `-6g`, `2B`) is class and series, which change no basic size.
    ///
    /// # Errors
    /// When it is neither.
    pub fn read(text: &str) -> Result<Designation, CalcError> {
        let wrong = || {
            CalcError::new(
                format!("`{text}` is no thread"),
                "write it as M30x2, 1.5-8 or 1 1/16-28: metric needs its pitch, inch its threads per inch",
            )
        };
        let plain = text.trim().to_ascii_uppercase().replace('×', "X");
        let found = match plain.strip_prefix('M') {
            Some(rest) => metric(rest),
            None => inch(&plain),
        };
        let size = |value: f64| value > 0.0 && value.is_finite();
        found.filter(|thread| size(thread.major) && size(thread.pitch)).ok_or_else(wrong)
    }
}

fn metric(text: &str) -> Option<Designation> {
    let (diameter, rest) = text.split_once('X')?;
    let pitch = rest.split(['-', ' ']).next()?;
    Some(Designation {
        major: number(diameter.trim())?,
        pitch: number(pitch.trim())?,
        units: Units::Millimetre,
    })
}

fn inch(text: &str) -> Option<Designation> {
    let (diameter, rest) = text.split_once('-')?;
    let diameter = diameter.trim().trim_end_matches(['"', '#']);
    let digits: String =
        rest.trim().chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    let tpi = number(&digits)?;
    Some(Designation { major: fraction(diameter)? * 25.4, pitch: 25.4 / tpi, units: Units::Inch })
}

/// `1.5`, `3/8`, `1 1/16`.
fn fraction(text: &str) -> Option<f64> {
    let mut sum = 0.0;
    for part in text.split_whitespace() {
        sum += match part.split_once('/') {
            Some((above, below)) => {
                let below = number(below)?;
                if below == 0.0 {
                    return None;
                }
                number(above)? / below
            }
            None => number(part)?,
        };
    }
    (sum > 0.0).then_some(sum)
}

fn number(text: &str) -> Option<f64> {
    let digits = text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    if text.is_empty() || !digits {
        return None;
    }
    text.parse().ok().filter(|value: &f64| value.is_finite())
}

impl Thread {
    /// Checks that there is something between the crests.
    ///
    /// # Errors
    /// When a size is none, or the profile is deeper than the thread is thick.
    pub fn check(&self, units: Units) -> Result<(), CalcError> {
        let Thread { major, pitch, starts } = *self;
        bounded(&[major, pitch], &[], units)?;
        let good = |value: f64| value > 0.0 && value.is_finite();
        if !good(major) || !good(pitch) || starts == 0 {
            return Err(CalcError::new(
                format!(
                    "a thread of diameter {} with a pitch of {} and {starts} starts cannot be",
                    units.length(major),
                    units.length(pitch)
                ),
                "diameter, pitch and starts are above zero",
            ));
        }
        if OUTSIDE * pitch >= major {
            return Err(CalcError::new(
                format!(
                    "a pitch of {} cuts {} off a diameter of {}: nothing is left",
                    units.length(pitch),
                    units.length(OUTSIDE * pitch),
                    units.length(major)
                ),
                "check the pitch; threads per inch go to --tpi, a distance to --pitch",
            ));
        }
        Ok(())
    }

    /// Minor diameter of an inside thread: the hole before it is cut, mm.
    pub fn minor_inside(&self) -> f64 {
        self.major - INSIDE * self.pitch
    }

    /// Where a profile without a rounded or flat root comes to a point, mm.
    pub(crate) fn sharp_root(&self) -> f64 {
        self.major - 2.0 * H * self.pitch
    }

    /// Root diameter of an outside thread, mm.
    pub fn minor_outside(&self) -> f64 {
        self.major - OUTSIDE * self.pitch
    }
}

/// Diameters, depths, lead and helix angle of a thread.
///
/// # Errors
/// When the thread cannot be.
pub fn thread_data(thread: &Thread, units: Units) -> Result<Worked, CalcError> {
    thread.check(units)?;
    let Thread { major, pitch, starts } = *thread;
    let mut worked = Worked::new("Thread, 60° profile (UN and ISO metric)", units);
    worked.given("D", "major (nominal) diameter", Kind::Length, major);
    worked.given("P", "pitch", Kind::Length, pitch);
    worked.given("n", "starts", Kind::Number, f64::from(starts));
    let (d, p) = (units.number(major), units.number(pitch));
    let length = Kind::Length;
    if units == Units::Inch {
        let tpi = 25.4 / pitch;
        let filled = format!("1/{p}");
        worked.way("TPI", "threads per inch", Kind::Number, tpi, "1/P", filled);
    }
    let lead = pitch * f64::from(starts);
    worked.result("L", "lead: Z in one turn", length, lead, "n·P", format!("{starts}·{p}"));
    worked.way(
        "H",
        "height of the sharp profile",
        length,
        H * pitch,
        "0.866025·P",
        format!("0.866025·{p}"),
    );
    let diameters = [
        ("D2", "pitch diameter", MIDDLE, "D − 0.649519·P", "0.649519"),
        ("D1", "minor diameter inside: the hole", INSIDE, "D − 1.082532·P", "1.082532"),
        ("d3", "minor (root) diameter outside", OUTSIDE, "D − 1.226869·P", "1.226869"),
    ];
    for (symbol, meaning, share, formula, number) in diameters {
        let value = major - share * pitch;
        worked.result(symbol, meaning, length, value, formula, format!("{d} − {number}·{p}"));
    }
    let depths = [
        ("t1", "single depth inside, 5/8·H", INSIDE, "0.541266·P", "0.541266"),
        ("t3", "single depth outside, 17/24·H", OUTSIDE, "0.613435·P", "0.613435"),
    ];
    for (symbol, meaning, share, formula, number) in depths {
        let value = share * pitch / 2.0;
        worked.result(symbol, meaning, length, value, formula, format!("{number}·{p}"));
    }
    let middle = major - MIDDLE * pitch;
    worked.result(
        "φ",
        "helix angle at the pitch diameter",
        Kind::Angle,
        atan(lead / (PI * middle)),
        "atan(L/(π·D2))",
        format!("atan({}/(π·{}))", units.number(lead), units.number(middle)),
    );
    worked.note("Basic sizes without allowance or tolerance: the class of fit comes on top.");
    worked.figure = profile(thread, units);
    Ok(worked)
}

/// Two pitches of the profile: the hole's above, the bolt's root below.
fn profile(thread: &Thread, units: Units) -> Figure {
    let p = thread.pitch;
    let (inside, root) = (INSIDE / 2.0 * p, OUTSIDE / 2.0 * p);
    let mut figure = Figure::default();
    let slope = 0.577_350_269_189_625_8;
    // Crest flat P/8 at the major diameter; flanks at 30° down to the root.
    let crest = p / 16.0;
    let mut last: Option<Vec2> = None;
    for turn in 0..3 {
        let middle = f64::from(turn) * p;
        let foot = crest + root * slope;
        let points = [
            Vec2::new(middle - foot, -root),
            Vec2::new(middle - crest, 0.0),
            Vec2::new(middle + crest, 0.0),
            Vec2::new(middle + foot, -root),
        ];
        if let Some(last) = last {
            figure.line(last, points[0], Style::Part);
        }
        for pair in points.windows(2) {
            figure.line(pair[0], pair[1], Style::Part);
        }
        last = Some(points[3]);
    }
    let (left, right) = (-0.75 * p, 2.75 * p);
    figure.line(Vec2::new(left, -inside), Vec2::new(right, -inside), Style::Helper);
    figure.line(Vec2::new(left, 0.0), Vec2::new(right, 0.0), Style::Helper);
    figure.line(
        Vec2::new(left, -MIDDLE / 2.0 * p),
        Vec2::new(right, -MIDDLE / 2.0 * p),
        Style::Path,
    );
    let at = |share: f64| Vec2::new(right, share);
    figure.text(at(0.0), format!("D {}", units.number(thread.major)));
    figure.text(at(-MIDDLE / 2.0 * p), format!("D2 {}", units.number(thread.major - MIDDLE * p)));
    figure.text(at(-inside), format!("D1 {}", units.number(thread.minor_inside())));
    figure.text(Vec2::new(1.5 * p, -root), format!("d3 {}", units.number(thread.minor_outside())));
    figure.width(Vec2::ZERO, Vec2::new(p, 0.0), 0.42 * p, format!("P {}", units.number(p)));
    figure.height(
        Vec2::new(left, 0.0),
        Vec2::new(left, -inside),
        left - 0.22 * p,
        format!("t1 {}", units.number(inside)),
    );
    figure.height(
        Vec2::new(left, 0.0),
        Vec2::new(-p / 2.0, -root),
        left - 0.75 * p,
        format!("t3 {}", units.number(root)),
    );
    let vertex = Vec2::new(p / 2.0, -root - (p / 2.0 - crest - root * slope) / slope);
    let opening = PI / 6.0;
    figure.angle(
        vertex,
        0.75 * p,
        PI / 2.0 - opening,
        2.0 * opening,
        format!("{}°", trimmed(60.0, 0)),
    );
    figure
}
