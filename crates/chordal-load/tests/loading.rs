//! What may come as a file, and what belongs to a program.

mod common;

use chordal::{Command, CommandKind};
use chordal_load::{LoadError, Loaded, Loader, ProgramInput, Request, find, text, without_called};
use common::{CLEAN, Folder, on};

fn commands(loaded: &Loaded) -> Vec<CommandKind> {
    let mut commands = Vec::new();
    let job = loaded.job().expect("a job");
    job.report_of_commands(|command: &Command| commands.push(command.kind.clone()));
    commands
}

/// The names of the files that a program was loaded with, without their folder.
fn names(loaded: Loaded) -> Vec<String> {
    let (texts, _, _) = loaded.into_parts();
    let name = |name: &str| name.rsplit(['/', '\\']).next().unwrap_or(name).to_string();
    texts.iter().map(|(path, _)| name(path)).collect()
}

fn errors(loaded: &Loaded) -> Vec<String> {
    let report = loaded.job().expect("a job").check();
    report.diagnostics.iter().map(|found| found.message.clone()).collect()
}

#[test]
fn encodings_are_recognized() {
    let folder = Folder::new();
    let wide =
        |units: fn(u16) -> [u8; 2]| -> Vec<u8> { CLEAN.encode_utf16().flat_map(units).collect() };
    folder
        .write("le.nc", [b"\xff\xfe".as_slice(), &wide(u16::to_le_bytes)].concat())
        .write("be.nc", wide(u16::to_be_bytes))
        .write("bom.nc", [b"\xef\xbb\xbf".as_slice(), CLEAN.as_bytes()].concat())
        .write("crlf.nc", CLEAN.replace('\n', "\r\n"))
        .write("cr.nc", CLEAN.replace('\n', "\r"))
        .write("nul.nc", [&[0; 32], CLEAN.as_bytes(), &[0; 32]].concat());
    let expected = text("part.nc", CLEAN.into(), &on("haas-vf2")).expect("a program");
    let expected = commands(&expected);
    assert!(expected.len() > 8);
    for name in ["le.nc", "be.nc", "bom.nc", "crlf.nc", "cr.nc", "nul.nc"] {
        assert_eq!(commands(&folder.load(name)), expected, "{name}");
    }
}

#[test]
fn a_mapped_file_reads_as_a_small_one() {
    let folder = Folder::new();
    let mut text = String::from("O1\nG21 G90 G0 X0 Y0 Z1.\nS100 M3\nG1 Z0 F100.\n");
    for step in 0..150_000 {
        text.push_str(&format!("X{}.{:03}\n", step % 100, step % 1000));
    }
    text.push_str("G0 Z1.\nM30\n");
    assert!(text.len() > 1 << 20);
    folder.write("long.nc", &text);
    let loaded = folder.load("long.nc");
    assert_eq!(loaded.text(), text.as_bytes());
    assert!(loaded.job().expect("a job").report().summary.lines >= 149_999);
}

#[test]
fn a_file_that_is_not_there_is_told() {
    let folder = Folder::new();
    let error = folder.load_with("none.nc", &Request::default()).err().expect("no file");
    let told = error.to_string();
    assert!(
        told.starts_with("cannot read ") && told.ends_with("none.nc: no such file or directory")
    );
}

