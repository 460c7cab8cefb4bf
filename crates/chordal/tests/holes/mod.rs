//! Holes: a tool that goes back into what it has cut touches nothing, whatever the resolution; real touches are found.

use chordal::stock::StockVerdict;

use crate::{Random, names, rounds, run};

/// A plate of 60 by 40 by 20 mm with a clamp at its end; a drill, a tap, a boring bar.
fn plate(machine: &str, has_lengths: bool) -> String {
    let length =
        |mm: u32| if has_lengths { format!("length = \"{mm} mm\"\n") } else { String::new() };
    format!(
        r#"
machine = "{machine}"
[stock]
shape = "box"
from = {{ X = "0 mm", Y = "0 mm", Z = "-20 mm" }}
to = {{ X = "60 mm", Y = "40 mm", Z = "0 mm" }}
[fixtures.clamp]
shape = "box"
from = {{ X = "25 mm", Y = "0 mm", Z = "0 mm" }}
to = {{ X = "35 mm", Y = "40 mm", Z = "12 mm" }}
[work_offsets.G54]
X = "-150 mm"
Y = "-100 mm"
Z = "-150 mm"
[tools.1]
shape = "drill"
diameter = "6.8 mm"
point_angle = "118 deg"
flute_length = "24 mm"
shank_diameter = "6.8 mm"
{}[tools.2]
shape = "tap"
diameter = "8 mm"
pitch = "1.25 mm"
flute_length = "20 mm"
{}[tools.3]
shape = "flat"
diameter = "7 mm"
flute_length = "30 mm"
{}"#,
        length(60),
        length(50),
        length(70)
    )
}

/// The mills with the cycles that go into a hole: code, words, and the number of the tool.
fn cycles(machine: &str) -> Vec<(u32, &'static str, u32)> {
    let tap = if machine == "fadal-4020" { "Q1.25 F625." } else { "F625." };
    let (dwell, feed) = match machine {
        "linuxcnc-mill" | "grblhal" => ("P.1 F200.", "F200."),
        _ => ("P100 F200.", "F200."),
    };
    let drilling = [(73, "Q4. F200.", 1), (81, feed, 1), (82, dwell, 1), (83, "Q4. F200.", 1)];
    let boring = [(85, feed, 3), (86, dwell, 3), (89, dwell, 3)];
    let tapping = [(74, tap, 2), (84, tap, 2)];
    let oriented = [(76, "Q.3 F200.", 3), (88, dwell, 3)];
    let mut all = [&drilling[..], &boring[..]].concat();
    match machine {
        "mach3-mill" => all.push((88, dwell, 3)),
        "grblhal" => all.push((84, tap, 2)),
        "linuxcnc-mill" => all.extend(tapping),
        _ => all.extend([&tapping[..], &oriented[..]].concat()),
    }
    all
}

const MILLS: [&str; 7] = [
    "fanuc-0i",
    "haas-vf2",
    "fadal-4020",
    "mitsubishi-m700",
    "linuxcnc-mill",
    "mach3-mill",
    "grblhal",
];

/// Holes of a cycle at places, after a drill where another tool makes them wider.
fn program(machine: &str, cycle: &str, tool: u32, spindle: &str, holes: &[(f64, f64)]) -> String {
    let has_lengths = machine != "grblhal";
    let length = |tool: u32| if has_lengths { format!("G43 H{tool} ") } else { String::new() };
    let begin =
        if has_lengths { "G21 G17 G40 G49 G80 G90 G94\n" } else { "G21 G17 G40 G80 G90 G94\n" };
    let (x, y) = holes[0];
    let more: String = holes[1..].iter().map(|(x, y)| format!("X{x:.3} Y{y:.3}\n")).collect();
    let end = "G80\nG0 Z25.\nM5\nG91 G28 Z0.\nG90\n";
    let drilled = match tool {
        1 => String::new(),
        _ => format!(
            "T1 M6\nG0 G54 X{x:.3} Y{y:.3} S3000 M3\n{}Z25.\nG98 G81 X{x:.3} Y{y:.3} Z-18. R2. F200.\n{more}{end}",
            length(1)
        ),
    };
    let speed = if tool == 2 { 500 } else { 3000 };
    let head = if ["linuxcnc-mill", "grblhal"].contains(&machine) { "" } else { "%\nO1\n" };
    format!(
        "{head}{begin}{drilled}T{tool} M6\nG0 G54 X{x:.3} Y{y:.3} S{speed} {spindle}\n{}Z25.\n{cycle}\n{more}{end}M30\n",
        length(tool)
    )
}

#[test]
fn every_cycle_of_every_mill_is_clean() {
    for machine in MILLS {
        let setup = plate(machine, machine != "grblhal");
        for (code, words, tool) in cycles(machine) {
            let spindle = if code == 74 { "M4" } else { "M3" };
            let cycle = format!("G98 G{code} X8. Y10. Z-15. R2. {words}");
            let program =
                program(machine, &cycle, tool, spindle, &[(8.0, 10.0), (18.0, 10.0), (50.0, 30.0)]);
            let found = run(&setup, &program);
            let said: Vec<String> =
                found.report.diagnostics.iter().map(|each| each.message.clone()).collect();
            assert_eq!(found.verdict, StockVerdict::Clean, "{machine} G{code}: {said:?}");
        }
    }
}

