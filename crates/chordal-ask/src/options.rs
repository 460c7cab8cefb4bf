//! What the questions take in addition to a program.

use chordal::motion::{OperationStart, PlannerLevel};
use serde::Deserialize;

/// In which form an answer is wanted.
#[derive(Deserialize, Clone, Copy, PartialEq, Eq, Default)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// What JavaScript makes an object or a table of.
    #[default]
    Object,
    Json,
    Text,
    Sarif,
    Github,
    Gitlab,
    Jsonl,
    Csv,
    Canon,
}

impl Format {
    /// An object is what JavaScript reads, and JSON the text that it is read from.
    pub fn is_json(self) -> bool {
        matches!(self, Format::Object | Format::Json)
    }
}

/// Nothing but the form.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OnlyFormat {
    #[serde(default)]
    pub format: Format,
}

/// Nothing at all.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Nothing {}

#[derive(Deserialize, Clone, Copy, Default)]
#[serde(rename_all = "lowercase")]
pub enum Effort {
    #[default]
    Fast,
    Best,
}

impl Effort {
    pub fn level(self) -> PlannerLevel {
        match self {
            Effort::Fast => PlannerLevel::Fast,
            Effort::Best => PlannerLevel::Best,
        }
    }
}

#[derive(Deserialize, Clone, Copy, Default)]
#[serde(rename_all = "lowercase")]
pub enum Operations {
    #[default]
    Tool,
    Comment,
}

impl Operations {
    pub fn start(self) -> OperationStart {
        match self {
            Operations::Tool => OperationStart::ToolChange,
            Operations::Comment => OperationStart::Comment,
        }
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
#[derive(Default)]
pub struct TimeOptions {
    pub format: Format,
    pub level: Effort,
    pub what_if: bool,
    pub bound: bool,
    pub operations: Operations,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct SampleOptions {
    pub format: Format,
    pub level: Effort,
    /// Seconds.
    pub period: f64,
    pub max_samples: u64,
}

impl Default for SampleOptions {
    fn default() -> SampleOptions {
        let (format, level) = (Format::default(), Effort::default());
        // Eighty minutes; what they take in memory has room in a page.
        SampleOptions { format, level, period: 1e-3, max_samples: 5_000_000 }
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct CompareOptions {
    pub format: Format,
    /// Millimetres.
    pub tolerance: f64,
    pub feed_tolerance: f64,
    pub ignore: Vec<String>,
}

impl Default for CompareOptions {
    fn default() -> CompareOptions {
        let format = Format::default();
        CompareOptions { format, tolerance: 0.0, feed_tolerance: 1e-6, ignore: Vec::new() }
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ConvertOptions {
    pub to: String,
    #[serde(default)]
    pub format: Format,
    /// Millimetres.
    pub tolerance: Option<f64>,
    pub digits: Option<usize>,
    #[serde(default)]
    pub despite_errors: bool,
    #[serde(default)]
    pub exact_cycles: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExplainOptions {
    pub word: String,
    pub machine: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MachineOptions {
    pub name: String,
}
