//! Problems for people and for other programs.

mod excerpt;
mod github;
mod gitlab;
mod groups;
mod json;
mod place;
mod sarif;
mod summary;
mod text;

pub use github::github;
pub use gitlab::GitlabReport;
pub use json::{files_json, json};
pub use place::{SourceLocation, place};
pub use sarif::SarifReport;
pub use summary::{SummarizedRun, summary_json};
pub use text::{ReportDetail, excerpt, one, text};

pub(crate) use excerpt::{ExcerptMark, ProblemExcerpts};
pub(crate) use text::renderer;