#[test]
fn subprograms_lie_beside_the_program() {
    let folder = Folder::new();
    let main = |numbers: &[u32]| {
        let calls: String = numbers.iter().map(|number| format!("M98 P{number}\n")).collect();
        format!("O1\nG20 G90 G0 X0 Y0\n{calls}M30\n")
    };
    folder
        .write("main.nc", main(&[1000, 1001, 1002, 1003]))
        .write("O1000.nc", "%\nO1000\nG4 P1000\nM98 P1004\nM99\n%\n")
        .write("1001.tap", "O1001\nM99\n")
        .write("o01002", "O1002\nM99\n")
        .write("by-its-head.nc", "%\n(LIBRARY)\nO1003 (DRILL)\nM99\n%\n")
        .write("o1004.nc", "O1004\nM99\n");
    let loaded = folder.load("main.nc");
    assert_eq!(errors(&loaded), [""; 0]);
    assert_eq!(loaded.job().expect("a job").report().summary.dwells, 1);
    let mut files = names(loaded);
    assert_eq!(files.remove(0), "main.nc");
    files.sort();
    assert_eq!(files, ["1001.tap", "O1000.nc", "by-its-head.nc", "o01002", "o1004.nc"]);
    // A file that only its name numbers.
    folder.write("O1006.nc", "%\n(NO HEAD)\nG4 P1\nM99\n").write("main.nc", main(&[1006]));
    assert_eq!(folder.load("main.nc").job().expect("a job").report().summary.dwells, 1);
    folder.write("main.nc", main(&[1000, 1005]));
    let told = errors(&folder.load("main.nc"));
    assert!(told.iter().any(|message| message.contains("1005")), "{told:?}");
    // What stands in the file itself comes before the folder's.
    folder.write("main.nc", main(&[1001]) + "O1001 (OWN)\nM99\n");
    assert_eq!(names(folder.load("main.nc")), ["main.nc"]);
}

#[test]
fn programs_of_a_folder_are_found_by_content() {
    let folder = Folder::new();
    folder
        .write("arch/main.nc", "O1\nG20 G90 S100 M3 G0 X0 Y0 Z0\nM98 P1000\nM30\n")
        .write("arch/O1000.nc", "O1000\nG1 X1. F10.\nM98 P1001\nM99\n")
        .write("arch/O1001.nc", "O1001\nG2 X5. I.1\nM99\n")
        .write("arch/O1002.nc", "O1002\nG4 P1\nM30\n")
        .write("arch/other/O1000.nc", "O1000\nG4 P1\nM99\n")
        .write("arch/readme", "What lies here\n")
        .write("arch/tools.csv", "T1,12\n")
        .write("arch/.hidden.nc", CLEAN);
    let root = folder.path("arch");
    let names = |inputs: &[ProgramInput]| -> Vec<String> {
        let name = |input: &ProgramInput| input.below_root().to_string_lossy().replace('\\', "/");
        inputs.iter().map(name).collect()
    };
    let (inputs, wrong) = find(std::slice::from_ref(&root));
    assert!(wrong.is_empty(), "{wrong:?}");
    assert_eq!(names(&inputs), ["O1000.nc", "O1001.nc", "O1002.nc", "main.nc", "other/O1000.nc"]);
    // Subprograms run where they are called.
    assert_eq!(names(&without_called(inputs)), ["O1002.nc", "main.nc", "other/O1000.nc"]);
    // A file that is named stays.
    let (named, _) = find(&[root.join("main.nc"), root.join("O1000.nc")]);
    assert_eq!(without_called(named).len(), 2);
    let (none, wrong) = find(&[folder.path("arch/other"), folder.path(".")]);
    assert!(!none.is_empty() && wrong.is_empty());
    folder.write("empty/readme", "nothing\n");
    let (none, wrong) = find(&[folder.path("empty")]);
    assert!(none.is_empty() && wrong[0].to_string().starts_with("there is no program in "));
}

#[test]
fn one_program_of_a_memory_can_be_loaded() {
    let folder = Folder::new();
    folder.write("all.txt", "%\nO1 (A)\nG4 P1000\nM30\nO2 (B)\nG4 P2000\nG4 P1\nM30\n%\n");
    let load =
        |number| folder.load_with("all.txt", &Request { program: Some(number), ..on("haas-vf2") });
    for (number, dwells) in [(2, 2), (1, 1)] {
        let loaded = load(number).expect("a program of the file");
        assert_eq!(loaded.job().expect("a job").report().summary.dwells, dwells, "O{number}");
    }
    let Err(LoadError::Request { message, help }) = load(3) else { panic!("there is no O3") };
    assert!(message.starts_with("there is no program O3 in ") && message.ends_with("all.txt"));
    assert_eq!(help.as_deref(), Some("it has O1, O2"));
}

