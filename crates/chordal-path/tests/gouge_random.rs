//! The gouge check on thousands of random contours, against sampling and against the offset of an
//! independent library.

mod support;

use cavalier_contours::polyline::PlineSource;
use chordal_path::gouge::{
    GougeCurve, GougeOptions, LimitReason, OutsideCornerRule, ToolSide, check, clearance, range,
};
use support::{
    Dice, closed_contour, contour, curves_of, has_inside_corner_with_arc, necked_pocket,
    offset_path, point_distance, polyline, sampled_distance,
};

fn side_of(dice: &mut Dice) -> ToolSide {
    if dice.unit() < 0.5 { ToolSide::Left } else { ToolSide::Right }
}

#[test]
fn the_search_finds_what_looking_at_every_pair_finds() {
    let options = GougeOptions::default();
    let (mut clean, mut gouging) = (0, 0);
    for seed in 0..6000 {
        let mut dice = Dice::new(seed);
        let curves = closed_contour(&mut dice);
        let side = side_of(&mut dice);
        let radius = 0.2 * 2.0_f64.powf(dice.between(0.0, 7.0));
        let Some(path) = offset_path(&curves, side, radius) else { continue };
        let contour = contour(&curves, side, radius);
        let report = check(&contour, &path, &options);
        let nearest = clearance(&contour, &path, &options).unwrap();
        assert!(report.complete);
        match report.gouges.first() {
            Some(deepest) => {
                gouging += 1;
                assert!(
                    (deepest.depth + nearest.clearance).abs() < 1e-9,
                    "seed {seed}, radius {radius}: {deepest:?} but {nearest:?}"
                );
            }
            None => {
                clean += 1;
                assert!(nearest.clearance >= -options.epsilon, "seed {seed}: {nearest:?}");
                assert!(nearest.clearance < 1e-9, "seed {seed}: the path leaves the contour");
            }
        }
        for gouge in &report.gouges {
            let to_contour = |c: &GougeCurve| point_distance(c, gouge.center);
            let distance = curves.iter().map(to_contour).fold(f64::INFINITY, f64::min);
            assert!(distance <= radius - gouge.depth + 1e-9, "seed {seed}: {gouge:?}");
            assert!(gouge.depth > options.epsilon);
        }
    }
    assert!(clean > 1000 && gouging > 1000, "{clean} clean, {gouging} gouging");
}

#[test]
fn sampling_finds_nothing_nearer() {
    let options = GougeOptions::default();
    for seed in 0..150 {
        let mut dice = Dice::new(seed + 100_000);
        let curves = closed_contour(&mut dice);
        let side = side_of(&mut dice);
        let radius = dice.between(0.2, 12.0);
        let Some(path) = offset_path(&curves, side, radius) else { continue };
        let found = clearance(&contour(&curves, side, radius), &path, &options).unwrap();
        let sampled = sampled_distance(&curves, &path, 60) - radius;
        assert!(found.clearance <= sampled + 1e-9, "seed {seed}");
        // A sample lies within half a step of the nearest place.
        let step = path.iter().map(|m| m.curve.length()).fold(0.0, f64::max) / 120.0;
        assert!(sampled <= found.clearance + step, "seed {seed}");
    }
}

/// The library's offset is what can be machined without a gouge. Where the path has none, it is the
/// offset; where it has one, part of the path is not in the offset.
#[test]
fn a_gouge_is_what_an_offset_library_cuts_away() {
    // Loops a micron deep are millimetres long between shallow corners.
    let options = GougeOptions { epsilon: 1e-6, ..GougeOptions::default() };
    let (mut clean, mut gouging, mut unlike) = (0, 0, 0);
    for seed in 0..3000 {
        let mut dice = Dice::new(seed + 200_000);
        let curves = closed_contour(&mut dice);
        let side = side_of(&mut dice);
        let radius = dice.between(0.2, 4.0);
        let Some(path) = offset_path(&curves, side, radius) else { continue };
        let report = check(&contour(&curves, side, radius), &path, &options);
        let offset = polyline(&curves).parallel_offset(side.sign() * radius);
        let theirs: f64 = offset.iter().map(PlineSource::path_length).sum();
        let ours: f64 = path.iter().map(|m| m.curve.length()).sum();
        match report.gouges.first() {
            None => {
                clean += 1;
                unlike += usize::from((theirs - ours).abs() > 0.05);
            }
            Some(gouge) => {
                gouging += 1;
                let away = offset
                    .iter()
                    .flat_map(curves_of)
                    .map(|c| point_distance(&c, gouge.center))
                    .fold(f64::INFINITY, f64::min);
                // The library keeps what comes no nearer than the radius less 1e-4.
                assert!(away >= gouge.depth - 2e-4, "seed {seed}: {gouge:?} {away}");
            }
        }
    }
    // Once the library's offset is a tenth of a millimetre longer than a path that keeps its
    // distance everywhere.
    assert!(unlike <= 1, "{unlike}");
    assert!(clean > 500 && gouging > 500, "{clean} clean, {gouging} gouging");
}

#[test]
fn just_below_the_limit_nothing_is_cut_and_just_above_something_is() {
    let options = GougeOptions { epsilon: 1e-7, ..GougeOptions::default() };
    let (mut throats, mut short, mut arcs) = (0, 0, 0);
    for seed in 0..3000 {
        let mut dice = Dice::new(seed + 300_000);
        let (curves, side) = if seed % 3 == 0 {
            (necked_pocket(&mut dice), ToolSide::Left)
        } else {
            (closed_contour(&mut dice), side_of(&mut dice))
        };
        if has_inside_corner_with_arc(&curves, side) {
            continue;
        }
        let limit =
            range(&contour(&curves, side, 0.0), OutsideCornerRule::Circular, &options).no_gouge;
        if limit.radius.is_infinite() || limit.radius < 0.01 {
            continue;
        }
        let gouges = |radius: f64| {
            let path = offset_path(&curves, side, radius)?;
            Some(check(&contour(&curves, side, radius), &path, &options).gouges)
        };
        let below = gouges(0.999 * limit.radius).unwrap();
        assert!(below.is_empty(), "seed {seed}: {limit:?} {below:?}");
        // An arc too small for the tool has no offset at all.
        let above = gouges(1.01 * limit.radius);
        assert!(above.is_none_or(|g| !g.is_empty()), "seed {seed}: {limit:?}");
        match limit.reason {
            LimitReason::Throat => throats += 1,
            LimitReason::ShortBlock => short += 1,
            _ => arcs += 1,
        }
    }
    assert!(throats > 200 && short > 200 && arcs > 50, "{throats} {short} {arcs}");
}
