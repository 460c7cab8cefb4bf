//! Files that `run` writes: what goes where, and whole or not at all.

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use chordal::stock::StockLeft;
use chordal::{Command, CommandKind, Job, PathCommand, Report, RunWatch, Segment};
use chordal_export::format::RUN_FILES;
use chordal_export::{CommandWriter, DxfWriter, OutputFormat, Plot, PlotOptions};
use chordal_files::FileDraft;
use chordal_load::{ProgramInput, ledger};

use crate::failure::CommandFailure;
use crate::formats::format_of_file;

/// What the ending of an output's name asks for.
fn format_of(path: &Path) -> Result<OutputFormat, CommandFailure> {
    let none = |name| match path.extension() {
        Some(ending) => {
            let ending = ending.to_string_lossy().to_ascii_lowercase();
            format!("there is no output format .{ending} ({name})")
        }
        None => format!("the extension of {name} is not a known format"),
    };
    format_of_file(&RUN_FILES, path, none, "the extensions are")
}

/// A file to write.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OutputTarget {
    path: PathBuf,
    format: OutputFormat,
}

/// What is written for each input. `DIR/` is a picture of each program in a folder, `DIR/*.dxf`
/// a file of each by its name; a plain name is one program's.
pub fn plan(
    patterns: &[PathBuf],
    inputs: &[ProgramInput],
) -> Result<Vec<Vec<OutputTarget>>, CommandFailure> {
    let names = names(inputs);
    let mut plan = vec![Vec::new(); inputs.len()];
    for pattern in patterns {
        let text = pattern.to_string_lossy();
        let pattern = if text.ends_with(['/', std::path::MAIN_SEPARATOR]) || pattern.is_dir() {
            pattern.join("*.svg")
        } else {
            pattern.clone()
        };
        let format = format_of(&pattern)?;
        let file = pattern.file_name().map(|name| name.to_string_lossy().into_owned());
        let file = file.unwrap_or_default();
        if !file.contains('*') && inputs.len() > 1 {
            return Err(CommandFailure::wrong(
                format!("{text} is one file, and there are {} programs", inputs.len()),
                format!("write -o 'DIR/*.{}': a file for each program", ending(&pattern)),
            ));
        }
        for (targets, name) in plan.iter_mut().zip(&names) {
            let path = pattern.with_file_name(file.replacen('*', name, 1));
            targets.push(OutputTarget { path, format });
        }
    }
    keep_inputs(&plan, inputs)?;
    Ok(plan)
}

fn ending(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().into_owned()
}

/// The name that stands for each input: without its ending, unless two would be the same.
fn names(inputs: &[ProgramInput]) -> Vec<String> {
    let text = |path: PathBuf| path.to_string_lossy().into_owned();
    let mut names: Vec<String> =
        inputs.iter().map(|input| text(input.below_root().with_extension(""))).collect();
    let mut seen = BTreeSet::new();
    let twice: BTreeSet<String> =
        names.iter().filter(|name| !seen.insert((*name).clone())).cloned().collect();
    for (name, input) in names.iter_mut().zip(inputs) {
        if twice.contains(name) {
            *name = text(input.below_root());
        }
    }
    names
}

/// No output takes the place of a program or of another output: said before any of them is run.
fn keep_inputs(plan: &[Vec<OutputTarget>], inputs: &[ProgramInput]) -> Result<(), CommandFailure> {
    let place = |path: &Path| chordal_files::place_of(path).unwrap_or_else(|_| path.to_path_buf());
    let programs: BTreeSet<PathBuf> =
        inputs.iter().filter_map(|input| input.path.as_deref()).map(place).collect();
    let mut seen = BTreeSet::new();
    for target in plan.iter().flatten().filter(|target| chordal_files::is_regular(&target.path)) {
        let (name, own) = (target.path.display(), place(&target.path));
        if programs.contains(&own) {
            return Err(CommandFailure::wrong(
                format!("{name} is one of the programs to run"),
                "give the output another name",
            ));
        }
        if !seen.insert(own) {
            return Err(CommandFailure::wrong(
                format!("{name} would be written twice"),
                "give each output a different name",
            ));
        }
    }
    Ok(())
}

