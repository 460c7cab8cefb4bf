//! Which format an output gets: by a word, or by the ending of its file.

use std::path::Path;

use chordal_export::format::{FormatList, OutputFormat, PICTURE_FILES};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::failure::CommandFailure;

/// Reads a word of `--format`: one of a list, whose words are in the help.
pub fn format_parser(list: &'static FormatList) -> impl TypedValueParser<Value = OutputFormat> {
    let value = |(format, help): (OutputFormat, &'static str)| {
        PossibleValue::new(format.name()).help(help).aliases(format.alias())
    };
    PossibleValuesParser::new(list.rows().map(value))
        .try_map(|name| list.named(&name).ok_or("no such format"))
}

/// The format that the ending of a file says, one of a list; `none` says that there is none, `help` begins the list.
pub fn format_of_file(
    list: &FormatList,
    path: &Path,
    none: impl FnOnce(String) -> String,
    help: &str,
) -> Result<OutputFormat, CommandFailure> {
    let wrong = || {
        let message = none(path.display().to_string());
        CommandFailure::wrong(message, format!("{help} {}", list.endings()))
    };
    list.of_file(path).ok_or_else(wrong)
}

/// The format of a picture file.
pub fn picture_format(path: &Path) -> Result<OutputFormat, CommandFailure> {
    PICTURE_FILES.of_file(path).ok_or_else(|| {
        CommandFailure::wrong(
            format!("the extension of {} is not a picture format", path.display()),
            "the extensions are .svg and .png",
        )
    })
}

/// The format of an output: that of `--format`, of the file's ending, or else that of standard output. `rows` says what is written, for messages.
pub fn format_of(
    list: &FormatList,
    requested: Option<OutputFormat>,
    path: Option<&Path>,
    streamed: OutputFormat,
    rows: &str,
) -> Result<OutputFormat, CommandFailure> {
    let Some(path) = path else { return Ok(requested.unwrap_or(streamed)) };
    let name = path.display();
    match (requested, list.of_file(path)) {
        (Some(chosen), Some(meant)) if chosen != meant => Err(CommandFailure::wrong(
            format!(
                "--format says {}, but the extension of {name} is another format",
                chosen.name()
            ),
            format!("leave --format out, or use the extension .{}", chosen.name()),
        )),
        (Some(format), _) | (None, Some(format)) => Ok(format),
        (None, None) => Err(CommandFailure::wrong(
            format!("the extension of {name} is not a format of {rows}"),
            format!("the extensions are {}; or give --format", list.endings()),
        )),
    }
}
