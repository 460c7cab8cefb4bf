//! Programs written anew: for another control, or changed in place.
//!
//! The old text is run, the new one is written from what it does and from how it is written, and
//! both are compared with each other move by move. What comes out is the text, a list of
//! [`Change`]s with their reasons, and a [`Certificate`] of how far the two are apart.
//!
//! ```
//! use chordal::{Job, Machine, Source, SourceMap};
//! use chordal_rewrite::{TransformStep, convert, transform};
//!
//! let mut sources = SourceMap::new();
//! let text = b"T1 M6\nG21 G90 G0 E1 X0 Y0 S900 M3\nH1 Z5.\nG1 X10. F100.\nM2\n";
//! sources.add(Source::new("part.nc", text.as_slice()));
//! let job = Job::new(sources, Machine::from_builtin("fadal-4020").unwrap()).unwrap();
//!
//! let haas = Machine::from_builtin("haas-vf2").unwrap();
//! let converted = convert::convert(&job, &haas, &convert::ConversionOptions::default());
//! assert!(converted.holds() && converted.text.contains("G43 H1"));
//!
//! let moved = transform(&job, &[TransformStep::Shift([5.0, 0.0, 0.0])]).unwrap();
//! assert!(moved.certificate.holds() && String::from_utf8(moved.text).unwrap().contains("X15."));
//! ```

#![forbid(unsafe_code)]

mod blocks;
mod change;
pub mod convert;
mod proof;
pub mod restart;
mod sides;
mod source;
mod split;
mod state;
mod transform;
mod walk;
mod word_address;

pub use change::Change;
pub use proof::{Certificate, ComparedSides, prove, prove_contour, prove_mapped};
pub use split::{ProgramPart, SplitBy, SplitProgram, split};
pub use transform::{
    ArcForm, ChipLimit, FeedProof, HeightCorrection, HeightMap, HeightOptions, MapError, NotSplit,
    OptimizeError, OptimizeOptions, OptimizedProgram, SplitResult, ToolChips, TransformRefusal,
    TransformStep, TransformedProgram, optimize, transform, warp,
};
