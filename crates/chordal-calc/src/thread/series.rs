//! The standard series: UNC, UNF, UNEF and those of constant pitch (ASME B1.1, table of the standard
//! series), and the coarse pitches of metric threads (ISO 261).

use crate::numbers::trimmed;

/// Diameters, in, with their threads per inch.
type ThreadTable = &'static [(f64, f64)];

const UNC: ThreadTable = &[
    (0.073, 64.0),
    (0.086, 56.0),
    (0.099, 48.0),
    (0.112, 40.0),
    (0.125, 40.0),
    (0.138, 32.0),
    (0.164, 32.0),
    (0.190, 24.0),
    (0.216, 24.0),
    (0.25, 20.0),
    (0.3125, 18.0),
    (0.375, 16.0),
    (0.4375, 14.0),
    (0.5, 13.0),
    (0.5625, 12.0),
    (0.625, 11.0),
    (0.75, 10.0),
    (0.875, 9.0),
    (1.0, 8.0),
    (1.125, 7.0),
    (1.25, 7.0),
    (1.375, 6.0),
    (1.5, 6.0),
    (1.75, 5.0),
    (2.0, 4.5),
    (2.25, 4.5),
    (2.5, 4.0),
    (2.75, 4.0),
    (3.0, 4.0),
    (3.25, 4.0),
    (3.5, 4.0),
    (3.75, 4.0),
    (4.0, 4.0),
];

const UNF: ThreadTable = &[
    (0.06, 80.0),
    (0.073, 72.0),
    (0.086, 64.0),
    (0.099, 56.0),
    (0.112, 48.0),
    (0.125, 44.0),
    (0.138, 40.0),
    (0.164, 36.0),
    (0.190, 32.0),
    (0.216, 28.0),
    (0.25, 28.0),
    (0.3125, 24.0),
    (0.375, 24.0),
    (0.4375, 20.0),
    (0.5, 20.0),
    (0.5625, 18.0),
    (0.625, 18.0),
    (0.75, 16.0),
    (0.875, 14.0),
    (1.0, 12.0),
    (1.125, 12.0),
    (1.25, 12.0),
    (1.375, 12.0),
    (1.5, 12.0),
];

const UNEF: ThreadTable = &[
    (0.216, 32.0),
    (0.25, 32.0),
    (0.3125, 32.0),
    (0.375, 32.0),
    (0.4375, 28.0),
    (0.5, 28.0),
    (0.5625, 24.0),
    (0.625, 24.0),
    (0.6875, 24.0),
    (0.75, 20.0),
    (0.8125, 20.0),
    (0.875, 20.0),
    (0.9375, 20.0),
    (1.0, 20.0),
    (1.0625, 18.0),
    (1.125, 18.0),
    (1.1875, 18.0),
    (1.25, 18.0),
    (1.3125, 18.0),
    (1.375, 18.0),
    (1.4375, 18.0),
    (1.5, 18.0),
    (1.5625, 18.0),
    (1.625, 18.0),
    (1.6875, 18.0),
];

/// Threads per inch of the series of constant pitch, and their smallest and largest diameters, in.
const CONSTANT: [(f64, f64, f64); 8] = [
    (4.0, 2.5, 6.0),
    (6.0, 1.375, 6.0),
    (8.0, 1.0, 6.0),
    (12.0, 0.5625, 6.0),
    (16.0, 0.375, 6.0),
    (20.0, 0.25, 3.0),
    (28.0, 0.216, 1.5),
    (32.0, 0.138, 1.0),
];

/// Coarse pitches of ISO 261: diameter and pitch, mm.
const COARSE_PITCHES: &[(f64, f64)] = &[
    (1.0, 0.25),
    (1.1, 0.25),
    (1.2, 0.25),
    (1.4, 0.3),
    (1.6, 0.35),
    (1.8, 0.35),
    (2.0, 0.4),
    (2.2, 0.45),
    (2.5, 0.45),
    (3.0, 0.5),
    (3.5, 0.6),
    (4.0, 0.7),
    (4.5, 0.75),
    (5.0, 0.8),
    (6.0, 1.0),
    (7.0, 1.0),
    (8.0, 1.25),
    (9.0, 1.25),
    (10.0, 1.5),
    (11.0, 1.5),
    (12.0, 1.75),
    (14.0, 2.0),
    (16.0, 2.0),
    (18.0, 2.5),
    (20.0, 2.5),
    (22.0, 2.5),
    (24.0, 3.0),
    (27.0, 3.0),
    (30.0, 3.5),
    (33.0, 3.5),
    (36.0, 4.0),
    (39.0, 4.0),
    (42.0, 4.5),
    (45.0, 4.5),
    (48.0, 5.0),
    (52.0, 5.0),
    (56.0, 5.5),
    (60.0, 5.5),
    (64.0, 6.0),
    (68.0, 6.0),
];

