//! Which machine runs a program, and why.

mod common;

use chordal::machine::ControlName;
use chordal_load::{
    BlockDeleteSwitch, LoadError, Loader, MachineReason, ProgramInput, Request, RequestedMachine,
    machine,
};
use common::{CLEAN, Folder, on};

#[test]
fn a_machine_is_named_or_a_file() {
    let folder = Folder::new();
    folder
        .write("part.nc", CLEAN)
        .write("shop/mill.toml", "inherits = 'haas-vf2'\ntitle = 'Mill 3'\n");
    let file = folder.path("shop/mill.toml").to_string_lossy().into_owned();
    let loaded = folder.load_with("part.nc", &on(&file)).expect("the machine of a file");
    assert_eq!(loaded.machine().title, "Mill 3");
    assert!(matches!(loaded.chosen, MachineReason::Requested));
    assert_eq!(loaded.chosen.why("Haas"), None);
    let typical = RequestedMachine::Control(ControlName::Fadal);
    let request = Request { machine: Some(typical), ..Request::default() };
    let loaded = folder.load_with("part.nc", &request).expect("the machine of a control");
    assert_eq!(loaded.machine().name, machine::typical_name(ControlName::Fadal));
    let Err(LoadError::Request { message, help }) = machine::named("haas-vf9") else {
        panic!("there is no haas-vf9")
    };
    assert!(message.contains("no built-in machine `haas-vf9`"), "{message}");
    assert!(help.is_some_and(|help| help.contains("haas-vf2")));
    assert!(matches!(machine::named("none.toml"), Err(LoadError::Read { .. })));
}

#[test]
fn a_custom_code_that_the_control_has_is_refused_where_it_stands() {
    let folder = Folder::new();
    folder
        .write("part.nc", CLEAN)
        .write("mill.toml", "inherits = 'fanuc-30i'\n\n[shop_codes.M48]\ntime = '1 s'\n");
    let file = folder.path("mill.toml").to_string_lossy().into_owned();
    let Err(LoadError::Machine(errors)) = folder.load_with("part.nc", &on(&file)) else {
        panic!("Fanuc has M48")
    };
    assert_eq!(errors[0].line(), Some(3));
    assert!(errors[0].message.contains("M48 is not a custom M code"), "{errors:?}");
}

#[test]
fn a_folder_says_its_machine() {
    let folder = Folder::new();
    folder
        .write("a/part.nc", CLEAN)
        .write("a/chordal.toml", "machine = 'linuxcnc-mill'\n")
        .write("b/part.nc", CLEAN)
        .write("b/chordal.toml", "machine = 'own/mill.toml'\n")
        .write("b/own/mill.toml", "inherits = 'haas-vf2'\ntitle = 'Mill 9'\n")
        .write("c/part.nc", CLEAN)
        .write("c/chordal.toml", "machine = 'mill.toml'\n");
    let load = |name| folder.load_with(name, &Request::default());
    let a = load("a/part.nc").expect("a program");
    assert_eq!(a.machine().name, "linuxcnc-mill");
    let MachineReason::Folder(file) = &a.chosen else { panic!("{:?}", a.chosen) };
    assert_eq!(file, &folder.path("a/chordal.toml"));
    assert_eq!(load("b/part.nc").expect("a program").machine().title, "Mill 9");
    let Err(LoadError::Machine(errors)) = load("c/part.nc") else { panic!("no such machine") };
    assert!(errors[0].message.contains("`mill.toml` is neither"), "{errors:?}");
    assert_eq!(errors[0].line(), Some(1));
}

#[test]
fn a_folders_machine_counts_below_it() {
    let folder = Folder::new();
    folder.write("arch/chordal.toml", "machine = 'haas-vf2'\n").write("arch/deep/part.nc", CLEAN);
    let mut loader = Loader::new(Request::default()).expect("no machine is named");
    let path = Some(folder.path("arch/deep/part.nc"));
    let mut chosen = |root| {
        let input = ProgramInput { path: path.clone(), root };
        loader.load(&input).expect("a program").chosen
    };
    assert!(matches!(chosen(Some(folder.path("arch"))), MachineReason::Folder(_)));
    // Named alone, only its own folder speaks.
    assert!(matches!(chosen(None), MachineReason::Recognized(..)));
}

#[test]
fn the_text_speaks_for_its_control() {
    let folder = Folder::new();
    folder.write("part.ngc", "G20 G90 G0 X0\nM2\n").write("part.nc", "G20 G90 G0 X0\nM2\n");
    let load = |name| folder.load_with(name, &Request::default()).expect("a program");
    let by_ending = load("part.ngc");
    assert!(matches!(by_ending.chosen, MachineReason::Ending));
    assert_eq!(by_ending.machine().control, ControlName::Linuxcnc);
    let why = load("part.nc").chosen.why("Haas NGC mill").expect("nobody named it");
    assert_eq!(why, "assumed Haas NGC mill: nothing in the text says which control it is for");
}

#[test]
fn a_request_changes_whichever_machine_runs() {
    let folder = Folder::new();
    folder
        .write("part.nc", "O1\nG20 G90 T1 M6\n/G4 P1000\nG43 H1 Z1.\nM30\n")
        .write("tool.tbl", "T1 P1 Z+2.5 D+0.5 ;half inch mill\n")
        .write("bad.tbl", "T1 P1 Zwide\n");
    let request = Request {
        set: vec!["title=\"Mill 4\"".into()],
        tools: Some(folder.path("tool.tbl")),
        block_delete: BlockDeleteSwitch::On,
        ..Request::default()
    };
    let loaded = folder.load_with("part.nc", &request).expect("a program");
    assert_eq!(loaded.machine().title, "Mill 4");
    assert!(loaded.machine().tools.contains_key(&1));
    assert_eq!(loaded.job().expect("a job").report().summary.dwells, 0);
    // For another machine, too, unless that one counts as it is.
    let loader = Loader::new(request.clone()).expect("a loader");
    let input = ProgramInput { path: Some(folder.path("part.nc")), root: None };
    let mut other =
        loader.on(RequestedMachine::Name("fadal-4020".into()), Vec::new()).expect("a machine");
    assert_eq!(other.load(&input).expect("a program").machine().title, "Mill 4");
    let exact = machine::named("fadal-4020").expect("a machine");
    let loaded = loader.on_exactly(exact.clone()).load(&input).expect("a program");
    assert_eq!(loaded.machine(), &exact);
    let bad = Request { tools: Some(folder.path("bad.tbl")), ..request };
    let Err(LoadError::Machine(errors)) = folder.load_with("part.nc", &bad) else {
        panic!("a table that cannot be read")
    };
    assert_eq!(errors[0].line(), Some(1));
    let wrong = Request { set: vec!["feed.maximum=20 in/min".into()], ..on("haas-vf2") };
    assert!(matches!(Loader::new(wrong), Err(LoadError::Machine(_))));
}
