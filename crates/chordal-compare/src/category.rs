//! The properties that two programs must have in common. Each command that compares programs compares every property
//! or ignores it with a reason.

use chordal::{CommandKind, Effect};
use serde::Serialize;

/// The property in which two runs differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Category {
    /// The path of the tool centre.
    Path,
    /// The same moves in another order.
    Order,
    /// The positions of the rotary axes during a move, and the rotating surface of polar or cylindrical
    /// interpolation.
    Rotary,
    /// A rapid instead of a cut.
    Rapid,
    /// A dog-leg rapid instead of a straight rapid.
    RapidPath,
    /// Moves to positions that are unknown relative to the part.
    Unknown,
    /// The feed.
    Feed,
    /// The time of cuts and dwells, when no difference in feed or path explains it.
    Time,
    /// The spindle's direction or speed.
    Spindle,
    /// The tool.
    Tool,
    /// The tool that is prepared for the next change.
    ReadyTool,
    /// The number of the tool length offset, or offsets that the program sets directly (G43.1).
    LengthOffset,
    /// The number of the radius offset.
    RadiusOffset,
    /// The work offset.
    WorkOffset,
    /// A value written to the control's memory: of a work offset, a tool or a reference point.
    Written,
    /// A variable that is an output or a setting, or that keeps its value after the program.
    Variable,
    /// The coolant.
    Coolant,
    /// The path mode at corners (exact stop or continuous).
    PathMode,
    /// Which overrides are enabled.
    Overrides,
    /// A dwell.
    Dwell,
    /// A stop for the operator.
    Stop,
    /// A code with its words that acts on something not simulated: a clamp, an output, limits.
    Code,
    /// A text for the operator.
    Message,
    /// An alarm of the program (#3000).
    Alarm,
    /// A block that a block delete switch skips.
    BlockDelete,
    /// A probe move.
    Probe,
    /// A printed line.
    Output,
    /// An unknown value that is read: a variable or an input.
    Value,
    /// Blocks that neither run reaches because a condition is unknown.
    NotRun,
    /// A problem that only one of the two programs has.
    Problem,
}

/// The commands that compare two programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ComparingCommand {
    /// `chordal diff`, which compares whole folders.
    Diff,
    /// `chordal compare`.
    Compare,
    /// The proof of `chordal convert`.
    Convert,
    /// The proof of `chordal transform`.
    Transform,
    /// The proof of `chordal restart`.
    Restart,
}

impl ComparingCommand {
    /// All commands.
    pub const ALL: [ComparingCommand; 5] = [
        ComparingCommand::Diff,
        ComparingCommand::Compare,
        ComparingCommand::Convert,
        ComparingCommand::Transform,
        ComparingCommand::Restart,
    ];

    /// The name of the command.
    pub fn word(self) -> &'static str {
        match self {
            ComparingCommand::Diff => "diff",
            ComparingCommand::Compare => "compare",
            ComparingCommand::Convert => "convert",
            ComparingCommand::Transform => "transform",
            ComparingCommand::Restart => "restart",
        }
    }
}

impl Category {
    /// All categories in the order of declaration.
    pub const ALL: [Category; 30] = [
        Category::Path,
        Category::Order,
        Category::Rotary,
        Category::Rapid,
        Category::RapidPath,
        Category::Unknown,
        Category::Feed,
        Category::Time,
        Category::Spindle,
        Category::Tool,
        Category::ReadyTool,
        Category::LengthOffset,
        Category::RadiusOffset,
        Category::WorkOffset,
        Category::Written,
        Category::Variable,
        Category::Coolant,
        Category::PathMode,
        Category::Overrides,
        Category::Dwell,
        Category::Stop,
        Category::Code,
        Category::Message,
        Category::Alarm,
        Category::BlockDelete,
        Category::Probe,
        Category::Output,
        Category::Value,
        Category::NotRun,
        Category::Problem,
    ];