/// Begins a file that is read by nothing of this command and is no other output of it.
pub fn draft(path: &Path) -> Result<FileDraft, CommandFailure> {
    may_be_written(path)?;
    FileDraft::open(path).map_err(|error| failure(path, &error))
}

/// Puts a file in its place.
pub fn put(draft: FileDraft, path: &Path) -> Result<(), CommandFailure> {
    // What was read in the meantime counts, too: meshes are read when the stock is made.
    not_an_input(path)?;
    draft.put().map_err(|error| failure(path, &error))
}

/// Writes a file whole or not at all.
pub fn write_whole(path: &Path, content: &[u8]) -> Result<(), CommandFailure> {
    let mut out = draft(path)?;
    out.write_all(content).map_err(|error| failure(path, &error))?;
    put(out, path)
}

/// Refuses a file that this command reads, and one that it writes already.
pub fn may_be_written(path: &Path) -> Result<(), CommandFailure> {
    not_an_input(path)?;
    if chordal_files::is_regular(path) && !ledger::note_output(path) {
        return Err(CommandFailure::wrong(
            format!("{} would be written twice", path.display()),
            "give each output a different name",
        ));
    }
    Ok(())
}

fn not_an_input(path: &Path) -> Result<(), CommandFailure> {
    if chordal_files::is_regular(path) && ledger::is_input(path) {
        return Err(CommandFailure::wrong(
            format!("{} is read by this command: it is not written over", path.display()),
            "give the output another name",
        ));
    }
    Ok(())
}

#[allow(clippy::large_enum_variant, reason = "there are few of them in a run")]
enum OutputWriter<'a> {
    Dxf(DxfWriter<FileDraft>),
    Commands(CommandWriter<'a, FileDraft>),
    Printed(FileDraft),
    /// A picture, drawn when the whole path is known.
    Picture(FileDraft, OutputFormat),
}

/// The outputs of one run, while it goes on.
pub struct RunOutputs<'a> {
    writers: Vec<(PathBuf, OutputWriter<'a>)>,
    plot: Option<Plot>,
    failed: Option<CommandFailure>,
}

impl<'a> RunOutputs<'a> {
    /// Opens them, so that a place where nothing can be written is reported before a long run.
    pub fn open(
        targets: &[OutputTarget],
        job: &'a Job<'a>,
    ) -> Result<RunOutputs<'a>, CommandFailure> {
        let mut outputs = RunOutputs { writers: Vec::new(), plot: None, failed: None };
        for OutputTarget { path, format } in targets {
            let writer = open(path, *format, job)?;
            if matches!(writer, OutputWriter::Picture(..)) {
                outputs.plot.get_or_insert_with(|| Plot::picture(job));
            }
            outputs.writers.push((path.clone(), writer));
        }
        Ok(outputs)
    }

    fn take(&mut self, mut write: impl FnMut(&mut OutputWriter) -> io::Result<()>) {
        if self.failed.is_some() {
            return;
        }
        for (path, writer) in &mut self.writers {
            if let Err(error) = write(writer) {
                self.failed = Some(failure(path, &error));
                return;
            }
        }
    }

    /// Puts the files in place and names them.
    pub fn finish(
        self,
        report: &Report,
        stock: Option<&StockLeft>,
        options: &PlotOptions,
    ) -> Result<Vec<PathBuf>, CommandFailure> {
        if let Some(failure) = self.failed {
            return Err(failure);
        }
        let mut plot = self.plot;
        if let Some(plot) = &mut plot {
            plot.set_inch(report.summary.inch);
            match stock {
                Some(StockLeft::Columns(found)) => plot.set_stock(found),
                Some(StockLeft::Section(found)) => plot.set_section(found),
                None => {}
            }
        }
        let mut written = Vec::new();
        for (path, writer) in self.writers {
            let done = match writer {
                OutputWriter::Commands(out) => out.finish(),
                OutputWriter::Dxf(out) => out.finish(),
                OutputWriter::Printed(out) => Ok(out),
                OutputWriter::Picture(out, format) => draw(out, format, plot.as_ref(), options),
            };
            put(done.map_err(|error| failure(&path, &error))?, &path)?;
            written.push(path);
        }
        Ok(written)
    }
}

