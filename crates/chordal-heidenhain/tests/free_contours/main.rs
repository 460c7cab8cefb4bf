//! Random free contours: made forwards from their angles and lengths, described by some of their values alone, and solved.
//!
//! What is found is compared with what was made. Where the values leave several contours, the one that was made must be
//! among them, each must have all values (checked here on its own), and FSELECT with its number must take it.

mod made_contour;
mod solution_values;
#[path = "../support/mod.rs"]
mod support;

use chordal_geometry::TurnDirection;
use chordal_heidenhain::geometry::{
    ContourChoice, FreeContourFault, FreeContourRequest, FreeElementValues, FreeReference,
    FreeSolutionOrder, FreeValue, KnownElement, NumberedSolution, SolvedFreeElement,
    solve_free_contour,
};

use made_contour::{MadeContour, TOLERANCE_MM, absolute, both, distance, nothing};
use solution_values::{difference, fault_of};

const CONTOURS: u64 = 20_000;

/// Whether what is known of a solution is what was made.
fn is_made(contour: &MadeContour, from: usize, solution: &NumberedSolution) -> bool {
    let mut elements = solution.elements.iter().zip(from..);
    elements.all(|(found, at)| {
        let expected = &contour.expected[at];
        let near = |found: Option<[f64; 2]>, expected: [f64; 2]| {
            found.is_none_or(|found| distance(found, expected) < 1e-5)
        };
        let direction = found
            .direction_deg
            .is_none_or(|degrees| (degrees - contour.ends_deg[at]).to_radians().cos() > 1.0 - 1e-9);
        let center = found.circle.zip(expected.center);
        near(found.end, expected.end)
            && direction
            && center.is_none_or(|((found, radius), center)| {
                near(Some(found), center) && (radius - distance(center, expected.end)).abs() < 1e-5
            })
    })
}

/// What solving a contour came to.
#[derive(Default)]
struct SelectedContour {
    /// FSELECT of the contour that was made.
    selections: Vec<(usize, u32)>,
    /// How many solutions were said, and how many of them lead to a contour.
    said: usize,
    whole: usize,
    is_left_open: bool,
    off: f64,
}

/// Solves a contour, selecting the one that was made wherever there are several.
fn solved_with_selection(seed: u64, contour: &MadeContour) -> SelectedContour {
    let shown = || format!("{seed}: {:#?}\n{:#?}", contour.values, contour.expected);
    let mut result = SelectedContour::default();
    loop {
        let choice = match contour.solve(&result.selections) {
            Ok(found) => {
                result.off = difference(&found, &contour.expected);
                return result;
            }
            Err(FreeContourFault::Ambiguous(choice)) => choice,
            // More than the limit that are still open: several arcs with two or four solutions each.
            Err(FreeContourFault::TooManySolutions(_)) => {
                result.is_left_open = true;
                return result;
            }
            Err(fault) => panic!("{fault:?}: {}", shown()),
        };
        let ContourChoice { element, from, solutions } = choice;
        assert!(solutions.len() > 1, "{}\n{solutions:#?}", shown());
        assert!(result.selections.iter().all(|(other, _)| *other < element), "{}", shown());
        for solution in &solutions {
            result.said += 1;
            let mut selections = result.selections.clone();
            selections.push((element, solution.number));
            // Another one of them may need another FSELECT later on.
            if let Ok(whole) = contour.solve(&selections) {
                result.whole += 1;
                let fault = fault_of(contour, &whole);
                assert!(fault < 2.0 * TOLERANCE_MM, "{fault}: {whole:#?}\n{}", shown());
            }
        }
        let mut made = solutions.iter().filter(|solution| is_made(contour, from, solution));
        let number = made.next().unwrap_or_else(|| panic!("{}\n{solutions:#?}", shown())).number;
        assert!(made.next().is_none(), "two solutions look alike: {}\n{solutions:#?}", shown());
        let mut beyond = result.selections.clone();
        beyond.push((element, 1_000));
        let refused = contour.solve(&beyond);
        assert!(
            matches!(refused, Err(FreeContourFault::NoSuchSolution(at, 1_000, _)) if at == element)
        );
        result.selections.push((element, number));
    }
}

#[test]
fn random_contours_are_solved() {
    let (mut solved, mut farthest) = (0, 0.0_f64);
    for seed in 0..CONTOURS {
        let mut contour = MadeContour::new(seed);
        for _ in 0..=contour.numbers.below(4) {
            match contour.numbers.below(5) {
                0 => contour.line(),
                1 => contour.arc(),
                2 => contour.corner(),
                3 => contour.rounding(),
                _ => contour.belt(),
            }
        }
        let found = contour.solve(&[]);
        let found = found.unwrap_or_else(|fault| {
            panic!("{seed}: {fault:?}\n{:#?}\n{:#?}", contour.values, contour.expected)
        });
        farthest = farthest.max(difference(&found, &contour.expected));
        assert!(farthest < 1e-4, "{seed}: {found:?}\n{:#?}", contour.values);
        solved += found.len();
    }
    println!("{solved} elements, {farthest:.1e} mm off at most");
}