    /// The name in output and in options.
    pub fn word(self) -> &'static str {
        match self {
            Category::Path => "path",
            Category::Order => "order",
            Category::Rotary => "rotary",
            Category::Rapid => "rapid",
            Category::RapidPath => "rapid-path",
            Category::Unknown => "unknown",
            Category::Feed => "feed",
            Category::Time => "time",
            Category::Spindle => "spindle",
            Category::Tool => "tool",
            Category::ReadyTool => "ready-tool",
            Category::LengthOffset => "length-offset",
            Category::RadiusOffset => "radius-offset",
            Category::WorkOffset => "work-offset",
            Category::Written => "written",
            Category::Variable => "variable",
            Category::Coolant => "coolant",
            Category::PathMode => "path-mode",
            Category::Overrides => "overrides",
            Category::Dwell => "dwell",
            Category::Stop => "stop",
            Category::Code => "code",
            Category::Message => "message",
            Category::Alarm => "alarm",
            Category::BlockDelete => "block-delete",
            Category::Probe => "probe",
            Category::Output => "output",
            Category::Value => "value",
            Category::NotRun => "not-run",
            Category::Problem => "problem",
        }
    }

    /// Its description in the documentation.
    pub fn meaning(self) -> &'static str {
        match self {
            Category::Path => "the path of the tool centre",
            Category::Order => "the same moves at another time",
            Category::Rotary => {
                "the place of a rotary axis on the way, and the surface that it turns"
            }
            Category::Rapid => "a rapid instead of a cut",
            Category::RapidPath => "a dog-leg rapid instead of a straight one",
            Category::Unknown => "moves to places that are not known relative to the part",
            Category::Feed => "the feed",
            Category::Time => "the time of cuts and dwells, where neither feeds nor paths show why",
            Category::Spindle => "the spindle's direction or speed",
            Category::Tool => "the tool",
            Category::ReadyTool => "the tool that is made ready",
            Category::LengthOffset => {
                "the number of the tool length offset, or the offsets that the program gives itself"
            }
            Category::RadiusOffset => "the number of the radius offset",
            Category::WorkOffset => "the work offset",
            Category::Written => {
                "a value that the control keeps: of a work offset, a tool, a reference point"
            }
            Category::Variable => {
                "a variable of the control that is an output, a setting, or outlives the program"
            }
            Category::Coolant => "the coolant",
            Category::PathMode => "how corners are passed",
            Category::Overrides => "which overrides act",
            Category::Dwell => "a dwell",
            Category::Stop => "a stop for the operator",
            Category::Code => {
                "a code that acts on something which is not simulated, with its words: a clamp, an output, limits"
            }
            Category::Message => "a text for the operator",
            Category::Alarm => "an alarm of the program (#3000)",
            Category::BlockDelete => "a block that a switch of the panel leaves out",
            Category::Probe => "a probe move",
            Category::Output => "a printed line",
            Category::Value => "a value that is read and not known: a variable, an input",
            Category::NotRun => {
                "blocks that neither run has come to, behind a condition that is not known"
            }
            Category::Problem => "a problem that only one of the two has",
        }
    }

    /// The category of a command of a run; `None` for commands that only change how other commands are interpreted or
    /// that have no effect. A move belongs to several categories; the result is the first, the path.
    pub fn of(kind: &CommandKind) -> Option<Category> {
        match kind {
            CommandKind::Rapid { .. }
            | CommandKind::Line { .. }
            | CommandKind::Arc { .. }
            | CommandKind::Spiral { .. }
            | CommandKind::Spline { .. } => Some(Category::Path),
            CommandKind::Dwell { .. } => Some(Category::Dwell),
            CommandKind::Tool { .. } | CommandKind::ToolNumber { .. } => Some(Category::Tool),
            CommandKind::ToolSelect { .. } => Some(Category::ReadyTool),
            CommandKind::ToolLength { .. } => Some(Category::LengthOffset),
            CommandKind::Compensation { .. } => Some(Category::RadiusOffset),
            CommandKind::Spindle { .. } => Some(Category::Spindle),
            CommandKind::Coolant(_) => Some(Category::Coolant),
            CommandKind::Stop { .. } => Some(Category::Stop),
            CommandKind::PathMode(_) => Some(Category::PathMode),
            CommandKind::Overrides(_) => Some(Category::Overrides),
            CommandKind::WorkOffset { .. } => Some(Category::WorkOffset),
            CommandKind::Surface { .. } | CommandKind::PartFrame { .. } => Some(Category::Rotary),
            CommandKind::Probed { .. } => Some(Category::Probe),
            CommandKind::Message(_) => Some(Category::Message),
            CommandKind::Output { .. } => Some(Category::Output),
            CommandKind::Effect(effect) => Some(Category::of_effect(effect)),
            // The effects of these are in the moves that follow; the end of the program is the end of the run.
            CommandKind::CornerArc { .. }
            | CommandKind::CornerMode { .. }
            | CommandKind::Idle
            | CommandKind::End
            | CommandKind::Units(_)
            | CommandKind::Plane(_)
            | CommandKind::FeedMode(_)
            | CommandKind::FeedRate { .. } => None,
        }
    }

    fn of_effect(effect: &Effect) -> Category {
        match effect {
            Effect::Code(_) => Category::Code,
            Effect::Written { .. } => Category::Written,
            Effect::Variable { .. } => Category::Variable,
            Effect::Deletable { .. } => Category::BlockDelete,
            Effect::Alarm { .. } => Category::Alarm,
        }
    }

    /// Why a command does not compare this category completely; `None` when it does.
    pub fn ignored_by(self, command: ComparingCommand) -> Option<&'static str> {
        match (self, command) {
            (
                Category::ReadyTool,
                ComparingCommand::Compare | ComparingCommand::Convert | ComparingCommand::Transform,
            ) => Some("a tool that is made ready moves nothing: programs name it sooner or later"),
            (Category::RapidPath, ComparingCommand::Convert) => {
                Some("whether rapids are straight is the machine's")
            }
            (Category::PathMode | Category::Overrides, ComparingCommand::Convert) => {
                Some("each control has its own codes for corners and overrides")
            }
            (Category::Code, ComparingCommand::Convert) => {
                Some("codes that the new control does not have are left out, and listed as changes")
            }
            (Category::Alarm | Category::Message, ComparingCommand::Convert) => {
                Some("statements and remarks are written as the new control has them")
            }
            (Category::Value, ComparingCommand::Convert) => Some(
                "variables have other names; a program that depends on one is not proved anyway",
            ),
            (Category::NotRun, ComparingCommand::Convert) => {
                Some("compared between two programs of one control alone")
            }
            (Category::Variable, ComparingCommand::Convert) => {
                Some("variables are named as the new control names them")
            }
            (Category::Unknown, ComparingCommand::Transform) => {
                Some("a way from a place that is not known is not known, moved or not")
            }
            (Category::RapidPath, ComparingCommand::Transform) => {
                Some("dog-legs of a program that is turned or mirrored bend elsewhere")
            }
            (Category::Variable, ComparingCommand::Restart) => {
                Some("the head sets none; those that were set before the line are named")
            }
            (Category::Code, ComparingCommand::Restart) => {
                Some("those before the line are not in the head, and are named")
            }
            _ => None,
        }
    }
}

/// The categories as a Markdown table for the documentation.
pub fn shared_reference() -> String {
    let mut page = String::from("| item | what | not compared, or only in part |\n|---|---|---|\n");
    for item in Category::ALL {
        let mut reasons: Vec<(&str, Vec<&str>)> = Vec::new();
        for command in ComparingCommand::ALL {
            let Some(why) = item.ignored_by(command) else { continue };
            match reasons.iter_mut().find(|(reason, _)| *reason == why) {
                Some((_, commands)) => commands.push(command.word()),
                None => reasons.push((why, vec![command.word()])),
            }
        }
        let reasons: Vec<String> = reasons
            .iter()
            .map(|(why, commands)| format!("`{}`: {why}", commands.join("`, `")))
            .collect();
        let (word, meaning) = (item.word(), item.meaning());
        page.push_str(&format!("| `{word}` | {meaning} | {} |\n", reasons.join("; ")));
    }
    page
}
