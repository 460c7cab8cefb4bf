//! Outlines of tools: where the programmed point is, what is exact and what is bounded.

use core::f64::consts::{FRAC_PI_2, PI};

use chordal_geometry::Vec2;
use chordal_stock::lathe::{
    Blade, BladeFacing, BladePoint, Insert, InsertShape, OutlineSegment, Region, Tip, ToolOutline,
};

use crate::shop::{at, bar, blade, near, tip};

/// The area of a tool of one convex part.
fn area(tool: &ToolOutline) -> f64 {
    let outlines = tool.outlines();
    assert_eq!(outlines.len(), 1);
    let up = |p: Vec2| at(p.a, p.b + 1000.0);
    let lifted = |side: &OutlineSegment| match side.bend {
        None => OutlineSegment::line(up(side.start), up(side.end)),
        Some(bend) => OutlineSegment::arc(up(side.start), up(side.end), up(bend.center), true),
    };
    let lifted: Vec<OutlineSegment> = outlines[0].iter().map(lifted).collect();
    Region::contour(&[lifted]).unwrap().area()
}

#[test]
fn the_programmed_point_lies_where_the_tip_says() {
    for number in 1..=8 {
        let tip = Tip::new(number).unwrap();
        let insert = Insert {
            nose: 0.8,
            tip,
            flanks: [0.3, 0.3 + 80_f64.to_radians()],
            length: 12.0,
            shape: InsertShape::Parallelogram,
        };
        let outlines = insert.outline().unwrap().outlines();
        let bends: Vec<_> = outlines[0].iter().filter_map(|side| side.bend).collect();
        assert_eq!(bends.len(), 1);
        let wanted = tip.to_center() * 0.8;
        near(bends[0].center.distance(wanted), 0.0, 1e-14);
        near(bends[0].radius, 0.8, 1e-15);
    }
    // Tips as they are drawn: an outside tool's nose lies above and to the right of its point.
    assert_eq!(tip(3).to_center(), at(1.0, 1.0));
    assert_eq!(tip(2).to_center(), at(1.0, -1.0));
    assert_eq!(tip(8).to_center(), at(0.0, 1.0));
    assert_eq!(tip(0).to_center(), tip(9).to_center());
}

#[test]
fn held_inserts_lean_as_holders_hold_them() {
    // PCLNL 95° with CNMG 80°: 5° clear of a shoulder and of a face.
    let insert =
        Insert::mounted(tip(3), 0.8, 95_f64.to_radians(), 80_f64.to_radians(), 12.0).unwrap();
    near(insert.flanks[0], 5_f64.to_radians(), 1e-15);
    near(insert.flanks[1], 85_f64.to_radians(), 1e-15);
    // In a bore it is mirrored at the axis, towards +z at a plane across it.
    for (number, low, high) in [(2, -85.0, -5.0), (4, 95.0, 175.0), (1, 185.0, 265.0)] {
        let (approach, included) = (95_f64.to_radians(), 80_f64.to_radians());
        let other = Insert::mounted(tip(number), 0.8, approach, included, 12.0).unwrap();
        near(other.flanks[0].to_degrees(), low, 1e-12);
        near(other.flanks[1].to_degrees(), high, 1e-12);
    }
    let tool = insert.outline().unwrap();
    let mirrored = tool.mirrored().unwrap();
    near(area(&mirrored), area(&tool), 1e-9);
    near(area(&tool.across().unwrap()), area(&tool), 1e-9);
    // The rhombus without what the nose leaves of its corner: r²(1/tan(ε/2) − (π − ε)/2).
    let half = 40_f64.to_radians();
    let whole = 144.0 * (2.0 * half).sin();
    near(area(&tool), whole - 0.64 * (1.0 / half.tan() - (FRAC_PI_2 - half)), 1e-9);
}

#[test]
fn blades_have_their_width_and_corners() {
    for facing in
        [BladeFacing::Outside, BladeFacing::Inside, BladeFacing::Face, BladeFacing::BackFace]
    {
        for (point, from) in
            [(BladePoint::Lower, 0.0), (BladePoint::Middle, -1.5), (BladePoint::Upper, -3.0)]
        {
            let tool = Blade { facing, point, length: 20.0, ..blade(3.0, 0.2) }.outline().unwrap();
            near(area(&tool), 60.0 - 2.0 * 0.04 * (1.0 - PI / 4.0), 1e-9);
            let outlines = tool.outlines();
            let across = |p: Vec2| match facing {
                BladeFacing::Outside | BladeFacing::Inside => p.a,
                BladeFacing::Face | BladeFacing::BackFace => p.b,
            };
            let places = || outlines[0].iter().map(|side| across(side.start));
            near(places().fold(f64::INFINITY, f64::min), from, 1e-14);
            near(places().fold(f64::NEG_INFINITY, f64::max), from + 3.0, 1e-14);
        }
    }
}

#[test]
fn a_form_tool_is_exact_outside_and_bounded_inside() {
    // A concave radius of 4 between two lips: it leaves a bead.
    let outline = |bulge: bool| {
        vec![
            OutlineSegment::line(at(-6.0, 0.0), at(-4.0, 0.0)),
            OutlineSegment::arc(at(-4.0, 0.0), at(4.0, 0.0), at(0.0, 0.0), bulge),
            OutlineSegment::line(at(4.0, 0.0), at(6.0, 0.0)),
            OutlineSegment::line(at(6.0, 0.0), at(6.0, 12.0)),
            OutlineSegment::line(at(6.0, 12.0), at(-6.0, 12.0)),
            OutlineSegment::line(at(-6.0, 12.0), at(-6.0, 0.0)),
        ]
    };
    let inward = ToolOutline::form(&outline(false), 0.01).unwrap();
    assert!(inward.bound() > 0.0 && inward.bound() <= 0.01);
    let mut stock = bar(20.0, -40.0, 0.0);
    let pass = stock.cut(&inward, &OutlineSegment::line(at(-20.0, 30.0), at(-20.0, 14.0))).unwrap();
    assert_eq!(pass.bound, inward.bound());
    let wanted = 12.0 * 6.0 - 8.0 * PI;
    assert!(pass.area >= wanted && pass.area <= wanted + 4.0 * PI * pass.bound, "{pass:?}");
    near(stock.region().highest_at(-20.0).unwrap(), 18.0, pass.bound + 1e-12);

    // The same bulging outward is exact, also along an arc.
    let outward = ToolOutline::form(&outline(true), 0.01).unwrap();
    assert_eq!(outward.bound(), 0.0);
    let mut stock = bar(20.0, -40.0, 0.0);
    let pass =
        stock.cut(&outward, &OutlineSegment::line(at(-20.0, 30.0), at(-20.0, 18.0))).unwrap();
    near(pass.area, 12.0 * 2.0 + 8.0 * PI, 1e-9);
    assert_eq!(pass.bound, 0.0);
}
