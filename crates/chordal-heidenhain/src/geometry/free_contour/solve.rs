//! Follows every possibility of a contour, and takes the one that FSELECT selects.

use super::carrier::ElementCarrier;
use super::chain::FreeChain;
use super::check::turn_of;
use super::{FreeContourFault, FreeContourRequest, FreeSolutionOrder, SolvedFreeElement};
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
    let mut leaves = vec![base.clone()];
    // Block by block, as the control does: what FSELECT selects from is what is known at its block.
    for limit in 1..=count {
        base.limit = limit;
        leaves = follow(&base)?;
        let selection = request.selections.iter().find(|(element, _)| element + 1 == limit);
        if let Some((element, number)) = selection {
            order_solutions(&mut leaves, request.order);
            let chosen = leaves.get((*number as usize).wrapping_sub(1)).cloned();
            base =
                chosen.ok_or(FreeContourFault::NoSuchSolution(*element, *number, leaves.len()))?;
            leaves = vec![base.clone()];
        } else if let [only] = leaves.as_slice() {
            base = only.clone();
        }
    }
    order_solutions(&mut leaves, request.order);
    if let Some(open) = leaves.iter().find_map(|leaf| leaf.first_unknown()) {
        return Err(FreeContourFault::Undetermined(open));
    }
    match leaves.as_slice() {
        [only] => Ok(only.solved(0)),
        _ => Err(ambiguity(&leaves)),
    }
}

/// The solutions from the first element on in which they differ.
fn ambiguity(leaves: &[FreeChain<'_>]) -> FreeContourFault {
    let solutions: Vec<Vec<SolvedFreeElement>> = leaves.iter().map(|leaf| leaf.solved(0)).collect();
    let count = solutions.first().map_or(0, Vec::len);
    let differs = |at: &usize| {
        let first = leaves[0].points[at + 1].zip(leaves[0].carriers[*at]);
        leaves.iter().any(|leaf| {
            let own = leaf.points[at + 1].zip(leaf.carriers[*at]);
            first.zip(own).is_none_or(|(first, own)| {
                first.0.distance(own.0) > SAME_SOLUTION_MM || is_other_carrier(&first.1, &own.1)
            })
        })
    };
    let from = (0..count).find(differs).unwrap_or_default();
    FreeContourFault::Ambiguous(from, leaves.iter().map(|leaf| leaf.solved(from)).collect())
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

    /// The elements from one on, where all are known.
    fn solved(&self, from: usize) -> Vec<SolvedFreeElement> {
        let elements = (from..self.limit).filter_map(|element| {
            let end = self.points[element + 1]?;
            let center = match self.carriers[element]? {
                ElementCarrier::Line { .. } => None,
                ElementCarrier::Circle { center, .. } => Some([center.a, center.b]),
            };
            Some(SolvedFreeElement { end: [end.a, end.b], center })
        });
        elements.collect()
    }
}
