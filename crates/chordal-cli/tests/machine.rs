//! Which machine runs a program, and what is reported about a wrong one.

mod common;

use common::{CLEAN, Folder};

#[test]
fn a_machine_is_named_or_a_file() {
    let folder = Folder::with_part();
    folder.write("shop/mill.toml", "inherits = 'haas-vf2'\ntitle = 'Mill 3'\n");
    folder
        .run(&["run", "part.nc", "--machine", "shop/mill.toml"])
        .ends(0)
        .says(&["Haas NGC mill", "Mill 3 (mill)"]);
    folder
        .run(&["run", "part.nc", "--machine", "haas-vf9"])
        .ends(2)
        .complains(&["there is no built-in machine `haas-vf9`", "did you mean \"haas-vf2\"?"]);
    folder
        .run(&["run", "part.nc", "-m", "none.toml"])
        .ends(2)
        .complains(&["error: cannot read none.toml: no such file"]);
}

#[test]
fn a_wrong_key_is_underlined() {
    let folder = Folder::with_part();
    folder.write("mill.toml", "inherits = 'haas-vf2'\n[feed]\nmax_velocity = '500 in/min'\n");
    folder.run(&["check", "part.nc", "-m", "mill.toml"]).ends(2).complains(&[
        "mill.toml:3",
        "max_velocity = '500 in/min'",
        "^^^^",
    ]);
    // Reported once for all the programs that it is for.
    folder.write("b.nc", CLEAN);
    let done = folder.run(&["check", "part.nc", "b.nc", "-m", "mill.toml"]).ends(2);
    assert_eq!(done.err.matches("mill.toml:3").count(), 1);
}

#[test]
fn an_unknown_setting_is_underlined() {
    let folder = Folder::with_part();
    folder.write("mill.toml", "inherits = 'haas-vf2'\n[settings]\n'Setting 400' = 1\n");
    folder.run(&["check", "part.nc", "-m", "mill.toml"]).ends(2).complains(&[
        "no setting `Setting 400`",
        "mill.toml:3:2",
        "'Setting 400' = 1",
        "^^^^^^^^^^^",
    ]);
    folder
        .run(&["check", "part.nc", "-m", "haas-vf2", "--set", "settings.Setting 40=area"])
        .ends(2)
        .complains(&["`Setting 40` cannot be `area`", "settings.Setting 40=area"]);
}

#[test]
fn keys_are_set_on_the_command_line() {
    let folder = Folder::with_part();
    let run =
        |assignment: &str| folder.run(&["check", "part.nc", "-m", "haas-vf2", "--set", assignment]);
    run("feed.max=8 in/min").says(&["error[CH407]"]);
    run("feed.max=20 in/min").ends(0);
    run("feed.maximum=20 in/min").ends(2).complains(&["feed.maximum=20 in/min", "^^^"]);
    run("feed.max=20").ends(2).complains(&["no unit", "20 in/min"]);
    run("feed").ends(2).complains(&["an assignment needs a `=`"]);
}

#[test]
fn tools_come_from_a_table() {
    let folder = Folder::new();
    folder
        .write("part.nc", "O1\nG20 G90 T1 M6\nG43 H1 Z1.\nM30\n")
        .write("tool.tbl", "T1 P1 Z+2.5 D+0.5 ;half inch mill\n")
        .write("bad.tbl", "T1 P1 Zwide\n");
    folder.run(&["check", "part.nc", "-m", "haas-vf2"]).says(&["note[CH603]"]);
    let done = folder.run(&["check", "part.nc", "-m", "haas-vf2", "--tools", "tool.tbl"]).ends(0);
    assert_eq!(done.out, "");
    folder
        .run(&["check", "part.nc", "-m", "haas-vf2", "--tools", "bad.tbl"])
        .ends(2)
        .complains(&["bad.tbl:1", "Zwide"]);
}

#[test]
fn the_folder_says_its_machine() {
    let folder = Folder::new();
    folder
        .write("a/part.nc", CLEAN)
        .write("a/chordal.toml", "machine = 'linuxcnc-mill'\n")
        .write("b/part.nc", CLEAN)
        .write("b/chordal.toml", "inherits = 'fadal-4020'\ntitle = 'Old Fadal'\n")
        .write("c/part.nc", CLEAN)
        .write("c/chordal.toml", "machine = 'own/mill.toml'\n")
        .write("c/own/mill.toml", "inherits = 'haas-vf2'\ntitle = 'Mill 9'\n")
        .write("d/part.nc", CLEAN)
        .write("d/more.nc", CLEAN)
        .write("d/chordal.toml", "machine = 'mill.toml'\n")
        .write("e/part.nc", CLEAN)
        .write("e/chordal.toml", "machine = 'haas-vf2'\n[feed]\nmax = '1 in/min'\n");
    folder.run(&["run", "a/part.nc"]).says(&["LinuxCNC\n", "from a/chordal.toml"]);
    folder.run(&["run", "b/part.nc"]).says(&["Fadal CNC 88\n", "Old Fadal"]);
    folder.run(&["run", "c/part.nc"]).says(&["Mill 9 (mill), from c/chordal.toml"]);
    // The command line comes first.
    folder.run(&["run", "a/part.nc", "-m", "haas-vf2"]).says(&["Haas NGC mill\n"]);
    let done = folder
        .run(&["check", "d/part.nc", "d/more.nc"])
        .ends(2)
        .complains(&["`mill.toml` is neither", "d/chordal.toml:1"]);
    assert_eq!(done.err.matches("neither").count(), 1);
    // What stands next to `machine` counts for the folder.
    folder.run(&["check", "e/part.nc"]).says(&["error[CH407]"]);
    folder.write("e/chordal.toml", "machine = 'haas-vf2'\ninherits = 'haas-vf3'\n");
    folder
        .run(&["check", "e/part.nc"])
        .ends(2)
        .complains(&["`machine` has no meaning together with"]);
}

#[test]
fn a_folders_machine_counts_below_it() {
    let folder = Folder::new();
    folder.write("arch/chordal.toml", "machine = 'haas-vf2'\n").write("arch/deep/part.nc", CLEAN);
    folder.run(&["run", "arch"]).says(&["from arch/chordal.toml"]);
    // Named alone, only its own folder speaks.
    folder.run(&["run", "arch/deep/part.nc"]).says(&["assumed"]);
}
