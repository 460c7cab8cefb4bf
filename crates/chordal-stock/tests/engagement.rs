//! Engagement of a cutter against worked cases, and against the exact floor of the moves before.

use std::f64::consts::PI;

use chordal_geometry::{Aabb, Arc, Curve, Frame, Line, ParamCurve, Plane, Vec3};
use chordal_stock::engagement::{
    BoundedValue, EngagementMeter, EngagementSlice, MeasureOptions, RemovedVolume, engagement_angle,
};
use chordal_stock::{ColumnOptions, ColumnStock, CutterProfile, TipMove, Undercut, floor};

mod support;

use support::Random;

const GRAZE: f64 = 0.005;

fn block(resolution: f64) -> ColumnStock {
    let bounds = Aabb::of_points(Vec3::new(0.0, 0.0, -20.0), Vec3::new(100.0, 60.0, 0.0));
    ColumnStock::new(bounds, ColumnOptions::new(resolution, 1 << 30)).unwrap()
}

fn meter(cutter: &CutterProfile, resolution: f64) -> EngagementMeter {
    EngagementMeter::new(
        cutter.clone(),
        resolution,
        MeasureOptions { spacing: resolution, graze: GRAZE },
    )
}

fn line(from: [f64; 3], to: [f64; 3]) -> Curve {
    Line::new(Vec3::from_array(from), Vec3::from_array(to)).into()
}

/// A turn about the middle of the block, counter-clockwise from X.
fn circle(radius: f64, z: f64, rise: f64) -> Curve {
    let frame = Frame { origin: Vec3::new(50.0, 30.0, z), ..Plane::Xy.frame() };
    Arc::new(frame, radius, 2.0 * PI, rise).into()
}

fn run(
    stock: &mut ColumnStock,
    cutter: &CutterProfile,
    curve: Curve,
) -> (Vec<EngagementSlice>, RemovedVolume) {
    let resolution = stock.grid().resolution();
    let mut slices = Vec::new();
    let removed =
        stock.cut_measuring(&meter(cutter, resolution), &TipMove { curve, tag: 0 }, &mut |slice| {
            slices.push(*slice);
        });
    (slices, removed)
}

/// The slices between two places along the move.
fn within(slices: &[EngagementSlice], from: f64, to: f64) -> Vec<EngagementSlice> {
    let found: Vec<EngagementSlice> =
        slices.iter().copied().filter(|slice| slice.at > from && slice.at < to).collect();
    assert!(!found.is_empty());
    found
}

fn encloses(between: BoundedValue, truth: f64, width: f64, what: &str) {
    let BoundedValue { least, most } = between;
    assert!(least <= truth + 1e-6 && truth <= most + 1e-6, "{what}: {least} {truth} {most}");
    assert!(most - least <= width, "{what}: {least} to {most} is wider than {width}");
}

#[test]
fn a_full_slot_is_a_slot() {
    // Case 1 of the worked ones, through 100 mm: 5000 mm³; of case 22 the slot: peak 1, mean 0.6366.
    let mut stock = block(0.1);
    let flat = CutterProfile::flat(10.0).unwrap();
    let (slices, removed) = run(&mut stock, &flat, line([-20.0, 30.0, -5.0], [120.0, 30.0, -5.0]));
    for slice in within(&slices, 30.0, 110.0) {
        encloses(slice.chip, 1.0, 0.01, "chip");
        encloses(slice.across, 10.0, 0.5, "across");
        encloses(slice.axial, 5.0, 0.001, "axial");
        encloses(slice.angle, PI, 0.35, "angle");
        encloses(slice.section, 50.0, 4.0, "section");
        assert!((slice.mean - 2.0 / PI).abs() < 0.002, "{}", slice.mean);
        assert!((slice.section_middle - 50.0).abs() < 0.2, "{}", slice.section_middle);
    }
    assert!(removed.bounds.least <= 5000.0 && 5000.0 <= removed.bounds.most);
    assert!((removed.middle - 5000.0).abs() < 25.0, "{removed:?}");
}

