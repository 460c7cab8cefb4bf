//! Recognizes kinds of files by their first lines.

use super::FileKind;
use super::sample::{TextSample, fits};

/// A kind and its test.
type FileKindTest = (FileKind, fn(&TextSample) -> bool);

/// Tested in this order: the first match decides.
const ROWS: &[FileKindTest] = &[
    (certain("a drawing (SVG)"), |s| s.begins("<svg") || s.begins("<?xml") && s.has("<svg")),
    (certain("a web page (HTML)"), |s| s.begins("<!doctype html") || s.begins("<html")),
    (certain("an XML file"), |s| s.begins("<?xml") || s.begins("<!doctype")),
    (certain("a drawing (DXF)"), is_dxf),
    (certain("a Gerber file of a circuit board"), is_gerber),
    (certain("an Excellon drill file of a circuit board"), is_excellon),
    (certain("a 3D model (STL)"), |s| s.begins("solid") && s.has("facet normal")),
    (certain("a 3D model (STEP)"), |s| s.begins("ISO-10303-21")),
    (
        certain("a tool table of a Heidenhain").help(
            "--tools takes tool tables of LinuxCNC (`T1 P1 Z50 D10`); write its tools in that form, or in the machine file",
        ),
        |s| s.begins("BEGIN TOOL") || s.begins("BEGIN PLACE"),
    ),
    (
        certain("a tool table of LinuxCNC").help("give it with --tools, and a program to run"),
        is_tool_table,
    ),
    (FileKind::new("a file of LinuxCNC's numbered parameters"), is_numbered_parameters),
    (FileKind::new("a list of macro variables of a control"), is_macro_variables),
    (FileKind::new("a list of parameters of a control"), is_control_parameters),
    (certain("a program for a Fanuc robot"), |s| s.begins("/PROG")),
    (certain("a macro file of Vericut"), |s| s.begins("CGTECH_MACRO")),
    (FileKind::new("the tool path of a CAM program (APT)"), is_apt),
    (FileKind::new("nesC source code"), is_nesc),
    (FileKind::new("a post processor (JavaScript, .cps)"), |s| {
        s.has("createFormat(") || s.has("CAPABILITY_MILLING") || s.has("function onOpen(")
    }),
    (FileKind::new("a post processor of Mastercam"), |s| {
        s.has("psof$") || s.has("peof$") || s.has("progno$")
    }),
    (FileKind::new("a post processor of Vectric"), |s| {
        s.begin(1, &["POST_NAME"]) && s.begin(1, &["FILE_EXTENSION", "var ", "VAR "])
    }),
    (FileKind::new("a Puppet manifest"), |s| s.has("=>") && s.has("ensure")),
    (FileKind::new("a settings file of ModelSim"), |s| {
        s.begin(1, &["[Library]"]) && s.begin(1, &["[vsim]", "[vcom]", "[vlog]", "[Project]"])
    }),
    (
        FileKind::new("a settings file (INI or TOML)")
            .help("--machine takes a machine file, --settings what GRBL prints for `$$`"),
        is_settings,
    ),
    (certain("a script"), |s| s.begins("#!")),
    (FileKind::new("C or C++ source code"), |s| {
        s.begin(1, &["#include <", "#include \"", "#ifndef ", "#pragma once", "#define "])
    }),
    (FileKind::new("Python source code"), |s| {
        s.begin(1, &["def ", "class "]) && s.begin(1, &["import ", "from ", "return", "yield "])
    }),
    (FileKind::new("JavaScript source code"), |s| {
        s.begin(1, &["function ", "const ", "export "]) && s.begin(1, &["}", "return "])
    }),
    (FileKind::new("a makefile"), is_makefile),
    (FileKind::new("a BASIC program"), is_basic),
    (FileKind::new("the output of a test (TAP)"), |s| {
        s.begins("TAP version") || fits(s.first(), "1..9+") && s.begin(1, &["ok ", "not ok "])
    }),
    (FileKind::new("a file of subtitles"), |s| {
        s.share(2, 60, |line| fits(line, "{9+}{9+}"))
            || s.count(|line| fits(line, "99:99:99,999 -->")) > 0
    }),
    (FileKind::new("a JSON file"), is_json),
    (FileKind::new("a YAML file"), is_yaml),
    (FileKind::new("a log"), is_log),
    (FileKind::new("a table (CSV)"), is_table),
];

