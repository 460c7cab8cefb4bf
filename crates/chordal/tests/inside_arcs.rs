//! Inside arcs as large as the offset: the tool centre stands still on them and cuts no wall. A control that runs them has no
//! alarm, so there is no false one; where it refuses them there is.

use chordal::{Job, Machine, Source, SourceMap};

/// The codes about interference that a program is told, each once, and how many are errors.
fn told(machine: &str, diameter: &str, text: &str) -> (Vec<&'static str>, usize) {
    let mut machine = Machine::from_builtin(machine).unwrap();
    machine.set(&format!("tools.1.diameter={diameter}")).unwrap();
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    let found = Job::new(sources, machine).unwrap().check();
    let about = |id: &str| id.starts_with("CH5");
    let mut codes: Vec<&str> =
        found.diagnostics.iter().map(|problem| problem.code.id()).filter(|id| about(id)).collect();
    codes.sort_unstable();
    codes.dedup();
    let errors = found
        .diagnostics
        .iter()
        .filter(|problem| about(problem.code.id()) && problem.severity == chordal::Severity::Error);
    (codes, errors.count())
}

const TAKES: [&str; 4] = ["fanuc-0i", "haas-vf2", "mitsubishi-m700", "fadal-4020"];

/// A pocket of 60 by 44 with fillets of a radius, by R or by the centre, in either direction.
fn pocket(fillet: f64, by_center: bool, climb: bool) -> String {
    let (x, y, r) = (30.0, 22.0, fillet);
    let corner = |end: [f64; 2], way: [f64; 2], code: &str| match by_center {
        true => format!("{code} X{} Y{} I{} J{}\n", end[0], end[1], way[0], way[1]),
        false => format!("{code} X{} Y{} R{r}\n", end[0], end[1]),
    };
    let mut text =
        String::from("G21 G90 G94 G17 G40 G54\nT1 M6\nS900 M3\nG0 X0 Y0 Z5.\nG1 Z-1. F100.\n");
    if climb {
        text += &format!("G41 D1 G1 X{x} Y0.\nG1 Y{}\n", y - r);
        text += &corner([x - r, y], [-r, 0.0], "G3");
        text += &format!("G1 X{}\n", r - x);
        text += &corner([-x, y - r], [0.0, -r], "G3");
        text += &format!("G1 Y{}\n", r - y);
        text += &corner([r - x, -y], [r, 0.0], "G3");
        text += &format!("G1 X{}\n", x - r);
        text += &corner([x, r - y], [0.0, r], "G3");
    } else {
        text += &format!("G42 D1 G1 X{x} Y0.\nG1 Y{}\n", r - y);
        text += &corner([x - r, -y], [-r, 0.0], "G2");
        text += &format!("G1 X{}\n", r - x);
        text += &corner([-x, r - y], [0.0, r], "G2");
        text += &format!("G1 Y{}\n", y - r);
        text += &corner([r - x, y], [r, 0.0], "G2");
        text += &format!("G1 X{}\n", x - r);
        text += &corner([x, y - r], [0.0, -r], "G2");
    }
    text += "G1 Y0.\nG40 G1 X0. Y0.\nG0 Z50.\nM30\n";
    // Whole numbers are thousandths on some controls.
    text.split('\n')
        .map(|line| {
            let word = |word: &str| match word.as_bytes()[0] {
                b'X' | b'Y' | b'I' | b'J' | b'R' if !word.contains('.') => format!("{word}."),
                _ => word.to_string(),
            };
            line.split(' ').filter(|word| !word.is_empty()).map(word).collect::<Vec<_>>().join(" ")
                + "\n"
        })
        .collect()
}

#[test]
fn fillets_of_the_radius_of_the_tool_are_run() {
    for machine in TAKES {
        for fillet in [5.0, 6.35, 3.2] {
            for (by_center, climb) in [(false, true), (true, true), (false, false), (true, false)] {
                let text = pocket(fillet, by_center, climb);
                let diameter = format!("{} mm", 2.0 * fillet);
                assert_eq!(told(machine, &diameter, &text), (vec!["CH507"], 0), "{machine} {text}");
                // A smaller tool meets nothing at all.
                let smaller = format!("{} mm", 2.0 * fillet - 0.4);
                assert_eq!(told(machine, &smaller, &text), (vec![], 0), "{machine} {text}");
            }
        }
    }
}

#[test]
fn a_control_that_refuses_them_has_the_alarm_and_its_falsity() {
    for climb in [true, false] {
        let (codes, errors) = told("linuxcnc-mill", "10 mm", &pocket(5.0, true, climb));
        assert!(errors > 0 && codes == ["CH507", "CH536"], "{codes:?}");
    }
}

#[test]
fn a_lead_in_of_the_radius_of_the_tool_is_run() {
    // The thread mill of the manual, with its cutter of half an inch.
    let text = "G20 G90 G94 G17 G40 G49 G54\nT1 M6\nG0 X0 Y0\nS1000 M3\nG43 H1 Z.1\nG1 Z-.5156 F50.\n\
        G41 X.25 Y-.25 F10. D1\nG3 X.5 Y0 I0 J.25 Z-.5\nI-.5 J0 Z-.375 F20.\nX.25 Y.25 I-.25 J0 Z-.3594\n\
        G40 G1 X0 Y0\nG0 Z.1\nM30\n";
    for machine in ["haas-vf2", "fanuc-0i"] {
        assert_eq!(told(machine, "0.5 in", text), (vec!["CH507"], 0), "{machine}");
    }
}
