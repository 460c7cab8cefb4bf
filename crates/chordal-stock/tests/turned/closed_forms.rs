//! Small programs whose removed volume has a closed form: cylinders, cones, spheres, and what turns with its
//! centroid (Pappus).

use core::f64::consts::{FRAC_PI_2, PI};

use chordal_stock::lathe::{
    Blade, BladeFacing, BladePoint, Insert, InsertShape, LatheStock, OutlineSegment, Region,
    ToolOutline,
};

use crate::shop::{at, bar, blade, near, point, tip};

/// Volumes agree to this part of them: what sums of doubles lose.
const PART: f64 = 1e-12;

fn cylinder(radius: f64, length: f64) -> f64 {
    PI * radius * radius * length
}

fn ring(inner: f64, outer: f64, length: f64) -> f64 {
    cylinder(outer, length) - cylinder(inner, length)
}

fn cone(r0: f64, r1: f64, length: f64) -> f64 {
    PI * length / 3.0 * (r0 * r0 + r0 * r1 + r1 * r1)
}

/// What an area makes whose centroid turns at a radius.
fn turned(area: f64, radius: f64) -> f64 {
    2.0 * PI * radius * area
}

/// What a round corner leaves of a square one: its area, and how far its centroid is from the sharp corner.
fn corner(radius: f64) -> (f64, f64) {
    ((1.0 - PI / 4.0) * radius * radius, (10.0 - 3.0 * PI) / (12.0 - 3.0 * PI) * radius)
}

/// A slim point for outside work, tip 8, that goes down slopes of up to 70°.
fn slim() -> ToolOutline {
    let half = 20_f64.to_radians();
    let flanks = [FRAC_PI_2 - half, FRAC_PI_2 + half];
    let shape = InsertShape::Parallelogram;
    Insert { nose: 0.0, tip: tip(8), flanks, length: 60.0, shape }.outline().unwrap()
}

/// A point for bores, tip 2.
fn inside() -> ToolOutline {
    Insert::ideal_point(tip(2), 9.0).unwrap().outline().unwrap()
}

/// A square nose: flanks along the axes.
fn nosed(radius: f64) -> ToolOutline {
    let shape = InsertShape::Parallelogram;
    let flanks = [0.0, FRAC_PI_2];
    Insert { nose: radius, tip: tip(3), flanks, length: 60.0, shape }.outline().unwrap()
}

fn plunge(z: f64, from: f64, to: f64) -> OutlineSegment {
    OutlineSegment::line(at(z, from), at(z, to))
}

fn along(r: f64, from: f64, to: f64) -> OutlineSegment {
    OutlineSegment::line(at(from, r), at(to, r))
}

fn line(from: (f64, f64), to: (f64, f64)) -> OutlineSegment {
    OutlineSegment::line(from.into(), to.into())
}

/// Cuts, and compares what went with the closed form: by the passes, and by what is left.
fn removes(
    stock: LatheStock,
    tool: &ToolOutline,
    path: &[OutlineSegment],
    wanted: f64,
) -> LatheStock {
    let mut stock = stock;
    let before = stock.volume();
    let passes = path.iter().map(|move_| stock.cut(tool, move_).unwrap().volume);
    let sum: f64 = passes.sum();
    near(sum, wanted, PART * wanted);
    near(before - stock.volume(), wanted, PART * before);
    stock
}

