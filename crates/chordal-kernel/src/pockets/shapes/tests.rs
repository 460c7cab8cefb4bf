//! Pockets on a grid of points: everything that a tool can reach is cut, nothing else is.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_geometry::{TurnDirection, Vec2};

use super::outline::OutlineElement;
use super::*;

/// Permitted rounding, mm; far below the documented 1e-6.
const EXACT_MM: f64 = 1e-7;

/// A path as elements, to measure distances with.
fn elements(start: Vec2, steps: &[Step]) -> Vec<OutlineElement> {
    let mut from = start;
    let mut all = Vec::new();
    for step in steps {
        let to = step.to();
        all.push(match *step {
            Step::Line { .. } => OutlineElement::Line { from, to },
            Step::Arc { center, sweep, .. } => {
                let (r0, r1) = (from.distance(center), to.distance(center));
                assert!((r0 - r1).abs() < 1e-4, "an arc from radius {r0} to {r1}");
                OutlineElement::Arc { from, to, center, sweep }
            }
        });
        from = to;
    }
    all
}

fn distance(path: &[OutlineElement], p: Vec2) -> f64 {
    path.iter().map(|element| element.distance(p)).fold(f64::INFINITY, f64::min)
}

/// Closely spaced points of the path.
fn samples(path: &[OutlineElement]) -> impl Iterator<Item = Vec2> + '_ {
    path.iter().flat_map(|element| (0..=40).map(|i| element.point(f64::from(i) / 40.0)))
}

fn grid(low: Vec2, high: Vec2, count: u32) -> impl Iterator<Item = Vec2> {
    (0..=count).flat_map(move |i| {
        (0..=count).map(move |j| {
            let (u, v) = (f64::from(i) / f64::from(count), f64::from(j) / f64::from(count));
            Vec2::new(low.a + (high.a - low.a) * u, low.b + (high.b - low.b) * v)
        })
    })
}

#[test]
fn a_rectangle_is_cut_wall_to_wall_without_islands() {
    let sizes = [(2.98, 1.98), (3.0, 3.0), (1.0, 6.0), (8.0, 0.5), (0.5, 0.5), (0.51, 0.52)];
    for (x, y) in sizes {
        for tool in [0.25, 0.1875, 0.04] {
            for direction in [TurnDirection::Cw, TurnDirection::Ccw] {
                let half = Vec2::new(x / 2.0 - tool, y / 2.0 - tool);
                let steps = rectangle(half, CORNER_STEP * tool, direction, 10_000).unwrap();
                let path = elements(Vec2::ZERO, &steps);
                for p in samples(&path) {
                    assert!(p.a.abs() <= half.a + EXACT_MM && p.b.abs() <= half.b + EXACT_MM);
                }
                let all = Vec2::new(x / 2.0, y / 2.0);
                for p in grid(-all, all, 60) {
                    // The corners keep the tool's radius.
                    let reach = Vec2::new(p.a.abs().min(half.a), p.b.abs().min(half.b));
                    let corner = Vec2::new(p.a.abs(), p.b.abs()).distance(reach) > tool;
                    let away = if path.is_empty() { p.length() } else { distance(&path, p) };
                    assert!(corner || away <= tool + 1e-9, "{x} x {y}, {tool}: {p:?} is left");
                }
                assert_eq!(steps.last().map_or(Vec2::ZERO, Step::to), Vec2::ZERO);
            }
        }
    }
}

#[test]
fn a_wider_step_leaves_islands_between_the_corners() {
    // The reason for the limit: with 1.9 radii the point between two corners is not cut.
    let steps = rectangle(Vec2::new(1.9, 1.9), 1.9, TurnDirection::Ccw, 10).unwrap();
    let path = elements(Vec2::ZERO, &steps);
    assert!(distance(&path, Vec2::new(0.8, 0.8)) > 1.0);
}

