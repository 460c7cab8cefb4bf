//! Distances and depths of convex solids against closed forms and against all pairs of triangles.

use chordal_geometry::{
    Aabb, ConvexSolid, PlacedSolid, SolidError, Transform, Vec3, solid_depth, solid_distance,
};

/// A small generator, so that a failure repeats.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn point(&mut self, size: f64) -> Vec3 {
        let mut along = || self.between(-size, size);
        Vec3::new(along(), along(), along())
    }

    fn pose(&mut self, size: f64) -> Transform {
        let turn =
            Transform::rotation_about(self.point(1.0), self.point(1.0), self.between(0.0, 6.3));
        turn.then(&Transform::translation(self.point(size)))
    }
}

const RESOLUTION: f64 = 1e-7;

fn between(a: &ConvexSolid, on: &Transform, b: &ConvexSolid, at: &Transform) -> [f64; 2] {
    let [a, b] = [PlacedSolid::new(a, *on), PlacedSolid::new(b, *at)];
    let found = solid_distance(&a, &b, RESOLUTION, f64::INFINITY);
    assert!(found.lower <= found.upper);
    [found.lower, found.upper]
}

/// The distance of two segments, exactly enough.
fn segments([p, q]: [Vec3; 2], [r, s]: [Vec3; 2]) -> f64 {
    let (u, v, w) = (q - p, s - r, p - r);
    let (a, b, c, d, e) = (u.dot(u), u.dot(v), v.dot(v), u.dot(w), v.dot(w));
    let clamp = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(0.0, 1.0) };
    let mut best = f64::INFINITY;
    let mut take = |s: f64, t: f64| {
        best = best.min((w + u * s - v * t).length());
    };
    let inner = a * c - b * b;
    let s = (b * e - c * d) / inner;
    let t = (a * e - b * d) / inner;
    if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
        take(s, t);
    }
    for end in [0.0, 1.0] {
        take(end, clamp((e + b * end) / c));
        take(clamp((b * end - d) / a), end);
    }
    best
}

/// The distance from a point to a triangle if the foot of its perpendicular is inside.
fn above(point: Vec3, [p, q, r]: [Vec3; 3]) -> f64 {
    let normal = (q - p).cross(r - p);
    let Some(unit) = normal.normalized() else { return f64::INFINITY };
    let foot = point - unit * (point - p).dot(unit);
    let is_left = |a: Vec3, b: Vec3| (b - a).cross(foot - a).dot(normal) >= 0.0;
    let is_inside = is_left(p, q) && is_left(q, r) && is_left(r, p);
    if is_inside { point.distance(foot) } else { f64::INFINITY }
}

/// The distance of two hulls that do not overlap, over all triangles of their corners.
fn by_triangles(a: &[Vec3], b: &[Vec3]) -> f64 {
    let mut best = f64::INFINITY;
    for (one, other) in [(a, b), (b, a)] {
        for i in 0..one.len() {
            for j in 0..i {
                for k in 0..j {
                    for point in other {
                        best = best.min(above(*point, [one[i], one[j], one[k]]));
                    }
                }
            }
        }
    }
    for i in 0..a.len() {
        for j in 0..i {
            for k in 0..b.len() {
                for l in 0..k {
                    best = best.min(segments([a[i], a[j]], [b[k], b[l]]));
                }
            }
        }
    }
    best
}

#[test]
fn hulls_are_as_far_apart_as_their_nearest_triangles() {
    let mut random = Random(0x5EED_1234);
    let mut apart = 0;
    for _ in 0..300 {
        let count = 4 + (random.unit() * 4.0) as usize;
        let a: Vec<Vec3> = (0..count).map(|_| random.point(10.0)).collect();
        let b: Vec<Vec3> = (0..5).map(|_| random.point(10.0)).collect();
        let (on, at) = (random.pose(12.0), random.pose(12.0));
        let moved = |points: &[Vec3], pose: &Transform| -> Vec<Vec3> {
            points.iter().map(|point| pose.apply_point(*point)).collect()
        };
        let exact = by_triangles(&moved(&a, &on), &moved(&b, &at));
        let [a, b] = [ConvexSolid::hull(a).unwrap(), ConvexSolid::hull(b).unwrap()];
        let [lower, upper] = between(&a, &on, &b, &at);
        if upper > 1e-9 {
            apart += 1;
            assert!(lower <= exact + 1e-9 && exact <= upper + 1e-9, "{lower} {exact} {upper}");
            assert!(upper - lower <= 1e-6, "{lower} to {upper}");
        }
    }
    assert!(apart > 150, "{apart}");
}

