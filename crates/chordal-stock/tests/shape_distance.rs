//! Distances of bodies of revolution from shapes, against places sampled in both.

mod common;

use chordal_geometry::{Transform, Vec3};
use chordal_stock::shape::{
    BodyBound, DistanceInterval, Frustum, PassageAnswer, RoundBody, ShapeAxis, TipMotion,
};
use chordal_stock::{CutterProfile, Mesh, SolidShape};
use proptest::prelude::*;

const RESOLUTION: f64 = 1e-7;
const ROUNDING: f64 = 1e-9;

/// Places that cover a shape so that none of it is further from one of them than `spacing`.
#[derive(Clone)]
struct Sampled {
    shape: SolidShape,
    places: Vec<Vec3>,
    spacing: f64,
    /// A closed mesh, of which only the surface is sampled.
    closed: Option<Mesh>,
}

impl std::fmt::Debug for Sampled {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.shape.fmt(f)
    }
}

/// How far a place is from a body with its tip at zero: by the outline of each part in the half plane.
fn from_place(body: &RoundBody, place: Vec3) -> f64 {
    let out = (place.x * place.x + place.y * place.y).sqrt();
    let part = |part: &Frustum| {
        let Frustum { from, to, lower, upper } = *part;
        if from <= place.z && place.z <= to {
            let radius = lower + (upper - lower) * (place.z - from) / (to - from);
            if out <= radius {
                return 0.0;
            }
        }
        let corners = [[0.0, from], [lower, from], [upper, to], [0.0, to]];
        (0..3)
            .map(|at| {
                let ([ax, ay], [bx, by]) = (corners[at], corners[at + 1]);
                let (dx, dy) = (bx - ax, by - ay);
                let whole = dx * dx + dy * dy;
                let t = if whole > 0.0 {
                    (((out - ax) * dx + (place.z - ay) * dy) / whole).clamp(0.0, 1.0)
                } else {
                    0.0
                };
                (ax + t * dx - out).hypot(ay + t * dy - place.z)
            })
            .fold(f64::INFINITY, f64::min)
    };
    body.frustums().iter().map(part).fold(f64::INFINITY, f64::min)
}

fn sampled_mesh(mesh: &Mesh, closed: bool) -> Sampled {
    const PARTS: usize = 8;
    let mut places = Vec::new();
    let mut spacing: f64 = 0.0;
    for triangle in 0..mesh.triangles().len() {
        let [a, b, c] = mesh.corners(triangle);
        for i in 0..=PARTS {
            for j in 0..=PARTS - i {
                let [u, v] = [i, j].map(|part| part as f64 / PARTS as f64);
                places.push(a + (b - a) * u + (c - a) * v);
            }
        }
        let side = a.distance(b).max(b.distance(c)).max(c.distance(a));
        spacing = spacing.max(side / PARTS as f64);
    }
    let shape =
        if closed { SolidShape::solid(mesh.clone()) } else { SolidShape::surface(mesh.clone()) };
    Sampled { shape: shape.unwrap(), places, spacing, closed: closed.then(|| mesh.clone()) }
}

/// A box, a cylinder or a tube: places throughout the body.
fn sampled_body(shape: SolidShape, axis: Option<(ShapeAxis, Vec3, [f64; 2])>) -> Sampled {
    const PARTS: usize = 24;
    let bounds = shape.bounds();
    let size = bounds.size();
    let mut places = Vec::new();
    let parts = || (0..=PARTS).map(|part| part as f64 / PARTS as f64);
    for u in parts() {
        for v in parts() {
            for w in parts() {
                match axis {
                    None => places.push(bounds.min + Vec3::new(u * size.x, v * size.y, w * size.z)),
                    Some((axis, middle, [outer, inner])) => {
                        let (sin, cos) = (v * std::f64::consts::TAU).sin_cos();
                        let radius = inner + (outer - inner) * w;
                        let (p, q) = (radius * cos, radius * sin);
                        let at = |low: f64, size: f64| low + u * size;
                        places.push(match axis {
                            ShapeAxis::X => {
                                Vec3::new(at(bounds.min.x, size.x), middle.y + p, middle.z + q)
                            }
                            ShapeAxis::Y => {
                                Vec3::new(middle.x + p, at(bounds.min.y, size.y), middle.z + q)
                            }
                            ShapeAxis::Z => {
                                Vec3::new(middle.x + p, middle.y + q, at(bounds.min.z, size.z))
                            }
                        });
                    }
                }
            }
        }
    }
    // Half a step in each of three directions; around the axis a step is an arc.
    let step = match axis {
        None => size.length(),
        Some((_, _, [outer, inner])) => {
            size.length() + (outer - inner) + std::f64::consts::TAU * outer
        }
    };
    Sampled { shape, places, spacing: step / PARTS as f64, closed: None }
}

