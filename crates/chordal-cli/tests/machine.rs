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

const DUMP: &str = "Grbl 1.1h ['$' for help]\n$0=10\n$11=0.020\n$12=0.002\n$32=1\n$100=40.000\n\
    $101=40.000 (y, step/mm)\n$102=188.976\n$110=5000.000\n$111=5000.000\n$112=1200.000\n\
    $120=400.000\n$121=400.000\n$122=120.000\n$130=425.000\n$131=465.000\n$132=80.000\n$N0=G54\nok\n";

#[test]
fn what_a_firmware_prints_becomes_a_machine_and_is_printed_again() {
    let folder = Folder::new();
    folder.write("dump.txt", DUMP);
    let is_kept = |line: &&str| line.starts_with("$1") || line.starts_with("$32");
    let kept: Vec<&str> = DUMP.lines().filter(is_kept).collect();
    let kept = kept.join("\n").replace(" (y, step/mm)", "") + "\n";
    let printed = folder.run(&["machines", "--settings", "dump.txt", "--dump"]).ends(0);
    assert_eq!(printed.out, kept);
    let file = folder.run(&["machines", "--settings", "dump.txt", "--toml"]).ends(0);
    folder.write("router.toml", &file.out);
    let again = folder.run(&["machines", "router.toml", "--dump"]).ends(0);
    assert_eq!(again.out, kept);
    // A program without a sign of its control runs on it; an assignment comes after the dump.
    folder.write("line.nc", "G21 G90\nG1 X-100 F3000\n");
    folder.run(&["time", "line.nc", "--settings", "dump.txt"]).ends(0).says(&["2.125 s"]);
    let slower =
        ["time", "line.nc", "--settings", "dump.txt", "--set", "axes.X.max_acceleration=40 mm/s^2"];
    folder.run(&slower).ends(0).says(&["3.250 s"]);
}

#[test]
fn a_wrong_dump_is_underlined() {
    let folder = Folder::with_part();
    folder.write("dump.txt", "$110=5000\n$111=-3\n$112=abc\nhello\n");
    folder.run(&["check", "part.nc", "--settings", "dump.txt"]).ends(2).complains(&[
        "`$111` needs a number from zero on, not `-3`",
        "dump.txt:3:6",
        "this line is no setting and no answer of the firmware",
        "dump.txt:4:1",
    ]);
    folder.write("dump.txt", "$120=0\n");
    folder
        .run(&["check", "part.nc", "--settings", "dump.txt"])
        .ends(2)
        .complains(&["dump.txt:1:6"]);
    // A file of another kind has one answer.
    let other = folder.run(&["check", "part.nc", "--settings", "part.nc"]).ends(2);
    assert_eq!(other.err.matches("error:").count(), 1);
    other.complains(&["there is no setting in this file"]);
    folder
        .run(&["check", "part.nc", "-m", "haas-vf2", "--settings", "dump.txt"])
        .ends(2)
        .complains(&["Haas NGC mill is no control that prints its settings"]);
    folder
        .run(&["machines", "haas-vf2", "--dump"])
        .ends(2)
        .complains(&["print this one with --toml"]);
    folder.run(&["machines", "--dump"]).ends(2).complains(&["no machine is named"]);
}
