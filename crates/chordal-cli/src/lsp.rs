//! The language server, for editors.

use std::path::Path;

use chordal_editor::Setup;
use chordal_lsp::{Opener, serve};

use crate::failure::{Failure, Verdict};
use crate::load::{self, Request};
use crate::options::Common;

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
    common: Common,
}

/// Loads texts of an editor as the other commands load files.
struct Files {
    request: Request,
    machine: Option<String>,
}

impl Opener for Files {
    fn open(
        &self,
        path: Option<&Path>,
        text: &[u8],
        machine: Option<&str>,
    ) -> Result<Setup, String> {
        let machine = machine.or(self.machine.as_deref()).map(load::machine).transpose();
        let request = machine.map(|machine| Request { machine, ..self.request.clone() });
        let loaded = request.and_then(|request| load::unsaved(path, text.to_vec(), &request));
        let loaded = loaded.map_err(|failure| failure.to_string())?;
        let title = chordal::control::table(loaded.machine().control).title;
        let (why, program) = (loaded.chosen.why(title), loaded.program);
        let (mut texts, machine, options) = loaded.into_parts();
        // The first is the text itself.
        let beside = texts.split_off(1);
        Ok(Setup { machine, why, options, program, beside })
    }
}

pub fn run(args: Args) -> Result<Verdict, Failure> {
    let Args { stdio: _, common } = args;
    let machine = common.machine.clone();
    let request = Request::of(common);
    let (connection, threads) = lsp_server::Connection::stdio();
    let served = serve(&connection, &Files { request, machine });
    drop(connection);
    threads.join()?;
    served.map_err(|error| Failure::Use { message: error.to_string(), help: None })?;
    Ok(Verdict::Clean)
}