#[test]
fn a_slot_over_a_hollow_is_as_deep_as_the_roof() {
    // A hollow 20 wide from -12 to -8 along the whole block. A slot to -10 cuts its roof alone: 8 deep, 80 mm².
    let disc = Undercut::t_slot(20.0, 4.0, 8.0).unwrap();
    let along = |z: f64| line([-20.0, 30.0, z], [120.0, 30.0, z]);
    let hollow = || {
        let mut stock = block(0.1);
        stock.cut_below(&[(0.0, disc.clone())], &[TipMove { curve: along(-12.0), tag: 0 }]);
        stock
    };
    let flat = CutterProfile::flat(10.0).unwrap();
    let (slices, removed) = run(&mut hollow(), &flat, along(-10.0));
    for slice in within(&slices, 30.0, 110.0) {
        encloses(slice.chip, 1.0, 0.01, "chip");
        encloses(slice.axial, 8.0, 0.01, "axial");
        encloses(slice.section, 80.0, 6.0, "section");
        assert!((slice.section_middle - 80.0).abs() < 0.4, "{}", slice.section_middle);
    }
    assert!(removed.bounds.least <= 8000.0 && 8000.0 <= removed.bounds.most, "{removed:?}");
    assert!((removed.middle - 8000.0).abs() < 40.0, "{removed:?}");
    // Through the hollow it cuts the floor as well; what is surely engaged is one of the two.
    let (slices, removed) = run(&mut hollow(), &flat, along(-14.0));
    for slice in within(&slices, 30.0, 110.0) {
        encloses(slice.axial, 14.0, 6.01, "axial");
        assert!((slice.section_middle - 100.0).abs() < 0.5, "{}", slice.section_middle);
    }
    assert!((removed.middle - 10_000.0).abs() < 50.0, "{removed:?}");
}

#[test]
fn narrow_cuts_have_thin_chips() {
    // Case 22: a radial depth of 1 of a diameter of 10: 36.87 degrees, peak 0.6, mean 0.3108; half: 1 and 0.6366.
    let flat = CutterProfile::flat(10.0).unwrap();
    assert!((engagement_angle(1.0, 10.0).to_degrees() - 36.8699).abs() < 1e-4);
    for (across, peak, mean) in [(1.0, 0.6, 0.310_8), (5.0, 1.0, 2.0 / PI)] {
        let mut errors = Vec::new();
        for resolution in [0.2, 0.1, 0.05] {
            let mut stock = block(resolution);
            let y = across - 5.0;
            let path = line([-20.0, y, -4.0], [120.0, y, -4.0]);
            let (slices, _) = run(&mut stock, &flat, path);
            let mut error = 0.0_f64;
            for slice in within(&slices, 40.0, 100.0) {
                // A wall is known to a cell, along the path and across it.
                let room = 3.0 * resolution;
                encloses(slice.chip, peak, room / 5.0 / 0.6 + 0.02, "chip");
                encloses(slice.across, across, room, "across");
                encloses(slice.axial, 4.0, 0.001, "axial");
                encloses(slice.section, 4.0 * across, 4.0 * room, "section");
                error = error.max((slice.mean - mean).abs());
                error = error.max(slice.chip.most - peak);
            }
            errors.push(error);
        }
        assert!(errors[2] < 0.013, "{errors:?}");
        assert!(errors[2] <= errors[0], "finer cells know more: {errors:?}");
    }
}

#[test]
fn what_slices_remove_is_what_the_stock_has_lost() {
    // Q = ΔV/Δt: the sections along the path are the volume.
    let flat = CutterProfile::flat(10.0).unwrap();
    let bull = CutterProfile::bull(10.0, 2.0).unwrap();
    let ball = CutterProfile::ball(10.0).unwrap();
    for (cutter, curve, share) in [
        (&flat, line([-20.0, 30.0, -5.0], [120.0, 30.0, -5.0]), 0.01),
        (&flat, line([-20.0, -2.3, -5.0], [120.0, 7.7, -5.0]), 0.02),
        (&flat, line([10.0, 30.0, 0.0], [70.0, 30.0, -6.0]), 0.02),
        (&bull, line([-20.0, 30.0, -5.0], [120.0, 20.0, -5.0]), 0.02),
        (&ball, line([-20.0, 30.0, -3.0], [120.0, 30.0, -3.0]), 0.02),
        (&ball, line([20.0, 30.0, 1.0], [80.0, 30.0, -5.0]), 0.03),
        (&flat, circle(12.0, -3.0, 0.0), 0.05),
        (&flat, circle(3.0, 0.0, -2.0), 0.05),
        (&flat, line([50.0, 30.0, 2.0], [50.0, 30.0, -5.0]), 0.02),
    ] {
        let mut stock = block(0.1);
        let (slices, removed) = run(&mut stock, cutter, curve);
        let sum: f64 = slices.iter().map(|slice| slice.section_middle * slice.length).sum();
        // What a round or a circle leaves below the first place of the path is cut at once.
        let first = if curve.start().z < -1.0 && stock.grid().bounds().contains(curve.start()) {
            PI * 25.0 * -curve.start().z
        } else {
            0.0
        };
        let truth = removed.middle - first;
        assert!((sum / truth - 1.0).abs() < share, "{sum} {truth} {curve:?}");
    }
}