#[test]
fn directions_turn_as_they_say() {
    for (half, direction) in [
        (Vec2::new(2.0, 1.0), TurnDirection::Ccw),
        (Vec2::new(1.0, 2.0), TurnDirection::Ccw),
        (Vec2::new(2.0, 1.0), TurnDirection::Cw),
        (Vec2::new(1.0, 2.0), TurnDirection::Cw),
    ] {
        let steps = rectangle(half, 5.0, direction, 10).unwrap();
        let mut from = Vec2::ZERO;
        let mut twice_area = 0.0;
        for step in &steps {
            twice_area += from.cross(step.to());
            from = step.to();
        }
        assert_eq!(twice_area.signum(), direction.sign());
        assert_eq!(twice_area.abs(), 16.0);
    }
}

#[test]
fn a_round_pocket_is_cut_and_its_arcs_are_tangent() {
    let cases: [(f64, f64, TurnDirection); 3] = [
        (1.5, 0.125, TurnDirection::Ccw),
        (0.4, 0.25, TurnDirection::Cw),
        (7.0, 1.0, TurnDirection::Ccw),
    ];
    for (radius, tool, direction) in cases {
        let last = radius - tool;
        let count = (last / (2.0 * tool)).ceil();
        let radii: Vec<f64> = (1..=count as u32).map(|k| last * f64::from(k) / count).collect();
        let steps = rings(&radii, 1, direction);
        let path = elements(Vec2::ZERO, &steps);
        for p in samples(&path) {
            assert!(p.length() <= last + EXACT_MM);
        }
        for p in grid(Vec2::new(-radius, -radius), Vec2::new(radius, radius), 80) {
            assert!(p.length() > radius || distance(&path, p) <= tool + 1e-9, "{p:?} is left");
        }
        let leaving = |element: &OutlineElement, at: f64| match *element {
            OutlineElement::Line { .. } => panic!("all cutting is circular"),
            OutlineElement::Arc { center, sweep, .. } => {
                (element.point(at) - center).turned_left() * sweep.signum()
            }
        };
        for pair in path.windows(2) {
            let (a, b) = (leaving(&pair[0], 1.0), leaving(&pair[1], 0.0));
            assert!(a.cross(b).abs() < 1e-9 * a.length() * b.length() && a.dot(b) > 0.0);
        }
    }
}

#[test]
fn the_length_of_the_manuals_pocket() {
    // I.3 K1.5 Q.3 with a radius of .125: 11.625 pi.
    let radii = ring_radii(0.3, 0.3, 1.5, 100).unwrap();
    assert_eq!(radii.len(), 5);
    let centers: Vec<f64> = radii.iter().map(|radius| radius - 0.125).collect();
    let path = elements(Vec2::ZERO, &rings(&centers, 1, TurnDirection::Ccw));
    let length: f64 = path.iter().map(OutlineElement::length).sum();
    assert!((length - 11.625 * PI).abs() < 1e-12);
    assert_eq!(ring_radii(0.3, 0.5, 1.5, 100).unwrap(), [0.3, 0.8, 1.3, 1.5]);
    assert_eq!(ring_radii(0.3, 1e-9, 1.5, 100), None);
}

fn polygon(corners: &[(f64, f64)]) -> Outline {
    let points: Vec<Vec2> = corners.iter().map(|(a, b)| Vec2::new(*a, *b)).collect();
    let elements = (0..points.len())
        .map(|i| OutlineElement::Line { from: points[i], to: points[(i + 1) % points.len()] })
        .collect();
    Outline::new(elements, 1e-3).unwrap()
}

/// A slot with round ends, 40 x 20, about the origin.
fn slot() -> Outline {
    let p = Vec2::new;
    let elements = vec![
        OutlineElement::Line { from: p(-10.0, -10.0), to: p(10.0, -10.0) },
        OutlineElement::Arc {
            from: p(10.0, -10.0),
            to: p(10.0, 10.0),
            center: p(10.0, 0.0),
            sweep: PI,
        },
        OutlineElement::Line { from: p(10.0, 10.0), to: p(-10.0, 10.0) },
        OutlineElement::Arc {
            from: p(-10.0, 10.0),
            to: p(-10.0, -10.0),
            center: p(-10.0, 0.0),
            sweep: PI,
        },
    ];
    Outline::new(elements, 1e-3).unwrap()
}

