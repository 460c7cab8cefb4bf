//! Follows every possibility of a contour, and takes the one that FSELECT selects.

use super::carrier::ElementCarrier;
use super::chain::FreeChain;
use super::check::turn_of;
use super::{
    ContourChoice, FreeContourFault, FreeContourRequest, FreeSolutionOrder, NumberedSolution,
    PartlySolvedElement, SolvedFreeElement,
};
use chordal_geometry::Vec2;

/// Contours that are followed at once.
const MAX_SOLUTIONS: usize = 64;

/// Choices that are followed for one contour.
const MAX_CHOICES: usize = 500;

/// Solutions whose points are closer are one, mm.
const SAME_SOLUTION_MM: f64 = 1e-4;

/// Something that was found of a contour.
#[derive(Clone, Copy, Debug)]
enum FoundPart {
    End(Vec2),
    Carrier(ElementCarrier),
}

/// What follows from what is known.
enum ChainState {
    /// A value of this element contradicts the others.
    Contradiction(usize),
    /// The parts of an element that are all possible.
    Choice(usize, Vec<FoundPart>),
    /// Nothing more follows.
    Settled,
}

/// Solves a contour from its start.
///
/// # Errors
/// See [`FreeContourFault`].
pub fn solve_free_contour(
    request: &FreeContourRequest<'_>,
) -> Result<Vec<SolvedFreeElement>, FreeContourFault> {
    let count = request.elements.len();
    let mut base = FreeChain::new(request);
    // The first block since which there are several contours.
    let mut open_since = None;
    // Block by block, as the control does: what FSELECT selects from is what is known at its block.
    for limit in 1..=count {
        base.limit = limit;
        let leaves = ordered_contours(&base)?;
        let selection = request.selections.iter().find(|(element, _)| element + 1 == limit);
        let chosen = match selection {
            Some((element, number)) => {
                let chosen = leaves.get((*number as usize).wrapping_sub(1));
                let fault = FreeContourFault::NoSuchSolution(*element, *number, leaves.len());
                Some(chosen.ok_or(fault)?.clone())
            }
            None if leaves.len() == 1 => leaves.into_iter().next(),
            None => None,
        };
        match chosen {
            Some(chosen) => (base, open_since) = (chosen, None),
            None => open_since = open_since.or(Some(limit)),
        }
    }
    if let Some(first) = open_since {
        return Err(first_choice(base, first)?);
    }
    match base.first_unknown() {
        Some(open) => Err(FreeContourFault::Undetermined(open)),
        None => Ok(base.solved()),
    }
}

/// The contours that fit, in the order of their numbers.
fn ordered_contours<'v>(base: &FreeChain<'v>) -> Result<Vec<FreeChain<'v>>, FreeContourFault> {
    let mut leaves = follow(base)?;
    order_solutions(&mut leaves, base.request.order);
    Ok(leaves)
}

/// The first block at which more than one of the contours is left by the values of later elements.
fn first_choice(
    mut base: FreeChain<'_>,
    first: usize,
) -> Result<FreeContourFault, FreeContourFault> {
    let count = base.request.elements.len();
    for limit in first..=count {
        base.limit = limit;
        let goes_on = |leaf: &FreeChain<'_>| {
            let whole = FreeChain { limit: count, ..leaf.clone() };
            !matches!(follow(&whole), Err(FreeContourFault::Contradiction(_)))
        };
        let numbers = (1..).zip(ordered_contours(&base)?).filter(|(_, leaf)| goes_on(leaf));
        let left: Vec<(u32, FreeChain<'_>)> = numbers.collect();
        if left.len() > 1 {
            return Ok(ambiguity(&left));
        }
    }
    Ok(FreeContourFault::Undetermined(first - 1))
}

