//! Random passes against a raster that knows nothing of edges: for each of many points, whether the tool
//! comes over it. A convex outline with round corners is a polygon and discs; a point is swept by a polygon
//! if at some time it lies on the right side of every line, by a disc if its path comes near enough.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_geometry::Vec2;
use chordal_stock::lathe::{
    Blade, BladeFacing, BladePoint, Insert, InsertShape, LatheStock, OutlineSegment, Tip,
    ToolOutline,
};

use crate::shop::{Random, at, bar, rounds};

pub const RADIUS: f64 = 30.0;
pub const LENGTH: f64 = 60.0;
/// Between points of the raster, mm.
const STEP: f64 = 0.4;
/// Points this near to an outline may be on either side, mm.
const AT_EDGE: f64 = 1e-8;

/// One part of a tool as the raster sees it.
struct Part {
    corners: Vec<Vec2>,
    discs: Vec<(Vec2, f64)>,
}

fn parts(tool: &ToolOutline) -> Vec<Part> {
    let outlines = tool.outlines();
    let part = |outline: &Vec<OutlineSegment>| Part {
        corners: outline.iter().map(|side| side.start).collect(),
        discs: outline
            .iter()
            .filter_map(|side| Some((side.bend?.center, side.bend?.radius)))
            .collect(),
    };
    outlines.iter().map(part).collect()
}

impl Part {
    fn sweeps(&self, path: &OutlineSegment, p: Vec2) -> bool {
        let near = |(center, radius): &(Vec2, f64)| distance(path, p - *center) <= *radius;
        self.discs.iter().any(near) || (self.corners.len() > 2 && self.polygon_sweeps(path, p))
    }

    /// Sides as (normal outward, reach): a point is within if normal·p ≤ reach.
    fn sides(&self) -> impl Iterator<Item = (Vec2, f64)> {
        let count = self.corners.len();
        (0..count).map(move |side| {
            let (from, to) = (self.corners[side], self.corners[(side + 1) % count]);
            let out = -(to - from).turned_left();
            (out, out.dot(from))
        })
    }

    fn polygon_sweeps(&self, path: &OutlineSegment, p: Vec2) -> bool {
        match path.bend {
            None => {
                // normal·(p − start − t·along) ≤ reach, for some t from 0 to 1.
                let (mut from, mut to) = (0.0_f64, 1.0_f64);
                let along = path.end - path.start;
                for (out, reach) in self.sides() {
                    let (over, gain) = (out.dot(p - path.start) - reach, out.dot(along));
                    if gain > 0.0 {
                        from = from.max(over / gain);
                    } else if gain < 0.0 {
                        to = to.min(over / gain);
                    } else if over > 0.0 {
                        return false;
                    }
                }
                from <= to
            }
            Some(bend) => {
                // A side lets pass an interval of angles; if some angle passes all, an end of one does.
                let mut tried = vec![path.start, path.end];
                for (out, reach) in self.sides() {
                    let (over, size) = (out.dot(p - bend.center) - reach, out.length());
                    let cos = over / (size * bend.radius);
                    if cos.abs() <= 1.0 {
                        let (out, off) = (libm::atan2(out.b, out.a), libm::acos(cos));
                        for angle in [out - off, out + off] {
                            let (sin, cos) = libm::sincos(angle);
                            tried.push(bend.center + at(cos, sin) * bend.radius);
                        }
                    }
                }
                let within = |place: &Vec2| {
                    self.sides()
                        .all(|(out, reach)| out.dot(p - *place) - reach <= 1e-9 * out.length())
                };
                tried.iter().any(|place| faces(path, *place) && within(place))
            }
        }
    }
}

fn faces(path: &OutlineSegment, place: Vec2) -> bool {
    let Some(bend) = path.bend else { return false };
    let angle = |p: Vec2| libm::atan2(p.b - bend.center.b, p.a - bend.center.a);
    let passed = angle(place) - angle(path.start);
    let passed = if bend.counterclockwise { passed } else { -passed };
    let passed = passed.rem_euclid(TAU);
    passed <= path.sweep().abs() + 1e-9 || passed > TAU - 1e-9
}

