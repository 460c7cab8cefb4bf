//! Moves that overload a tool or the spindle, or whose chip is too thin to cut.

use std::collections::BTreeMap;

use chordal_command::{Units, number_text, telling_number};
use chordal_diagnostics::{Code, Diagnostic, SourceMap};
use chordal_geometry::tolerance::ROUNDING_SHARE;
use chordal_machine::Tool;
use chordal_stock::engagement::BoundedValue;

use super::materials::POWER_SHARE;
use super::report::{EngagementProblem, MoveEngagement};

/// Most problems that are kept of a run.
const MAX_PROBLEMS: usize = 1000;

/// The limits of tools and spindle.
pub(super) struct EngagementLimits<'a> {
    pub tools: &'a BTreeMap<u32, Tool>,
    /// Thickest chip of every tool, mm; it replaces that of the tool.
    pub max_chip: Option<f64>,
    pub spindle_kw: Option<f64>,
    pub units: Units,
    pub sources: &'a SourceMap<'a>,
}

/// The problems found.
#[derive(Default)]
pub(super) struct LimitFindings {
    pub list: Vec<EngagementProblem>,
    pub diagnostics: Vec<Diagnostic>,
    pub more: u64,
}

impl EngagementLimits<'_> {
    /// The problems of all moves; of consecutive moves of one block only the worst.
    pub fn problems(&self, moves: &[MoveEngagement]) -> LimitFindings {
        let mut found = LimitFindings::default();
        let mut last: Option<(MoveEngagement, Code)> = None;
        for each in moves {
            for (code, value, limit) in self.broken(each) {
                let again =
                    last.is_some_and(|(one, known)| (one.origin, known) == (each.origin, code));
                last = Some((*each, code));
                let file = self.sources.get(each.origin.span.file);
                let problem = EngagementProblem {
                    code,
                    file: file.map_or_else(String::new, |source| source.name().to_string()),
                    line: each.origin.line,
                    tool: each.tool,
                    value,
                    limit,
                };
                let message = self.limit_diagnostic(&problem, each);
                if let (true, Some(kept), Some(diagnostic)) =
                    (again, found.list.last_mut(), found.diagnostics.last_mut())
                {
                    let worse = match code {
                        Code::ToolRubs => value.most < kept.value.most,
                        _ => value.most > kept.value.most,
                    };
                    if worse {
                        (*kept, *diagnostic) = (problem, message);
                    }
                } else if found.list.len() < MAX_PROBLEMS {
                    found.list.push(problem);
                    found.diagnostics.push(message);
                } else {
                    found.more += 1;
                }
            }
        }
        found
    }

    /// The first limit that a move breaks.
    pub fn worst(&self, each: &MoveEngagement) -> Option<Code> {
        self.broken(each).first().map(|(code, ..)| *code)
    }

    /// The limits that a move breaks.
    fn broken(&self, each: &MoveEngagement) -> Vec<(Code, BoundedValue, f64)> {
        let tool = self.tools.get(&each.tool);
        let mut broken = Vec::new();
        if let Some(chip) = each.chip {
            let most = self.max_chip.or(tool.and_then(|tool| tool.max_chip_mm));
            if let Some(limit) =
                most.filter(|limit| chip.peak_mm.most > limit * (1.0 + ROUNDING_SHARE))
            {
                broken.push((Code::ChipTooThick, chip.peak_mm, limit));
            }
            // Only where something is cut: along a wall that was cut before there is nothing to rub on.
            let least = tool.and_then(|tool| tool.min_chip_mm);
            if let Some(limit) =
                least.filter(|limit| chip.peak_mm.most < *limit && each.rate_mm3_per_s > 0.0)
            {
                broken.push((Code::ToolRubs, chip.peak_mm, limit));
            }
        }
        if let (Some(effort), Some(limit)) = (each.effort, self.spindle_kw)
            && effort.power_kw > limit
        {
            let [least, most] =
                [1.0 - POWER_SHARE, 1.0 + POWER_SHARE].map(|share| effort.power_kw * share);
            broken.push((Code::SpindleOverloaded, BoundedValue { least, most }, limit));
        }
        broken
    }

    fn limit_diagnostic(&self, problem: &EngagementProblem, each: &MoveEngagement) -> Diagnostic {
        let EngagementProblem { code, tool, value, limit, .. } = *problem;
        let chip = |mm: f64| match self.units {
            Units::Inch => format!("{} in", telling_number(mm / 25.4, 5)),
            Units::Millimetre => format!("{} mm", telling_number(mm, 4)),
        };
        let kilowatts = |kw: f64| format!("{} kW", number_text(kw, 2));
        let (message, label, help) = match code {
            Code::SpindleOverloaded => (
                format!(
                    "this cut of tool {tool} needs about {}, the spindle has {}",
                    kilowatts(each.effort.map_or(0.0, |effort| effort.power_kw)),
                    kilowatts(limit)
                ),
                "too much for the spindle",
                "take less depth or width, or a lower feed",
            ),
            Code::ToolRubs => (
                format!(
                    "the thickest chip of tool {tool} is at most {}, it cuts from {} on",
                    chip(value.most),
                    chip(limit)
                ),
                "it rubs",
                "feed faster, or leave more for this pass",
            ),
            _ => (
                format!(
                    "the chip of tool {tool} is up to {} thick, {} is the limit",
                    chip(value.most),
                    chip(limit)
                ),
                "too thick a chip",
                "lower F here, or run `chordal optimize`",
            ),
        };
        let length = |mm: f64| self.units.length_text(mm);
        let at_most = format!(
            "{} wide and {} deep at most",
            length(each.across_mm.most),
            length(each.axial_mm.most)
        );
        Diagnostic::new(code, each.origin.span, message).label(label).note(at_most).help(help)
    }
}
