//! temporary
#![allow(missing_docs)]
#![allow(clippy::all, clippy::disallowed_methods, clippy::disallowed_types)]
use chordal_geometry::*;
use chordal_motion::*;
fn main() {
    let limit = AxisLimit {
        velocity: 200.0,
        acceleration: 2000.0,
        jerk: std::env::var("J").map_or(1e5, |j| j.parse().unwrap()),
    };
    let limits = Limits::new([Some(limit), Some(limit), Some(limit), None, None, None]).unwrap();
    for file in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&file).unwrap();
        let (mut p, mut f, mut corner) = (Vec3::ZERO, 0.0, Corner::Exact);
        let mut planner = Planner::new(limits, PlannerOptions::new(Level::Fast));
        let (mut total, mut stretches, mut phases, mut used, mut rest) =
            (0.0, 0, 0, Use::default(), 0.0);
        let mut length = 0.0;

        let mut all: Vec<Stretch> = vec![];
        let mut tag = 0;
        let mut take = |step: Step<'_>| {
            if let Step::Stretch(s) = step {
                total += s.duration_s() - s.overlap_s;
                rest += s.overlap_s;
                all.push(s.clone());
                stretches += 1;
                phases += s.phases.len();
                used = used.or(largest_use(s, &limits, 5));
            }
        };
        for line in text.lines() {
            tag += 1;
            let w: Vec<(char, f64)> = line
                .split_whitespace()
                .map(|x| (x.as_bytes()[0] as char, x[1..].parse().unwrap()))
                .collect();
            let get = |c: char| w.iter().find(|x| x.0 == c).map(|x| x.1);
            if let Some(v) = get('F') {
                f = v / 60.0;
            }
            let g: Vec<f64> = w.iter().filter(|x| x.0 == 'G').map(|x| x.1).collect();
            if g.contains(&64.0) {
                let e = get('P').unwrap_or(0.0);
                if e > 0.0 {
                    corner = Corner::Within { linear_mm: e, rotary_rad: 1e-4 };
                }
            }
            if g.contains(&61.1) {
                corner = Corner::Stop;
            }
            let end = Vec3::new(
                get('X').unwrap_or(p.x),
                get('Y').unwrap_or(p.y),
                get('Z').unwrap_or(p.z),
            );
            let curve: Curve = if g.contains(&1.0) || (g.is_empty() && get('X').is_some()) {
                Line { start: p, end }.into()
            } else if g.contains(&2.0) || g.contains(&3.0) {
                let d = if g.contains(&2.0) { Direction::Cw } else { Direction::Ccw };
                let c = (p.x + get('I').unwrap_or(0.0), p.y + get('J').unwrap_or(0.0));
                arc_from_center(Plane::Xy, p, end, c, d, get('P').unwrap_or(1.0) as u32 - 1, 1e-3)
                    .curve
            } else {
                continue;
            };
            p = end;
            length += curve.length();
            planner
                .push(
                    &Move {
                        curve,
                        rotary_from: [0.0; 3],
                        rotary_to: [0.0; 3],
                        speed: f,
                        corner,
                        kind: MoveKind::Cut,
                        tag,
                    },
                    &mut take,
                )
                .unwrap();
        }
        planner.finish(&mut take);
        let mut gauge = Gauge::new(limits, Effort::default());
        for s in &all {
            gauge.push(Step::Stretch(s), |_| f, |_| {});
        }
        let least = gauge.finish(|_| {});
        println!(
            "bound {:.4} ref {:.4} ratio {:.4}",
            least.bound_s,
            least.reference_s,
            total / least.reference_s
        );
        println!(
            "{:28} {total:9.4} s  L {length:8.3}  L/F {:8.4} stretches {stretches} phases {phases} overlap {rest:.4} v {:.4} a {:.4} j {:.6}",
            file.rsplit('/').next().unwrap(),
            length / f,
            used.velocity,
            used.acceleration,
            used.jerk
        );
    }
}