fn open<'a>(
    path: &Path,
    format: OutputFormat,
    job: &'a Job<'a>,
) -> Result<OutputWriter<'a>, CommandFailure> {
    let out = draft(path)?;
    let writer = || {
        Ok(match format {
            OutputFormat::Svg | OutputFormat::Png => OutputWriter::Picture(out, format),
            OutputFormat::Dxf => OutputWriter::Dxf(DxfWriter::new(out, job)?),
            OutputFormat::Txt => OutputWriter::Printed(out),
            _ => OutputWriter::Commands(CommandWriter::new(out, format, job, false)?),
        })
    };
    writer().map_err(|error| failure(path, &error))
}

fn draw(
    mut out: FileDraft,
    format: OutputFormat,
    plot: Option<&Plot>,
    options: &PlotOptions,
) -> io::Result<FileDraft> {
    if let Some(plot) = plot {
        match format {
            OutputFormat::Png => out.write_all(&plot.png(options).map_err(io::Error::other)?)?,
            _ => out.write_all(plot.svg(options).as_bytes())?,
        }
    }
    Ok(out)
}

fn failure(path: &Path, error: &io::Error) -> CommandFailure {
    CommandFailure::write(path.to_string_lossy(), error)
}

/// The writers of commands see the program as written, pictures see the tool centre. After a
/// failure nothing more is taken.
impl RunWatch for RunOutputs<'_> {
    fn programmed(&mut self, command: &Command) {
        self.take(|writer| match writer {
            OutputWriter::Commands(out) => out.command(command),
            OutputWriter::Printed(out) => match &command.kind {
                CommandKind::Output { text } => writeln!(out, "{text}"),
                _ => Ok(()),
            },
            OutputWriter::Dxf(_) | OutputWriter::Picture(..) => Ok(()),
        });
    }

    fn path(&mut self, _: PathCommand<'_>, segments: &[Segment]) {
        self.take(|writer| match writer {
            OutputWriter::Dxf(out) => segments.iter().try_for_each(|segment| out.segment(segment)),
            _ => Ok(()),
        });
        if let Some(plot) = &mut self.plot {
            segments.iter().for_each(|segment| plot.segment(segment));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn input(path: &str, root: Option<&str>) -> ProgramInput {
        ProgramInput { path: Some(path.into()), root: root.map(PathBuf::from) }
    }

    fn paths(plan: &[Vec<OutputTarget>]) -> Vec<String> {
        plan.iter().flatten().map(|target| target.path.display().to_string()).collect()
    }

    #[test]
    fn a_pattern_names_a_file_for_each_program() {
        let inputs = [input("in/a/O1.nc", Some("in")), input("in/O2", Some("in"))];
        let written = plan(&["out/".into(), "x/*-path.dxf".into()], &inputs).unwrap();
        assert_eq!(
            paths(&written),
            ["out/a/O1.svg", "x/a/O1-path.dxf", "out/O2.svg", "x/O2-path.dxf"]
        );
        assert!(plan(&["one.svg".into()], &inputs).is_err());
        assert!(plan(&["one.svg".into()], &inputs[..1]).is_ok());
        assert!(plan(&["one.doc".into()], &inputs[..1]).is_err());
        assert!(plan(&["one".into()], &inputs[..1]).is_err());
    }

    #[test]
    fn programs_of_one_stem_keep_their_endings() {
        let inputs = [input("O1.nc", None), input("O1.tap", None), input("O2.nc", None)];
        let written = plan(&["out/*.svg".into()], &inputs).unwrap();
        assert_eq!(paths(&written), ["out/O1.nc.svg", "out/O1.tap.svg", "out/O2.svg"]);
    }
}