const fn certain(what: &'static str) -> FileKind {
    FileKind::new(what).certain()
}

/// The kind of a file with these lines; `None` when unknown.
pub(super) fn kind_of(sample: &TextSample) -> Option<&'static FileKind> {
    ROWS.iter().find(|(_, test)| test(sample)).map(|(kind, _)| kind)
}

/// A DXF file has a group code and its value on separate lines: `0`, `SECTION`.
fn is_dxf(sample: &TextSample) -> bool {
    let first: Vec<&str> = sample.lines().take(8).collect();
    matches!(first.first(), Some(&"0" | &"999"))
        && first.windows(2).any(|pair| pair == ["0", "SECTION"])
}

/// A Gerber file has its format, its unit or an aperture between percent signs.
fn is_gerber(sample: &TextSample) -> bool {
    let starts = ["%FSL", "%FST", "%MOMM*%", "%MOIN*%", "%ADD"];
    sample.lines().take(40).any(|line| starts.iter().any(|start| line.starts_with(start)))
}

/// An Excellon file begins with M48, followed by the unit or a tool with its diameter.
fn is_excellon(sample: &TextSample) -> bool {
    let is_head =
        |line: &str| line.starts_with("METRIC") || line.starts_with("INCH") || fits(line, "T9+C9");
    sample.first_without(&['%', ';']) == "M48" && sample.count(is_head) > 0
}

/// Only lines like `T1 P1 Z0.5 D0.25 ;end mill`, and comments.
fn is_tool_table(sample: &TextSample) -> bool {
    let is_tool = |line: &str| {
        let words = line.split(';').next().unwrap_or("");
        let mut words = words.split_whitespace();
        let starts = |word: Option<&str>, shape| word.is_some_and(|word| fits(word, shape));
        starts(words.next(), "T9+")
            && starts(words.next(), "P9+")
            && words.all(|word| word.starts_with(|c: char| "XYZABCUVWDIJQ".contains(c)))
    };
    let comment = |line: &str| line.starts_with(';');
    sample.count(is_tool) > 0 && sample.share(1, 100, |line| comment(line) || is_tool(line))
}

/// Lines like `5161 0.000000`: a parameter number and its value.
fn is_numbered_parameters(sample: &TextSample) -> bool {
    sample.share(3, 100, |line| {
        let mut words = line.split_whitespace();
        let number = words.next().is_some_and(|word| word.parse::<u16>().is_ok());
        let value = words.next().is_some_and(|word| word.parse::<f64>().is_ok());
        number && value && words.next().is_none()
    })
}

/// Lines like `G10L85P500(4059…)` and `SETVN500[LEN]`.
fn is_macro_variables(sample: &TextSample) -> bool {
    sample.share(2, 80, |line| {
        fits(line, "G10L85P9+(") || line.starts_with("SETVN") || line.starts_with('%')
    }) && sample.begin(1, &["G10L85P", "SETVN"])
}

/// Lines like `N1320A1P650000A2P420000`: a parameter file of a Fanuc.
fn is_control_parameters(sample: &TextSample) -> bool {
    sample.share(4, 75, |line| {
        let shapes = ["N99999P", "N9999P", "N9999A9P", "N99999A9P", "N9999Q", "N99999Q"];
        shapes.iter().any(|shape| fits(line, shape)) && !line.contains(['X', 'Y', 'Z', 'G', ' '])
    })
}

/// APT words with a slash: `GOTO/10.0,10.0,5.0`.
fn is_apt(sample: &TextSample) -> bool {
    const WORDS: &[&str] = &[
        "PARTNO", "UNITS", "CUTTER", "LOADTL", "LOAD", "SPINDL", "FEDRAT", "GOTO", "FROM",
        "GODLTA", "CIRCLE", "COOLNT", "MACHIN", "MULTAX", "PPRINT", "TLDATA", "CYCLE", "ARCSLP",
    ];
    let is_statement = |line: &str| {
        let (word, rest) = line.split_once('/').unwrap_or((line, ""));
        WORDS.contains(&word.trim()) && !rest.is_empty() || line.starts_with("PARTNO")
    };
    sample.count(is_statement) >= 3
}