#[test]
fn outside_turning() {
    let edge = point();
    // Straight; in two depths; with steps; across the whole bar.
    removes(bar(25.0, -60.0, 0.0), &edge, &[along(20.0, 1.0, -30.0)], ring(20.0, 25.0, 30.0));
    let two = [along(23.0, 1.0, -40.0), along(20.0, 1.0, -30.0)];
    let wanted = ring(23.0, 25.0, 40.0) + ring(20.0, 23.0, 30.0);
    removes(bar(25.0, -60.0, 0.0), &edge, &two, wanted);
    let steps = [
        along(10.0, 1.0, -10.0),
        plunge(-10.0, 10.0, 15.0),
        along(15.0, -10.0, -25.0),
        plunge(-25.0, 15.0, 26.0),
    ];
    let wanted = ring(10.0, 25.0, 10.0) + ring(15.0, 25.0, 15.0);
    removes(bar(25.0, -60.0, 0.0), &edge, &steps, wanted);
    let whole =
        removes(bar(25.0, -60.0, 0.0), &edge, &[along(24.0, 5.0, -70.0)], ring(24.0, 25.0, 60.0));
    assert_eq!(whole.region().shape()[0].len(), 4);

    // Tapers of two slopes, a chamfer, a cone to a point.
    let taper = [line((0.0, 15.0), (-40.0, 25.0))];
    removes(bar(25.0, -60.0, 0.0), &edge, &taper, cylinder(25.0, 40.0) - cone(15.0, 25.0, 40.0));
    let steep = [line((1.0, 9.0), (-15.0, 25.0))];
    removes(bar(25.0, -60.0, 0.0), &edge, &steep, cylinder(25.0, 15.0) - cone(10.0, 25.0, 15.0));
    let chamfer = [line((1.0, 22.0), (-2.0, 25.0))];
    removes(bar(25.0, -60.0, 0.0), &edge, &chamfer, cylinder(25.0, 2.0) - cone(23.0, 25.0, 2.0));
    let tip = [line((0.0, 0.0), (-25.0, 25.0))];
    removes(bar(25.0, -60.0, 0.0), &edge, &tip, cylinder(25.0, 25.0) - cone(0.0, 25.0, 25.0));
}

#[test]
fn facing() {
    let edge = point();
    removes(bar(25.0, -60.0, 0.0), &edge, &[plunge(-3.0, 26.0, 0.0)], cylinder(25.0, 3.0));
    // Past the axis, and not quite to it.
    removes(bar(25.0, -60.0, 0.0), &edge, &[plunge(-3.0, 26.0, -0.8)], cylinder(25.0, 3.0));
    let pip = [plunge(-3.0, 26.0, 0.8)];
    removes(bar(25.0, -60.0, 0.0), &edge, &pip, ring(0.8, 25.0, 3.0));
    // A nose that stops at the axis leaves a horn; past it by its radius it does not.
    let (area, off) = corner(0.8);
    let horn = cylinder(25.0, 3.0) - turned(area, off);
    removes(bar(25.0, -60.0, 0.0), &nosed(0.8), &[plunge(-3.0, 26.0, 0.0)], horn);
    removes(bar(25.0, -60.0, 0.0), &nosed(0.8), &[plunge(-3.0, 26.0, -0.8)], cylinder(25.0, 3.0));
}

#[test]
fn arcs() {
    let edge = point();
    // A convex corner, a fillet, a sphere's end, half a sphere.
    let convex = [
        line((0.0, 16.0), (0.0, 21.0)),
        OutlineSegment::arc(at(0.0, 21.0), at(-4.0, 25.0), at(-4.0, 21.0), true),
    ];
    let (area, off) = corner(4.0);
    removes(bar(25.0, -60.0, 0.0), &edge, &convex, turned(area, 25.0 - off));
    let fillet = [
        along(15.0, 1.0, -20.0),
        OutlineSegment::arc(at(-20.0, 15.0), at(-25.0, 20.0), at(-20.0, 20.0), false),
        plunge(-25.0, 20.0, 26.0),
    ];
    let (area, off) = corner(5.0);
    let wanted = ring(15.0, 25.0, 25.0) - turned(area, 15.0 + off);
    removes(bar(25.0, -60.0, 0.0), &edge, &fillet, wanted);
    // A cap of height 4 of a sphere R10: π·4²(3·10 − 4)/3.
    let cap = [
        OutlineSegment::arc(at(0.0, 0.0), at(-4.0, 8.0), at(-10.0, 0.0), true),
        plunge(-4.0, 8.0, 16.0),
    ];
    let wanted = cylinder(15.0, 4.0) - PI * 16.0 * 26.0 / 3.0;
    removes(bar(15.0, -50.0, 0.0), &edge, &cap, wanted);
    // A valley of half a circle of radius 3, its centre at the surface.
    let valley = [OutlineSegment::arc(at(-10.0, 25.0), at(-16.0, 25.0), at(-13.0, 25.0), false)];
    let tool = ToolOutline::round(0.001, tip(0)).unwrap();
    let half = PI * 9.0 / 2.0;
    let mut cut = bar(25.0, -60.0, 0.0);
    // A small round tool leaves the middle; its ring is exact: half of π(3.001² − 2.999²), above and below.
    let ring_area = PI * (3.001_f64.powi(2) - 2.999_f64.powi(2)) / 2.0;
    let found = cut.cut(&tool, &valley[0]).unwrap();
    // Both ends add a quarter of the tool's disc below the surface.
    near(found.area, ring_area, 1e-5);
    let bodies = cut.region().bodies();
    assert_eq!(bodies.len(), 2);
    near(bodies[1].area(), half * (2.999_f64 / 3.0).powi(2), 1e-5);
    // With a disc of that radius at the same place it is exact.
    let disc = ToolOutline::round(3.0, tip(0)).unwrap();
    let wanted = turned(half, 25.0 - 4.0 * 3.0 / (3.0 * PI));
    removes(bar(25.0, -60.0, 0.0), &disc, &[plunge(-13.0, 29.0, 25.0)], wanted);
}

