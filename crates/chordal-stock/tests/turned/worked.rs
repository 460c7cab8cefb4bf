//! Cases worked by hand.

use core::f64::consts::PI;

use chordal_stock::lathe::{Insert, InsertShape, LatheStock, OutlineSegment, Region};

use crate::shop::{at, bar, blade, follow, near, point, tip, turn};

#[test]
fn a_bar_turned_down_a_taper_and_a_groove() {
    let mut stock = bar(25.0, -60.0, 0.0);
    let pass = turn(&mut stock, &point(), &[(40.0, 2.0), (40.0, -30.0)])[0];
    near(pass.volume, 6750.0 * PI, 1e-9);
    assert_eq!((pass.across, pass.along), (5.0, 30.0));

    let mut stock = bar(25.0, -60.0, 0.0);
    let taper = OutlineSegment::line(at(0.0, 15.0), at(-40.0, 25.0));
    let pass = stock.cut(&point(), &taper).unwrap();
    near(pass.volume, 27_227.136, 5e-4);
    // The cone that stays is π/3·40·(15² + 15·25 + 25²).
    near(pass.volume, PI * 40.0 * (625.0 - (225.0 + 375.0 + 625.0) / 3.0), 1e-9);

    let mut stock = bar(20.0, -60.0, 0.0);
    let tool = blade(3.0, 0.0).outline().unwrap();
    let pass = turn(&mut stock, &tool, &[(44.0, -23.0), (32.0, -23.0)])[0];
    near(pass.volume, 432.0 * PI, 1e-9);
    assert_eq!((pass.across, pass.along), (3.0, 4.0));
}

#[test]
fn half_a_sphere_and_a_relief() {
    let mut stock = bar(15.0, -50.0, 0.0);
    let path = [
        OutlineSegment::arc(at(0.0, 0.0), at(-10.0, 10.0), at(-10.0, 0.0), true),
        OutlineSegment::line(at(-10.0, 10.0), at(-10.0, 16.0)),
    ];
    let volume: f64 = follow(&mut stock, &point(), &path).iter().map(|pass| pass.volume).sum();
    near(volume, 2250.0 * PI - 2000.0 * PI / 3.0, 1e-9);

    let mut stock = bar(10.0, -50.0, 0.0);
    let slim = Insert {
        nose: 0.0,
        tip: tip(8),
        flanks: [PI / 3.0, 2.0 * PI / 3.0],
        length: 30.0,
        shape: InsertShape::Parallelogram,
    };
    let run = 1.15 * 3_f64.sqrt();
    let corners =
        [(20.0, -20.0), (17.7, -20.0 - run), (17.7, -22.0 - run), (20.0, -22.0 - 2.0 * run)];
    let tool = slim.outline().unwrap();
    let volume: f64 = turn(&mut stock, &tool, &corners).iter().map(|pass| pass.volume).sum();
    near(volume, 274.612, 5e-4);
}

#[test]
fn what_a_nose_leaves_on_a_taper_and_a_cusp() {
    // Uncompensated nose 0.8 on a taper of 30°: the surface lies 0.585641 off along z, 0.338120 in r.
    let insert =
        Insert::mounted(tip(3), 0.8, 95_f64.to_radians(), 35_f64.to_radians(), 40.0).unwrap();
    let tool = insert.outline().unwrap();
    let mut stock = bar(30.0, -60.0, 0.0);
    let slope = 30_f64.to_radians().tan();
    stock
        .cut(&tool, &OutlineSegment::line(at(1.0, 15.0 - slope), at(-40.0, 15.0 + 40.0 * slope)))
        .unwrap();
    let (z, radius) = (-20.0, 15.0 + 20.0 * slope);
    let top = stock.region().highest_at(z).unwrap();
    near(top - radius, 0.338_120, 5e-7);
    near((top - radius) / slope, 0.585_641, 5e-7);

    // Feed 0.2 with a nose of 0.8 leaves cusps of r − √(r² − f²/4).
    let mut stock = bar(30.0, -60.0, 0.0);
    for step in 0..20 {
        let z = -10.0 - 0.2 * f64::from(step);
        stock.cut(&tool, &OutlineSegment::line(at(z, 31.0), at(z, 29.0))).unwrap();
    }
    // Between two places of the nose, whose centre is 0.8 to the right of the programmed point.
    let ridge = stock.region().highest_at(-10.0 + 0.8 - 0.1 - 1.0).unwrap();
    near(ridge - 29.0, 0.006_275, 5e-7);
}