#[test]
fn random_contours_with_relations_are_solved_or_selected() {
    let (mut elements, mut farthest, mut left_open) = (0, 0.0_f64, 0);
    let (mut selected, mut selections, mut said, mut whole) = (0, 0, 0, 0);
    for seed in 0..CONTOURS {
        let mut contour = MadeContour::new(seed + CONTOURS);
        for _ in 0..=contour.numbers.below(3) {
            match contour.numbers.below(5) {
                0 => contour.related_line(),
                1 | 2 => contour.related_arc(),
                3 => contour.crossing(),
                _ => contour.line(),
            }
        }
        let result = solved_with_selection(seed, &contour);
        farthest = farthest.max(result.off);
        assert!(farthest < 1e-3, "{seed}\n{:#?}\n{:#?}", contour.values, contour.expected);
        elements += contour.values.len();
        selected += usize::from(!result.selections.is_empty());
        selections += result.selections.len();
        (said, whole) = (said + result.said, whole + result.whole);
        left_open += u64::from(result.is_left_open);
    }
    println!("{elements} elements, {farthest:.1e} mm off at most");
    println!("{selected} of {CONTOURS} contours with {selections} FSELECT from {said} solutions");
    println!("{whole} of these are whole contours, {left_open} were left open");
    assert!(left_open < CONTOURS / 50, "{left_open} contours have too many solutions");
}

fn solve(
    values: &[FreeElementValues],
    selections: &[(usize, u32)],
) -> Result<Vec<SolvedFreeElement>, FreeContourFault> {
    solve_free_contour(&FreeContourRequest {
        elements: values,
        before: &[],
        start: [0.0; 2],
        entry: None,
        selections,
        order: FreeSolutionOrder::Turning,
        tolerance_mm: TOLERANCE_MM,
    })
}

#[test]
fn too_little_is_not_guessed() {
    let line = FreeElementValues { angle: absolute(30.0), ..nothing() };
    assert_eq!(solve(&[line], &[]), Err(FreeContourFault::Undetermined(0)));
    let contradiction =
        FreeElementValues { end: both([10.0, 0.0]), length: Some(12.0), ..nothing() };
    assert_eq!(solve(&[contradiction], &[]), Err(FreeContourFault::Contradiction(0)));
    assert_eq!(solve(&[], &[]), Ok(Vec::new()));
}

#[test]
fn a_circle_meets_a_line_twice() {
    let arc = FreeElementValues {
        turn: Some(TurnDirection::Ccw),
        center: both([10.0, 0.0]),
        ..nothing()
    };
    let after = FreeElementValues { angle: absolute(90.0), end: both([12.0, 50.0]), ..nothing() };
    let height = 96_f64.sqrt();
    let Err(FreeContourFault::Ambiguous(choice)) = solve(&[arc, after], &[]) else {
        panic!("one solution");
    };
    assert_eq!((choice.element, choice.from), (1, 0));
    // The arc begins on the left of its circle and turns counter-clockwise: below first.
    let ends: Vec<[f64; 2]> =
        choice.solutions.iter().filter_map(|solution| solution.elements[0].end).collect();
    assert_eq!(ends.len(), 2);
    assert!(distance(ends[0], [12.0, -height]) < 1e-9, "{ends:?}");
    assert!(distance(ends[1], [12.0, height]) < 1e-9, "{ends:?}");
    let second = solve(&[arc, after], &[(1, 2)]).expect("a contour");
    assert!(distance(second[0].end, [12.0, height]) < 1e-9);
}

/// Words that refer to elements before the contour.
#[test]
fn elements_before_the_contour_are_references() {
    let before = [KnownElement { start: [-20.0, 5.0], end: [-10.0, 5.0], arc: None }];
    let reference = Some(FreeReference::Before(0));
    let first = FreeElementValues {
        end: [Some(FreeValue { value: 30.0, from: reference }), absolute(3.0)],
        ..nothing()
    };
    let second = FreeElementValues {
        angle: Some(FreeValue { value: 90.0, from: reference }),
        length: Some(4.0),
        ..nothing()
    };
    let found = solve_free_contour(&FreeContourRequest {
        elements: &[first, second],
        before: &before,
        start: [0.0; 2],
        entry: None,
        selections: &[],
        order: FreeSolutionOrder::Along,
        tolerance_mm: TOLERANCE_MM,
    });
    let found = found.expect("a contour");
    assert!(distance(found[0].end, [20.0, 3.0]) < 1e-9);
    assert!(distance(found[1].end, [20.0, 7.0]) < 1e-9);
}

/// Long contours with a choice at every element end, and none of them is guessed.
#[test]
fn long_contours_of_choices_end() {
    // From each point two points have the same distance and the same X.
    let zigzag = FreeElementValues {
        length: Some(5.0),
        end: [Some(FreeValue { value: 3.0, from: None }), None],
        ..nothing()
    };
    let chain: Vec<FreeElementValues> = (1..=200)
        .map(|at| FreeElementValues { end: [absolute(3.0 * f64::from(at)), None], ..zigzag })
        .collect();
    assert!(matches!(solve(&chain, &[]), Err(FreeContourFault::TooManySolutions(_))));
    // With FSELECT after each there is one.
    let selections: Vec<(usize, u32)> = (0..200).map(|at| (at, 1)).collect();
    assert_eq!(solve(&chain, &selections).map(|found| found.len()), Ok(200));
    // Circles about one point say nothing about where they meet.
    let ring =
        FreeElementValues { turn: Some(TurnDirection::Ccw), center: both([9.0, 0.0]), ..nothing() };
    assert!(matches!(solve(&[ring; 200], &[]), Err(FreeContourFault::Undetermined(0))));
}
