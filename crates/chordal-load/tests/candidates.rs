//! Controls that a program may be for: what speaks against one of them, and what does not.

use chordal_load::{Request, text};

#[test]
fn whole_numbers_do_not_outweigh_a_code_that_the_control_refuses() {
    let programs = [
        "G21 G90 G17 G64 P0.01\nT1 M6\nS12000 M3\nG0 X0 Y0 Z5\nG1 Z0.3 F3000\nX0.1Z0.5\nX7\nG0 Z5\nM30\n",
        "G21 G90 G17 G61.1\nS9000 M3\nG0 X0 Y0 Z5\nG1 Z-0.5 F300\nX12\nG0 Z5\nM30\n",
    ];
    for program in programs {
        let loaded =
            text("part", program.as_bytes().to_vec(), &Request::default()).expect("a program");
        assert_ne!(loaded.control(), "grbl", "{program}");
        assert_eq!(loaded.job().expect("a job").check().counts.errors, 0, "{program}");
    }
}

/// The beginning of a long program has no M30 on any control: that is no error of one.
#[test]
fn the_end_of_a_long_program_is_not_missed_in_its_beginning() {
    let lines: String = (0..20_000).map(|at| format!("X{}.25Y0.5Z-0.125\n", at % 90)).collect();
    let head = "%\nG21 G90 G17\nT1 M6\nS9000 M3\nG0 X0.5 Y0.5\nG43 H1 Z5.5\nG1 Z-0.5 F300.\n";
    let program = format!("{head}{lines}G0 Z5.5\nM30\n%\n");
    let loaded = text("part", program.into_bytes(), &Request::default()).expect("a program");
    let found = loaded.chosen.recognition().expect("a guess");
    let linuxcnc = found.ranking.iter().find(|each| each.name == "linuxcnc").expect("a candidate");
    assert_eq!(linuxcnc.errors, Some(0));
}
