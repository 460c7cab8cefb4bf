//! The order in which a control carries out what a block says, whatever the order of its words.

use BlockStep as S;

use crate::action::{Action, AfterCode, BeforeCode};
use crate::settings::Certainty;

/// One thing that a block may do.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum BlockStep {
    /// A message to the operator.
    Message,
    /// The unit of F: per minute, per revolution, inverse time.
    FeedMode,
    /// F.
    Feed,
    /// S.
    SpindleSpeed,
    /// T.
    ToolSelect,
    /// M6.
    ToolChange,
    /// M3, M4.
    SpindleOn,
    /// M5.
    SpindleOff,
    /// M7, M8.
    CoolantOn,
    /// M9.
    CoolantOff,
    /// M48 to M53.
    Overrides,
    /// G4.
    Dwell,
    /// G17 to G19.
    Plane,
    /// G20, G21.
    Units,
    /// G40 to G42.
    Compensation,
    /// G43, G49.
    ToolLength,
    /// G54 and the others.
    WorkOffset,
    /// G61, G64.
    PathMode,
    /// G90, G91.
    Distance,
    /// G98, G99.
    ReturnLevel,
    /// G10, G28, G92.
    Offsets,
    /// The motion, or the cycle.
    Motion,
    /// M98, G65.
    Call,
    /// M0, M1, M30.
    Stop,
}

impl BlockStep {
    /// For users: `spindle off (M5)`.
    pub const fn name(self) -> &'static str {
        match self {
            BlockStep::Message => "message",
            BlockStep::FeedMode => "feed mode (G93, G94)",
            BlockStep::Feed => "F",
            BlockStep::SpindleSpeed => "S",
            BlockStep::ToolSelect => "T",
            BlockStep::ToolChange => "tool change (M6)",
            BlockStep::SpindleOn => "spindle on (M3, M4)",
            BlockStep::SpindleOff => "spindle off (M5)",
            BlockStep::CoolantOn => "coolant on (M7, M8)",
            BlockStep::CoolantOff => "coolant off (M9)",
            BlockStep::Overrides => "overrides (M48, M49)",
            BlockStep::Dwell => "dwell (G4)",
            BlockStep::Plane => "plane (G17 to G19)",
            BlockStep::Units => "units (G20, G21)",
            BlockStep::Compensation => "cutter compensation (G40 to G42)",
            BlockStep::ToolLength => "tool length (G43, G49)",
            BlockStep::WorkOffset => "work offset (G54 …)",
            BlockStep::PathMode => "path mode (G61, G64)",
            BlockStep::Distance => "distance (G90, G91)",
            BlockStep::ReturnLevel => "return level (G98, G99)",
            BlockStep::Offsets => "reference points and shifts (G10, G28, G92)",
            BlockStep::Motion => "motion",
            BlockStep::Call => "call (M98)",
            BlockStep::Stop => "stop (M0, M1, M30)",
        }
    }

    /// The step of a code that switches the machine rather than moving it; `None` for other codes.
    pub const fn of_switch(action: Action) -> Option<BlockStep> {
        match action {
            Action::Before(code) => match code {
                BeforeCode::ToolChange | BeforeCode::SetToolNumber => Some(BlockStep::ToolChange),
                BeforeCode::SpindleCw
                | BeforeCode::SpindleCcw
                | BeforeCode::SpindleOrient
                | BeforeCode::LiveToolCw
                | BeforeCode::LiveToolCcw
                | BeforeCode::CAxisOn => Some(BlockStep::SpindleOn),
                BeforeCode::CoolantMist
                | BeforeCode::CoolantFlood
                | BeforeCode::CoolantThroughTool
                // Outputs are switched with the coolant, before the motion.
                | BeforeCode::AnalogueOutput => Some(BlockStep::CoolantOn),
                BeforeCode::SaveModes { .. }
                | BeforeCode::ForgetModes
                | BeforeCode::RestoreModes => None,
            },
            Action::After(code) => match code {
                AfterCode::SpindleStop | AfterCode::LiveToolStop => Some(BlockStep::SpindleOff),
                AfterCode::CoolantOff | AfterCode::CoolantThroughToolOff => {
                    Some(BlockStep::CoolantOff)
                }
                AfterCode::ProgramStop
                | AfterCode::OptionalStop
                | AfterCode::ProgramEnd { .. }
                | AfterCode::ProgramAgain => Some(BlockStep::Stop),
                AfterCode::ShopCode | AfterCode::RunCycleHere => None,
            },
            Action::Reading(_)
            | Action::Mode(_)
            | Action::Length(_)
            | Action::Motion(_)
            | Action::Cycle(_)
            | Action::Once(_)
            | Action::Call(_)
            | Action::NoEffect
            | Action::NotSimulated
            | Action::NotFollowed => None,
        }
    }
}

