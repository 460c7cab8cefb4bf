//! Pockets with islands, parallels of open chains, and corners, against distances that are measured here.

use core::f64::consts::{PI, TAU};

use chordal_geometry::Vec2;

use super::*;

/// Permitted rounding, mm.
const EXACT_MM: f64 = 1e-6;

fn line(a: [f64; 2], b: [f64; 2]) -> OutlineElement {
    OutlineElement::Line { from: Vec2::new(a[0], a[1]), to: Vec2::new(b[0], b[1]) }
}

fn polygon(points: &[[f64; 2]]) -> Vec<OutlineElement> {
    let next = |index: usize| points[(index + 1) % points.len()];
    (0..points.len()).map(|index| line(points[index], next(index))).collect()
}

fn disc(center: [f64; 2], radius: f64) -> Vec<OutlineElement> {
    let center = Vec2::new(center[0], center[1]);
    let from = center + Vec2::new(radius, 0.0);
    vec![OutlineElement::Arc { from, to: from, center, sweep: TAU }]
}

fn outline(elements: Vec<OutlineElement>) -> Outline {
    Outline::new(elements, 1e-6).expect("an outline")
}

fn random(state: &mut u64) -> f64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    (*state % 1_000_000) as f64 / 1e6
}

/// A rectangle of 100 by 70 with round and square islands at random places, apart from each other.
fn pocket(state: &mut u64) -> (IslandPocket, Vec<([f64; 2], f64)>) {
    let mut discs: Vec<([f64; 2], f64)> = Vec::new();
    for _ in 0..4 {
        let radius = 4.0 + 9.0 * random(state);
        let center = [20.0 + 60.0 * random(state), 20.0 + 30.0 * random(state)];
        let fits = |own: &([f64; 2], f64)| {
            (center[0] - own.0[0]).hypot(center[1] - own.0[1]) > radius + own.1 + 0.5
        };
        if discs.iter().all(fits) {
            discs.push((center, radius));
        }
    }
    let wall = outline(polygon(&[[0.0, 0.0], [100.0, 0.0], [100.0, 70.0], [0.0, 70.0]]));
    let islands = discs.iter().map(|(center, radius)| outline(disc(*center, *radius))).collect();
    (IslandPocket::new(wall, islands).expect("a pocket"), discs)
}

/// The distance of a point from the walls of that pocket, by hand: negative outside.
fn room(p: Vec2, discs: &[([f64; 2], f64)]) -> f64 {
    let wall = p.a.min(100.0 - p.a).min(p.b).min(70.0 - p.b);
    let islands = discs.iter().map(|(center, r)| (p.a - center[0]).hypot(p.b - center[1]) - r);
    islands.fold(wall, f64::min)
}

fn nearest(elements: &[OutlineElement], p: Vec2) -> f64 {
    elements.iter().map(|own| own.distance(p)).fold(f64::INFINITY, f64::min)
}

#[test]
fn borders_are_where_the_tool_touches() {
    let mut state = 7;
    for _ in 0..60 {
        let (pocket, discs) = pocket(&mut state);
        let tool = 2.0 + 4.0 * random(&mut state);
        let borders = pocket.borders(tool);
        let all: Vec<OutlineElement> =
            borders.iter().flat_map(|border| border.elements().to_vec()).collect();
        for own in &all {
            for t in 0..=20 {
                let found = room(own.point(f64::from(t) / 20.0), &discs);
                assert!((found - tool).abs() < EXACT_MM, "{found} is not {tool}");
            }
        }
        // Where there is room for the tool and less than a thousandth more, there is a border.
        for i in 0..400 {
            for j in 0..280 {
                let p = Vec2::new(0.25 * f64::from(i), 0.25 * f64::from(j));
                let left = room(p, &discs) - tool;
                if left.abs() < 0.02 {
                    assert!(nearest(&all, p) < 0.5, "no border at {p:?}");
                }
            }
        }
    }
}

#[test]
fn rings_clear_a_pocket_and_never_cut_a_wall() {
    let mut state = 99;
    for _ in 0..40 {
        let (pocket, discs) = pocket(&mut state);
        let tool = 2.0 + 3.0 * random(&mut state);
        let rings = pocket.rings(tool, tool, 1000).expect("rings");
        let all: Vec<OutlineElement> =
            rings.iter().flatten().flat_map(|ring| ring.elements().to_vec()).collect();
        for own in &all {
            for t in 0..=20 {
                assert!(room(own.point(f64::from(t) / 20.0), &discs) > tool - EXACT_MM);
            }
        }
        for i in 0..200 {
            for j in 0..140 {
                let p = Vec2::new(0.5 * f64::from(i), 0.5 * f64::from(j));
                let left = room(p, &discs);
                if left >= tool {
                    assert!(nearest(&all, p) <= tool + EXACT_MM, "{p:?} with {left} is left");
                }
            }
        }
        // Straight lines that are said to be clear are.
        for _ in 0..200 {
            let place = |state: &mut u64| Vec2::new(100.0 * random(state), 70.0 * random(state));
            let (from, to) = (place(&mut state), place(&mut state));
            let least =
                (0..=2000).map(|t| room(from + (to - from) * (f64::from(t) / 2000.0), &discs));
            let least = least.fold(f64::INFINITY, f64::min);
            if (least - tool).abs() > 0.1 {
                assert_eq!(pocket.is_clear(tool, from, to), least > tool, "{from:?} {to:?}");
            }
        }
    }
}