/// `configuration LampAppC {` or `module LampC {`, and `implementation`.
fn is_nesc(sample: &TextSample) -> bool {
    sample.begin(1, &["implementation"])
        && sample.begin(1, &["configuration ", "module ", "generic ", "interface "])
}

/// First a section in brackets, and most lines of the form `key = value`.
fn is_settings(sample: &TextSample) -> bool {
    let is_section = |line: &str| line.starts_with('[') && line.ends_with(']');
    let is_setting = |line: &str| {
        line.split_once('=').is_some_and(|(key, _)| {
            key.trim().len() > 2 && !key.contains(['(', '#', ']']) && !fits(key, "G9")
        })
    };
    let first = sample.first_without(&[';', '#']);
    let is_head = is_section(first) && !first.starts_with("[ ") || is_setting(first);
    is_head
        && sample.count(is_section) > 0
        && sample.share(3, 90, |line| {
            is_section(line) || is_setting(line) || line.starts_with([';', '#'])
        })
}

/// Targets with a colon, variables like `$(CC)`, and indented commands.
fn is_makefile(sample: &TextSample) -> bool {
    let is_target = |line: &str| {
        let name = line.split_once(':').map_or("", |(name, _)| name);
        name.len() > 1 && name.chars().all(|c| c.is_ascii_alphanumeric() || "$()_.-%".contains(c))
    };
    sample.has("$(") && sample.count(is_target) > 0 && sample.indented(|line| line.contains('$'))
}

/// Most lines have a line number and a BASIC keyword.
fn is_basic(sample: &TextSample) -> bool {
    const WORDS: &[&str] = &[
        "REM", "LET", "PRINT", "IF", "GOTO", "GOSUB", "FOR", "NEXT", "INPUT", "END", "DIM", "DATA",
        "READ", "RETURN", "CLS", "POKE", "BORDER", "PAPER",
    ];
    sample.share(3, 80, |line| {
        let mut words = line.split_whitespace();
        let number = words.next().is_some_and(|word| word.parse::<u32>().is_ok());
        number && words.next().is_some_and(|word| WORDS.contains(&word))
    })
}

/// Begins with a brace or a bracket, followed by a JSON name, list or object.
fn is_json(sample: &TextSample) -> bool {
    let mut start = sample.lines().flat_map(str::bytes).filter(|byte| !byte.is_ascii_whitespace());
    match (start.next(), start.next()) {
        (Some(b'{'), Some(next)) => next == b'"' || next == b'}',
        (Some(b'['), Some(next)) => next == b'{' || next == b'"' || next == b'[',
        _ => false,
    }
}

/// Most lines are `name: value` or list items.
fn is_yaml(sample: &TextSample) -> bool {
    let is_entry = |line: &str| {
        let line = line.strip_prefix("- ").unwrap_or(line);
        line.split_once(':').is_some_and(|(name, value)| {
            !name.is_empty()
                && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
                && (value.is_empty() || value.starts_with(' '))
        })
    };
    let first = sample.first();
    let small = first.starts_with(|c: char| c.is_ascii_lowercase()) && is_entry(first);
    first == "---" || small && sample.share(3, 80, is_entry)
}

/// Most lines begin with a date or a time.
fn is_log(sample: &TextSample) -> bool {
    let times = ["9999-99-99", "[99:99:99", "99:99:99", "[9999-99-99", "99.99.9999", "99/99/9999"];
    sample.share(3, 70, |line| times.iter().any(|time| fits(line, time)))
}

/// A header and rows of numbers with the same number of commas, semicolons or tabs.
fn is_table(sample: &TextSample) -> bool {
    let is_row = |line: &str, mark: char| {
        line.split(mark).all(|field| field.trim().trim_matches('"').parse::<f64>().is_ok())
    };
    [',', ';', '\t'].into_iter().any(|mark| {
        let columns = sample.first().matches(mark).count();
        columns >= 1
            && sample.share(3, 100, |line| line.matches(mark).count() == columns)
            && sample.count(|line| is_row(line, mark)) + 1 >= sample.lines().count()
    })
}