/// A square of 40 with a round bay into it and a rounded corner.
fn bay() -> Outline {
    let p = Vec2::new;
    let elements = vec![
        OutlineElement::Line { from: p(-20.0, -20.0), to: p(-6.0, -20.0) },
        OutlineElement::Arc {
            from: p(-6.0, -20.0),
            to: p(6.0, -20.0),
            center: p(0.0, -20.0),
            sweep: -PI,
        },
        OutlineElement::Line { from: p(6.0, -20.0), to: p(20.0, -20.0) },
        OutlineElement::Line { from: p(20.0, -20.0), to: p(20.0, 10.0) },
        OutlineElement::Arc {
            from: p(20.0, 10.0),
            to: p(10.0, 20.0),
            center: p(10.0, 10.0),
            sweep: FRAC_PI_2,
        },
        OutlineElement::Line { from: p(10.0, 20.0), to: p(-20.0, 20.0) },
        OutlineElement::Line { from: p(-20.0, 20.0), to: p(-20.0, -20.0) },
    ];
    Outline::new(elements, 1e-3).unwrap()
}

fn l_shape() -> Outline {
    polygon(&[(0.0, 0.0), (50.0, 0.0), (50.0, 15.0), (15.0, 15.0), (15.0, 40.0), (0.0, 40.0)])
}

/// Two rooms and a throat of 4 between them, given clockwise.
fn rooms() -> Outline {
    polygon(&[
        (0.0, 0.0),
        (0.0, 20.0),
        (20.0, 20.0),
        (20.0, 12.0),
        (30.0, 12.0),
        (30.0, 20.0),
        (50.0, 20.0),
        (50.0, 0.0),
        (30.0, 0.0),
        (30.0, 8.0),
        (20.0, 8.0),
        (20.0, 0.0),
    ])
}

/// A star of pseudo-random reach: sharp corners, throats, arms.
fn star(seed: u64) -> Outline {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let count = 5 + (random() * 12.0) as u32;
    let corners: Vec<(f64, f64)> = (0..count)
        .map(|i| {
            let angle = TAU * (f64::from(i) + 0.6 * random()) / f64::from(count);
            let reach = 8.0 + 22.0 * random();
            (reach * libm::cos(angle), reach * libm::sin(angle))
        })
        .collect();
    polygon(&corners)
}

/// The same star with some of its sides bent in or out. `None` where they cross.
fn bent_star(seed: u64) -> Option<Outline> {
    let star = star(seed);
    let elements = star
        .elements()
        .iter()
        .enumerate()
        .map(|(index, element)| {
            let (from, to) = (element.from(), element.to());
            let half = (to - from) * 0.5;
            let bend = match (seed as usize + index) % 4 {
                0 => 2.0,
                1 => -1.5,
                2 => -6.0,
                _ => return *element,
            };
            let center = from + half + half.turned_left() * bend;
            let angle = 2.0 * libm::atan(1.0 / bend);
            OutlineElement::Arc { from, to, center, sweep: angle }
        })
        .collect();
    Outline::new(elements, 1e-3).ok()
}