fn distance(path: &OutlineSegment, p: Vec2) -> f64 {
    let ends = p.distance(path.start).min(p.distance(path.end));
    match path.bend {
        None => {
            let along = path.end - path.start;
            let squared = along.dot(along);
            if squared == 0.0 {
                return ends;
            }
            let share = ((p - path.start).dot(along) / squared).clamp(0.0, 1.0);
            p.distance(path.start + along * share)
        }
        Some(bend) if faces(path, p) => ends.min((p.distance(bend.center) - bend.radius).abs()),
        Some(_) => ends,
    }
}

/// The distance of a point from an outline.
fn off_outline(outline: &[Vec<OutlineSegment>], p: Vec2) -> f64 {
    outline.iter().flatten().map(|side| distance(side, p)).fold(f64::INFINITY, f64::min)
}

pub fn random_tool(random: &mut Random) -> ToolOutline {
    let number = 1 + random.below(8) as u8;
    let tip = Tip::new(number).unwrap();
    let nose = [0.0, 0.4, 0.8, 1.2, random.between(0.01, 3.0)][random.below(5)];
    match random.below(6) {
        0 | 1 => {
            let first = match random.below(3) {
                0 => random.below(8) as f64 * PI / 4.0,
                _ => random.between(0.0, TAU),
            };
            let included = [FRAC_PI_2, 80_f64.to_radians(), 35_f64.to_radians(), PI / 3.0];
            let flanks = [first, first + included[random.below(4)]];
            let shape = [InsertShape::Parallelogram, InsertShape::Triangle][random.below(2)];
            let insert = Insert { nose, tip, flanks, length: random.between(14.0, 30.0), shape };
            insert.outline().unwrap()
        }
        2 | 3 => {
            let width = [2.0, 3.0, random.between(1.0, 6.0)][random.below(3)];
            let corner = [0.0, 0.2, 0.5 * width, random.between(0.0, 0.4) * width][random.below(4)];
            let facing = [
                BladeFacing::Outside,
                BladeFacing::Inside,
                BladeFacing::Face,
                BladeFacing::BackFace,
            ];
            let points = [BladePoint::Lower, BladePoint::Middle, BladePoint::Upper];
            let blade = Blade {
                width,
                corners: [corner, [corner, 0.3 * width][random.below(2)]],
                length: random.between(8.0, 20.0),
                lead: [0.0, 0.0, 0.1, -0.2][random.below(4)],
                facing: facing[random.below(4)],
                point: points[random.below(3)],
            };
            let square = Blade { corners: [0.0; 2], ..blade };
            blade.outline().or_else(|_| square.outline()).unwrap()
        }
        4 => ToolOutline::round(random.between(0.5, 6.0), tip).unwrap(),
        _ => {
            // An angle with an inner corner.
            let (wide, tall, thick) =
                (random.between(6.0, 12.0), random.between(6.0, 12.0), random.between(1.0, 4.0));
            let corners = [
                at(0.0, 0.0),
                at(thick, 0.0),
                at(thick, tall - thick),
                at(wide, tall - thick),
                at(wide, tall),
                at(0.0, tall),
            ];
            ToolOutline::polygon(&corners).unwrap()
        }
    }
}

/// A place on or near the stock: often on a coarse raster, so that moves lie on each other.
pub fn random_place(random: &mut Random) -> Vec2 {
    let place = at(random.between(-LENGTH - 5.0, 5.0), random.between(-1.0, RADIUS + 6.0));
    match random.below(3) {
        0 => place,
        1 => at(place.a.round(), place.b.round()),
        _ => at((place.a / 5.0).round() * 5.0, (place.b / 5.0).round() * 5.0),
    }
}

pub fn random_path(random: &mut Random, from: Vec2) -> OutlineSegment {
    let far = random_place(random);
    let to = match random.below(5) {
        0 => at(from.a, far.b),
        1 => at(far.a, from.b),
        2 => from + (far - from) * 0.2,
        _ => far,
    };
    if random.below(3) > 0 || from.distance(to) < 1e-3 {
        return OutlineSegment::line(from, to);
    }
    // A centre beside the middle of the chord.
    let aside = (to - from).turned_left() * [0.0, 0.5, -0.5, 1.3, -2.0][random.below(5)];
    OutlineSegment::arc(from, to, (from + to) * 0.5 + aside, random.below(2) == 0)
}

struct Raster {
    points: Vec<Vec2>,
    left: Vec<bool>,
}

