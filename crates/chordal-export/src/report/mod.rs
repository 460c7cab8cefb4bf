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
pub use gitlab::Gitlab;
pub use json::{files_json, json};
pub use place::{Place, place};
pub use sarif::Sarif;
pub use summary::{RunOf, summary_json};
pub use text::{Detail, excerpt, one, text};

pub(crate) use excerpt::{Excerpts, Mark};
pub(crate) use text::renderer;