#[test]
fn grooves() {
    let square = blade(3.0, 0.0).outline().unwrap();
    removes(bar(20.0, -60.0, 0.0), &square, &[plunge(-23.0, 22.0, 16.0)], ring(16.0, 20.0, 3.0));
    let wide = [plunge(-23.0, 22.0, 16.0), plunge(-23.0, 16.0, 22.0), plunge(-25.0, 22.0, 16.0)];
    removes(bar(20.0, -60.0, 0.0), &square, &wide, ring(16.0, 20.0, 5.0));
    // Round corners, a full radius, a slanted front.
    let (area, off) = corner(0.4);
    let round = blade(3.0, 0.4).outline().unwrap();
    let wanted = ring(16.0, 20.0, 3.0) - 2.0 * turned(area, 16.0 + off);
    removes(bar(20.0, -60.0, 0.0), &round, &[plunge(-23.0, 22.0, 16.0)], wanted);
    let full = blade(3.0, 1.5).outline().unwrap();
    let half = PI * 1.5 * 1.5 / 2.0;
    let wanted = ring(17.5, 20.0, 3.0) + turned(half, 17.5 - 4.0 * 1.5 / (3.0 * PI));
    removes(bar(20.0, -60.0, 0.0), &full, &[plunge(-23.0, 22.0, 16.0)], wanted);
    let slanted = Blade { lead: 0.1, ..blade(3.0, 0.0) }.outline().unwrap();
    let rise = 3.0 * 0.1_f64.tan();
    let wanted = cylinder(20.0, 3.0) - cone(16.0, 16.0 + rise, 3.0);
    removes(bar(20.0, -60.0, 0.0), &slanted, &[plunge(-23.0, 22.0, 16.0)], wanted);
    // A V of 40°, 3 deep: a triangle, a third of its depth below the surface.
    let half = 3.0 * 20_f64.to_radians().tan();
    let wanted = turned(3.0 * half, 20.0 - 1.0);
    removes(bar(20.0, -60.0, 0.0), &slim(), &[plunge(-20.0, 25.0, 17.0)], wanted);
    // In a face: from r 10 to 13, 4 deep.
    let face = Blade { facing: BladeFacing::Face, ..blade(3.0, 0.0) }.outline().unwrap();
    removes(bar(20.0, -60.0, 0.0), &face, &[along(10.0, 2.0, -4.0)], ring(10.0, 13.0, 4.0));
    // In a bore.
    let tube = LatheStock::new(&Region::tube(12.0, 20.0, -60.0, 0.0).unwrap());
    let inner =
        Blade { facing: BladeFacing::Inside, length: 10.0, ..blade(3.0, 0.0) }.outline().unwrap();
    removes(tube, &inner, &[plunge(-30.0, 11.0, 14.0)], ring(12.0, 14.0, 3.0));
}

