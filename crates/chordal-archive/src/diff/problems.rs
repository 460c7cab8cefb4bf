//! Finds the problems that a change has added.

use std::collections::BTreeMap;

use chordal::{Job, Report};

use crate::check::problem;
use crate::row::ArchivedProblem;

/// The most problems of a file that are listed; all are counted.
const MAX_LISTED: usize = 20;

/// The problems of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProblemList {
    /// The problems that the report kept, the most severe first and then by position.
    listed: Vec<ArchivedProblem>,
    /// The number of problems of each code, including those that were not kept.
    counts: BTreeMap<String, u64>,
}

/// The problems that only one of two runs has.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AddedProblems {
    /// Their number.
    pub count: u64,
    /// The first of them, the most severe first.
    pub listed: Vec<ArchivedProblem>,
}

impl ProblemList {
    /// The problems of a report.
    pub fn of(job: &Job<'_>, report: &Report) -> ProblemList {
        let mut problems = ProblemList::default();
        let mut by_weight: Vec<_> = report.diagnostics.iter().collect();
        by_weight.sort_by_key(|diagnostic| std::cmp::Reverse(diagnostic.severity));
        for diagnostic in by_weight {
            problems.add(problem(job, diagnostic));
        }
        for (code, more) in &report.dropped {
            *problems.counts.entry(code.info().id.into()).or_default() += more;
        }
        problems
    }

    fn add(&mut self, problem: ArchivedProblem) {
        *self.counts.entry(problem.code.clone()).or_default() += 1;
        self.listed.push(problem);
    }

    /// The problems of each code in excess of those of the other run. Only the messages can tell which of them are
    /// new: problems whose message the other run does not have come first.
    pub fn more_than(&self, other: &ProblemList) -> AddedProblems {
        let mut known: BTreeMap<(&str, &str), u64> = BTreeMap::new();
        for problem in &other.listed {
            *known.entry((&problem.code, &problem.message)).or_default() += 1;
        }
        let (mut unknown, mut again) = (Vec::new(), Vec::new());
        for problem in &self.listed {
            match known.get_mut(&(problem.code.as_str(), problem.message.as_str())) {
                Some(left) if *left > 0 => {
                    *left -= 1;
                    again.push(problem);
                }
                _ => unknown.push(problem),
            }
        }
        let mut left: BTreeMap<&str, u64> = BTreeMap::new();
        for (code, count) in &self.counts {
            let before = other.counts.get(code).copied().unwrap_or(0);
            left.insert(code, count.saturating_sub(before));
        }
        let count = left.values().sum();
        let mut listed = Vec::new();
        for problem in unknown.into_iter().chain(again) {
            match left.get_mut(problem.code.as_str()) {
                Some(left) if *left > 0 && listed.len() < MAX_LISTED => {
                    *left -= 1;
                    listed.push(problem.clone());
                }
                _ => {}
            }
        }
        AddedProblems { count, listed }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(problems: &[(&str, u32, &str)]) -> ProblemList {
        let mut all = ProblemList::default();
        for (code, line, message) in problems {
            all.add(ArchivedProblem {
                severity: "error".into(),
                code: (*code).into(),
                line: *line,
                message: (*message).into(),
            });
        }
        all
    }

    #[test]
    fn moved_lines_are_no_new_problems() {
        let before = of(&[("CH401", 5, "0.2 mm off"), ("CH306", 9, "no M97")]);
        let after = of(&[("CH401", 7, "0.3 mm off"), ("CH306", 11, "no M97")]);
        assert_eq!(after.more_than(&before), AddedProblems::default());
    }

    #[test]
    fn of_two_places_the_unknown_one_is_listed() {
        let before = of(&[("CH401", 5, "0.2 mm off")]);
        let after = of(&[("CH401", 5, "0.2 mm off"), ("CH401", 8, "0.9 mm off")]);
        let more = after.more_than(&before);
        assert_eq!(more.count, 1);
        assert_eq!(more.listed[0].line, 8);
        assert_eq!(before.more_than(&after), AddedProblems::default());
    }

    #[test]
    fn what_was_not_kept_counts() {
        let before = of(&[("CH401", 5, "0.2 mm off")]);
        let mut after = before.clone();
        *after.counts.get_mut("CH401").unwrap() += 1_000;
        let more = after.more_than(&before);
        assert_eq!((more.count, more.listed.len()), (1_000, 1));
    }
}