/// Several contours at a block, from the first element on in which they differ.
fn ambiguity(left: &[(u32, FreeChain<'_>)]) -> FreeContourFault {
    let element = left.first().map_or(0, |(_, leaf)| leaf.limit - 1);
    let differs = |at: &usize| {
        let first = left.first().map(|(_, leaf)| leaf.part(*at));
        left.iter()
            .any(|(_, leaf)| first.is_some_and(|first| is_other_part(&first, &leaf.part(*at))))
    };
    let from = (0..=element).find(differs).unwrap_or(element);
    let solutions = left.iter().map(|(number, leaf)| NumberedSolution {
        number: *number,
        elements: (from..=element).map(|at| leaf.part(at)).collect(),
    });
    let solutions = solutions.collect();
    FreeContourFault::Ambiguous(ContourChoice { element, from, solutions })
}

fn is_other_part(one: &PartlySolvedElement, other: &PartlySolvedElement) -> bool {
    let far = |one: [f64; 2], other: [f64; 2]| {
        Vec2::from_array(one).distance(Vec2::from_array(other)) > SAME_SOLUTION_MM
    };
    let ends = one.end.zip(other.end).is_some_and(|(one, other)| far(one, other));
    let circles = one
        .circle
        .zip(other.circle)
        .is_some_and(|((one, r), (other, s))| far(one, other) || (r - s).abs() > SAME_SOLUTION_MM);
    let directions = one.direction_deg.zip(other.direction_deg);
    let turned = directions.is_some_and(|(one, other)| (one - other).abs() > 1e-4);
    let kinds = one.end.is_some() != other.end.is_some()
        || one.circle.is_some() != other.circle.is_some()
        || one.direction_deg.is_some() != other.direction_deg.is_some();
    ends || circles || turned || kinds
}

/// All contours that fit the values of the elements that are looked at, as far as they are determined.
fn follow<'v>(base: &FreeChain<'v>) -> Result<Vec<FreeChain<'v>>, FreeContourFault> {
    let mut open = vec![base.clone()];
    let mut leaves: Vec<FreeChain<'v>> = Vec::new();
    let (mut choices, mut contradiction) = (0, 0);
    while let Some(mut chain) = open.pop() {
        match chain.settle() {
            ChainState::Contradiction(element) => contradiction = contradiction.max(element),
            ChainState::Choice(element, parts) => {
                choices += 1;
                if choices > MAX_CHOICES {
                    return Err(FreeContourFault::TooManySolutions(element));
                }
                for part in parts.into_iter().rev() {
                    let mut next = chain.clone();
                    next.take(element, part);
                    open.push(next);
                }
            }
            ChainState::Settled => match chain.first_wrong() {
                Some(element) => contradiction = contradiction.max(element),
                None if leaves.iter().any(|leaf| leaf.is_same(&chain)) => {}
                None if leaves.len() == MAX_SOLUTIONS => {
                    return Err(FreeContourFault::TooManySolutions(chain.limit - 1));
                }
                None => leaves.push(chain),
            },
        }
    }
    match leaves.is_empty() {
        true => Err(FreeContourFault::Contradiction(contradiction)),
        false => Ok(leaves),
    }
}