#[test]
fn noses() {
    // A nose leaves its fillet at a shoulder.
    let (area, off) = corner(0.8);
    let wanted = ring(20.0, 25.0, 30.0) - turned(area, 20.0 + off);
    removes(bar(25.0, -60.0, 0.0), &nosed(0.8), &[along(20.0, 1.0, -30.0)], wanted);
    // A round insert of radius 4 on a full circle of radius 6: a ring, and a core that is loose.
    let disc = ToolOutline::round(2.0, tip(0)).unwrap();
    let start = at(-14.0, 15.0);
    let circle = [OutlineSegment::arc(start, start, at(-20.0, 15.0), true)];
    let wanted = turned(PI * (64.0 - 16.0), 15.0);
    let left = removes(bar(30.0, -60.0, 0.0), &disc, &circle, wanted);
    assert_eq!(left.region().bodies().len(), 2);
    near(left.region().bodies()[1].volume(), turned(PI * 16.0, 15.0), 1e-9);
    // A quarter of it: half discs at both ends.
    let quarter = [OutlineSegment::arc(start, at(-20.0, 21.0), at(-20.0, 15.0), true)];
    let mut stock = bar(30.0, -60.0, 0.0);
    let pass = stock.cut(&disc, &quarter[0]).unwrap();
    near(pass.area, PI * 48.0 / 4.0 + PI * 4.0, 1e-11);
    near(pass.across, 4.0, 1e-12);
    // Inside its own radius: a path of radius 1 for a disc of 2 sweeps a disc of 3 without a hole.
    let start = at(-19.0, 15.0);
    let small = [OutlineSegment::arc(start, start, at(-20.0, 15.0), false)];
    removes(bar(30.0, -60.0, 0.0), &disc, &small, turned(PI * 9.0, 15.0));
}

#[test]
fn holes() {
    let flat = ToolOutline::drill(10.0, PI, 80.0).unwrap();
    removes(bar(20.0, -60.0, 0.0), &flat, &[along(0.0, 2.0, -30.0)], cylinder(5.0, 30.0));
    let drill = ToolOutline::drill(10.0, 118_f64.to_radians(), 80.0).unwrap();
    let height = 5.0 / 59_f64.to_radians().tan();
    let wanted = cylinder(5.0, 30.0 - height) + cone(0.0, 5.0, height);
    let drilled = removes(bar(20.0, -60.0, 0.0), &drill, &[along(0.0, 2.0, -30.0)], wanted);
    // Opened with a boring bar to r 8, with a chamfer, and to a taper.
    let bored = removes(drilled, &inside(), &[along(8.0, 2.0, -20.0)], ring(5.0, 8.0, 20.0));
    let chamfer = [line((1.0, 11.0), (-2.0, 8.0))];
    removes(bored, &inside(), &chamfer, cone(10.0, 8.0, 2.0) - cylinder(8.0, 2.0));
    let tube = LatheStock::new(&Region::tube(8.0, 20.0, -60.0, 0.0).unwrap());
    let taper = [line((0.0, 12.0), (-40.0, 8.0))];
    removes(tube, &inside(), &taper, cone(12.0, 8.0, 40.0) - cylinder(8.0, 40.0));
    // Through: a bar becomes a tube.
    let through = [along(0.0, 2.0, -70.0)];
    let left = removes(bar(20.0, -60.0, 0.0), &flat, &through, cylinder(5.0, 60.0));
    near(left.region().lowest_at(-30.0).unwrap(), 5.0, 0.0);
}

#[test]
fn parts_and_castings() {
    // Parted off.
    let tool = blade(2.0, 0.0).outline().unwrap();
    let left =
        removes(bar(10.0, -60.0, 0.0), &tool, &[plunge(-32.0, 12.0, -0.2)], cylinder(10.0, 2.0));
    assert_eq!(left.region().bodies().len(), 2);
    // A casting: a cone with a bore, given in either sense; turned to a cylinder.
    let outer = [at(0.0, 0.0), at(0.0, 10.0), at(-40.0, 20.0), at(-40.0, 0.0)];
    let bore = [at(0.0, 0.0), at(-10.0, 0.0), at(-10.0, 4.0), at(0.0, 4.0)];
    let closed = |corners: &[chordal_geometry::Vec2]| -> Vec<OutlineSegment> {
        let count = corners.len();
        (0..count)
            .map(|side| OutlineSegment::line(corners[side], corners[(side + 1) % count]))
            .collect()
    };
    let casting = Region::contour(&[closed(&outer), closed(&bore)]).unwrap();
    near(casting.volume(), cone(10.0, 20.0, 40.0) - cylinder(4.0, 10.0), 1e-9);
    // From r 15 on, at z −20, to r 20.
    let wanted = cone(15.0, 20.0, 20.0) - cylinder(15.0, 20.0);
    removes(LatheStock::new(&casting), &point(), &[along(15.0, 1.0, -40.0)], wanted);
    // A ring with a round section, halved by a facing pass.
    let circle = OutlineSegment::arc(at(-5.0, 20.0), at(-5.0, 20.0), at(-10.0, 20.0), true);
    let section = Region::contour(&[vec![circle]]).unwrap();
    near(section.volume(), turned(25.0 * PI, 20.0), 1e-9);
    let mut ring = LatheStock::new(&section);
    let pass = ring.cut(&point(), &plunge(-10.0, 30.0, 10.0)).unwrap();
    near(pass.volume, turned(12.5 * PI, 20.0), 1e-9);
    let turned_down = ring.cut(&point(), &along(20.0, 0.0, -20.0)).unwrap();
    // A quarter of the circle above its centre: its centroid is 4r/3π away.
    near(turned_down.volume, turned(6.25 * PI, 20.0 + 20.0 / (3.0 * PI)), 1e-9);
}