#[test]
fn random_plates_are_clean_and_planted_touches_are_found() {
    for round in 0..rounds() {
        let mut random = Random::new(0xd411 + round);
        let machine = MILLS[round as usize % MILLS.len()];
        let setup = plate(machine, machine != "grblhal");
        let all = cycles(machine);
        let (code, words, tool) = all[(random.share() * all.len() as f64) as usize];
        let spindle = if code == 74 { "M4" } else { "M3" };
        // On both sides of the clamp, so far from each other and from it that no tool meets it.
        let holes: Vec<(f64, f64)> = (0..6)
            .map(|index| {
                let (column, row) = (f64::from(index / 3), f64::from(index % 3));
                let x = 8.0 + 40.0 * column + random.between(-2.0, 8.0);
                (x, 8.0 + 12.0 * row + random.between(-1.0, 1.0))
            })
            .collect();
        let depth = random.between(3.0, 17.0);
        let (x, y) = holes[0];
        let at = |back: &str, r: f64| {
            let cycle = format!("{back} G{code} X{x:.3} Y{y:.3} Z-{depth:.3} R{r:.3} {words}");
            program(machine, &cycle, tool, spindle, &holes)
        };
        let found = run(&setup, &at("G98", 2.0));
        assert_eq!(found.verdict, StockVerdict::Clean, "{machine} G{code}, round {round}");
        // Between the holes only up to R: through the clamp.
        let touched = run(&setup, &at("G99", random.between(1.0, 10.0)));
        let hit = touched.problems.iter().any(|each| each.code.info().name == "fixture-hit");
        assert!(hit, "{machine} G{code}, round {round}: {:?}", touched.problems);
        // R in the material: the rapid there touches, where nothing was drilled before.
        if tool == 1 {
            let below = run(&setup, &at("G98", -random.between(2.0, 2.9)));
            let hit =
                below.problems.iter().any(|each| each.code.info().name == "rapid-through-stock");
            assert!(hit, "{machine} G{code}, round {round}");
        }
    }
}

/// A slot of 40 mm, 3 mm deep, and what comes after it in the same tool.
fn slotted(blocks: &str) -> String {
    format!(
        "O1\nG21 G17 G40 G49 G80 G90\nT3 M6\nG0 G54 X10. Y30. S3000 M3\nG43 H3 Z25.\nZ2.\nG1 Z-3. F200.\nX20.\nX24. F400.\n{blocks}\nG0 Z25.\nM30\n"
    )
}

#[test]
fn a_slot_is_entered_again_along_the_path_that_cut_it() {
    let setup = plate("fanuc-0i", true).replace("[fixtures.clamp]", "[fixtures.far]").replace(
        "from = { X = \"25 mm\", Y = \"0 mm\", Z = \"0 mm\" }",
        "from = { X = \"33 mm\", Y = \"0 mm\", Z = \"0 mm\" }",
    );
    for (blocks, verdict) in [
        // Back in two blocks of the cut at once, and down again where the tool went down.
        ("G0 X10.", StockVerdict::Clean),
        ("G0 Z2.\nX10.\nZ-3.", StockVerdict::Clean),
        ("G0 Z-1.\nX12.\nZ-3.", StockVerdict::NotProved),
        // Deeper, or farther, than anything was cut.
        ("G0 Z2.\nX10.\nZ-5.", StockVerdict::Problems),
        ("G0 X7.", StockVerdict::Problems),
    ] {
        let found = run(&setup, &slotted(blocks));
        assert_eq!(found.verdict, verdict, "{blocks}: {:?}", found.problems);
    }
}

#[test]
fn a_disc_below_material_touches_it_straight_up() {
    let setup = plate("fanuc-0i", true).replace(
        "shape = \"flat\"\ndiameter = \"7 mm\"\nflute_length = \"30 mm\"",
        "shape = \"t-slot\"\ndiameter = \"16 mm\"\nflute_length = \"4 mm\"\nshank_diameter = \"6 mm\"",
    );
    let program = "O1\nG21 G17 G40 G49 G80 G90\nT1 M6\nG0 G54 X10. Y-10. S3000 M3\nG43 H1 Z25.\nZ-8.\nG1 Y25. F200.\nG0 Y-10.\n\
                   G0 Z25.\nT3 M6\nG0 X10. Y-15. S800 M3\nG43 H3 Z25.\nZ-8.\nG1 Y20. F100.\nG0 Z25.\nM30\n";
    let found = run(&setup, program);
    assert!(names(&found, 15).contains(&"rapid-through-stock"), "{:?}", found.problems);
    // Back the way it came nothing is touched.
    let back = run(&setup, &program.replace("F100.\nG0 Z25.", "F100.\nG0 Y-15.\nG0 Z25."));
    assert_eq!(names(&back, 16), Vec::<&str>::new());
}
