//! The options of the questions.

use chordal::motion::{OperationStart, PlannerLevel};
use chordal_export::OutputFormat;
use chordal_export::format::QUESTION_FORMATS;
use serde::de::Error;
use serde::{Deserialize, Deserializer};

/// Reads the name of a format.
fn format<'de, D: Deserializer<'de>>(name: D) -> Result<OutputFormat, D::Error> {
    let name = String::deserialize(name)?;
    QUESTION_FORMATS.named(&name).ok_or_else(|| {
        let names = QUESTION_FORMATS.names().replace(", ", "`, `");
        D::Error::custom(format!("unknown variant `{name}`, expected one of `{names}`"))
    })
}

/// Only the format.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FormatOptions {
    #[serde(default, deserialize_with = "format")]
    pub format: OutputFormat,
}

/// No options.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NoOptions {}

#[derive(Deserialize, Clone, Copy, Default)]
#[serde(rename_all = "lowercase")]
pub enum PlanQuality {
    #[default]
    Fast,
    Best,
}

impl PlanQuality {
    pub fn level(self) -> PlannerLevel {
        match self {
            PlanQuality::Fast => PlannerLevel::Fast,
            PlanQuality::Best => PlannerLevel::Best,
        }
    }
}

#[derive(Deserialize, Clone, Copy, Default)]
#[serde(rename_all = "lowercase")]
pub enum OperationSplit {
    #[default]
    Tool,
    Comment,
}

impl OperationSplit {
    pub fn start(self) -> OperationStart {
        match self {
            OperationSplit::Tool => OperationStart::ToolChange,
            OperationSplit::Comment => OperationStart::Comment,
        }
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
#[derive(Default)]
pub struct TimeOptions {
    #[serde(deserialize_with = "format")]
    pub format: OutputFormat,
    pub level: PlanQuality,
    pub what_if: bool,
    pub bound: bool,
    pub operations: OperationSplit,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct SampleOptions {
    #[serde(deserialize_with = "format")]
    pub format: OutputFormat,
    pub level: PlanQuality,
    /// Seconds.
    pub period: f64,
    pub max_samples: u64,
}

impl Default for SampleOptions {
    fn default() -> SampleOptions {
        let (format, level) = (OutputFormat::default(), PlanQuality::default());
        // Eighty minutes; what they take in memory has room in a page.
        SampleOptions { format, level, period: 1e-3, max_samples: 5_000_000 }
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct CompareOptions {
    #[serde(deserialize_with = "format")]
    pub format: OutputFormat,
    /// Millimetres.
    pub tolerance: f64,
    pub feed_tolerance: f64,
    pub ignore: Vec<String>,
}

impl Default for CompareOptions {
    fn default() -> CompareOptions {
        let format = OutputFormat::default();
        CompareOptions { format, tolerance: 0.0, feed_tolerance: 1e-6, ignore: Vec::new() }
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ConvertOptions {
    pub to: String,
    #[serde(default, deserialize_with = "format")]
    pub format: OutputFormat,
    /// Millimetres.
    pub tolerance: Option<f64>,
    pub digits: Option<usize>,
    #[serde(default)]
    pub despite_errors: bool,
    #[serde(default)]
    pub exact_cycles: bool,
    #[serde(default)]
    pub axis_positions: bool,
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
