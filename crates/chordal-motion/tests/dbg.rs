mod support;
use chordal_motion::*;
use support::*;
#[test]
fn dbg() {
    let mix =
        Mix { moves: 60, curves: false, rotary: false, shortest: 0.5, longest: 80.0, turn: 4.0 };
    let mut dice = Dice(mix.moves as u64);
    let limits = random_limits(&mut dice);
    let moves = random_path(&mut dice, &mix);
    let st = plan(&moves, limits, Level::Fast);
    let s = samples(&st, 2.5e-4);
    let p: f64 = 2.5e-4;
    for i in 0..s.len() - 3 {
        let j = (s[i + 3].position[0] - 3.0 * s[i + 2].position[0] + 3.0 * s[i + 1].position[0]
            - s[i].position[0])
            / p.powi(3);
        if j.abs() > limits.jerk()[0] * (1.0 + 2e-6) {
            println!(
                "i {i} t {} j {j} {} {:?}",
                s[i].time_s,
                limits.jerk()[0],
                [s[i].jerk[0], s[i + 1].jerk[0], s[i + 2].jerk[0], s[i + 3].jerk[0]]
            );
            println!("{:?} {:?} {:?}", s[i].position, s[i].velocity, s[i + 3].tag);
        }
    }
    let mut t = 0.0;
    for x in &st {
        t -= x.overlap_s;
        println!(
            "t {t} d {} ov {} phases {} {:?}",
            x.duration_s(),
            x.overlap_s,
            x.phases.len(),
            x.phases.first()
        );
        t += x.duration_s();
    }
}