#[test]
fn boxes_and_balls_by_hand() {
    let unit = ConvexSolid::cuboid(Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0)).unwrap();
    let at = |x, y, z| Transform::translation(Vec3::new(x, y, z));
    let [lower, upper] = between(&unit, &at(0.0, 0.0, 0.0), &unit, &at(4.0, 6.0, 0.0));
    assert!((lower - 5.0).abs() < 1e-6 && (upper - 5.0).abs() < 1e-6);
    let [_, upper] = between(&unit, &at(0.0, 0.0, 0.0), &unit, &at(0.9, 0.0, 0.0));
    assert!(upper < 1e-10);
    let ball = ConvexSolid::ball(Vec3::ZERO, 2.0).unwrap();
    let [lower, upper] = between(&ball, &at(0.0, 0.0, 0.0), &ball, &at(30.0, 40.0, 0.0));
    assert!((lower - 46.0).abs() < 1e-6 && (upper - 46.0).abs() < 1e-6, "{lower} {upper}");
    // A cone with its tip up, under a ball: 10 above the tip.
    let cone = ConvexSolid::frustum([Vec3::ZERO, Vec3::Z * 20.0], [5.0, 0.0]).unwrap();
    let [lower, upper] = between(&cone, &at(0.0, 0.0, 0.0), &ball, &at(0.0, 0.0, 32.0));
    assert!((lower - 10.0).abs() < 1e-6 && (upper - 10.0).abs() < 1e-6, "{lower} {upper}");
}

#[test]
fn round_solids_are_between_polygons_inside_and_outside_of_them() {
    const SIDES: usize = 256;
    let mut random = Random(77);
    let mut apart = 0;
    for _ in 0..200 {
        let radii = [random.between(0.0, 8.0), random.between(1.0, 8.0)];
        let ends = [random.point(10.0), random.point(10.0)];
        let axis = (ends[1] - ends[0]).normalized().unwrap();
        let side = axis.cross(random.point(1.0)).normalized().unwrap();
        let polygon = |scale: f64| -> Vec<Vec3> {
            let corner = |end: usize, index: usize| {
                let (sin, cos) = (core::f64::consts::TAU * index as f64 / SIDES as f64).sin_cos();
                let rim = side * cos + axis.cross(side) * sin;
                ends[end] + rim * (radii[end] * scale)
            };
            (0..2).flat_map(|end| (0..SIDES).map(move |i| corner(end, i))).collect()
        };
        let cut = 1.0 / (core::f64::consts::PI / SIDES as f64).cos();
        let round = ConvexSolid::frustum(ends, radii).unwrap();
        let [inside, outside] = [1.0, cut].map(|scale| ConvexSolid::hull(polygon(scale)).unwrap());
        let other = ConvexSolid::cuboid(random.point(6.0), random.point(6.0)).unwrap();
        let (on, at) = (random.pose(15.0), random.pose(15.0));
        let [lower, upper] = between(&round, &on, &other, &at);
        let [_, most] = between(&inside, &on, &other, &at);
        let [least, _] = between(&outside, &on, &other, &at);
        assert!(lower <= most + 1e-9 && least <= upper + 1e-9, "{least} {lower} {upper} {most}");
        if upper > 1e-9 {
            apart += 1;
            assert!(upper - lower <= 1e-4 * (1.0 + upper), "{lower} to {upper}");
        }
    }
    assert!(apart > 80, "{apart}");
}