/// A series of unified threads, as a name says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnifiedSeries {
    /// Coarse.
    Unc,
    /// Fine.
    Unf,
    /// Extra fine.
    Unef,
    /// Constant pitch: 8-UN.
    Un,
    /// Special.
    Uns,
}

impl UnifiedSeries {
    /// A series by its name. R after UN is the rounded root, which changes no size here; NC, NF and NEF
    /// are the older names.
    pub(super) fn read(name: &str) -> Option<UnifiedSeries> {
        match name {
            "UNC" | "UNRC" | "NC" => Some(UnifiedSeries::Unc),
            "UNF" | "UNRF" | "NF" => Some(UnifiedSeries::Unf),
            "UNEF" | "UNREF" | "NEF" => Some(UnifiedSeries::Unef),
            "UN" | "UNR" => Some(UnifiedSeries::Un),
            "UNS" | "UNRS" | "NS" => Some(UnifiedSeries::Uns),
            _ => None,
        }
    }

    /// The series that has this thread; diameter in inches.
    pub(super) fn of(diameter: f64, tpi: f64) -> UnifiedSeries {
        let within =
            |table: ThreadTable| threads(table, diameter).is_some_and(|own| same(own, tpi));
        let constant = CONSTANT.iter().any(|(own, least, most)| {
            same(*own, tpi) && diameter >= least - 1e-6 && diameter <= most + 1e-6
        });
        if within(UNC) {
            UnifiedSeries::Unc
        } else if within(UNF) {
            UnifiedSeries::Unf
        } else if within(UNEF) {
            UnifiedSeries::Unef
        } else if constant && has_size(diameter) {
            UnifiedSeries::Un
        } else {
            UnifiedSeries::Uns
        }
    }

    /// True where the standard takes the diameter as the length of engagement; the others have nine
    /// pitches (ASME B1.1, paragraph 5.1).
    pub(super) fn engages_by_diameter(self, tpi: f64) -> bool {
        match self {
            UnifiedSeries::Unc | UnifiedSeries::Unf => true,
            UnifiedSeries::Un => tpi <= 8.0 + 1e-6,
            UnifiedSeries::Unef | UnifiedSeries::Uns => false,
        }
    }

    fn text(self, tpi: f64) -> String {
        match self {
            UnifiedSeries::Unc => "UNC".into(),
            UnifiedSeries::Unf => "UNF".into(),
            UnifiedSeries::Unef => "UNEF".into(),
            UnifiedSeries::Un => format!("{}-UN", trimmed(tpi, 3)),
            UnifiedSeries::Uns => "UNS (special, in no standard series)".into(),
        }
    }

    const fn table(self) -> Option<ThreadTable> {
        match self {
            UnifiedSeries::Unc => Some(UNC),
            UnifiedSeries::Unf => Some(UNF),
            UnifiedSeries::Unef => Some(UNEF),
            UnifiedSeries::Un | UnifiedSeries::Uns => None,
        }
    }

    /// What to say when a name has another series than its sizes.
    pub(super) fn misnamed(self, diameter: f64, tpi: f64) -> Option<String> {
        let right = UnifiedSeries::of(diameter, tpi);
        if right == self {
            return None;
        }
        let (size, threads_text) = (trimmed(diameter, 4), trimmed(tpi, 3));
        let right = format!("{size}-{threads_text} is {}", right.text(tpi));
        let Some(table) = self.table() else {
            return Some(format!("{right}."));
        };
        let name = self.text(tpi);
        Some(match threads(table, diameter) {
            Some(own) => {
                format!("{name} of {size} in has {} threads per inch; {right}.", trimmed(own, 3))
            }
            None => format!("{name} has no diameter of {size} in; {right}."),
        })
    }
}

/// The coarse pitch of a metric diameter, mm.
pub(super) fn coarse(diameter: f64) -> Option<f64> {
    threads(COARSE_PITCHES, diameter)
}

fn threads(table: ThreadTable, diameter: f64) -> Option<f64> {
    table.iter().find(|(own, _)| same(*own, diameter)).map(|(_, threads)| *threads)
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

/// Diameters of the series of constant pitch: numbers, and sixteenths of an inch.
fn has_size(diameter: f64) -> bool {
    let sixteenths = diameter * 16.0;
    let number = (diameter - 0.06) / 0.013;
    let whole = |count: f64| (count - count.round()).abs() < 1e-5;
    whole(sixteenths) || (diameter < 0.22 && whole(number))
}