/// Checks that everything within `tool` of a permitted centre, in the part of the start, is cut, and that the
/// centre stays in its region. True when the start lies in a part.
fn check_cleared(outline: &Outline, tool: f64, start: Vec2, along: RasterAlong, step: f64) -> bool {
    let border = inset(outline, tool);
    for part in &border {
        for element in part.elements() {
            for i in 0..=20 {
                let away = outline.distance(element.point(f64::from(i) / 20.0));
                // Nearer only by rounding; further by arcs that are too short to keep.
                let touches = (-1e-6..1e-5).contains(&(away - tool));
                assert!(touches, "the border is {away} away, not {tool}");
            }
        }
    }
    let Some(region) = PocketRegion::around(outline, &border, tool, start) else { return false };
    let steps = region.clear(along, step, 10_000).unwrap();
    assert_eq!(steps.last().map(Step::to), Some(start));
    let path = elements(start, &steps);
    for p in samples(&path) {
        let away = outline.distance(p);
        assert!(away >= tool - 1e-6 && outline.contains(p), "{p:?} is {away} from the wall");
    }
    // Every permitted centre is within a tool radius of the path, or in another part.
    let part = |p: Vec2| border.iter().position(|border| border.contains(p));
    let home = part(start);
    let reach = 60.0;
    for p in grid(Vec2::new(-reach, -reach), Vec2::new(reach, reach), 70) {
        let free = outline.contains(p) && outline.distance(p) >= tool + 1e-3;
        if !free {
            continue;
        }
        assert!(part(p).is_some(), "the border forgets {p:?}");
        if part(p) != home {
            continue;
        }
        let away = distance(&path, p);
        assert!(away <= tool + 1e-6, "{p:?} is left: the tool passes at {away}");
        // So is everything that the tool would cut from there, in every direction.
        for i in 0..8 {
            let angle = TAU * f64::from(i) / 8.0;
            let q = p + Vec2::new(libm::cos(angle), libm::sin(angle)) * tool;
            assert!(distance(&path, q) <= tool + 1e-6, "{q:?} beside {p:?} is left");
        }
    }
    true
}

#[test]
fn outlines_are_cleared_and_never_left() {
    let cases = [
        (slot(), Vec2::new(1.0, 2.0)),
        (bay(), Vec2::new(0.0, 5.0)),
        (l_shape(), Vec2::new(7.0, 7.0)),
        (rooms(), Vec2::new(10.0, 10.0)),
        (rooms(), Vec2::new(42.0, 9.0)),
    ];
    for (outline, start) in &cases {
        for tool in [1.5, 3.175, 5.0] {
            for along in [RasterAlong::First, RasterAlong::Second] {
                for step in [tool, 2.0 * tool] {
                    assert!(check_cleared(outline, tool, *start, along, step));
                }
            }
        }
    }
}

#[test]
fn random_outlines_are_cleared_and_never_left() {
    let mut cleared = 0;
    for seed in 1..=60 {
        let outline = star(seed);
        let tool = 0.7 + f64::from(seed as u32 % 5);
        let along = if seed % 2 == 0 { RasterAlong::First } else { RasterAlong::Second };
        let done = check_cleared(&outline, tool, Vec2::new(0.3, -0.2), along, 1.9 * tool);
        cleared += u32::from(done);
    }
    assert!(cleared > 30, "{cleared}");
}

#[test]
fn random_outlines_with_arcs_are_cleared_and_never_left() {
    let (mut simple, mut cleared) = (0, 0);
    for seed in 1..=60 {
        let Some(outline) = bent_star(seed) else { continue };
        simple += 1;
        let tool = 0.5 + f64::from(seed as u32 % 4);
        let done =
            check_cleared(&outline, tool, Vec2::new(-0.3, 0.4), RasterAlong::Second, 1.7 * tool);
        cleared += u32::from(done);
    }
    assert!(simple > 30 && cleared > 20, "{simple} {cleared}");
}

/// A rectangle of 60 x 40 with corners of radius 5, whose points are off by `noise`.
fn rounded(noise: f64) -> Outline {
    let p = Vec2::new;
    let n = noise;
    let arc = |from: Vec2, to: Vec2, center: Vec2| OutlineElement::Arc {
        from,
        to,
        center,
        sweep: FRAC_PI_2,
    };
    let elements = vec![
        OutlineElement::Line { from: p(0.0, -20.0), to: p(25.0 + n, -20.0) },
        arc(p(25.0 + n, -20.0), p(30.0, -15.0 - n), p(25.0, -15.0)),
        OutlineElement::Line { from: p(30.0, -15.0 - n), to: p(30.0, 15.0 - n) },
        arc(p(30.0, 15.0 - n), p(25.0 + n, 20.0), p(25.0, 15.0)),
        OutlineElement::Line { from: p(25.0 + n, 20.0), to: p(-25.0 + n, 20.0) },
        arc(p(-25.0 + n, 20.0), p(-30.0, 15.0 + n), p(-25.0, 15.0)),
        OutlineElement::Line { from: p(-30.0, 15.0 + n), to: p(-30.0, -15.0) },
        arc(p(-30.0, -15.0), p(-25.0, -20.0 + n), p(-25.0, -15.0)),
        OutlineElement::Line { from: p(-25.0, -20.0 + n), to: p(0.0, -20.0) },
    ];
    Outline::new(elements, 1e-2).unwrap()
}

