//! Single forms, and what becomes of them.

use super::{converted, job, machine, verdict};

/// The body of a program on another control, where it is proved.
#[track_caller]
fn on(from: &str, text: &str, to: &str) -> String {
    let mut own = machine(from);
    own.set("tools.1.diameter=\"10 mm\"").expect("a good assignment");
    let old = job(text, own);
    let found = converted(&old, to);
    assert!(found.holds(), "{}\n{}", verdict(&found), found.text);
    let lines = found.text.lines().filter(|line| *line != "%" && !line.starts_with('O'));
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn work_offsets_by_their_number() {
    let text = "G0 G90 E1 X1. Y1.\nE7 X2.\nM2\n";
    assert_eq!(on("fadal-4020", text, "haas-vf2"), "G0 G90 G54 X1. Y1.\nG154 P1 X2.\nM2");
    assert_eq!(on("fadal-4020", text, "linuxcnc-mill"), "G0 G90 G54 X1. Y1.\nG59.1 X2.\nM2");
    let text = "G20 G90 G0 G55 X1.\nG154 P2 X2.\nM30\n";
    assert_eq!(on("haas-vf2", text, "fadal-4020"), "G20 G90 G0 E2 X1.\nE8 X2.\nM2");
    assert_eq!(on("haas-vf2", text, "fanuc-30i"), "G20 G90 G0 G55 X1.\nG54.1 P2 X2.\nM30");
}

#[test]
fn repeats_are_copied_or_kept() {
    let text = "S100 M3\nG0 G90 X0 Y0 Z0\nG1 F10.\nG91 X1. Z-.1 G90 L3\nM2\n";
    let haas = "S100 M3\nG0 G90 X0 Y0 Z0\nG1 F10.\nG91 X1. Z-.1 L3\nG90\nM2";
    assert_eq!(on("fadal-4020", text, "haas-vf2"), haas);
    let cnc =
        "S100 M3\nG0 G90 X0 Y0 Z0\nG1 F10.\nG91 X1. Z-.1\nG91 X1. Z-.1\nG91 X1. Z-.1\nG90\nM2";
    assert_eq!(on("fadal-4020", text, "linuxcnc-mill"), cnc);
}

#[test]
fn numbers_without_a_point() {
    let text = "G20 G90 S100 M3\nG0 X10000 Y0 Z0\nG1 X-5000 F10.\nM30\n";
    let fadal = "G20 G90 S100 M3\nG0 X1. Y0 Z0\nG1 X-.5 F10.\nM2";
    assert_eq!(on("haas-vf2", text, "fadal-4020"), fadal);
}

#[test]
fn dwells_in_the_unit_of_the_control() {
    let text = "G20 S100 M3\nG0 X0 Y0 Z0\nG4 P500\nM2\n";
    let linux = "G20 S100 M3\nG0 X0 Y0 Z0\nG4 P0.5\nM2";
    assert_eq!(on("fadal-4020", text, "linuxcnc-mill"), linux);
    // A setting makes its units milliseconds.
    let mut own = machine("mach3-mill");
    own.set("settings.\"G04 Dwell in ms\"=\"on\"").expect("a good assignment");
    let text = "G20 G90 S100 M3\nG0 X0 Y0 Z0\nG4 P1500\nM2\n";
    let found = converted(&job(text, own), "linuxcnc-mill");
    assert!(found.holds() && found.text.contains("\nG4 P1.5\n"), "{}", found.text);
}

#[test]
fn spirals_as_arcs() {
    let text = "G21 G17 G90 S100 M3\nG0 X10. Y0 Z0\nG1 F100.\nG3.1 X20. Y0 I-10. J0 P2\nM30\n";
    let old = job(text, machine("mitsubishi-m700"));
    for to in ["haas-vf2", "fadal-4020", "linuxcnc-mill"] {
        let found = converted(&old, to);
        assert!(found.holds(), "{to}: {}", verdict(&found));
        let arcs = found.text.lines().filter(|line| line.contains("G3 ")).count();
        assert!((16..=200).contains(&arcs), "{arcs} arcs on {to}");
        let most = found.certificate.expect("a proof").comparison.max_distance_mm;
        assert!(most.is_some_and(|most| most > 0.0 && most <= 0.005), "{most:?}");
    }
}

#[test]
fn nothing_is_written_of_a_program_with_errors() {
    let text = "G20 G90 S100 M3\nG0 X0 Y0 Z0\nG2 X1. Y0 I.6 J0 F10.\nM30\n";
    let found = converted(&job(text, machine("haas-vf2")), "fadal-4020");
    assert!(found.text.is_empty() && !found.holds());
    assert_eq!(found.refusals[0].line, 3);
    assert!(found.refusals[0].reason.contains("original control"), "{}", found.refusals[0].reason);
}

#[test]
fn programs_of_lathes_and_mills_are_refused_for_each_other_in_one_sentence() {
    let turned = "G21 G18 G40 G99 S500 M3\nT0101\nG0 X50. Z2.\nG1 Z-20. F.2\nG28 U0 W0\nM30\n";
    let milled = "G21 G90 S500 M3\nG0 X50. Y2. Z2.\nG1 Z-2. F100.\nM30\n";
    for (text, from, to, said) in [
        (
            turned,
            "fanuc-lathe",
            "haas-vf2",
            "a program of a lathe (Fanuc lathe) is not converted for a mill (Haas NGC mill)",
        ),
        (
            milled,
            "haas-vf2",
            "haas-lathe",
            "a program of a mill (Haas NGC mill) is not converted for a lathe (Haas lathe)",
        ),
    ] {
        let found = converted(&job(text, machine(from)), to);
        assert!(found.text.is_empty() && !found.holds());
        let reasons: Vec<&str> = found.refusals.iter().map(|one| one.reason.as_str()).collect();
        assert_eq!(reasons, [said]);
    }
}

#[test]
fn what_has_no_form_is_said_with_its_line() {
    // Thread cutting: the source control carries it out and Chordal does not.
    let text = "G21 G90 S100 M3\nG0 X0 Y0 Z0\nG33 Z-5. F2.\nG1 X1. F100.\nM30\n";
    let found = converted(&job(text, machine("fanuc-30i")), "haas-vf2");
    assert!(!found.holds());
    let said = found.refusals.iter().any(|refusal| refusal.line == 3);
    assert!(said, "{:?}", found.refusals);
}

#[test]
fn compensation_of_another_kind_is_proved_by_the_contour() {
    // An arc about the corner on a Fadal, two lines on a Fanuc.
    let text =
        "G20 G90 S100 M3\nG0 X-1. Y-1. Z0\nG1 G41 D1 X0 F10.\nY1.\nX2.\nY0\nX-1.\nG40 Y-1.\nM2\n";
    let mut own = machine("fadal-4020");
    own.set("tools.1.diameter=\"10 mm\"").expect("a good assignment");
    let found = converted(&job(text, own), "fanuc-30i");
    let certificate = found.certificate.as_ref().expect("a proof");
    assert!(certificate.holds());
    let center = certificate.tool_center.as_ref().expect("another way round corners");
    assert!(center.max_distance_mm.is_some_and(|mm| mm > 1.0 && mm < 5.0), "{center:?}");
}

#[test]
fn moves_of_unknown_places_are_proved_too() {
    // In increments from wherever the tool stands.
    let old = job("G20 G91 S100 M3\nG1 X1. F10.\nY.5\nM30\n", machine("haas-vf2"));
    let found = converted(&old, "fadal-4020");
    assert!(found.holds(), "{}", verdict(&found));
    let comparison = found.certificate.expect("a proof").comparison;
    assert_eq!(comparison.max_distance_mm, Some(0.0));
    assert_eq!(comparison.moves, [2, 2]);
}

/// A loop, a jump and computed places: the same statements in the other language, and back.
#[test]
fn statements_go_from_one_language_to_the_other() {
    let haas = "O100\nG20 G17 G90 G40 G80\nT1 M6\nS1000 M3\nG0 X0 Y0 Z0\n#102=0\n\
                WHILE [#102 LT 3] DO1 (ROWS)\nG1 X[#102*2.+.5] Y#102 F20.\n#103=-[#102+1]/2\n\
                IF [#103 LT -1] GOTO 50\nG1 Z#103\nN50 #102=#102+1\nEND1\nG0 Z1.\nM30\n";
    let there = converted(&job(haas, machine("haas-vf2")), "fadal-4020");
    assert!(there.holds(), "{}", verdict(&there));
    assert_eq!(
        there.text,
        "O100\nG20 G17 G90 G40 G80\nT1 M6\nS1000 M3\nG0 X0 Y0 Z0\n# V2=0\n(ROWS\n#:LOOP1\n\
         # IF V2>=3 THEN GOTO :END1\n# R1=V2*2.+.5\n# R2=V2\nG1 X+R1 Y+R2 F20.\n# V3=(-(V2+1))/2\n\
         # IF V3<(-1) THEN GOTO N50\n# R1=V3\nG1 Z+R1\nN50\n# V2=V2+1\n# GOTO :LOOP1\n#:END1\nG0 Z1.\nM2\n"
    );
    let back = converted(&there.job("converted").unwrap(), "fanuc-30i");
    assert!(back.holds(), "{}", verdict(&back));
    assert_eq!(
        back.text,
        "O0100\nG20 G17 G90 G40 G80\nT1 M6\nS1000 M3\nG0 X0 Y0 Z0\n#102=0\n(ROWS)\nN9001\n\
         IF [#102 GE 3] GOTO 9000\n#199=#102*2.+.5\n#198=#102\nG1 X#199 Y#198 F20.\n\
         #103=[-[#102+1]]/2\nIF [#103 LT [-1]] GOTO 50\n#199=#103\nG1 Z#199\nN50\n#102=#102+1\n\
         GOTO 9001\nN9000\nG0 Z1.\nM2\n"
    );
}

/// Statements that the other language does not have: what they do is written out.
#[test]
fn other_statements_are_written_out() {
    let fadal = "O5\nM6 T1\nG0 G90 S1000 M3 X0 Y0 Z0\n# SET RADIANS\n# V1=COS(1)\n# R1=V1*2\nG1 X+R1 F10.\nM2\n";
    let there = converted(&job(fadal, machine("fadal-4020")), "haas-vf2");
    assert!(there.holds(), "{}", verdict(&there));
    assert!(there.text.contains("X1.0806"), "{}", there.text);
}

/// The spindle of another control would stop at R: that is said, and not how the moves differ.
#[test]
fn a_tap_that_no_cycle_does_is_refused() {
    let text = "G20 G90 G17 G94\nS200 M3\nG0 X0 Y0 Z2.5\nG84 G98 X1. Y0 Z1.9 R2. F10.\nG80\nM2\n";
    let there = converted(&job(text, machine("linuxcnc-mill")), "haas-vf2");
    assert!(!there.holds());
    assert_eq!(there.refusals.len(), 1, "{:?}", there.refusals);
    assert_eq!(there.refusals[0].line, 4);
    assert!(there.refusals[0].reason.contains("feeds out further"), "{:?}", there.refusals);
}

/// Nothing is known of what they move, so nothing can be proved.
#[test]
fn codes_that_are_not_carried_out_are_refused() {
    let begin = "O1\nT1 M6\nG20 G90 G54 S900 M3\nG0 X0 Y0 Z1.\n";
    let line = "G33 Z-.5 F.1";
    let text = format!("{begin}{line}\nG1 X2. Y1. F10.\nM30\n");
    let there = converted(&job(&text, machine("fanuc-30i")), "haas-vf2");
    assert_eq!(there.refusals.len(), 1, "{line}: {:?}", there.refusals);
    assert_eq!(there.refusals[0].line, 5, "{line}");
}

/// Degrees of one control are lengths of the other: 30 degrees of radius 2 in are 1.0472 in.
#[test]
fn coordinates_on_a_cylinder_become_lengths() {
    let text = "O1\nT1 M6\nG20 G90 G54 S900 M3\nG0 X0 Y0 Z1. A0\nG7.1 A2.\nG1 X2. A30. F10.\nG7.1 A0\nM30\n";
    let there = converted(&job(text, machine("fanuc-30i")), "haas-vf2");
    assert!(there.holds(), "{:?} {}", there.refusals, there.text);
    for line in ["G107 A0 Y0 R2.", "G1 X2. Y1.0472 F10.", "G107"] {
        assert!(there.text.lines().any(|own| own == line), "{line}: {}", there.text);
    }
    let back = converted(&there.job("back").expect("a job"), "fanuc-30i");
    assert!(back.holds() && back.text.contains("G1 X2. A30. F10."), "{}", back.text);
    let without = converted(&job(text, machine("fanuc-30i")), "linuxcnc-mill");
    assert!(
        without.refusals[0].reason.contains("no cylindrical interpolation"),
        "{:?}",
        without.refusals
    );
}

/// A rotation with its whole centre and its angle is read alike; other frames are written out.
#[test]
fn frames_are_kept_or_written_out() {
    let begin = "O1\nT1 M6\nG21 G90 G17 G54 S900 M3\nG0 X0 Y0 Z1.\n";
    let end = "G1 X20. Y5. F100.\nG2 X30. Y5. I5. J0\nG91 G1 X5.\nG90 X2. Y1.\n";
    let cases = [
        ("G68 X10. Y5. R30.", "G69", "G68 X10. Y5. R30."),
        ("G51.1 X50.", "G50.1 X0", "X80."),
        ("G51 X0 Y0 Z0 P2.", "G50", "X40."),
        ("G16", "G15", "X19.924"),
    ];
    for (frame, off, expected) in cases {
        let arc = if frame == "G16" { "G1 X20. Y5. F100.\nG91 Y10.\nG90 X2. Y1.\n" } else { end };
        let text = format!("{begin}{frame}\n{arc}{off}\nG1 X2. Y1.\nM30\n");
        let there = converted(&job(&text, machine("fanuc-30i")), "haas-vf2");
        assert!(there.holds(), "{frame}: {:?}\n{}", there.refusals, there.text);
        assert!(there.text.contains(expected), "{frame}: {}", there.text);
    }
}

/// What block delete leaves out cannot be said in a program that is written out as it runs.
#[test]
fn block_delete_in_a_program_that_is_written_out_is_refused() {
    let text = "O1\nM6 T1\nG0 G90 S900 M3 X0 Y0 Z0\n# SET RADIANS\n# V1=0\n#:A\n/G1 X5. F10.\n# V1=V1+1\n\
                # IF V1<3 THEN GOTO :A\nM2\n";
    let there = converted(&job(text, machine("fadal-4020")), "haas-vf2");
    assert!(there.refusals.iter().any(|refusal| refusal.line == 7), "{:?}", there.refusals);
}

/// A program that is written out begins with what is active at its first move.
#[test]
fn a_program_that_is_written_out_begins_safely() {
    let text = "O1\nM6 T1\nG0 G90 S900 M3 E1 X0 Y0\n# SET RADIANS\n# V1=0\n#:A\nG1 Z-1. F10.\nG0 Z0\n\
                # V1=V1+1\n# IF V1<2 THEN GOTO :A\nM2\n";
    let there = converted(&job(text, machine("fadal-4020")), "haas-vf2");
    assert!(there.holds(), "{}", verdict(&there));
    assert!(
        there.text.starts_with("O00001\nG20 G17 G90 G40 G80 G54\nT1 M6\nS900 M3\nG0 X0. Y0.\n"),
        "{}",
        there.text
    );
}

/// `,R` and `,C` stay where the other control makes the same of them; else the shortened moves are written.
#[test]
fn corners_are_kept_or_written_out() {
    let begin = "G21 G17 G90 S100 M3\nG0 X0 Y0 Z0\n";
    let lines = format!("{begin}G1 X20. ,R5. F100.\nY20. ,C3.\nX0\nM30\n");
    for to in ["haas-vf2", "mitsubishi-m700"] {
        let text = on("fanuc-30i", &lines, to);
        assert!(text.contains("G1 X20. ,R5. F100.\nY20. ,C3.\nX0\n"), "{to}: {text}");
    }
    for from in ["fanuc-30i", "haas-vf2", "mitsubishi-m700"] {
        for to in ["linuxcnc-mill", "fadal-4020"] {
            let text = on(from, &lines, to);
            assert!(text.contains("X15.") && text.contains("X17."), "{to}: {text}");
            assert!(
                !text.lines().any(|line| line.starts_with(['G', 'X', 'Y']) && line.contains(',')),
                "{to}: {text}"
            );
        }
    }
    // The arc begins where the rounding ends: I counts from there.
    let arcs = format!(
        "{begin}G0 Y10.\nG1 X5. ,R1. F100.\nG2 X15. I5. ,R2.\nG1 X25. ,R1.\nG91 Y5.\nG90 X0\nM30\n"
    );
    let text = on("fanuc-30i", &arcs, "mitsubishi-m700");
    assert!(text.contains("G1 X5. ,R1. F100.\nG2 X15. I5. ,R2.\nG1 X25. ,R1.\n"), "{text}");
    for to in ["haas-vf2", "linuxcnc-mill", "fadal-4020"] {
        let text = on("fanuc-30i", &arcs, to);
        assert!(
            !text.lines().any(|line| line.starts_with(['G', 'X', 'Y']) && line.contains(','))
                && text.contains("X16.708"),
            "{to}: {text}"
        );
    }
    // A dwell between, which only some allow.
    let dwell = format!("{begin}G1 X20. ,R5. F100.\nG4 P100\nY20.\nM30\n");
    assert!(on("fanuc-30i", &dwell, "haas-vf2").contains(",R5."));
    assert!(on("fanuc-30i", &dwell, "mitsubishi-m700").contains("\nG1 X15."));
    // Without a point.
    let plain = format!("{begin}G1 X20. ,R500 F100.\nY20.\nM30\n");
    assert!(on("fanuc-30i", &plain, "mitsubishi-m700").contains(",R"));
}

#[test]
fn a_control_without_tool_lengths_percent_and_program_numbers() {
    let text = "%\nO1001 (PLATE)\nG21 G17 G90 G40 G49 G80\nT1 M6\nG54 G0 X10. Y5. S900 M3\nG43 H1 Z5.\nG1 Z-1. F100.\n\
                G2 I-4. F200.\nG0 Z5.\nG81 X20. Z-2. R1. F80.\nX30.\nG80\nG4 P500\nM30\n%\n";
    let router = on("haas-vf2", text, "grbl");
    assert!(router.contains("\nG0 Z5.") || router.contains("\nZ5."), "{router}");
    assert!(
        router.contains("G2 X10. I-4. F200.") || router.contains("G2 I-4. F200. X10."),
        "{router}"
    );
    for lacking in ["G43", "H1", "G81", "G80 \n"] {
        assert!(
            !router.lines().any(|line| !line.starts_with('(') && line.contains(lacking)),
            "{router}"
        );
    }
    assert!(router.contains("G4 P0.5"), "{router}");
    // Cycles and full circles without an end stay where the control has them.
    let hal = on("haas-vf2", text, "grblhal");
    assert!(hal.contains("G81 X20. Z-2. R1. F80.") && hal.contains("G2 I-4. F200."), "{hal}");
    assert!(!hal.contains("G43"), "{hal}");
}

#[test]
fn from_a_router_to_a_mill() {
    let text = "G21 G90 G17 G94\nM3 S9000\nG0 Z5\nG0 X0 Y0\nG1 Z-1 F200\nG2 X0 Y0 I5 F400\nG4 P1\nG0 Z5\nM5\nM2\n";
    let mill = on("grbl", text, "haas-vf2");
    assert!(mill.contains("G2 X0 Y0 I5. F400"), "{mill}");
    // Milliseconds there.
    assert!(mill.contains("G4 P1000"), "{mill}");
}
