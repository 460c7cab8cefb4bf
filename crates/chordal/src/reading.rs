//! As which control and machine a program is read, and the alternatives where that is a guess.

use chordal_diagnostics::Span;
use chordal_kernel::Recognition;

/// As which control and machine a program is read, and why.
#[derive(Clone, Debug)]
pub struct ProgramReading<'a> {
    /// The machine; `None` where the text is not read.
    pub machine: Option<&'a str>,
    /// The control, or the language that is not read: `fanuc`, `fanuc-lathe`.
    pub control: &'a str,
    /// Where that choice comes from: `given` (named by the user), `folder`, `extension`, `text`.
    pub from: &'a str,
    /// What was recognized in the text; `None` where it was not examined.
    pub recognition: Option<&'a Recognition>,
    /// What else the text may be; `None` where the control and the units are named or certain.
    pub choices: Option<ReadingChoices>,
}

/// A setting of a machine that a text leaves open, as a reading assumes it.
#[derive(Debug, PartialEq, Eq)]
pub struct AssumedSetting {
    /// What stands after the name of a control or of a machine: `in inch`.
    pub words: &'static str,
    /// The assignment to the machine: `settings.units="inch"`.
    pub assignment: &'static str,
}

impl AssumedSetting {
    /// Units at power-on: inch.
    pub const INCH: AssumedSetting =
        AssumedSetting { words: "in inch", assignment: "settings.units=\"inch\"" };
    /// Units at power-on: millimetres.
    pub const MILLIMETRES: AssumedSetting =
        AssumedSetting { words: "in mm", assignment: "settings.units=\"mm\"" };
    /// `X5` is 5 mm or 5 in.
    pub const FULL_UNITS: AssumedSetting = AssumedSetting {
        words: "with whole numbers in full units",
        assignment: "settings.decimal_point=\"calculator\"",
    };
    /// `X5` is 0.005 mm or 0.0005 in.
    pub const LEAST_INCREMENTS: AssumedSetting = AssumedSetting {
        words: "with whole numbers in increments",
        assignment: "settings.decimal_point=\"least-increment\"",
    };
    /// All of them.
    pub const ALL: [&'static AssumedSetting; 4] = [
        &AssumedSetting::INCH,
        &AssumedSetting::MILLIMETRES,
        &AssumedSetting::FULL_UNITS,
        &AssumedSetting::LEAST_INCREMENTS,
    ];

    /// The units at power-on that it assumes, `inch` or `mm`; `None` for another setting.
    pub fn units(&self) -> Option<&'static str> {
        match *self {
            AssumedSetting::INCH => Some("inch"),
            AssumedSetting::MILLIMETRES => Some("mm"),
            _ => None,
        }
    }

    /// The name of a machine or a control with settings after it.
    pub fn after(name: &str, settings: &[&AssumedSetting]) -> String {
        settings.iter().fold(name.to_string(), |name, setting| format!("{name} {}", setting.words))
    }
}

/// The possible readings of a text that leaves its control or a setting of it open, as shells show them.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadingChoices {
    /// The readings that move the text differently; the first one is what runs.
    pub readings: Vec<ReadingChoice>,
    /// The first block that they move differently; `None` where all readings move alike.
    pub difference: Option<ChoiceDifference>,
}

/// One possible reading: controls that move the text alike, with names for programs and words for people.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadingChoice {
    /// The names of the controls, the most likely one first.
    pub controls: Vec<&'static str>,
    /// The built-in machine of the first of them.
    pub machine: &'static str,
    /// The settings of the machine that the text leaves open.
    pub settings: Vec<&'static AssumedSetting>,
    /// The size of what is cut, mm; `None` on an axis along which nothing is cut.
    pub size_mm: Option<[Option<f64>; 3]>,
    /// What the block of [`ReadingChoices::difference`] does in this reading: `Z 0.006 mm`; empty where there is no
    /// difference.
    pub motion: String,
    /// The command line option that selects this reading.
    pub option: String,
    /// The controls, and the settings that are a guess: `GRBL and LinuxCNC in inch`.
    pub title: String,
    /// The size in words: `36 x 20 x 6 mm`; `None` where nothing is cut.
    pub size: Option<String>,
}

impl ReadingChoice {
    /// Units at power-on as settings name them, `inch` or `mm`; `None` where the text names its units.
    pub fn units(&self) -> Option<&'static str> {
        self.settings.iter().find_map(|setting| setting.units())
    }
}

/// Where possible readings move a text differently.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceDifference {
    /// The block.
    pub span: Span,
    /// True where only feeds differ, and so the time; the path is the same.
    pub only_feed: bool,
    /// What is not known, as a sentence.
    pub message: String,
}

/// Readings that are shown next to each other: more do not fit on a screen.
const SHOWN_READINGS: usize = 4;

impl ReadingChoices {
    /// The readings that are shown next to each other, the most likely one first.
    pub fn shown(&self) -> &[ReadingChoice] {
        &self.readings[..self.readings.len().min(SHOWN_READINGS)]
    }

    /// How many readings are not shown.
    pub fn more(&self) -> usize {
        self.readings.len() - self.shown().len()
    }
}