#[test]
fn wrong_outlines_are_named() {
    use chordal_stock::lathe::{RegionError as E, ToolError as T};
    let tri = |a, b, c| {
        vec![OutlineSegment::line(a, b), OutlineSegment::line(b, c), OutlineSegment::line(c, a)]
    };
    let region = |loops: &[Vec<OutlineSegment>]| Region::contour(loops).unwrap_err();
    assert!(matches!(Region::bar(0.0, 0.0, 1.0), Err(E::TooSmall { .. })));
    assert!(matches!(Region::bar(1.0, 2.0, 2.0), Err(E::TooSmall { what: "length", .. })));
    assert!(matches!(Region::tube(-1.0, 2.0, 0.0, 2.0), Err(E::BelowAxis { .. })));
    assert!(matches!(Region::bar(f64::NAN, 0.0, 1.0), Err(E::OutOfRange { .. })));
    let flat = tri(at(0.0, 0.0), at(1.0, 1.0), at(2.0, 2.0));
    assert_eq!(region(&[flat]), E::Empty { number: 1 });
    assert_eq!(region(&[vec![]]), E::Empty { number: 1 });
    let open = vec![
        OutlineSegment::line(at(0.0, 0.0), at(1.0, 0.0)),
        OutlineSegment::line(at(1.0, 0.5), at(0.0, 1.0)),
        OutlineSegment::line(at(0.0, 1.0), at(0.0, 0.0)),
    ];
    assert_eq!(region(&[open]), E::Open { number: 1, z: 1.0, r: 0.0 });
    let below = tri(at(0.0, -1.0), at(1.0, 0.0), at(0.0, 2.0));
    assert!(matches!(region(&[below]), E::BelowAxis { .. }));
    let bow = vec![
        OutlineSegment::line(at(0.0, 0.0), at(2.0, 2.0)),
        OutlineSegment::line(at(2.0, 2.0), at(2.0, 0.0)),
        OutlineSegment::line(at(2.0, 0.0), at(0.0, 1.0)),
        OutlineSegment::line(at(0.0, 1.0), at(0.0, 0.0)),
    ];
    assert_eq!(region(&[bow]), E::CrossesItself);
    let arc = vec![
        OutlineSegment::arc(at(0.0, 0.0), at(2.0, 0.0), at(0.5, 0.0), true),
        OutlineSegment::line(at(2.0, 0.0), at(0.0, 0.0)),
    ];
    assert!(matches!(region(&[arc]), E::Radii { first: 0.5, second: 1.5, .. }));

    assert_eq!(tip_error(10), T::Tip(10));
    assert!(matches!(blade(2.0, 1.1).outline(), Err(T::TooLarge { .. })));
    assert!(matches!(blade(0.0, 0.0).outline(), Err(T::NotPositive { what: "width", .. })));
    let bow = [at(0.0, 0.0), at(2.0, 2.0), at(2.0, 0.0), at(0.0, 1.0)];
    assert!(ToolOutline::polygon(&bow).is_err());
    assert!(ToolOutline::drill(10.0, PI / 2.0, 4.0).is_err());
    let _ = BladePoint::Middle;
}

fn tip_error(number: u8) -> chordal_stock::lathe::ToolError {
    chordal_stock::lathe::Tip::new(number).unwrap_err()
}