#[test]
fn plunges_and_ramps_cut_with_the_end() {
    let drill = CutterProfile::pointed(10.0, 0.0, 118.0_f64.to_radians()).unwrap();
    let mut stock = block(0.1);
    let (slices, _) = run(&mut stock, &drill, line([50.0, 30.0, 2.0], [50.0, 30.0, -12.0]));
    for slice in within(&slices, 6.0, 13.0) {
        // The normal of the edge leans by 31 degrees from down.
        encloses(slice.chip, 59.0_f64.to_radians().sin(), 0.01, "chip");
        encloses(slice.across, 10.0, 0.7, "across");
    }
    let flat = CutterProfile::flat(10.0).unwrap();
    let mut stock = block(0.1);
    let (slices, _) = run(&mut stock, &flat, line([20.0, 30.0, 0.0], [80.0, 30.0, -6.0]));
    for slice in within(&slices, 30.0, 60.0) {
        // The side faces the feed but for the ramp, so much is its cosine.
        encloses(slice.chip, 1.0 / 1.01_f64.sqrt(), 0.02, "chip");
    }
}

#[test]
fn a_circle_meets_its_own_beginning() {
    // A full circle with the middle of the cutter on 12: where it began, half of the slot is gone.
    let flat = CutterProfile::flat(10.0).unwrap();
    let mut stock = block(0.1);
    let circle = circle(12.0, -3.0, 0.0);
    let (slices, _) = run(&mut stock, &flat, circle);
    let length = circle.length();
    // Where a piece of the circle begins, its wall is only known to a cell.
    for slice in within(&slices, 15.0, 60.0) {
        encloses(slice.chip, 1.0, 1.0, "chip");
        assert!(slice.across.most > 9.9 && slice.mean > 0.5, "{slice:?}");
    }
    let sure = within(&slices, 15.0, 60.0);
    assert!(sure.iter().any(|slice| slice.chip.least > 0.97 && slice.across.least > 9.0));
    // At its end only what cells do not know of the walls is left: 0.14 mm to either side.
    let end = within(&slices, length - 2.0, length);
    assert!(end.iter().all(|slice| slice.chip.most < 0.4 && slice.chip.least == 0.0), "{end:?}");
    // A second time it finds nothing.
    let (slices, removed) = run(&mut stock, &flat, circle);
    let thin = slices.iter().all(|slice| slice.chip.least == 0.0);
    assert!(thin && removed.middle.abs() < 1.0, "{removed:?}");
}

/// The truth by sampling: the largest u·n where the moves before have left material.
fn dense(cutter: &CutterProfile, before: &[Curve], curve: &Curve, at: [f64; 2]) -> f64 {
    const PLACES: usize = 12;
    let radius = cutter.radius();
    let bounds = Aabb::of_points(Vec3::new(0.0, 0.0, -20.0), Vec3::new(100.0, 60.0, 0.0));
    let mut most = 0.0_f64;
    for k in 0..=PLACES {
        let s = at[0] + (at[1] - at[0]) * k as f64 / PLACES as f64;
        let (tip, feed) = (curve.point_at(s), curve.tangent_at(s));
        let feed = feed * (1.0 / feed.length());
        let plan = feed.x.hypot(feed.y);
        let ahead = if plan > 1e-9 { [feed.x / plan, feed.y / plan] } else { [1.0, 0.0] };
        for n in 0..720 {
            let angle = f64::from(n) * PI / 360.0;
            let (sine, cosine) = angle.sin_cos();
            let outward =
                [ahead[0] * cosine - ahead[1] * sine, ahead[1] * cosine + ahead[0] * sine];
            // The side: as high as the material is.
            let place = [tip.x + radius * outward[0], tip.y + radius * outward[1]];
            let inside = place[0] >= bounds.min.x
                && place[0] <= bounds.max.x
                && place[1] >= bounds.min.y
                && place[1] <= bounds.max.y;
            if !inside {
                continue;
            }
            let left = before
                .iter()
                .filter_map(|path| floor::floor(cutter, path, place, 1e-6))
                .fold(0.0_f64, f64::min);
            if left > tip.z + cutter.side() + 2.0 * GRAZE {
                most = most.max(plan * cosine);
            }
        }
    }
    most
}

