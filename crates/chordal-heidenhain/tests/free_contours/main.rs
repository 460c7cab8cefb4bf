//! Random free contours: made forwards from their angles and lengths, described by some of their values alone, and solved.
//!
//! What is found is compared with what was made. Where the values leave several contours, the one that was made must be
//! among them, each must have all values (checked here on its own), and FSELECT with its number must take it.

mod made_contour;
mod solution_values;

use chordal_geometry::TurnDirection;
use chordal_heidenhain::geometry::{
    FreeContourFault, FreeContourRequest, FreeElementValues, FreeReference, FreeSolutionOrder,
    FreeValue, KnownElement, SolvedFreeElement, solve_free_contour,
};

use made_contour::{MadeContour, TOLERANCE_MM, absolute, both, distance, nothing};
use solution_values::{difference, fault_of};

const CONTOURS: u64 = 20_000;

/// Solves a contour, selecting the one that was made where there are several; how many there were, and the difference.
fn solved_with_selection(seed: u64, contour: &MadeContour) -> (usize, f64) {
    let shown = || format!("{seed}: {:#?}\n{:#?}", contour.values, contour.expected);
    match contour.solve(&[]) {
        Ok(found) => (1, difference(&found, &contour.expected)),
        Err(FreeContourFault::Ambiguous(from, solutions)) => {
            let is_expected = |found: &Vec<SolvedFreeElement>| {
                difference(found, &contour.expected[from..]) < 1e-3
            };
            let number = solutions.iter().position(is_expected);
            let number = number.unwrap_or_else(|| panic!("{}\n{solutions:#?}", shown()));
            for solution in &solutions {
                let whole: Vec<SolvedFreeElement> =
                    contour.expected[..from].iter().chain(solution).copied().collect();
                let fault = fault_of(contour, &whole);
                assert!(fault < 2.0 * TOLERANCE_MM, "{fault}: {whole:#?}\n{}", shown());
            }
            let last = contour.values.len() - 1;
            let selected = contour.solve(&[(last, number as u32 + 1)]);
            let selected = selected.unwrap_or_else(|fault| panic!("{fault:?}: {}", shown()));
            let beyond = contour.solve(&[(last, solutions.len() as u32 + 1)]);
            let count = solutions.len();
            let expected = FreeContourFault::NoSuchSolution(last, count as u32 + 1, count);
            assert_eq!(beyond, Err(expected));
            (count, difference(&selected, &contour.expected))
        }
        // More than the limit that are still open: several arcs with two or four solutions each.
        Err(FreeContourFault::TooManySolutions(_)) => (0, 0.0),
        Err(fault) => panic!("{fault:?}: {}", shown()),
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
    let (mut elements, mut farthest, mut selected, mut solutions) = (0, 0.0_f64, 0, 0);
    let mut left_open = 0;
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
        let (count, off) = solved_with_selection(seed, &contour);
        farthest = farthest.max(off);
        assert!(farthest < 1e-3, "{seed}: {off}\n{:#?}\n{:#?}", contour.values, contour.expected);
        elements += contour.values.len();
        selected += usize::from(count > 1);
        solutions += count;
        left_open += u64::from(count == 0);
    }
    assert!(left_open < CONTOURS / 50, "{left_open} contours have too many solutions");
    println!(
        "{elements} elements, {selected} of {CONTOURS} contours selected from {solutions}, {farthest:.1e} mm off at most"
    );
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
    let Err(FreeContourFault::Ambiguous(0, solutions)) = solve(&[arc, after], &[]) else {
        panic!("one solution");
    };
    // The arc begins on the left of its circle and turns counter-clockwise: below first.
    let ends: Vec<[f64; 2]> = solutions.iter().map(|solution| solution[0].end).collect();
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
