//! What must not matter: where a move is divided, its sense, the order of passes that do not meet, which way
//! z points; and that twice the same takes nothing.

use chordal_stock::lathe::{LatheStock, OutlineSegment, Region, SegmentArc};

use crate::raster::{LENGTH, RADIUS, random_path, random_place, random_tool};
use crate::shop::{Random, at, bar, near, point, rounds};

/// Areas of regions that are the same differ by no more, mm².
const SAME: f64 = 1e-7;

fn same(one: &LatheStock, two: &LatheStock, what: &str) {
    let (one, two) = (one.region(), two.region());
    for (less, other) in [(&one, &two), (&two, &one)] {
        let off = less.difference(other).unwrap().region.area();
        assert!(off.abs() < SAME, "{what}: {off} mm²");
    }
}

/// Two parts of a path, divided at a place on it.
fn parts(path: &OutlineSegment, share: f64) -> [OutlineSegment; 2] {
    let middle = match path.bend {
        None => path.start + (path.end - path.start) * share,
        Some(bend) => {
            let (sin, cos) = libm::sincos(path.sweep() * share);
            let to = path.start - bend.center;
            bend.center + to * cos + to.turned_left() * sin
        }
    };
    [OutlineSegment { end: middle, ..*path }, OutlineSegment { start: middle, ..*path }]
}

fn reversed(path: &OutlineSegment) -> OutlineSegment {
    let back = |bend: SegmentArc| SegmentArc { counterclockwise: !bend.counterclockwise, ..bend };
    OutlineSegment { start: path.end, end: path.start, bend: path.bend.map(back), ..*path }
}

/// Mirrored at the middle of the stock.
fn mirrored(path: &OutlineSegment) -> OutlineSegment {
    let flip = |p: chordal_geometry::Vec2| at(-LENGTH - p.a, p.b);
    let back = |bend: SegmentArc| SegmentArc {
        center: flip(bend.center),
        counterclockwise: !bend.counterclockwise,
        ..bend
    };
    let (start, end) = (flip(path.start), flip(path.end));
    OutlineSegment { start, end, bend: path.bend.map(back), ..*path }
}

#[test]
fn divided_reversed_repeated_and_mirrored_moves_leave_the_same() {
    for round in 0..rounds(400) {
        let mut random = Random(0x1357_9BDF_2468_ACE0 ^ (round + 1).wrapping_mul(0x9E37_79B9));
        let fresh = || bar(RADIUS, -LENGTH, 0.0);
        let (mut whole, mut divided, mut back, mut mirror) = (fresh(), fresh(), fresh(), fresh());
        let mut from = random_place(&mut random);
        for _ in 0..4 {
            let tool = random_tool(&mut random);
            let path = random_path(&mut random, from);
            from = path.end;
            let pass = whole.cut(&tool, &path).unwrap();
            for part in parts(&path, random.between(0.01, 0.99)) {
                divided.cut(&tool, &part).unwrap();
            }
            back.cut(&tool, &reversed(&path)).unwrap();
            let other = mirror.cut(&tool.mirrored().unwrap(), &mirrored(&path)).unwrap();
            near(other.area, pass.area, SAME);
            near(other.volume, pass.volume, SAME * 200.0);
            near(other.across, pass.across, 1e-6);

            let again = whole.clone().cut(&tool, &path).unwrap();
            assert!(!again.touched && again.area < SAME, "round {round}: {again:?}");
            let (touch, _) = whole.touch(&tool, &path).unwrap();
            assert!(!touch.touched);
        }
        same(&whole, &divided, "divided");
        same(&whole, &back, "reversed");
        near(mirror.area(), whole.area(), SAME);
    }
}

#[test]
fn passes_that_do_not_meet_come_in_any_order() {
    for round in 0..rounds(200) {
        let mut random = Random(0xABCD_EF01_2345_6789 ^ (round + 1).wrapping_mul(0x9E37_79B9));
        let tool =
            chordal_stock::lathe::ToolOutline::round(random.between(0.2, 2.0), crate::shop::tip(0));
        let tool = tool.unwrap();
        // Each in its own stretch of 10 mm.
        let mut passes: Vec<OutlineSegment> = (0..6)
            .map(|stretch| {
                let z = -10.0 * f64::from(stretch);
                let mut place =
                    || at(z - random.between(2.5, 7.5), random.between(0.5, 1.1) * RADIUS);
                OutlineSegment::line(place(), place())
            })
            .collect();
        let mut forward = bar(RADIUS, -LENGTH, 0.0);
        passes.iter().for_each(|pass| assert!(forward.cut(&tool, pass).is_ok()));
        for at in (1..passes.len()).rev() {
            passes.swap(at, random.below(at + 1));
        }
        let mut mixed = bar(RADIUS, -LENGTH, 0.0);
        passes.iter().for_each(|pass| assert!(mixed.cut(&tool, pass).is_ok()));
        same(&forward, &mixed, "mixed");
        assert_eq!(forward.edges(), mixed.edges());
    }
}

#[test]
fn an_outline_comes_back_as_it_went_in() {
    let mut stock = bar(RADIUS, -LENGTH, 0.0);
    let fillet =
        OutlineSegment::arc(at(-20.0, 15.0), at(-25.0, 20.0), at(-20.0, 20.0), false).tagged(2);
    let path = [
        OutlineSegment::line(at(1.0, 15.0), at(-20.0, 15.0)).tagged(1),
        fillet,
        OutlineSegment::line(at(-25.0, 20.0), at(-25.0, 31.0)).tagged(3),
    ];
    for move_ in &path {
        stock.cut(&point(), move_).unwrap();
    }
    let region = stock.region();
    let outline = region.outline();
    // The edges that the moves made carry their tags; an arc stays one.
    let made = |tag: u32| outline[0].iter().filter(|side| side.tag == tag).count();
    // The flank has cut the wall while the tip was on the arc: nothing is left for the third.
    assert_eq!([made(0), made(1), made(2), made(3)], [4, 1, 2, 0], "{outline:?}");
    let arcs: Vec<&OutlineSegment> = outline[0].iter().filter(|side| side.bend.is_some()).collect();
    assert_eq!(arcs.len(), 1);
    let arc = arcs[0];
    assert!(arc.start.distance(fillet.start) < 1e-12 || arc.end.distance(fillet.start) < 1e-12);
    assert_eq!(arc.bend.unwrap().radius, 5.0);
    let again = Region::contour(&outline).unwrap();
    near(again.volume(), region.volume(), 1e-9);
    assert_eq!(again.shape()[0].len(), region.shape()[0].len());
}
