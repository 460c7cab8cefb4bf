//! The sense of arcs in G18, a matter that many programs and more forum threads get wrong.
//!
//! All controls follow one rule: the axes of a plane are ordered (X, Y), (Z, X), (Y, Z), G3 turns
//! from the first to the second, G2 back. Seen against the third axis that is counter-clockwise and
//! clockwise. In G18 the third axis is Y, so one has to look from +Y towards the machine's front; a
//! person who draws X to the right and Z up looks from −Y and sees the opposite. A manual that says
//! "G2 and G3 are reversed in G18" describes that drawing. **It does not describe another flip**, and
//! Chordal makes none.
//!
//! The proof is in the numbers of a real profile: read by the rule above, both arcs are tangent to
//! their neighbours and short; flipped, the first would sweep 309.92 degrees and leave its line at a
//! kink of 180 degrees.

use chordal::control::CommandKind;
use chordal::geometry::{ParamCurve, Vec3};
use chordal::path::curve_of;
use chordal::{Job, Machine, Source, SourceMap};

const PROFILE: &str = "S1000 M3 D1
G90 G0 X-5.09 Y0 Z-2.
G18
G1 Z-2.56 F10.
X-3.4585 Z-1.618
X-2.9928 Z-.952 I-.48 K.8314 G2
X-1.86 Z0 I1.1328 K-.198 G3
X0
M2
";

/// Sweep in degrees (0 for lines) and the directions at both ends of each cut.
fn cuts(program: &str) -> Vec<(f64, Vec3, Vec3)> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("profile.nc", program.as_bytes()));
    let machine = Machine::from_builtin("fadal-4020").expect("a built-in machine");
    let job = Job::new(sources, machine).expect("good settings");
    let mut cuts = Vec::new();
    job.report_of_commands(|command| {
        if command.kind.feed().is_none() {
            return;
        }
        let Some(motion) = command.kind.motion() else { return };
        let shape = match &command.kind {
            CommandKind::Arc { shape, .. } => Some(shape),
            _ => None,
        };
        let curve = curve_of(motion, shape);
        let sweep = shape.map_or(0.0, |shape| shape.sweep.to_degrees());
        cuts.push((sweep, curve.tangent_at(0.0), curve.tangent_at(curve.length())));
    });
    cuts
}

fn turn_degrees(before: Vec3, after: Vec3) -> f64 {
    before.cross(after).length().atan2(before.dot(after)).to_degrees()
}

#[test]
fn the_arcs_are_short_and_tangent() {
    let cuts = cuts(PROFILE);
    let sweeps: Vec<f64> = cuts.iter().map(|cut| cut.0).collect();
    assert!((sweeps[2] + 50.08).abs() < 0.005, "clockwise by 50.08: {sweeps:?}");
    assert!((sweeps[3] - 80.09).abs() < 0.005, "counter-clockwise by 80.09: {sweeps:?}");
    for pair in cuts[1..].windows(2) {
        let kink = turn_degrees(pair[0].2, pair[1].1);
        assert!(kink < 0.01, "a kink of {kink} degrees");
    }
}

#[test]
fn the_other_sense_would_be_long_and_kinked() {
    let flipped = PROFILE.replace("K.8314 G2", "K.8314 G3");
    let cuts = cuts(&flipped);
    assert!((cuts[2].0 - 309.92).abs() < 0.005, "{}", cuts[2].0);
    assert!(turn_degrees(cuts[1].2, cuts[2].1) > 179.9);
}

#[test]
fn in_g19_the_same_profile_turns_the_other_way_round() {
    // Y to the right and Z up is seen from +X, against the third axis: no reversal there.
    let in_yz = "S1000 M3 D1
G90 G0 X0 Y-5.09 Z-2.
G19
G1 Z-2.56 F10.
Y-3.4585 Z-1.618
Y-2.9928 Z-.952 J-.48 K.8314 G3
Y-1.86 Z0 J1.1328 K-.198 G2
Y0
M2
";
    let (zx, yz) = (cuts(PROFILE), cuts(in_yz));
    for (a, b) in zx.iter().zip(&yz) {
        assert!((a.0 + b.0).abs() < 1e-9, "{} and {}", a.0, b.0);
    }
}