#[test]
fn the_truth_lies_between_the_bounds() {
    let mut random = Random(22);
    let flat = CutterProfile::flat(8.0).unwrap();
    let mut looked = 0;
    for _ in 0..12 {
        let mut stock = block(0.25);
        let mut before: Vec<Curve> = Vec::new();
        for _ in 0..5 {
            let mut point = || {
                [
                    random.between(-5.0, 105.0),
                    random.between(-5.0, 65.0),
                    random.between(-6.0, -1.0),
                ]
            };
            let (from, mut to) = (point(), point());
            to[2] = from[2];
            let curve = line(from, to);
            let (slices, _) = run(&mut stock, &flat, curve);
            for slice in slices.iter().step_by(37) {
                let at = [slice.at - 0.5 * slice.length, slice.at + 0.5 * slice.length];
                let truth = dense(&flat, &before, &curve, at);
                looked += 1;
                assert!(truth <= slice.chip.most + 1e-9, "{truth} {slice:?}");
                // Dense places are half a degree apart.
                assert!(truth >= slice.chip.least - 0.02, "{truth} {slice:?}");
            }
            before.push(curve);
        }
    }
    assert!(looked > 300, "{looked}");
}

#[test]
fn the_truth_lies_between_the_bounds_over_hollows() {
    // Discs of 16 and 3 on random lines, then a flat of 8 through the stock and its hollows.
    let mut random = Random(23);
    let disc = Undercut::t_slot(16.0, 3.0, 6.0).unwrap();
    let flat = CutterProfile::flat(8.0).unwrap();
    let (mut looked, mut hollow) = (0, 0);
    for _ in 0..12 {
        let mut stock = block(0.25);
        let mut point = |low: f64, high: f64| {
            [random.between(-5.0, 105.0), random.between(-5.0, 65.0), random.between(low, high)]
        };
        let ends: [([f64; 3], [f64; 3]); 3] = core::array::from_fn(|k| {
            let (low, high) = if k < 2 { (-12.0, -4.0) } else { (-14.0, -2.0) };
            let (from, mut to) = (point(low, high), point(low, high));
            to[2] = from[2];
            (from, to)
        });
        let gaps = &ends[..2];
        for (from, to) in gaps {
            stock.cut_below(&[(0.0, disc.clone())], &[TipMove { curve: line(*from, *to), tag: 0 }]);
        }
        let curve = line(ends[2].0, ends[2].1);
        let (slices, _) = run(&mut stock, &flat, curve);
        let height = ends[2].0[2];
        // What of a column above the end of the cutter is stock, as stretches.
        let left = |place: [f64; 2]| {
            let mut stock = vec![[height, 0.0]];
            for (from, _) in gaps.iter().filter(|(from, to)| near_line(place, *from, *to) <= 8.0) {
                let [floor, top] = [from[2], from[2] + 3.0];
                stock = stock
                    .iter()
                    .flat_map(|&[low, high]| [[low, high.min(floor)], [low.max(top), high]])
                    .filter(|[low, high]| low < high)
                    .collect();
            }
            stock
        };
        for slice in slices.iter().step_by(23) {
            let mut truth = 0.0_f64;
            for k in 0..=12 {
                let tip = curve.point_at(slice.at + slice.length * (f64::from(k) / 12.0 - 0.5));
                let feed = curve.tangent_at(slice.at);
                for n in 0..720 {
                    let (sine, cosine) = (f64::from(n) * PI / 360.0).sin_cos();
                    let place = [
                        tip.x + 4.0 * (feed.x * cosine - feed.y * sine),
                        tip.y + 4.0 * (feed.y * cosine + feed.x * sine),
                    ];
                    let is_in =
                        (0.0..=100.0).contains(&place[0]) && (0.0..=60.0).contains(&place[1]);
                    let stock = left(place);
                    hollow += u32::from(is_in && stock != [[height, 0.0]]);
                    if is_in && stock.iter().any(|[low, high]| high - low > 2.0 * GRAZE) {
                        truth = truth.max(cosine);
                    }
                }
            }
            looked += 1;
            assert!(truth <= slice.chip.most + 1e-9, "{truth} {slice:?}");
            assert!(truth >= slice.chip.least - 0.02, "{truth} {slice:?}");
        }
    }
    assert!(looked > 60 && hollow > 10_000, "{looked} {hollow}");
}

