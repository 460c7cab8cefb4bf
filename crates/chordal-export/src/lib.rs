//! What Chordal knows, in the formats that people and programs read: one file per format.
//!
//! | of | format | here |
//! |---|---|---|
//! | commands | JSON lines, canonical text, CSV, Parquet, Arrow | [`CommandWriter`] |
//! | chords | JSON lines, CSV, Parquet, Arrow | [`ChordWriter`] |
//! | path | SVG, PNG, DXF | [`Plot`], [`DxfWriter`] |
//! | setpoints | CSV, JSON lines, Parquet, Arrow | [`SampleWriter`] |
//! | commands, path, chords, setpoints | record batches of Arrow | [`columns`] |
//! | motion | SVG, PNG | [`MotionPlot`] |
//! | calculations | text, JSON, SVG, PNG | [`worked_text`], [`worked_json`], [`figure_svg`], [`figure_png`] |
//! | time | JSON | [`time_json`] |
//! | comparisons | text, JSON | [`comparison_text`], [`comparison_json`] |
//! | collisions | text, JSON | [`collision_text`], [`collision_json`] |
//! | stock | text, JSON, PNG, STL, 3MF, GLB | [`stock_text`], [`stock_json`], [`stock_png`], [`stock_mesh`] |
//! | turned stock | text, JSON, SVG, PNG, DXF, STL, 3MF, GLB | [`turned_text`], [`turned_json`], [`section_svg`], [`section_dxf`], [`turned_mesh`] |
//! | engagement of cuts | text, JSON, CSV, columns | [`engagement_text`], [`engagement_json`], [`columns`] |
//! | new feeds | text, JSON | [`optimized_text`], [`optimized_json`] |
//! | problems | text, JSON, GitHub, SARIF | [`report`] |
//!
//! Which formats a content has is in [`format`](mod@format), once for every shell.
//!
//! Inside Chordal everything is millimetres, radians and millimetres per second; each
//! format converts on the way out. Writers stream: they take any [`std::io::Write`], hold
//! a line at a time, and open no file.
//!
//! Feature `pictures` is whatever draws, with the calculations that have figures, feature `files` is Parquet and Arrow files; a shell that offers neither
//! builds without their dependencies.
//!
//! ```
//! use chordal::{Job, Machine, ProgramReading, Source, SourceMap};
//! use chordal_export::{CanonWriter, report};
//!
//! let mut sources = SourceMap::new();
//! sources.add(Source::new("part.nc", b"G21 G90 S900 M3\nG1 X10. F100.\nM30\n".as_slice()));
//! let job = Job::new(sources, Machine::from_builtin("haas-vf2").unwrap()).unwrap();
//!
//! let mut canon = CanonWriter::new(Vec::new(), &job).unwrap();
//! let found = job.report_of_commands(|command| canon.command(command).unwrap());
//! let text = String::from_utf8(canon.finish().unwrap()).unwrap();
//! assert!(text.contains("STRAIGHT_FEED(10.000000"));
//! let reading = ProgramReading { machine: None, control: "haas", from: "given", recognition: None, choices: None };
//! let text = report::json(&found, job.sources(), "part.nc", &reading);
//! assert!(text.contains("chordal.diagnostics/1"));
//! ```

#![forbid(unsafe_code)]

#[cfg(feature = "pictures")]
mod calculation;
mod canon;
mod chords;
mod collision;
pub mod columns;
mod command_json;
mod command_rows;
mod comparison;
mod comparison_text;
mod contour_ranges;
mod digest;
mod dxf;
pub mod format;
mod json;
mod json_text;
mod machine_error;
mod motion;
mod number;
pub mod numbers;
mod omissions;
mod optimization;
#[cfg(feature = "pictures")]
mod plot;
pub mod report;
mod setpoints;
mod stock;
mod time;
mod transformation;
mod write_errors;

#[cfg(feature = "pictures")]
pub use calculation::{worked_json, worked_text};
pub use canon::CanonWriter;
pub use chords::ChordWriter;
pub use collision::{collision_json, collision_text};
pub use columns::{SampleWriter, column_reference};
pub use command_json::CommandJsonLines;
pub use command_rows::CommandWriter;
pub use comparison::{comparison_json, conversion_json, value_text};
pub use comparison_text::{
    DifferenceWords, SideWords, comparison_headline, comparison_names, comparison_text,
    difference_text, difference_words, length_text,
};
pub use contour_ranges::{contour_ranges_json, contour_ranges_text};
pub use digest::sha256_hex;
pub use dxf::DxfWriter;
pub use format::{FormatList, OutputFormat};
pub use json_text::pretty_json;
pub use machine_error::machine_error_text;
pub use omissions::{GIVE_OFFSETS, left_out_texts, not_named_texts};
pub use optimization::{optimized_json, optimized_text};
#[cfg(feature = "pictures")]
pub use plot::{
    MotionPlot, PageTool, PageView, Plot, PlotError, PlotOptions, Viewpoint, figure_png,
    figure_svg, page_section, palette_typescript, section_png, section_svg,
};
pub use setpoints::{SAMPLE_SCHEMA, SampleHead};
#[cfg(feature = "pictures")]
pub use stock::stock_png;
pub use stock::{
    MeshSurface, StockMeshError, engagement_json, engagement_text, section_dxf, stock_json,
    stock_left_text, stock_mesh, stock_text, stock_verdict_text, stock_volume, turned_json,
    turned_mesh, turned_text, turned_verdict_text, turning_json, turning_text,
};
pub use time::{comment_text, junctions_text, level_word, short_blocks_text, time_json};
pub use transformation::{refusal_json, restart_json, split_json, transformed_json};
pub use write_errors::write_unless_failed;