#[test]
fn depths_of_boxes_and_balls() {
    let mut random = Random(4711);
    for _ in 0..200 {
        // Two boxes with parallel sides: the depth is the least overlap of their sides.
        let one = [random.point(5.0), random.point(5.0)];
        let other = [random.point(5.0), random.point(5.0)];
        let [a, b] = [one, other].map(|[from, to]| Aabb::of_points(from, to));
        let overlap = (0..3)
            .map(|axis| {
                let high = b.max.component(axis) - a.min.component(axis);
                high.min(a.max.component(axis) - b.min.component(axis))
            })
            .fold(f64::INFINITY, f64::min);
        let [a, b] = [ConvexSolid::Cuboid(a), ConvexSolid::Cuboid(b)];
        let pose = random.pose(100.0);
        let place = |solid| PlacedSolid::new(solid, pose);
        let found = solid_depth(&place(&a), &place(&b), 1e-6);
        assert!(found.lower <= overlap.max(0.0) + 1e-6, "{found:?} {overlap}");
        assert!(found.upper >= overlap.max(0.0) - 1e-6, "{found:?} {overlap}");
        if overlap > 0.0 {
            assert!(found.upper - found.lower < 1e-4, "{found:?} {overlap}");
        }
    }
    let ball = ConvexSolid::ball(Vec3::ZERO, 10.0).unwrap();
    let place = |x| PlacedSolid::new(&ball, Transform::translation(Vec3::X * x));
    let found = solid_depth(&place(0.0), &place(17.0), 1e-3);
    assert!(found.lower > 2.9 && found.lower <= 3.0 && found.upper >= 3.0 - 1e-9, "{found:?}");
    assert_eq!(solid_depth(&place(0.0), &place(21.0), 1e-3).upper, 0.0);
}

#[test]
fn a_bounding_ball_and_the_enclosing_balls_contain_the_solid() {
    let mut random = Random(99);
    for _ in 0..200 {
        let solids = [
            ConvexSolid::cuboid(random.point(5.0), random.point(5.0)).unwrap(),
            ConvexSolid::frustum([random.point(5.0), random.point(5.0)], [1.0, random.unit()])
                .unwrap(),
            ConvexSolid::hull((0..6).map(|_| random.point(5.0)).collect()).unwrap(),
            ConvexSolid::ball(random.point(5.0), 1.5).unwrap(),
        ];
        for solid in &solids {
            let direction = random.point(1.0);
            let point = solid.farthest(direction);
            let (center, radius) = solid.bounding_ball();
            assert!(point.distance(center) <= radius + 1e-9, "{solid:?}");
            let unit = direction.normalized().unwrap();
            let reach = |(at, r): &(Vec3, f64)| at.dot(unit) + r;
            let most = solid.enclosing_balls().iter().map(reach).fold(f64::NEG_INFINITY, f64::max);
            assert!(point.dot(unit) <= most + 1e-9, "{solid:?}");
        }
    }
}

#[test]
fn a_lower_bound_is_enough_where_it_is_large() {
    let unit = ConvexSolid::cuboid(Vec3::ZERO, Vec3::new(1.0, 1.0, 1.0)).unwrap();
    let place = |x| PlacedSolid::new(&unit, Transform::translation(Vec3::X * x));
    let found = solid_distance(&place(0.0), &place(100.0), 1e-9, 5.0);
    assert!(found.lower > 5.0 && found.lower <= 99.0 && found.upper >= 99.0);
}

#[test]
fn wrong_dimensions_are_refused() {
    let (zero, one) = (Vec3::ZERO, Vec3::new(1.0, 1.0, 1.0));
    assert_eq!(ConvexSolid::cuboid(zero, Vec3::X), Err(SolidError::NoLength));
    assert_eq!(ConvexSolid::cuboid(zero, one * f64::NAN), Err(SolidError::NotFinite));
    assert_eq!(ConvexSolid::ball(zero, 0.0), Err(SolidError::NoRadius));
    assert_eq!(ConvexSolid::frustum([zero, zero], [1.0, 1.0]), Err(SolidError::NoLength));
    assert_eq!(ConvexSolid::frustum([zero, one], [0.0, 0.0]), Err(SolidError::NoRadius));
    assert_eq!(ConvexSolid::frustum([zero, one], [-1.0, 2.0]), Err(SolidError::NoRadius));
    assert_eq!(ConvexSolid::hull(Vec::new()), Err(SolidError::NoPoints));
}