impl Raster {
    fn new() -> Raster {
        // Off every round number.
        let (z0, r0) = (0.412_310_563, 0.271_828_182);
        let mut points = Vec::new();
        for column in 0..(LENGTH / STEP) as usize {
            for row in 0..(RADIUS / STEP) as usize {
                let place = at(column as f64 + z0, row as f64 + r0) * STEP;
                points.push(at(place.a - LENGTH, place.b));
            }
        }
        let left = vec![true; points.len()];
        Raster { points, left }
    }

    /// How many points go.
    fn cut(&mut self, parts: &[Part], path: &OutlineSegment) -> usize {
        let mut count = 0;
        let reach = reach(parts, path);
        for (point, left) in self.points.iter().zip(&mut self.left) {
            if (point.a - reach.0.a).abs() > reach.1.a || point.b - reach.0.b.abs() > reach.1.b {
                continue;
            }
            let mirrored = at(point.a, -point.b);
            let swept = || {
                let over = |part: &Part| part.sweeps(path, *point) || part.sweeps(path, mirrored);
                parts.iter().any(over)
            };
            if *left && swept() {
                *left = false;
                count += 1;
            }
        }
        count
    }

    fn agrees(&self, stock: &LatheStock) {
        let region = stock.region();
        let outline = region.outline();
        for (point, left) in self.points.iter().zip(&self.left) {
            if region.holds(*point) != *left {
                let off = off_outline(&outline, *point);
                assert!(off < AT_EDGE, "{point:?} left {left}, {off} mm from the outline");
            }
        }
    }
}

/// The middle of a path, and how far along z and r the tool comes from there at most.
fn reach(parts: &[Part], path: &OutlineSegment) -> (Vec2, Vec2) {
    let corners = parts.iter().flat_map(|part| part.corners.iter().map(|corner| (*corner, 0.0)));
    let discs = parts.iter().flat_map(|part| part.discs.iter().copied());
    let mut tool = at(0.0, 0.0);
    for (place, radius) in corners.chain(discs) {
        tool = at(tool.a.max(place.a.abs() + radius), tool.b.max(place.b.abs() + radius));
    }
    match path.bend {
        None => {
            let half = (path.end - path.start) * 0.5;
            (path.start + half, tool + at(half.a.abs(), half.b.abs()))
        }
        Some(bend) => (bend.center, tool + at(bend.radius, bend.radius)),
    }
}

#[test]
fn random_passes_leave_what_a_raster_leaves() {
    const PASSES: u64 = 20;
    let rounds = rounds(600).div_ceil(PASSES);
    let (mut cut, mut shifted) = (0_u64, 0_u64);
    for round in 0..rounds {
        let mut random = Random(0x9E37_79B9_7F4A_7C15 ^ (round + 1).wrapping_mul(0x1_0000_01B3));
        let mut raster = Raster::new();
        let mut stock = bar(RADIUS, -LENGTH, 0.0);
        let mut tool = random_tool(&mut random);
        let mut seen = parts(&tool);
        let mut from = random_place(&mut random);
        for pass in 0..PASSES {
            if random.below(4) == 0 {
                tool = random_tool(&mut random);
                seen = parts(&tool);
            }
            let path = random_path(&mut random, from).tagged(pass as u32 + 1);
            from = path.end;
            let before = stock.area();
            let (found, region) = stock.cut_out(&tool, &path).unwrap();
            let count = raster.cut(&seen, &path);
            cut += u64::from(found.touched);
            shifted += u64::from(found.bound > 0.0);
            let around: f64 = region.outline().iter().flatten().map(length).sum();
            // A point stands for its cell: cells on the outline may count either way.
            let off = (found.area - count as f64 * STEP * STEP).abs();
            let most = 1.5 * around * STEP + 4.0 * STEP * STEP;
            assert!(off <= most, "round {round}: {off} of {around}");
            assert!((before - stock.area() - found.area).abs() < 1e-8, "round {round}");
            assert!((region.area() - found.area).abs() < 1e-9, "round {round}");
        }
        raster.agrees(&stock);
    }
    println!("{} passes, {cut} of them cut, {shifted} were shifted", rounds * PASSES);
}

fn length(side: &OutlineSegment) -> f64 {
    match side.bend {
        None => side.start.distance(side.end),
        Some(bend) => bend.radius * side.sweep().abs(),
    }
}