#[test]
fn islands_that_touch_are_refused() {
    let wall = || outline(polygon(&[[0.0, 0.0], [50.0, 0.0], [50.0, 50.0], [0.0, 50.0]]));
    let refused = |islands: Vec<Outline>| IslandPocket::new(wall(), islands).is_err();
    assert!(refused(vec![outline(disc([48.0, 20.0], 5.0))]));
    assert!(refused(vec![outline(disc([90.0, 20.0], 5.0))]));
    assert!(refused(vec![outline(disc([20.0, 20.0], 5.0)), outline(disc([27.0, 20.0], 5.0))]));
    assert!(refused(vec![outline(disc([20.0, 20.0], 9.0)), outline(disc([20.0, 20.0], 5.0))]));
    assert!(!refused(vec![outline(disc([20.0, 20.0], 5.0)), outline(disc([35.0, 20.0], 5.0))]));
}

#[test]
fn parallels_keep_their_distance_or_are_refused() {
    let mut state = 5;
    let (mut made, mut refused) = (0, 0);
    for _ in 0..3000 {
        // A random chain of lines that never goes back far, and an arc at its end.
        let mut points = vec![[0.0, 0.0]];
        for _ in 0..5 {
            let last = points[points.len() - 1];
            points.push([last[0] + 5.0 + 20.0 * random(&mut state), 30.0 * random(&mut state)]);
        }
        let mut chain: Vec<OutlineElement> =
            points.windows(2).map(|pair| line(pair[0], pair[1])).collect();
        let end = chain[chain.len() - 1].to();
        let radius = 3.0 + 10.0 * random(&mut state);
        let sign = if random(&mut state) < 0.5 { 1.0 } else { -1.0 };
        let center = end + Vec2::new(radius, 0.0);
        let to = center + Vec2::new(0.0, -radius * sign);
        chain.push(OutlineElement::Arc { from: end, to, center, sweep: sign * PI / 2.0 });
        let distance =
            (if random(&mut state) < 0.5 { 1.0 } else { -1.0 }) * (0.5 + 6.0 * random(&mut state));
        let Ok(path) = offset_train(&chain, distance) else {
            refused += 1;
            continue;
        };
        made += 1;
        for pair in path.windows(2) {
            assert!(pair[0].to().distance(pair[1].from()) < EXACT_MM);
        }
        for own in &path {
            for t in 0..=40 {
                let found = nearest(&chain, own.point(f64::from(t) / 40.0));
                assert!((found - distance.abs()).abs() < 2e-5, "{found} is not {distance}");
            }
        }
        // It lies on its side at both ends, perpendicular to them.
        let begin = path[0].from() - chain[0].from();
        let along = chain[0].to() - chain[0].from();
        assert!(begin.dot(along).abs() < 1e-6 * along.length() || path.len() < chain.len());
        assert!(along.cross(begin) * distance > 0.0);
    }
    assert!(made > 1000 && refused > 100, "{made} made, {refused} refused");
}

#[test]
fn roundings_touch_both_elements() {
    let first = line([0.0, 0.0], [40.0, 0.0]);
    let second = line([40.0, 0.0], [40.0, 30.0]);
    let [a, arc, b] = rounded(&first, &second, 5.0).expect("a rounding");
    assert!(a.to().distance(Vec2::new(35.0, 0.0)) < EXACT_MM);
    assert!(b.from().distance(Vec2::new(40.0, 5.0)) < EXACT_MM);
    let OutlineElement::Arc { center, sweep, .. } = arc else { panic!("an arc") };
    assert!(center.distance(Vec2::new(35.0, 5.0)) < EXACT_MM);
    assert!((sweep - PI / 2.0).abs() < 1e-9);
    assert!(rounded(&first, &second, 31.0).is_none());
    // A line into an arc: both tangent points are at the radius from the centre of the rounding.
    let (center, end) = (Vec2::new(40.0, 20.0), Vec2::new(60.0, 20.0));
    let bow = OutlineElement::Arc { from: Vec2::new(40.0, 0.0), to: end, center, sweep: PI / 2.0 };
    assert!(rounded(&first, &bow, 3.0).is_none(), "they are tangent");
    let back = OutlineElement::Arc {
        from: Vec2::new(40.0, 0.0),
        to: Vec2::new(40.0, 40.0),
        center,
        sweep: -PI,
    };
    let steep = line([0.0, -30.0], [40.0, 0.0]);
    for (one, other) in [(steep, back), (back.reversed(), steep.reversed())] {
        let [a, arc, b] = rounded(&one, &other, 2.0).expect("a rounding");
        let OutlineElement::Arc { from, to, center, .. } = arc else { panic!("an arc") };
        assert!((from.distance(center) - 2.0).abs() < EXACT_MM);
        assert!((to.distance(center) - 2.0).abs() < EXACT_MM);
        let tangent = |own: &OutlineElement, t: f64, arc_t: f64| {
            let (u, v) = (own.direction(t), arc.direction(arc_t));
            u.zip(v).is_some_and(|(u, v)| u.cross(v).abs() < 1e-6 && u.dot(v) > 0.0)
        };
        assert!(tangent(&a, 1.0, 0.0) && tangent(&b, 0.0, 1.0));
    }
    let [a, cut, b] = chamfered(&first, &second, 10.0).expect("a chamfer");
    assert!((cut.length() - 200.0_f64.sqrt()).abs() < EXACT_MM);
    assert!((a.length() - 30.0).abs() < EXACT_MM && (b.length() - 20.0).abs() < EXACT_MM);
}
