//! The gouge check on published and worked examples of compensation: the paths of `data/` with the
//! least clearance each leaves, found by another program.

use chordal_geometry::Vec2;
use chordal_path::gouge::{
    CenterMove, Contour, ContourBlock, GougeCurve, GougeKind, GougeOptions, GougeReport, GougeRole,
    LimitReason, OutsideCornerRule, PartContour, ToolSide, check, clearance, intervals, nearest,
    range,
};

struct Case {
    name: String,
    contour: Contour,
    path: Vec<CenterMove>,
    expected: f64,
    /// A tool centre with that clearance, and the curve of the part it has it from.
    at: Option<(Vec2, usize)>,
    options: GougeOptions,
}

fn numbers(words: &[&str]) -> Vec<f64> {
    words.iter().map(|w| w.parse().expect(w)).collect()
}

fn curve(words: &[&str], sweep: bool) -> GougeCurve {
    let n = numbers(&words[1..]);
    if words[0] == "L" {
        return GougeCurve::line(Vec2::new(n[0], n[1]), Vec2::new(n[2], n[3]));
    }
    let (center, from) = (Vec2::new(n[0], n[1]), Vec2::new(n[2], n[3]));
    if sweep {
        let out = from - center;
        return GougeCurve::Arc {
            center,
            radius: out.length(),
            start: out.b.atan2(out.a),
            sweep: n[4].to_radians(),
        };
    }
    GougeCurve::arc(center, from, Vec2::new(n[4], n[5]), n[6] > 0.0)
}

fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    for line in include_str!("data/compensation.txt").lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[0] {
            "case" => {
                let scale = if words[3] == "inch" { 1.0 / 25.4 } else { 1.0 };
                let usual = GougeOptions::default();
                cases.push(Case {
                    name: format!("{} {}", words[1], words[2]),
                    contour: Contour {
                        blocks: Vec::new(),
                        side: if words[4] == "left" { ToolSide::Left } else { ToolSide::Right },
                        radius: words[5].parse().unwrap(),
                    },
                    path: Vec::new(),
                    expected: words[6].parse().unwrap(),
                    at: (words.len() > 9).then(|| {
                        let n = numbers(&words[7..9]);
                        (Vec2::new(n[0], n[1]), words[9].parse().unwrap())
                    }),
                    options: GougeOptions {
                        epsilon: usual.epsilon * scale,
                        vertex: usual.vertex * scale,
                        ..usual
                    },
                });
            }
            "#" => {}
            "move" => cases.last_mut().unwrap().path.push(CenterMove {
                tag: words[1].parse().unwrap(),
                curve: curve(&words[2..], true),
            }),
            role => {
                let blocks = &mut cases.last_mut().unwrap().contour.blocks;
                let role = match role {
                    "in" => GougeRole::LeadIn,
                    "out" => GougeRole::LeadOut,
                    _ => GougeRole::Offset,
                };
                blocks.push(ContourBlock {
                    curve: curve(&words[1..], false),
                    tag: blocks.len() as u32,
                    role,
                });
            }
        }
    }
    cases
}

fn case(name: &str) -> Case {
    cases().into_iter().find(|c| c.name == name).expect(name)
}

fn report(name: &str) -> GougeReport {
    let case = case(name);
    check(&case.contour, &case.path, &case.options)
}