fn number() -> std::ops::Range<f64> {
    -6.0..6.0
}

fn shapes() -> impl Strategy<Value = Sampled> {
    let three = || [number(), number(), number()];
    let boxes = (three(), [0.2..6.0_f64, 0.2..6.0_f64, 0.2..6.0_f64]).prop_map(|(low, size)| {
        let low = Vec3::from_array(low);
        sampled_body(SolidShape::cuboid(low, low + Vec3::from_array(size)).unwrap(), None)
    });
    let axis = prop_oneof![Just(ShapeAxis::X), Just(ShapeAxis::Y), Just(ShapeAxis::Z)];
    let rounds = (axis, three(), 0.3..3.0_f64, number(), 0.2..6.0_f64).prop_map(
        |(axis, middle, outer, from, length)| {
            let middle = Vec3::from_array(middle);
            let shape =
                SolidShape::cylinder(axis, middle, 2.0 * outer, from, from + length).unwrap();
            sampled_body(shape, Some((axis, middle, [outer, 0.0])))
        },
    );
    let along = prop_oneof![Just(ShapeAxis::X), Just(ShapeAxis::Y), Just(ShapeAxis::Z)];
    let tubes = (along, three(), 0.5..6.0_f64, 0.2..0.9_f64, number(), 0.2..6.0_f64).prop_map(
        |(axis, middle, outer, bore, from, length)| {
            let middle = Vec3::from_array(middle);
            let radii = [outer, outer * bore];
            let diameters = radii.map(|radius| 2.0 * radius);
            let shape = SolidShape::tube(axis, middle, diameters, from, from + length).unwrap();
            sampled_body(shape, Some((axis, middle, radii)))
        },
    );
    let meshes = (three(), 3..9_usize, 3..7_usize, any::<bool>()).prop_map(|(turn, u, v, open)| {
        let place =
            Transform::rotation_about(Vec3::ZERO, Vec3::new(1.0, turn[0], turn[1]), turn[2])
                .then(&Transform::translation(Vec3::new(turn[1], turn[2], turn[0])));
        let mesh = common::torus(3.0, 1.0, [u, v], &place);
        if open {
            let some = mesh.triangles()[..u].to_vec();
            sampled_mesh(&Mesh::new(mesh.vertices().to_vec(), some).unwrap(), false)
        } else {
            sampled_mesh(&mesh, true)
        }
    });
    let balls = (three(), 0.5..5.0_f64, 0.0..0.6_f64, 3..9_usize, 2..6_usize).prop_map(
        |(middle, radius, dent, around, rings)| {
            let place = Transform::translation(Vec3::from_array(middle));
            sampled_mesh(&common::ball(radius, dent, [around, rings], &place), true)
        },
    );
    prop_oneof![boxes, rounds, tubes, meshes, balls]
}

fn bodies() -> impl Strategy<Value = RoundBody> {
    let part = (-1.0..3.0_f64, 0.1..4.0_f64, 0.0..2.0_f64, 0.0..2.0_f64);
    proptest::collection::vec(part, 1..4).prop_map(|parts| {
        let frustums = parts
            .into_iter()
            .map(|(from, height, lower, upper)| Frustum { from, to: from + height, lower, upper })
            .collect();
        RoundBody::new(frustums).unwrap()
    })
}

