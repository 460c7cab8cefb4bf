//! On what a program is read.

use chordal_diagnostics::Span;
use chordal_gcode::Recognition;

/// On what a program is read, and why.
#[derive(Clone, Debug)]
pub struct ProgramReading<'a> {
    /// The machine; nothing where the text is not read.
    pub machine: Option<&'a str>,
    /// The control, or the language that is not read: `fanuc`, `fanuc-lathe`.
    pub control: &'a str,
    /// Who says so: `given`, `folder`, `extension`, `text`.
    pub from: &'a str,
    /// What the text says.
    pub recognition: Option<&'a Recognition>,
    /// What else the text may be; nothing where the control and the units are named or certain.
    pub choices: Option<ReadingChoices>,
}

/// As what a text may be read that does not name its control and its units for certain, as shells show it.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadingChoices {
    /// The readings that move the text differently; the first one is what runs.
    pub readings: Vec<ReadingChoice>,
    /// The first block that they move differently; nothing where all move alike.
    pub difference: Option<ChoiceDifference>,
}

/// Controls that move a text alike: names for programs, and words for people.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadingChoice {
    /// The names of the controls, the likeliest first.
    pub controls: Vec<&'static str>,
    /// The built-in machine of the first.
    pub machine: &'static str,
    /// Units at power-on as settings name them, `inch` or `mm`; nothing where the text names its units.
    pub units: Option<&'static str>,
    /// The size of what is cut, mm; nothing on an axis where nothing is cut.
    pub size_mm: Option<[Option<f64>; 3]>,
    /// What the block of the difference does: `Z 0.006 mm`; empty where there is no difference.
    pub motion: String,
    /// What to type to read the text so.
    pub option: String,
    /// The controls, and the units where they are a guess: `GRBL and LinuxCNC in inch`.
    pub title: String,
    /// The size in words: `36 x 20 x 6 mm`.
    pub size: Option<String>,
}

/// Where possible readings move a text differently.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceDifference {
    /// The block.
    pub span: Span,
    /// Only feeds differ, and so the time; the path is the same.
    pub only_feed: bool,
    /// What is not known, in a sentence.
    pub message: String,
}

/// So many readings are shown next to each other.
const SHOWN_READINGS: usize = 4;

impl ReadingChoices {
    /// Those that are shown next to each other, the likeliest first.
    pub fn shown(&self) -> &[ReadingChoice] {
        &self.readings[..self.readings.len().min(SHOWN_READINGS)]
    }

    /// How many more there are.
    pub fn more(&self) -> usize {
        self.readings.len() - self.shown().len()
    }
}