#[test]
fn every_path_leaves_the_clearance_stated() {
    let mut wrong = Vec::new();
    let cases = cases();
    assert!(cases.len() > 100, "{}", cases.len());
    for case in &cases {
        let found = clearance(&case.contour, &case.path, &case.options).unwrap();
        // Where the tool must be clear, ends of the contour may lie farther off than the radius.
        let clear = case.expected > -2e-4 && found.clearance > -2e-4;
        if !clear && (found.clearance - case.expected).abs() > 2e-4 {
            wrong.push(format!("{}: {} for {}", case.name, found.clearance, case.expected));
        }
        let report = check(&case.contour, &case.path, &case.options);
        let deepest = report.gouges.first().map_or(0.0, |g| g.depth);
        let expected = if case.expected < -case.options.epsilon { -case.expected } else { 0.0 };
        if (deepest - expected).abs() > 2e-4 {
            wrong.push(format!("{}: gouge {} for {}", case.name, deepest, expected));
        }
        assert!(report.complete && !report.more);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_stated_tool_centre_has_the_stated_distance_from_the_stated_curve() {
    let mut checked = 0;
    for case in cases() {
        // The lines into and out of the full turn are leads by the rules of this crate.
        if case.name.starts_with("12 ") {
            continue;
        }
        let material = PartContour::of(&case.contour, &case.options);
        let (at, block) = case.at.expect(&case.name);
        let distance = nearest(&GougeCurve::line(at, at), &material.curves[block]).square.sqrt();
        let clearance = distance - case.contour.radius;
        assert!((clearance - case.expected).abs() < 2e-4, "{}: {clearance}", case.name);
        checked += 1;
    }
    assert!(checked > 100);
}

#[test]
fn a_neck_narrower_than_the_tool_is_found_though_its_walls_are_blocks_apart() {
    let report = report("11 typeA_linear");
    // The neck is 8 wide, between X−4 and X4 of Y20 to Y40; each wall is cut from the other side.
    assert!(report.gouges.iter().all(|g| g.kind == GougeKind::Contour));
    assert!((report.gouges[0].depth - 2.0).abs() < 1e-9);
    assert_eq!(report.gouges[0].center.a.abs(), 1.0);
    assert!(report.gouges.iter().any(|g| g.cutting < g.cut));
    assert!(report.gouges.iter().any(|g| g.cutting > g.cut));
}

#[test]
fn a_lead_that_cuts_the_open_end_of_the_wall_is_told_apart() {
    for (name, depth) in [
        ("03b typeA_linear", 2.955_698),
        ("03c typeA_linear", 5.0),
        ("03b typeB_linear", 0.731_34),
        ("03c typeB_linear", 1.077_677),
        ("26 typeA_linear", 0.149_287),
        ("04b typeA_linear", 2.747_776),
    ] {
        let report = report(name);
        assert!((report.gouges[0].depth - depth).abs() < 1e-4, "{name}: {:?}", report.gouges);
        assert!(report.gouges.iter().all(|g| g.kind == GougeKind::AtLead), "{name}");
    }
}

#[test]
fn a_kink_left_untrimmed_gouges_by_the_radius_less_its_cosine() {
    let kink = (2.0_f64).atan2(40.0 * 0.998_8).to_degrees();
    assert!((kink - 2.866).abs() < 0.01);
    let report = report("13b linuxcnc");
    assert!((report.gouges[0].depth - 0.0298).abs() < 1e-4);
    assert_eq!(report.gouges[0].kind, GougeKind::Contour);
}

#[test]
fn a_corner_left_out_after_two_idle_blocks_cuts_the_wall() {
    let line = |a, b, c, d| GougeCurve::line(Vec2::new(a, b), Vec2::new(c, d));
    let block = |curve, tag, role| ContourBlock { curve, tag, role };
    let contour = Contour {
        blocks: vec![
            block(line(-40.0, 20.0, -40.0, 0.0), 0, GougeRole::LeadIn),
            block(line(-40.0, 0.0, 0.0, 0.0), 1, GougeRole::Offset),
            block(line(0.0, 0.0, 0.0, 40.0), 2, GougeRole::Offset),
            block(line(0.0, 40.0, -20.0, 40.0), 3, GougeRole::LeadOut),
        ],
        side: ToolSide::Left,
        radius: 5.0,
    };
    let path: Vec<CenterMove> = [
        line(-40.0, 20.0, -40.0, 5.0),
        line(-40.0, 5.0, 0.0, 5.0),
        line(0.0, 5.0, -5.0, 40.0),
        line(-5.0, 40.0, -20.0, 40.0),
    ]
    .into_iter()
    .enumerate()
    .map(|(k, curve)| CenterMove { curve, tag: k as u32 })
    .collect();
    let report = check(&contour, &path, &GougeOptions::default());
    let deepest = report.gouges[0];
    assert_eq!((deepest.depth, deepest.center), (5.0, Vec2::new(0.0, 5.0)));
    assert_eq!(deepest.cut, 2);
}

#[test]
fn the_largest_radius_and_what_limits_it() {
    use LimitReason::{InsideArc, LeadArc, ShortBlock, Throat};
    for (name, corners, radius, reason) in [
        ("08a typeA_linear", OutsideCornerRule::Linear, 5.5, InsideArc),
        // The step itself does not limit; the open ends' blocks of 40 mm are used up.
        ("09a typeA_linear", OutsideCornerRule::Linear, 40.0, ShortBlock),
        ("09a typeA_circular", OutsideCornerRule::Circular, 3.0, ShortBlock),
        ("10 typeA_linear", OutsideCornerRule::Linear, 4.0, Throat),
        ("11 typeA_linear", OutsideCornerRule::Linear, 4.0, Throat),
        ("17 typeA_linear", OutsideCornerRule::Linear, 1.0, InsideArc),
        ("18 typeA_linear", OutsideCornerRule::Linear, 0.19, InsideArc),
        ("22a typeA_linear", OutsideCornerRule::Linear, 0.25, LeadArc),
        ("24 typeA_linear", OutsideCornerRule::Linear, 0.25, LeadArc),
        ("25 typeA_linear", OutsideCornerRule::Linear, 0.375, InsideArc),
        ("28a typeA_linear", OutsideCornerRule::Linear, 16.1803, ShortBlock),
    ] {
        let case = case(name);
        let found = range(&case.contour, corners, &case.options);
        let largest = if reason == LeadArc { found.largest() } else { found.no_gouge.clone() };
        assert_eq!(largest.reason, reason, "{name}: {found:?}");
        assert!((largest.radius - radius).abs() < 1e-4 && found.complete, "{name}: {found:?}");
    }
}

#[test]
fn a_floor_between_two_slopes_is_used_up() {
    // 4 mm between slopes of 45°: both neighbours take tan 22.5° of the radius.
    let points = [(-20.0, 20.0), (0.0, 0.0), (4.0, 0.0), (24.0, 20.0)].map(Vec2::from);
    let curves: Vec<GougeCurve> = points.windows(2).map(|p| GougeCurve::line(p[0], p[1])).collect();
    let blocks = curves
        .iter()
        .enumerate()
        .map(|(k, &curve)| ContourBlock { curve, tag: 10 + k as u32, role: GougeRole::Offset })
        .collect();
    let contour = Contour { blocks, side: ToolSide::Left, radius: 1.0 };
    let found = range(&contour, OutsideCornerRule::Linear, &GougeOptions::default());
    assert!((found.no_gouge.radius - 4.828_427).abs() < 1e-6, "{found:?}");
    assert_eq!(found.no_gouge.blocks, [10, 11, 12]);
    assert_eq!(found.every_edge.radius, 0.0);
    assert_eq!(found.every_edge.reason, LimitReason::InsideCorner);
}

#[test]
fn the_thread_mill_program_is_limited_by_its_lead_arcs() {
    let case = case("22b typeA_linear");
    let found = range(&case.contour, OutsideCornerRule::Linear, &case.options);
    let arc = found.lead_arc.unwrap();
    assert_eq!((arc.block, arc.radius), (1, 0.25));
    // The line in passes the arc's centre at R/√2, the figure that the manual rounds to .175.
    assert!((arc.line_distance.unwrap() - 0.25 / 2.0_f64.sqrt()).abs() < 1e-12);
    assert_eq!(found.no_gouge.radius, 0.5);
}

#[test]
fn radii_between_the_events_are_tried() {
    let case = case("28a typeA_linear");
    let found = range(&case.contour, OutsideCornerRule::Linear, &case.options);
    let limit = found.no_gouge.radius;
    let tried =
        intervals(&case.contour, &[limit], &case.options, &mut |r| (r < 17.0).then(Vec::new));
    assert_eq!(tried.len(), 2);
    assert!(tried[0].clear && tried[0].to == limit);
    assert!(!tried[1].clear && tried[1].to == f64::INFINITY);
}
