//! What may come as a file, and what belongs to a program.

mod common;

use common::{CLEAN, Folder};

#[test]
fn standard_input_is_a_file() {
    let folder = Folder::new();
    folder.run_with(&["check", "-", "-m", "haas-vf2"], CLEAN.as_bytes()).ends(0);
    folder.run_with(&["run", "-", "-m", "haas-vf2"], CLEAN.as_bytes()).ends(0).says(&["<stdin>"]);
    folder.run_with(&["commands", "-"], CLEAN.as_bytes()).ends(0).says(&["\"kind\":\"arc\""]);
}

#[test]
fn odd_files_get_an_answer() {
    let folder = Folder::new();
    let line = format!("O1\nG1 {} F10.\nM30\n", "X1.".repeat(400_000));
    folder
        .write("empty.nc", "")
        .write("line.nc", line)
        .write("binary.nc", (0..=255).cycle().take(50_000).collect::<Vec<u8>>())
        .write("nul.nc", [0; 5000])
        .write("numbers.nc", "O1\nG1 X99999999999999999999999 YNaN Z1e400 F1.\nM30\n")
        .write("loop.nc", "O1\nG91 X1.\nM99\n")
        .write("repeat.nc", "O1\nG91 G1 X.1 F1. L99999999\nM30\n")
        .write("deep.nc", "O1\nM98 P1\nM30\n");
    for name in ["line.nc", "numbers.nc", "loop.nc", "repeat.nc", "deep.nc", "nul.nc"] {
        for command in ["check", "run", "commands", "chords"] {
            let done = folder.run(&[command, name, "-m", "haas-vf2"]);
            assert!(matches!(done.code, 0 | 1), "{command} {name}: {}\n{}", done.code, done.err);
            assert!(done.out.len() + done.err.len() < 20_000_000, "{command} {name}");
        }
    }
    folder.run(&["check", "empty.nc"]).ends(1).says(&["there is no block to run"]);
    folder.run(&["check", "binary.nc"]).ends(1).says(&["not an NC program"]);
}

#[test]
fn the_summary_says_where_subprograms_come_from() {
    let folder = Folder::new();
    folder
        .write(
            "main.nc",
            "O1\nG20 G90 G0 X0 Y0\nM98 P1000\nM98 P1003\nM98 P1004\nM30\nO1004 (OWN)\nM99\n",
        )
        .write("O1000.nc", "%\nO1000\nG4 P1000\nM99\n%\n")
        .write("by-its-head.nc", "%\n(LIBRARY)\nO1003 (DRILL)\nM99\n%\n");
    folder.run(&["check", "main.nc", "-m", "haas-vf2"]).ends(0);
    folder.run(&["run", "main.nc", "-m", "haas-vf2"]).ends(0).says(&[
        "program   O1\n",
        "calls     O1004 (OWN)\n",
        "O1000 from O1000.nc",
        "O1003 (DRILL) from by-its-head.nc",
        "1 dwell",
    ]);
}

#[test]
fn subprograms_of_a_folder_run_where_they_are_called() {
    let folder = Folder::new();
    folder
        .write("arch/main.nc", "O1\nG20 G90 S100 M3 G0 X0 Y0 Z0\nM98 P1000\nM30\n")
        .write("arch/O1000.nc", "O1000\nG1 X1. F10.\nM98 P1001\nM99\n")
        .write("arch/O1001.nc", "O1001\nG2 X5. I.1\nM99\n")
        .write("arch/O1002.nc", "O1002\nG4 P1\nM30\n")
        .write("arch/other/O1000.nc", "O1000\nG4 P1\nM99\n");
    folder
        .run(&["check", "arch", "-m", "haas-vf2"])
        .ends(1)
        .says(&["arch/O1001.nc:2", "called from", "arch/O1000.nc", "called from", "main"])
        // A subprogram whose caller is elsewhere has no problem by itself.
        .complains(&["1 of 3 programs with problems (2 files with only subprograms"]);
    // Named by itself it is run by itself.
    folder
        .run(&["check", "arch/O1000.nc", "-m", "haas-vf2"])
        .ends(1)
        .says(&["M99 in the main program"]);
}

#[test]
fn one_program_of_a_memory_can_be_run() {
    let folder = Folder::new();
    folder.write("all.txt", "%\nO1 (A)\nG4 P1000\nM30\nO2 (B)\nG4 P2000\nG4 P1\nM30\n%\n");
    let run = |number: &str| folder.run(&["run", "all.txt", "-m", "haas-vf2", "--program", number]);
    run("O2").ends(0).says(&["program   O2 (B)", "2 dwells"]);
    run("1").ends(0).says(&["program   O1 (A)", "1 dwell"]);
    run("3").ends(2).complains(&["there is no program O3 in all.txt", "it has O1, O2"]);
}

#[test]
fn block_delete_is_a_switch() {
    let folder = Folder::new();
    folder.write("part.nc", "O1\nG20 G90 G0 X0\n/G4 P1000\nM30\n");
    folder.run(&["run", "part.nc", "-m", "haas-vf2"]).ends(0).says(&["1 dwell"]);
    let done = folder.run(&["run", "part.nc", "-m", "haas-vf2", "--block-delete"]).ends(0);
    assert!(!done.out.contains("dwell"), "{}", done.out);
}

#[test]
fn the_budget_can_be_set() {
    let folder = Folder::new();
    folder.write("part.nc", "O1\nG20 G90\nM98 P2 L50\nM30\nO2\nG4 P1\nG4 P1\nM99\n");
    folder.run(&["check", "part.nc", "-m", "haas-vf2"]).ends(0);
    folder
        .run(&["check", "part.nc", "-m", "haas-vf2", "--max-blocks", "20"])
        .says(&["stopped after 20 blocks"]);
}