/// Puts solutions into the order of their numbers; those that are alike keep that in which they were found.
fn order_solutions(leaves: &mut [FreeChain<'_>], order: FreeSolutionOrder) {
    match order {
        FreeSolutionOrder::Along => {}
        FreeSolutionOrder::Turning => leaves.sort_by(|one, other| {
            let turned = |leaf: &FreeChain<'_>| (leaf.turned() * 1e6).round();
            turned(one).total_cmp(&turned(other))
        }),
    }
}

fn is_other_carrier(one: &ElementCarrier, other: &ElementCarrier) -> bool {
    match (*one, *other) {
        (
            ElementCarrier::Line { point, direction },
            line @ ElementCarrier::Line { direction: along, .. },
        ) => line.distance_mm(point) > SAME_SOLUTION_MM || direction.distance(along) > 1e-6,
        (
            ElementCarrier::Circle { center, signed },
            ElementCarrier::Circle { center: other, signed: its },
        ) => center.distance(other) > SAME_SOLUTION_MM || (signed - its).abs() > SAME_SOLUTION_MM,
        _ => true,
    }
}

impl FreeChain<'_> {
    /// Finds what follows until nothing more does, or there is a choice.
    fn settle(&mut self) -> ChainState {
        loop {
            let (mut has_more, mut choice) = (false, None);
            for element in 0..self.limit {
                let (carriers, ends) = (self.unknown_carrier(element), self.unknown_end(element));
                for parts in [carriers, ends].into_iter().flatten() {
                    match parts.as_slice() {
                        [] => return ChainState::Contradiction(element),
                        [part] => {
                            self.take(element, *part);
                            has_more = true;
                        }
                        _ => choice = choice.or(Some((element, parts))),
                    }
                }
            }
            if has_more {
                continue;
            }
            return match choice {
                Some((element, parts)) => ChainState::Choice(element, parts),
                None => ChainState::Settled,
            };
        }
    }

    fn unknown_end(&self, element: usize) -> Option<Vec<FoundPart>> {
        match self.points[element + 1] {
            Some(_) => None,
            None => Some(self.end_candidates(element)?.into_iter().map(FoundPart::End).collect()),
        }
    }

    fn unknown_carrier(&self, element: usize) -> Option<Vec<FoundPart>> {
        if self.carriers[element].is_some() {
            return None;
        }
        let found = match self.values(element).turn {
            None => self.line_candidates(element)?,
            Some(turn) => self.circle_candidates(element, turn.sign())?,
        };
        Some(found.into_iter().map(FoundPart::Carrier).collect())
    }

    fn take(&mut self, element: usize, part: FoundPart) {
        match part {
            FoundPart::End(point) => self.points[element + 1] = Some(point),
            FoundPart::Carrier(carrier) => self.carriers[element] = Some(carrier),
        }
    }

    fn first_unknown(&self) -> Option<usize> {
        (0..self.limit).find(|at| self.points[at + 1].is_none() || self.carriers[*at].is_none())
    }

    fn first_wrong(&self) -> Option<usize> {
        let tolerance = self.request.tolerance_mm;
        (0..self.limit).find(|at| {
            let fault = self.fault_mm(*at);
            fault.is_nan() || fault > tolerance
        })
    }

    /// Whether the same is known, at the same places.
    fn is_same(&self, other: &FreeChain<'_>) -> bool {
        let same_points = self.points.iter().zip(&other.points).all(|pair| match pair {
            (Some(one), Some(two)) => one.distance(*two) <= SAME_SOLUTION_MM,
            (one, two) => one.is_none() && two.is_none(),
        });
        let mut carriers = self.carriers.iter().zip(&other.carriers);
        same_points
            && carriers.all(|pair| match pair {
                (Some(one), Some(two)) => !is_other_carrier(one, two),
                (one, two) => one.is_none() && two.is_none(),
            })
    }

    /// By how much the elements turn, with the corners between them, rad, as far as they are known.
    fn turned(&self) -> f64 {
        let mut sum = 0.0;
        let mut last = self.request.entry.map(Vec2::from_array);
        for element in 0..self.limit {
            let ends = self.points[element].zip(self.points[element + 1]);
            let carrier = self.carriers[element];
            let at = |point: Option<Vec2>| carrier?.direction_at(point.unwrap_or(Vec2::ZERO));
            let is_line = matches!(carrier, Some(ElementCarrier::Line { .. }));
            let first = at(self.points[element]).filter(|_| is_line || ends.is_some());
            if let (Some(last), Some(first)) = (last, first) {
                sum += libm::atan2(last.cross(first), last.dot(first)).abs();
            }
            if let (Some(ElementCarrier::Circle { center, signed }), Some((start, end))) =
                (carrier, ends)
            {
                sum += turn_of(center, signed.signum(), [start, end]);
            }
            last = at(self.points[element + 1]).filter(|_| is_line || ends.is_some());
        }
        sum
    }

    /// The elements, where all are known.
    fn solved(&self) -> Vec<SolvedFreeElement> {
        let elements = (0..self.limit).filter_map(|element| {
            let PartlySolvedElement { end, circle, .. } = self.part(element);
            Some(SolvedFreeElement { end: end?, center: circle.map(|(center, _)| center) })
        });
        elements.collect()
    }

    /// What is known of an element.
    fn part(&self, element: usize) -> PartlySolvedElement {
        let end = self.points[element + 1].map(Vec2::to_array);
        let (circle, direction_deg) = match self.carriers[element] {
            None => (None, None),
            Some(ElementCarrier::Circle { center, signed }) => {
                (Some((center.to_array(), signed.abs())), None)
            }
            Some(ElementCarrier::Line { direction, .. }) => {
                let degrees = libm::atan2(direction.b, direction.a).to_degrees();
                (None, Some(degrees.rem_euclid(360.0)))
            }
        };
        PartlySolvedElement { end, circle, direction_deg }
    }
}
