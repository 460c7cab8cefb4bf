//! Where rows go: a file, whole or not at all, or standard output as a stream.

use std::io::{self, BufWriter, IsTerminal, Stdout, Write};
use std::path::{Path, PathBuf};

use chordal_export::OutputFormat;
use chordal_files::FileDraft;

use crate::failure::{CommandFailure, OfFile};
use crate::output;

/// Where rows go.
pub enum RowOutput {
    /// A file under a passing name, and the name that it gets.
    File(FileDraft, PathBuf),
    /// Standard output.
    Standard(BufferedStdout),
}

impl RowOutput {
    /// Opens the output before a long run. No program is written over, and a terminal is
    /// given no columns.
    pub fn open(
        path: Option<&Path>,
        program: &Path,
        format: OutputFormat,
    ) -> Result<RowOutput, CommandFailure> {
        let Some(path) = path else {
            if format.is_binary() && io::stdout().is_terminal() {
                return Err(CommandFailure::wrong(
                    "a terminal cannot show this format",
                    "write a file with -o, or pipe the output into another program",
                ));
            }
            return Ok(RowOutput::Standard(buffered()));
        };
        if chordal_files::is_regular(path) && chordal_files::is_same(program, path) {
            return Err(CommandFailure::wrong(
                format!("{} is the program", path.display()),
                "give the output another name",
            ));
        }
        Ok(RowOutput::File(output::draft(path)?, path.to_path_buf()))
    }

    /// Puts a file in its place.
    pub fn put(self) -> Result<(), CommandFailure> {
        match self {
            RowOutput::File(draft, path) => output::put(draft, &path),
            RowOutput::Standard(mut out) => Ok(out.flush()?),
        }
    }
}

impl Write for RowOutput {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            RowOutput::File(out, path) => out.write(bytes).map_err(|error| of_file(path, error)),
            RowOutput::Standard(out) => out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            RowOutput::File(out, path) => out.flush().map_err(|error| of_file(path, error)),
            RowOutput::Standard(out) => out.flush(),
        }
    }
}

/// What could not be written, by the name that the user gave.
pub fn trouble(path: Option<&Path>, error: io::Error) -> CommandFailure {
    match path {
        Some(path) => of_file(path, error).into(),
        None => error.into(),
    }
}

/// An error that knows its file, however it is handed on: it is not that of standard output.
fn of_file(path: &Path, error: io::Error) -> io::Error {
    if error.get_ref().is_some_and(|inner| inner.is::<OfFile>()) {
        return error;
    }
    io::Error::new(error.kind(), OfFile { file: path.to_string_lossy().into_owned(), error })
}

/// Standard output of a run that streams. A run cannot be stopped from within, and what
/// streams has nothing to clean up: when nobody reads any more (`| head`) the process ends
/// here, quietly, however the writers above would wrap the error.
pub struct StdoutStream(Stdout);

impl Write for StdoutStream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes).inspect_err(end_if_closed)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush().inspect_err(end_if_closed)
    }
}

fn end_if_closed(error: &io::Error) {
    if error.kind() == io::ErrorKind::BrokenPipe {
        std::process::exit(0);
    }
}

/// Standard output for many small writes.
pub type BufferedStdout = BufWriter<StdoutStream>;

fn buffered() -> BufferedStdout {
    BufWriter::with_capacity(1 << 16, StdoutStream(io::stdout()))
}