/// The order in which a control carries out the steps of a block.
#[derive(Clone, Copy, Debug)]
pub struct BlockOrder {
    /// Groups of steps, one after the other; the steps of one group act in the order of the words in the block.
    pub steps: &'static [&'static [BlockStep]],
    /// Manual and section.
    pub source: &'static str,
    /// How certain it is.
    pub certainty: Certainty,
}

impl BlockOrder {
    /// The index of the group of a step; steps that are in no group come last.
    pub fn rank(&self, step: BlockStep) -> usize {
        let index = self.steps.iter().position(|group| group.contains(&step));
        index.unwrap_or(self.steps.len())
    }

    /// Whether one step is carried out before another, because it is in an earlier group.
    pub fn is_before(&self, one: BlockStep, other: BlockStep) -> bool {
        self.rank(one) < self.rank(other)
    }
}

/// RS274/NGC: one step after the other. F comes before the units, and every switch before the motion.
pub(crate) const RS274_STEPS: &[&[BlockStep]] = &[
    &[S::Message],
    &[S::FeedMode],
    &[S::Feed],
    &[S::SpindleSpeed],
    &[S::ToolSelect],
    &[S::ToolChange],
    &[S::SpindleOn, S::SpindleOff],
    &[S::CoolantOn, S::CoolantOff],
    &[S::Overrides],
    &[S::Dwell],
    &[S::Plane],
    &[S::Units],
    &[S::Compensation],
    &[S::ToolLength],
    &[S::WorkOffset],
    &[S::PathMode],
    &[S::Distance],
    &[S::ReturnLevel],
    &[S::Offsets],
    &[S::Motion],
    &[S::Stop],
];

/// GRBL: as RS274/NGC, except that the units apply to the whole block, F included.
pub(crate) const GRBL_STEPS: &[&[BlockStep]] = &[
    &[S::Units],
    &[S::FeedMode],
    &[S::Feed],
    &[S::SpindleSpeed],
    &[S::ToolSelect],
    &[S::ToolChange],
    &[S::SpindleOn, S::SpindleOff],
    &[S::CoolantOn, S::CoolantOff],
    &[S::Overrides],
    &[S::Dwell],
    &[S::Plane],
    &[S::ToolLength],
    &[S::WorkOffset],
    &[S::PathMode],
    &[S::Distance],
    &[S::ReturnLevel],
    &[S::Offsets],
    &[S::Motion],
    &[S::Stop],
];

/// Production controls: the modes of a block apply to its words and its motion. The machine builder decides which M
/// codes act before the motion and which after it.
pub(crate) const BUILDER_STEPS: &[&[BlockStep]] = &[
    &[S::Units, S::FeedMode, S::Distance],
    &[S::Feed, S::SpindleSpeed, S::ToolSelect],
    &[S::ToolChange, S::SpindleOn, S::CoolantOn],
    &[S::Overrides, S::Plane, S::Compensation, S::WorkOffset, S::PathMode, S::ReturnLevel],
    &[S::ToolLength],
    &[S::Dwell, S::Offsets, S::Motion],
    &[S::SpindleOff, S::CoolantOff, S::Stop],
    &[S::Call],
];

/// The order of a Fanuc, and of the controls whose manuals say the same.
pub(crate) const BUILDER_ORDER: BlockOrder = BlockOrder {
    steps: BUILDER_STEPS,
    source: "Fanuc B-63844EN, 12.1: M codes beside a motion as the builder of the machine chooses; which, as is usual",
    certainty: Certainty::Practice,
};