#[test]
fn a_tool_as_large_as_the_corners_and_corners_off_by_rounding() {
    for noise in [0.0, 1e-9, 5e-7, 1e-4, 2e-3, -2e-3] {
        let outline = rounded(noise);
        for off in [0.0, 1e-12, -1e-9, -1e-6, 1e-4, -1e-4, 2.0, -2.0] {
            let border = inset(&outline, 5.0 + off);
            assert_eq!(border.len(), 1, "{noise} {off}");
            let cleared =
                check_cleared(&outline, 5.0 + off, Vec2::new(1.0, 2.0), RasterAlong::First, 5.0);
            assert!(cleared, "{noise} {off}");
        }
    }
    // A slot as wide as the tool is a line there and back.
    for off in [0.0, -1e-9, -1e-6, -1e-4] {
        let border = inset(&slot(), 10.0 + off);
        let length: f64 =
            border.iter().flat_map(Outline::elements).map(OutlineElement::length).sum();
        assert!(border.len() == 1 && (length - 40.0).abs() < 1e-2, "{off}: {length}");
    }
}

#[test]
fn the_border_of_a_square_and_of_a_throat() {
    let square = polygon(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)]);
    let border = inset(&square, 2.0);
    assert_eq!(border.len(), 1);
    let length: f64 = border[0].elements().iter().map(OutlineElement::length).sum();
    assert!((length - 24.0).abs() < 1e-9);
    assert!(inset(&square, 5.1).is_empty());
    // A throat of 4: a tool of radius 1.5 passes, one of 3 finds two rooms.
    assert_eq!(inset(&rooms(), 1.5).len(), 1);
    assert_eq!(inset(&rooms(), 3.0).len(), 2);
    assert!(rooms().was_clockwise());
    // An inside arc smaller than the tool goes, and the walls meet.
    let border = inset(&bay(), 12.0);
    assert_eq!(border.len(), 1);
}

#[test]
fn what_is_no_outline() {
    let p = Vec2::new;
    let lines = |points: &[(f64, f64)]| -> Vec<OutlineElement> {
        points
            .windows(2)
            .map(|w| OutlineElement::Line { from: p(w[0].0, w[0].1), to: p(w[1].0, w[1].1) })
            .collect()
    };
    let open = Outline::new(lines(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)]), 1e-2);
    assert!(matches!(open, Err(OutlineError::Open(gap)) if (gap - 200f64.sqrt()).abs() < 1e-12));
    let bow = lines(&[(0.0, 0.0), (10.0, 10.0), (10.0, 0.0), (0.0, 10.0), (0.0, 0.0)]);
    assert_eq!(Outline::new(bow, 1e-2).err(), Some(OutlineError::CrossesItself(p(5.0, 5.0))));
    let back = lines(&[(0.0, 0.0), (10.0, 0.0), (5.0, 0.0), (0.0, 0.0)]);
    assert!(Outline::new(back, 1e-2).is_err());
    assert_eq!(Outline::new(Vec::new(), 1e-2).err(), Some(OutlineError::Empty));
    let circle = OutlineElement::Arc {
        from: p(1.0, 0.0),
        to: p(1.0, 0.0),
        center: p(0.0, 0.0),
        sweep: -TAU,
    };
    assert!(Outline::new(vec![circle], 1e-2).unwrap().was_clockwise());
}