/// G71 I of the reference: X62 Z2, U2.5 R1, allowance U.6 W.2, then G70.
#[test]
fn a_roughing_cycle_and_its_finish() {
    let mut stock = bar(30.0, -60.0, 0.0);
    let tool = point();
    near(stock.area(), 1800.0, 1e-9);
    near(stock.volume(), 169_646.003, 5e-4);
    let ends = [
        (57.6, -49.8),
        (52.6, -49.8),
        (47.6, -49.8),
        (42.6, -49.8),
        (37.6, -32.55),
        (32.6, -28.8),
        (27.6, -25.05),
        (22.6, -21.3),
    ];
    for (x, z) in ends {
        let corners = [(62.6, 2.2), (x, 2.2), (x, z), (x + 2.0, z + 1.0), (x + 2.0, 2.2)];
        turn(&mut stock, &tool, &corners);
    }
    near(stock.area(), 1097.49, 1e-9);
    near(stock.volume(), 71_508.420, 5e-4);
    let profile =
        [(20.6, 2.2), (20.6, -19.8), (40.6, -34.8), (40.6, -49.8), (62.6, -49.8), (62.0, 2.0)];
    turn(&mut stock, &tool, &profile);
    near(stock.area(), 1043.94, 1e-9);
    near(stock.volume(), 66_282.208, 5e-4);
    // What is left for G70, and that nothing is gone that should stay.
    let corners = [(0.0, -60.0), (0.0, 0.0), (10.0, 0.0), (10.0, -20.0), (20.0, -35.0)];
    let corners = corners.into_iter().chain([(20.0, -50.0), (30.0, -50.0), (30.0, -60.0)]);
    let corners: Vec<_> = corners.map(|(r, z)| at(z, r)).collect();
    let sides = (0..8).map(|side| OutlineSegment::line(corners[side], corners[(side + 1) % 8]));
    let target = Region::contour(&[sides.collect()]).unwrap();
    let left = stock.region().difference(&target).unwrap().region;
    near(left.area(), 18.94, 1e-9);
    near(left.volume(), stock.volume() - 20_500.0 * PI, 1e-8);
    assert!(target.difference(&stock.region()).unwrap().region.is_empty());
    let finish =
        [(62.0, 2.0), (20.0, 2.0), (20.0, -20.0), (40.0, -35.0), (40.0, -50.0), (62.0, -50.0)];
    turn(&mut stock, &tool, &finish);
    near(stock.area(), 1025.0, 1e-9);
    near(stock.volume(), 20_500.0 * PI, 1e-8);
    let shape = stock.region().shape();
    assert_eq!(shape.len(), 1);
    assert_eq!(shape[0].len(), 8, "{shape:?}");
}

/// G75 of the reference: four plunges of a blade 3 wide.
#[test]
fn a_grooving_cycle() {
    let mut stock = bar(30.0, -60.0, 0.0);
    let tool = blade(3.0, 0.0).outline().unwrap();
    let mut areas = Vec::new();
    for z in [-23.0, -25.5, -28.0, -30.0] {
        let pecks = [(62.0, z), (56.0, z), (57.0, z), (50.0, z), (51.0, z), (44.0, z), (45.0, z)];
        let mut area = 0.0;
        for corners in [&pecks[..], &[(45.0, z), (40.0, z), (62.0, z)]] {
            area += turn(&mut stock, &tool, corners).iter().map(|pass| pass.area).sum::<f64>();
        }
        areas.push(area);
    }
    for (found, wanted) in areas.iter().zip([30.0, 25.0, 25.0, 20.0]) {
        near(*found, wanted, 1e-9);
    }
    near(169_646.003_293 - stock.volume(), 5000.0 * PI, 1e-6);
    near(5400.0 * 10.0 * PI - stock.volume(), 5000.0 * PI, 1e-8);
}

#[test]
fn a_bar_is_parted_or_leaves_a_pip() {
    let tool = blade(3.0, 0.2).outline().unwrap();
    let mut stock = bar(10.0, -60.0, 0.0);
    turn(&mut stock, &tool, &[(24.0, -33.0), (1.0, -33.0)]);
    let (_, radius) = stock.region().neck(-33.0, -30.0).unwrap();
    near(radius, 0.5, 1e-12);
    assert_eq!(stock.region().bodies().len(), 1);

    turn(&mut stock, &tool, &[(1.0, -33.0), (-0.4, -33.0)]);
    let (_, radius) = stock.region().neck(-33.0, -30.0).unwrap();
    assert_eq!(radius, 0.0);
    let bodies = stock.region().bodies();
    assert_eq!(bodies.len(), 2);
    near(bodies[0].volume(), 3000.0 * PI, 1e-9);
    near(bodies[1].volume(), 2700.0 * PI, 1e-9);
}

#[test]
fn a_wall_stays_between_two_grooves() {
    let tool = blade(3.0, 0.0).outline().unwrap();
    let mut stock = bar(30.0, -60.0, 0.0);
    for z in [-23.0, -26.5] {
        turn(&mut stock, &tool, &[(62.0, z), (40.0, z), (62.0, z)]);
    }
    let walls = stock.region().spans_at(25.0, chordal_stock::lathe::PlaceSide::Higher);
    assert_eq!(walls, [(-60.0, -26.5), (-23.5, -23.0), (-20.0, 0.0)]);
}

#[test]
fn a_rapid_and_a_holder_in_the_stock_are_measured() {
    let stock = bar(30.0, -60.0, 0.0);
    let tool = point();
    let (pass, region) =
        stock.touch(&tool, &OutlineSegment::line(at(5.0, 29.9), at(-40.0, 29.9))).unwrap();
    assert!(pass.touched);
    near(pass.depth(), 0.1, 1e-12);
    near(region.area(), 4.0, 1e-9);
    // Along the surface, and just above it.
    for r in [30.0, 30.0 + 1e-6] {
        let (pass, _) =
            stock.touch(&tool, &OutlineSegment::line(at(5.0, r), at(-40.0, r))).unwrap();
        assert!(!pass.touched);
        assert_eq!(pass.area, 0.0);
    }
    // A holder that begins 10 to the right of the tip and 20 above it, into a shoulder.
    let mut stock = LatheStock::new(&Region::bar(50.0, -60.0, 0.0).unwrap());
    turn(&mut stock, &tool, &[(40.0, 2.0), (40.0, -20.0), (110.0, -20.0)]);
    let corners = [at(-2.0, 20.0), at(20.0, 20.0), at(20.0, 60.0), at(-2.0, 60.0)];
    let holder = chordal_stock::lathe::ToolOutline::polygon(&corners).unwrap();
    let (pass, _) =
        stock.touch(&holder, &OutlineSegment::line(at(2.0, 20.0), at(-19.5, 20.0))).unwrap();
    near(pass.along, 1.5, 1e-12);
    near(pass.across, 10.0, 1e-12);
}