/// How far a place is from a line, both seen from above, mm.
fn near_line(place: [f64; 2], from: [f64; 3], to: [f64; 3]) -> f64 {
    let way = [to[0] - from[0], to[1] - from[1]];
    let square = way[0] * way[0] + way[1] * way[1];
    let share = ((place[0] - from[0]) * way[0] + (place[1] - from[1]) * way[1]) / square;
    let share = share.clamp(0.0, 1.0);
    (place[0] - from[0] - share * way[0]).hypot(place[1] - from[1] - share * way[1])
}

#[test]
fn mirrored_cuts_are_engaged_alike() {
    let flat = CutterProfile::flat(10.0).unwrap();
    let first = |mirror: f64| {
        let y = |y: f64| 30.0 + mirror * (y - 30.0);
        let mut stock = block(0.1);
        run(&mut stock, &flat, line([-20.0, y(20.0), -4.0], [120.0, y(20.0), -4.0]));
        run(&mut stock, &flat, line([-20.0, y(26.0), -4.0], [120.0, y(27.0), -4.0])).0
    };
    let (one, other) = (first(1.0), first(-1.0));
    assert_eq!(one.len(), other.len());
    for (a, b) in one.iter().zip(&other) {
        assert!((a.chip.most - b.chip.most).abs() < 0.02, "{a:?} {b:?}");
        assert!((a.section_middle - b.section_middle).abs() < 0.1, "{a:?} {b:?}");
    }
}

#[test]
fn finer_cells_narrow_the_bounds() {
    let ball = CutterProfile::ball(8.0).unwrap();
    let widths: Vec<f64> = [0.4, 0.2, 0.1]
        .map(|resolution| {
            let mut stock = block(resolution);
            run(&mut stock, &ball, line([-20.0, 20.0, -4.0], [120.0, 20.0, -4.0]));
            let (slices, _) =
                run(&mut stock, &ball, line([-20.0, 23.0, -4.0], [120.0, 23.0, -4.0]));
            let some = within(&slices, 40.0, 100.0);
            some.iter().map(|slice| slice.chip.most - slice.chip.least).fold(0.0, f64::max)
        })
        .to_vec();
    assert!(widths[2] < widths[0], "{widths:?}");
}

#[test]
fn nothing_is_engaged_in_air_and_odd_moves_are_left_out() {
    let flat = CutterProfile::flat(10.0).unwrap();
    let mut stock = block(0.5);
    for curve in [
        line([-20.0, 30.0, 1.0], [120.0, 30.0, 1.0]),
        line([-20.0, -30.0, -5.0], [120.0, -30.0, -5.0]),
        line([f64::NAN, 0.0, 0.0], [1.0, 0.0, 0.0]),
        line([50.0, 30.0, 5.0], [50.0, 30.0, 5.0]),
    ] {
        let (slices, removed) = run(&mut stock, &flat, curve);
        assert!(slices.is_empty() && removed == RemovedVolume::default(), "{curve:?}");
    }
    // Up out of the material nothing is cut.
    run(&mut stock, &flat, line([50.0, 30.0, 5.0], [50.0, 30.0, -5.0]));
    let (slices, _) = run(&mut stock, &flat, line([50.0, 30.0, -5.0], [50.0, 30.0, 5.0]));
    assert!(slices.is_empty(), "{slices:?}");
}
