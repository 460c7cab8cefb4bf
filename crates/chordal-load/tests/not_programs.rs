//! The set `tests/not-programs`: files that are no programs. Each is one sentence that says what it is.

#![allow(clippy::disallowed_methods, reason = "reads the files of the tree")]

mod labelled;

use std::fs;
use std::path::{Path, PathBuf};

use chordal_load::{
    LoadError, Loader, ProgramInput, ProgramText, Request, RequestedMachine, file, find,
    looks_like_program,
};

/// A file whose name says nothing.
const INPUT: ProgramInput = ProgramInput { path: None, root: None };

/// The beginning of a file's name, and what the sentence says. The first that fits counts.
const KINDS: &[(&str, &str)] = &[
    ("apt", "the tool path of a CAM program"),
    ("archive", "a ZIP archive"),
    ("basic", "a BASIC program"),
    ("c-header", "C or C++ source"),
    ("csv", "a table (CSV)"),
    ("document", "a PDF document"),
    ("dxf", "a drawing (DXF)"),
    ("excellon", "an Excellon drill file"),
    ("gerber", "a Gerber file"),
    ("html", "a web page"),
    ("image", "a picture (PNG)"),
    ("ini", "a settings file"),
    ("json", "a JSON file"),
    ("letter", "not an NC program: no line"),
    ("log", "a log"),
    ("macro-variables", "a list of macro variables"),
    ("makefile", "a makefile"),
    ("modelsim", "a settings file of ModelSim"),
    ("nesc", "nesC source"),
    ("netcdf", "a NetCDF data file"),
    ("parameters", "a list of parameters of a control"),
    ("post-1", "a post processor (JavaScript"),
    ("post-2", "a post processor of Mastercam"),
    ("puppet", "a Puppet manifest"),
    ("python", "a script"),
    ("robot", "a program for a Fanuc robot"),
    ("shell", "a script"),
    ("spectrum", "a tape of a ZX Spectrum"),
    ("stl", "a 3D model (STL)"),
    ("subtitles", "subtitles"),
    ("svg", "a drawing (SVG)"),
    ("test-output", "the output of a test"),
    ("tool-table-1", "a tool table of a Heidenhain"),
    ("tool-table-2", "a tool table of LinuxCNC"),
    ("utf16", "not an NC program: no line"),
    ("var", "LinuxCNC's numbered parameters"),
    ("vectric-post", "a post processor of Vectric"),
    ("vericut", "a macro file of Vericut"),
    ("xml", "an XML file"),
    ("yaml", "a YAML file"),
];

/// Tool offsets that a control prints are blocks of G10: they are run.
const PROGRAMS: &str = "offset-dump";

fn tree() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../")
}

/// All files below a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let mut all = Vec::new();
    for path in entries.map(|entry| entry.path()) {
        if path.is_dir() {
            all.extend(files(&path));
        } else {
            all.push(path);
        }
    }
    all.sort();
    all
}

fn refusal(path: &Path, request: &Request) -> Option<String> {
    match file(path, request) {
        Ok(_) => None,
        Err(LoadError::Request { message, .. }) => Some(message),
        Err(error) => panic!("{}: {error}", path.display()),
    }
}

#[test]
fn each_is_called_what_it_is() {
    let mut wrong = Vec::new();
    for path in files(&tree().join("tests/not-programs")) {
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let said = refusal(&path, &Request::default());
        if name.starts_with(PROGRAMS) {
            assert_eq!(said, None);
            continue;
        }
        let kind = KINDS.iter().find(|(begin, _)| name.starts_with(begin));
        let (_, words) = kind.unwrap_or_else(|| panic!("no kind for {name}"));
        match &said {
            Some(said) if said.contains(words) && said.contains("not an NC program") => {}
            _ => wrong.push(format!("{name}: {said:?}")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// In a folder they are left out.
#[test]
fn a_folder_has_only_its_programs() {
    let (inputs, failures) = find(&[tree().join("tests/not-programs")]);
    let names = inputs.iter().map(|input| input.name().into_owned());
    let others: Vec<String> = names.filter(|name| !name.contains(PROGRAMS)).collect();
    assert!(failures.is_empty() && others.is_empty(), "{others:?}");
    assert_eq!(inputs.len(), 2);
}

/// Where somebody names the machine, only what is certain is refused.
#[test]
fn a_named_machine_reads_what_may_be_a_program() {
    let machine = Some(RequestedMachine::Name("haas-vf2".into()));
    let request = Request { machine, ..Request::default() };
    let folder = tree().join("tests/not-programs");
    assert_eq!(refusal(&folder.join("letter-1.txt"), &request), None);
    assert_eq!(refusal(&folder.join("csv-1.csv"), &request), None);
    assert!(refusal(&folder.join("netcdf-1.nc"), &request).is_some());
    assert!(refusal(&folder.join("svg-1.svg"), &request).is_some());
}

#[test]
fn tool_tables_name_their_option() {
    let table = tree().join("tests/not-programs/tool-table-2.tbl");
    let Err(LoadError::Request { help, .. }) = file(&table, &Request::default()) else {
        panic!("a tool table is no program")
    };
    assert!(help.is_some_and(|help| help.contains("--tools")));
}

/// No program of the tree is taken for something else.
#[test]
fn programs_stay_programs() {
    let refused = |name: &str, program: &str| {
        let text = ProgramText::of(name, program.as_bytes().to_vec()).expect("a text");
        let loaded =
            Loader::new(Request::default()).and_then(|mut loader| loader.load_text(text, &INPUT));
        match loaded {
            Err(LoadError::Request { message, .. }) => Some(message),
            _ => None,
        }
    };
    let mut wrong = Vec::new();
    let mut count = 0;
    for folder in ["tests/posts", "tests/recognition"] {
        for path in files(&tree().join(folder)) {
            let all = fs::read_to_string(&path).expect("a text");
            for part in all.split("\n=== ").skip(1) {
                let (title, program) = part.split_once('\n').expect("a program");
                count += 1;
                wrong.extend(refused(title, program));
            }
        }
    }
    const ENDINGS: &[&str] = &["nc", "ngc", "tap", "gcode", "cnc", "txt", "min", "eia"];
    for folder in ["tests/suite", "tests/rs274", "tests/grbl", "tests/motion", "examples"] {
        for path in files(&tree().join(folder)) {
            let ending = path.extension().unwrap_or_default().to_string_lossy().into_owned();
            if !ENDINGS.contains(&ending.as_str()) {
                continue;
            }
            let program = String::from_utf8_lossy(&fs::read(&path).expect("a file")).into_owned();
            if looks_like_program(program.as_bytes()) {
                count += 1;
                wrong.extend(refused(&path.to_string_lossy(), &program));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 1300, "{count}");
}