#[test]
fn a_loader_sees_new_files_when_it_starts_again() {
    let folder = Folder::new();
    folder.write("main.nc", "O1\nG20 G90\nM98 P5\nM30\n");
    let input = ProgramInput { path: Some(folder.path("main.nc")), root: None };
    let mut loader = Loader::new(on("haas-vf2")).expect("a machine");
    let calls = |loader: &mut Loader| names(loader.load(&input).expect("a program")).len() - 1;
    assert_eq!(calls(&mut loader), 0);
    folder.write("O5.nc", "O5\nM99\n");
    assert_eq!(calls(&mut loader), 0, "the folder is listed once");
    assert_eq!(calls(&mut loader.again()), 1);
}

/// A program of a Fanuc that reads variables which it does not set.
const KEPT: &str =
    "O1\nG21 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z0\nG1 X#500 F#501\nIF[#502EQ#0]GOTO9\nX99.\nN9 M30\n";

fn codes(loaded: &Loaded) -> Vec<&'static str> {
    let report = loaded.job().expect("a job").check();
    report.diagnostics.iter().map(|found| found.code.id()).collect()
}

#[test]
fn variables_come_from_the_files_of_the_control_next_to_the_program() {
    let written = "O1\nG21 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z0\nG1 X12.5 F250.\nN9 M30\n";
    let expected = text("part.nc", written.into(), &on("fanuc-30i")).expect("a program");
    let expected = commands(&expected);
    for (name, dump) in [
        (
            "MACRO.TXT",
            "%\r\nG10L85P500(4029000000000000) \r\nG10L85P501(406F400000000000) \r\n\
             G10L85P502(FFFFFFFFFFFFFFFF) \r\nSETVN500[FEED] \r\nM02\r\n%",
        ),
        ("COMMON.VAR", "#500=12.5\n#501=250\n#502=#0\n"),
        ("mill.var", "#500=[25600*65536+0]/134217728\n#501=250.\n#502=#0\n"),
    ] {
        let folder = Folder::new();
        folder.write("part.nc", KEPT).write(name, dump);
        let loaded = folder.load_with("part.nc", &on("fanuc-30i")).expect("a program");
        assert_eq!(commands(&loaded), expected, "{name}");
        assert_eq!(codes(&loaded), [""; 0], "{name}");
    }
}

#[test]
fn what_is_said_goes_before_the_files_of_variables() {
    let folder = Folder::new();
    folder
        .write("part.nc", KEPT)
        .write("MACRO.TXT", "#500=1.\n#501=100.\n#502=0.\n")
        .write("other.var", "#500=9.\n#600=1.\n");
    let mut request = on("fanuc-30i");
    let x = |loaded: &Loaded| {
        commands(loaded).iter().filter_map(|kind| Some(kind.motion()?.to[0])).fold(0.0, f64::max)
    };
    assert_eq!(x(&folder.load_with("part.nc", &request).expect("a program")), 99.0);
    request.set = vec!["#502=#0".into()];
    assert!(folder.load_with("part.nc", &request).is_err());
    request.set = vec!["#500=120.".into()];
    assert_eq!(x(&folder.load_with("part.nc", &request).expect("a program")), 120.0);
}

#[test]
fn bad_lines_of_variables_are_said_with_file_and_line() {
    let folder = Folder::new();
    folder
        .write("part.nc", KEPT)
        .write("plain.nc", CLEAN)
        .write("MACRO.TXT", "%\nG10L85P500(4029000000000000)\nG10L85P501(40)\n")
        .write("notes.var", "the variables of this machine\n#501=1\n");
    let loaded = folder.load_with("part.nc", &on("fanuc-30i")).expect("a program");
    let said = errors(&loaded);
    let bad = "MACRO.TXT:3: `G10L85P501(40)` is no value of a variable";
    assert!(said.iter().any(|message| message == bad), "{said:?}");
    assert!(codes(&loaded).contains(&"CH726"), "{said:?}");
    // A program without variables has nothing to do with it.
    assert_eq!(codes(&folder.load("plain.nc")), [""; 0]);
}