/// Whether the body is inside a closed mesh by a place of one of its parts: then there is no distance, whatever
/// the samples of the surface say.
fn inside(sampled: &Sampled, body: &RoundBody, tip: Vec3) -> bool {
    sampled.closed.as_ref().is_some_and(|mesh| {
        body.frustums().iter().any(|part| {
            let middle = tip + Vec3::Z * (0.5 * (part.from + part.to));
            common::winding(mesh, middle).abs() > 0.5
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn distances_agree_with_samples(
        sampled in shapes(),
        body in bodies(),
        tip in [number(), number(), number()],
    ) {
        let tip = Vec3::from_array(tip);
        let found = sampled.shape.distance(&body, tip, RESOLUTION);
        let least = sampled
            .places
            .iter()
            .map(|place| from_place(&body, *place - tip))
            .fold(f64::INFINITY, f64::min);
        prop_assert!(found.lower <= found.upper);
        prop_assert!(found.upper - found.lower <= RESOLUTION, "{found:?}");
        prop_assert!(found.lower <= least + ROUNDING, "{found:?} {least}");
        if inside(&sampled, &body, tip) {
            prop_assert_eq!(found, DistanceInterval { lower: 0.0, upper: 0.0 });
        } else {
            prop_assert!(found.upper >= least - sampled.spacing, "{found:?} {least}");
        }
    }

    #[test]
    fn the_way_is_as_near_as_its_nearest_place(
        sampled in shapes(),
        body in bodies(),
        from in [number(), number(), number()],
        to in [number(), number(), number()],
    ) {
        const PLACES: usize = 100;
        let (from, to) = (Vec3::from_array(from), Vec3::from_array(to));
        let whole = sampled.shape.distance_along(&body, from, to, RESOLUTION);
        let mut least = DistanceInterval { lower: f64::INFINITY, upper: f64::INFINITY };
        for place in 0..=PLACES {
            let tip = from.lerp(to, place as f64 / PLACES as f64);
            let there = sampled.shape.distance(&body, tip, RESOLUTION);
            if there.lower < least.lower {
                least = there;
            }
        }
        let step = from.distance(to) / PLACES as f64 / 2.0;
        prop_assert!(whole.lower <= least.upper + ROUNDING, "{whole:?} {least:?}");
        prop_assert!(whole.upper >= least.lower - step - ROUNDING, "{whole:?} {least:?}");

        let path = TipMotion { tip: &|t| from.lerp(to, t), speed: from.distance(to) };
        match sampled.shape.passage(&body, &path, 0.25, 0.01, 10_000) {
            PassageAnswer::Clean { nearest } => {
                prop_assert!(nearest >= 0.25 && least.upper >= nearest - ROUNDING);
                prop_assert!(whole.upper >= nearest - ROUNDING, "{whole:?} {nearest}");
            }
            PassageAnswer::Hit { fraction, distance } => {
                prop_assert!(distance.upper <= 0.26);
                let there = sampled.shape.distance(&body, from.lerp(to, fraction), RESOLUTION);
                prop_assert!(there.lower <= 0.26);
                // Nothing before it is nearer.
                let places = if fraction > 0.0 { PLACES } else { 0 };
                for place in 0..places {
                    let t = fraction * place as f64 / PLACES as f64;
                    let before = sampled.shape.distance(&body, from.lerp(to, t), RESOLUTION);
                    prop_assert!(before.upper >= 0.25 - ROUNDING);
                }
            }
            PassageAnswer::Undecided { .. } => prop_assert!(false, "a distance that is known decides"),
        }
    }

    #[test]
    fn cutters_lie_between_their_bodies(
        diameter in 0.5..20.0_f64,
        corner in 0.01..1.0_f64,
        angle in 0.3..3.0_f64,
        tolerance in 1e-4..0.1_f64,
    ) {
        let cutters = [
            CutterProfile::flat(diameter).unwrap(),
            CutterProfile::ball(diameter).unwrap(),
            CutterProfile::bull(diameter, corner * diameter / 2.0).unwrap(),
            CutterProfile::pointed(diameter, corner * diameter, angle).unwrap(),
            CutterProfile::outline(&[[0.0, 0.0], [2.0, 1.0], [2.5, 3.0], [4.0, 3.0], [4.0, 5.0]]).unwrap(),
        ];
        for cutter in cutters {
            let top = cutter.side() + 10.0;
            let [outer, inner] = [BodyBound::Outer, BodyBound::Inner]
                .map(|bound| RoundBody::of_cutter(&cutter, top, tolerance, bound).unwrap());
            for part in 0..=200 {
                let radius = (cutter.radius() * f64::from(part) / 200.0).min(cutter.radius());
                let place = Vec3::new(radius, 0.0, cutter.height_at(radius));
                let off = from_place(&outer, place);
                prop_assert!(off <= ROUNDING, "{off} at {place:?} of {cutter:?} {outer:?}");
                // The outside of the outer one is near, and the inside of the inner one.
                prop_assert!(from_place(&inner, place) <= tolerance + ROUNDING);
                let below = place - Vec3::Z * 1e-6;
                prop_assert!(from_place(&inner, below) > 0.0);
            }
            for body in [&outer, &inner] {
                for part in body.frustums() {
                    for (radius, height) in [(part.lower, part.from), (part.upper, part.to)] {
                        // No corner of a body is further from the cutter than the tolerance.
                        let least = (0..=2000)
                            .map(|at| (cutter.radius() * f64::from(at) / 2000.0).min(cutter.radius()))
                            .map(|r| (r - radius).hypot((cutter.height_at(r) - height).max(0.0)))
                            .fold(f64::INFINITY, f64::min);
                        prop_assert!(least <= tolerance + cutter.radius() / 1000.0, "{least}");
                    }
                }
            }
        }
    }
}

#[test]
fn by_hand() {
    let body =
        RoundBody::new(vec![Frustum { from: 0.0, to: 10.0, lower: 2.0, upper: 2.0 }]).unwrap();
    let near = |shape: &SolidShape, tip: Vec3, distance: f64| {
        let found = shape.distance(&body, tip, RESOLUTION);
        assert!(
            found.lower - ROUNDING <= distance && distance <= found.upper + ROUNDING,
            "{found:?}"
        );
        assert!(found.upper - found.lower <= RESOLUTION);
    };
    let clamp = SolidShape::cuboid(Vec3::ZERO, Vec3::new(10.0, 10.0, 5.0)).unwrap();
    near(&clamp, Vec3::new(-5.0, 5.0, 0.0), 3.0);
    near(&clamp, Vec3::new(5.0, 5.0, 6.5), 1.5);
    near(&clamp, Vec3::new(-3.0, -4.0, 9.0), 5.0);
    near(&clamp, Vec3::new(-1.0, 5.0, 2.0), 0.0);
    // A lying bolt of radius 1: over it, beside it, beyond its end.
    let bolt =
        SolidShape::cylinder(ShapeAxis::X, Vec3::new(0.0, 0.0, 3.0), 2.0, 0.0, 20.0).unwrap();
    near(&bolt, Vec3::new(5.0, 0.0, 7.0), 3.0);
    near(&bolt, Vec3::new(5.0, 8.0, 0.0), 5.0);
    near(&bolt, Vec3::new(-5.0, 0.0, 0.0), 3.0);
    near(&bolt, Vec3::new(5.0, 0.0, 3.9), 0.0);
    // In the bore of a ring that stands, and of one that lies.
    let ring = SolidShape::tube(ShapeAxis::Z, Vec3::ZERO, [20.0, 12.0], 0.0, 5.0).unwrap();
    near(&ring, Vec3::new(1.0, 0.0, 1.0), 3.0);
    near(&ring, Vec3::new(3.0, 4.0, 1.0), 0.0);
    let pipe = SolidShape::tube(ShapeAxis::X, Vec3::ZERO, [60.0, 40.0], -50.0, 50.0).unwrap();
    let found = pipe.distance(&body, Vec3::new(0.0, 1.0, -4.0), RESOLUTION);
    let exact = 20.0 - 3.0_f64.hypot(6.0);
    assert!(
        (found.lower - exact).abs() < 1e-9 && exact <= found.upper && found.upper < exact + 0.2
    );
    // A body wholly within a mesh has no distance from it.
    let block = SolidShape::solid(common::cuboid(Vec3::ZERO, Vec3::new(50.0, 50.0, 50.0))).unwrap();
    near(&block, Vec3::new(25.0, 25.0, 20.0), 0.0);
    near(&block, Vec3::new(25.0, 25.0, 51.0), 1.0);
}

#[test]
fn steps_end() {
    let body =
        RoundBody::new(vec![Frustum { from: 0.0, to: 10.0, lower: 2.0, upper: 2.0 }]).unwrap();
    let clamp = SolidShape::cuboid(Vec3::ZERO, Vec3::new(10.0, 10.0, 5.0)).unwrap();
    // Along a wall, at a distance of 0.1.
    let tip = |t: f64| Vec3::new(20.0 * t - 5.0, -2.1, 1.0);
    let path = TipMotion { tip: &tip, speed: 20.0 };
    let clean = clamp.passage(&body, &path, 0.0, 0.01, 1000);
    assert!(
        matches!(clean, PassageAnswer::Clean { nearest } if nearest > 0.04 && nearest <= 0.1 + ROUNDING)
    );
    assert!(matches!(clamp.passage(&body, &path, 0.0, 0.01, 10), PassageAnswer::Undecided { .. }));
    assert!(matches!(clamp.passage(&body, &path, 0.2, 0.01, 1000), PassageAnswer::Hit { .. }));
    let stays = TipMotion { tip: &|_| Vec3::new(0.0, -3.0, 0.0), speed: 0.0 };
    assert!(
        matches!(clamp.passage(&body, &stays, 0.0, 0.01, 10), PassageAnswer::Clean { nearest } if (nearest - 1.0).abs() < 1e-9)
    );
    assert!(RoundBody::new(Vec::new()).is_err());
    assert!(RoundBody::new(vec![Frustum { from: 1.0, to: 1.0, lower: 1.0, upper: 1.0 }]).is_err());
    assert!(
        RoundBody::new(vec![Frustum { from: 1.0, to: f64::NAN, lower: 1.0, upper: 1.0 }]).is_err()
    );
    assert!(
        RoundBody::of_cutter(&CutterProfile::ball(6.0).unwrap(), 2.0, 0.01, BodyBound::Outer)
            .is_err()
    );
}
