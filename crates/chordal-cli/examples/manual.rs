//! `cargo run -p chordal-cli --example manual -- FOLDER` writes the manual pages, one for each command.

#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "a shell: it writes files")]

use std::path::PathBuf;

fn main() -> std::io::Result<()> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let folder = folder.ok_or_else(|| std::io::Error::other("name the folder to write to"))?;
    std::fs::create_dir_all(&folder)?;
    clap_mangen::generate_to(chordal_cli::command().disable_help_subcommand(true), folder)
}
