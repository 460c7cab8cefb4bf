//! The formats that Chordal writes. Each has one name, which is the ending of its files and its word for `--format`; each
//! content has one list of the formats that it is written in, with their words in the help of the command.

use std::path::Path;

/// The type of formats, and their names.
macro_rules! output_formats {
    ($($(#[$meta:meta])? $format:ident $name:literal,)*) => {
        /// A format of an output.
        #[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
        pub enum OutputFormat {
            $($(#[$meta])? #[doc = concat!("`", $name, "`")] $format,)*
        }

        impl OutputFormat {
            /// The ending of its files, without a point, and its word on a command line.
            pub const fn name(self) -> &'static str {
                match self { $(OutputFormat::$format => $name,)* }
            }
        }
    };
}

output_formats! {
    #[default]
    Object "object",
    Text "text",
    Txt "txt",
    Markdown "markdown",
    Html "html",
    Json "json",
    Jsonl "jsonl",
    Csv "csv",
    Canon "canon",
    Parquet "parquet",
    Arrow "arrow",
    Sarif "sarif",
    Github "github",
    Gitlab "gitlab",
    Svg "svg",
    Png "png",
    Dxf "dxf",
    Stl "stl",
    ThreeMf "3mf",
    Glb "glb",
}

impl OutputFormat {
    /// Another ending of its files.
    pub const fn alias(self) -> Option<&'static str> {
        if matches!(self, OutputFormat::Html) { Some("htm") } else { None }
    }

    /// Whether it is for programs alone: a terminal cannot show it.
    pub const fn is_binary(self) -> bool {
        matches!(self, OutputFormat::Parquet | OutputFormat::Arrow)
    }
}

/// A format and its words in the help of a command.
type FormatRow = (OutputFormat, &'static str);

/// The formats that a content is written in, in the order of help and messages.
#[derive(Clone, Copy, Debug)]
pub struct FormatList(&'static [FormatRow]);

impl FormatList {
    /// Each format, and its words in the help.
    pub fn rows(&self) -> impl Iterator<Item = FormatRow> + use<> {
        self.0.iter().copied()
    }

    /// Whether the content is written in it.
    pub fn has(&self, format: OutputFormat) -> bool {
        self.rows().any(|(own, _)| own == format)
    }

    /// The format of this name.
    pub fn named(&self, name: &str) -> Option<OutputFormat> {
        let is_named = |own: OutputFormat| own.name() == name || own.alias() == Some(name);
        self.rows().map(|(own, _)| own).find(|own| is_named(*own))
    }

    /// The format that the ending of a file says, in capitals or not.
    pub fn of_file(&self, path: &Path) -> Option<OutputFormat> {
        self.named(&path.extension()?.to_string_lossy().to_ascii_lowercase())
    }

    /// The names in a row: `svg, png`.
    pub fn names(&self) -> String {
        self.rows().map(|(own, _)| own.name()).collect::<Vec<_>>().join(", ")
    }

    /// A line for each content: the endings that have it, and its words in the help.
    pub fn help_lines(&self) -> String {
        let line = |rows: &[FormatRow]| {
            let endings = FormatList::endings_of(rows).replace(',', "");
            format!("  {endings:<9}   {}\n", rows[0].1)
        };
        self.0.chunk_by(|one, next| one.1 == next.1).map(line).collect()
    }

    /// The endings of files in a row: `.svg, .png`.
    pub fn endings(&self) -> String {
        FormatList::endings_of(self.0)
    }

    fn endings_of(rows: &[FormatRow]) -> String {
        rows.iter().map(|(own, _)| format!(".{}", own.name())).collect::<Vec<_>>().join(", ")
    }
}

/// A list without a help of its own.
macro_rules! format_list {
    ($($format:ident),*) => { FormatList(&[$((OutputFormat::$format, "")),*]) };
}

const PARQUET: FormatRow = (OutputFormat::Parquet, "Apache Parquet");
const ARROW: FormatRow = (OutputFormat::Arrow, "Arrow IPC file (Feather)");
const VIEWS: &str = "views with axes and scale, rapids dashed, feeds coloured by tool";
const CANONICAL: &str = "the canonical commands, as `chordal commands` prints them";
const TEXT: FormatRow = (OutputFormat::Text, "Text for the reader");
const OBJECT: FormatRow = (OutputFormat::Json, "One JSON object");
const OBJECT_OF_FILES: FormatRow = (OutputFormat::Json, "One JSON object for all files");

/// Commands as programmed.
pub const COMMAND_FORMATS: FormatList = FormatList(&[
    (OutputFormat::Jsonl, "JSON lines: a header, then one object per command"),
    (OutputFormat::Canon, "LinuxCNC's canonical text"),
    (OutputFormat::Csv, "Comma-separated, one row per command"),
    PARQUET,
    ARROW,
]);
/// Commands of the tool centre, chords and setpoints.
pub const ROW_FORMATS: FormatList = FormatList(&[
    (OutputFormat::Csv, "Comma-separated, a row each"),
    (OutputFormat::Jsonl, "JSON lines: a header, then an object each"),
    PARQUET,
    ARROW,
]);
/// Files of a run: pictures, the path, the commands, what the program itself prints.
pub const RUN_FILES: FormatList = FormatList(&[
    (OutputFormat::Svg, VIEWS),
    (OutputFormat::Png, VIEWS),
    (OutputFormat::Dxf, "the path with true arcs"),
    (OutputFormat::Csv, CANONICAL),
    (OutputFormat::Jsonl, CANONICAL),
    (OutputFormat::Canon, CANONICAL),
    (OutputFormat::Txt, "the text that the program itself prints (DPRNT)"),
]);
/// Pictures of any kind.
pub const PICTURE_FILES: FormatList = format_list![Svg, Png];
/// What is left of the stock of a mill.
pub const STOCK_FILES: FormatList = format_list![Stl, ThreeMf, Glb, Png];
/// What is left of the stock of a lathe.
pub const LATHE_STOCK_FILES: FormatList = format_list![Svg, Png, Dxf, Stl, ThreeMf, Glb];
/// How hard each move cuts.
pub const ENGAGEMENT_FILES: FormatList = format_list![Parquet, Arrow, Csv, Json];

/// Answers about one program.
pub const ANSWER_FORMATS: FormatList = FormatList(&[TEXT, OBJECT]);
/// Answers of calculations.
pub const CALCULATION_FORMATS: FormatList =
    FormatList(&[TEXT, (OutputFormat::Json, "JSON for programs")]);
/// Summaries of programs.
pub const SUMMARY_FORMATS: FormatList = FormatList(&[TEXT, OBJECT_OF_FILES]);
/// Answers about the stock of a program.
pub const STOCK_FORMATS: FormatList = FormatList(&[
    TEXT,
    OBJECT,
    (OutputFormat::Sarif, "The problems as SARIF 2.1.0, for code scanning"),
]);
/// Setup sheets.
pub const SETUP_SHEET_FORMATS: FormatList =
    FormatList(&[(OutputFormat::Html, "One HTML page with everything in it"), OBJECT]);
/// Problems of programs.
pub const PROBLEM_FORMATS: FormatList = FormatList(&[
    (OutputFormat::Text, "Text for the reader: the lines with the words underlined"),
    OBJECT_OF_FILES,
    (OutputFormat::Sarif, "SARIF 2.1.0, for code scanning"),
    (OutputFormat::Github, "Annotations of a GitHub workflow"),
    (OutputFormat::Gitlab, "A Code Quality report of GitLab"),
]);
/// Differences of two archives.
pub const ARCHIVE_DIFF_FORMATS: FormatList = FormatList(&[
    (OutputFormat::Text, "A table for the reader"),
    OBJECT_OF_FILES,
    (OutputFormat::Markdown, "A table for a pull request or the summary of a job"),
]);

/// Every format of a question in a message. An object is what JavaScript makes an object or a table of.
pub const QUESTION_FORMATS: FormatList =
    format_list![Object, Json, Text, Sarif, Github, Gitlab, Jsonl, Csv, Canon];
/// The question about columns alone.
pub const QUESTION_OBJECT: FormatList = format_list![Object];
/// Questions that are answered with one object.
pub const QUESTION_JSON: FormatList = format_list![Object, Json];
/// The question about differences.
pub const QUESTION_DIFFERENCES: FormatList = format_list![Object, Json, Text];
/// The question about problems.
pub const QUESTION_PROBLEMS: FormatList = format_list![Object, Json, Text, Github, Gitlab, Sarif];
/// The question about commands.
pub const QUESTION_COMMANDS: FormatList = format_list![Object, Jsonl, Csv, Canon];
/// The question about commands of the tool centre.
pub const QUESTION_PATH: FormatList = format_list![Object, Jsonl, Csv];
/// The question about setpoints.
pub const QUESTION_SETPOINTS: FormatList = format_list![Object, Csv, Jsonl];
