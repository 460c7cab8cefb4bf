//! How shells write files: whole or not at all.
//!
//! A [`FileDraft`] is written under a passing name in the folder of its file and put in its place when it is whole. The
//! file that was there keeps its permissions and its owner, and a link stays a link. What is no regular file
//! (`/dev/null`, a pipe) is written through. A signal that ends the process takes the drafts away.
//!
//! ```
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("part.svg");
//! chordal_files::write_whole(&path, b"<svg/>")?;
//! assert_eq!(std::fs::read(&path)?, b"<svg/>");
//! # Ok::<(), std::io::Error>(())
//! ```

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a shell: files and signals are its business, so that they are nobody else's"
)]
#![forbid(unsafe_code)]

mod draft;
mod leftover;
mod place;

pub use draft::{FileDraft, write_whole};
pub use place::{is_regular, is_same, place_of};
