//! F of lines with rotary axes: each control counts it in its own way, and a conversion keeps the time.

use chordal_rewrite::convert::prove_text;

use super::*;

/// The cuts of a program: lines with and without rotary axes, a rotary axis alone, inverse time.
const CUTS: &str = "G94 G1 Z0 F200.\nG91 G1 X200. A40. F300.\nX20. A40.\nX5.\nA90.\nX3. Y4. A-12.\n\
                    G93 G1 X10. A10. F2.\nG94 F100. X1.\nG90 G1 Z5. A0 F500.";

fn program(units: &str) -> String {
    format!("O1\n{units} G17 G40 G80 G90\nS100 M3\nG0 X0 Y0 Z5. A0\n{CUTS}\nM30\n")
}

#[test]
fn the_time_is_kept_between_controls_that_count_otherwise() {
    let machines = ["fanuc-30i", "mitsubishi-m700", "linuxcnc-mill", "haas-vf2"];
    for units in ["G21", "G20"] {
        for from in machines {
            let mut own = machine(from);
            own.axes.iter_mut().flatten().for_each(|axis| axis.travel = None);
            let old = job(&program(units), own);
            for to in machines {
                let found = converted(&old, to);
                assert!(
                    found.holds(),
                    "{units} {from} to {to}: {}\n{}",
                    verdict(&found),
                    found.text
                );
            }
        }
    }
}

#[test]
fn f_is_written_for_the_new_rule() {
    let text = |from: &str, to: &str| converted(&job(&program("G21"), machine(from)), to).text;
    // 300 mm/min along 200 mm and 40 degrees is 300 * 200 / sqrt(200² + 40²) along X.
    assert!(text("fanuc-30i", "linuxcnc-mill").contains("X200. A40. F294.174"));
    // And back: what takes 40 s on LinuxCNC is F305.941 there.
    assert!(text("linuxcnc-mill", "fanuc-30i").contains("X200. A40. F305.941"));
    // 90 degrees at 300 deg/min are 18 s; on a diameter of 4 in that is 79.796 mm at 265.988 mm/min.
    assert!(text("fanuc-30i", "haas-vf2").contains("A90. F265.98"));
    assert_eq!(text("fanuc-30i", "mitsubishi-m700").matches("F300.").count(), 1);
}

/// Without the new F the times differ, and the proof sees it.
#[test]
fn a_text_that_keeps_f_is_not_proved() {
    let old = job(&program("G21"), machine("fanuc-30i"));
    let found = converted(&old, "linuxcnc-mill");
    let kept = found.text.replace("F294.174", "F300.");
    assert_ne!(kept, found.text);
    let certificate =
        prove_text(&old, &found, kept, &ConversionOptions::default()).expect("a certificate");
    assert!(!certificate.holds());
}
