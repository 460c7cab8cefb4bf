//! The language server, for editors.

mod wire;

use std::path::Path;

use chordal_ask::setup_of;
use chordal_editor::EditorSetup;
use chordal_load::Request;
use chordal_lsp::{SetupFinder, serve};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::options::CommonArgs;

const EXAMPLES: &str = "\
Editors start it and talk to it over standard input and output; docs/editors.md shows how to
set up VS Code, Neovim and Helix.";

/// Serves editors over the Language Server Protocol
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Uses standard input and output, as always; accepted because some editors pass it
    #[arg(long)]
    stdio: bool,

    #[command(flatten)]
    common: CommonArgs,
}

/// Loads texts of an editor as the other commands load files.
struct EditorFileLoader {
    request: Request,
}

impl SetupFinder for EditorFileLoader {
    fn open(
        &self,
        path: Option<&Path>,
        text: &[u8],
        machine: Option<&str>,
    ) -> Result<EditorSetup, String> {
        setup_of(path, text, machine, self.request.clone())
    }
}

pub fn run(args: Args) -> Result<ExitVerdict, CommandFailure> {
    let Args { stdio: _, common } = args;
    let (connection, writer) = wire::connect();
    let served = serve(&connection, &EditorFileLoader { request: common.request() });
    drop(connection);
    if let Ok(written) = writer.join() {
        written?;
    }
    served.map_err(|error| CommandFailure::Use { message: error.to_string(), help: None })?;
    Ok(ExitVerdict::Clean)
}
