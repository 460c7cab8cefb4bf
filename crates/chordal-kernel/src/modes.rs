//! The modes that a statement sets: distance, units, feed, plane, path, spindle, tool.

use chordal_command::{
    CommandKind, CompensationSide, Coolant, FeedMode, SpindleState, SurfaceSpeed, Units,
};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_geometry::Plane;

use crate::kernel::Kernel;
use crate::path_mode::PathState;
use crate::state::LiveTool;

impl Kernel<'_> {
    /// G90 and G91; the position at which G91 becomes active is remembered.
    pub fn set_incremental(&mut self, incremental: bool) {
        if incremental && !self.state.incremental {
            self.state.incremental_from = self.state.position;
        }
        self.state.incremental = incremental;
    }

    /// Sets the units of the program.
    pub fn set_units(&mut self, units: Units) {
        if self.state.units != units {
            self.state.units = units;
            self.emit(CommandKind::Units(units));
        }
    }

    /// Sets the unit of F by a code of the program; on some controls this ends F even without a change.
    pub fn set_feed_mode_by_code(&mut self, mode: FeedMode) {
        let is_active = self.state.feed_mode == mode;
        if is_active && self.rules.feed_mode_code_ends_feed {
            self.end_feed();
        }
        self.set_feed_mode(mode);
    }

    /// Forgets F, as before the first one.
    fn end_feed(&mut self) {
        self.state.feed = None;
        self.state.feed_angular = None;
        self.state.unknown.feed = false;
        self.reported.missing_feed = false;
    }

    /// Sets the unit of F; a change forgets F.
    pub fn set_feed_mode(&mut self, mode: FeedMode) {
        if self.state.feed_mode != mode {
            self.state.feed_mode = mode;
            // A feed of one unit means nothing in another.
            self.end_feed();
            self.emit(CommandKind::FeedMode(mode));
        }
    }

    /// Selects the plane of arcs and compensation; `word` is the code.
    pub fn set_plane(&mut self, word: Span, plane: Plane) {
        if plane == self.state.plane {
            return;
        }
        if self.state.side != CompensationSide::Off {
            self.report(
                Diagnostic::new(
                    Code::PlaneChangeInCompensation,
                    word,
                    "the plane changes while cutter compensation is on",
                )
                .help("cancel compensation with G40 first"),
            );
        }
        self.check_plane_change(word, plane);
        self.state.plane = plane;
        self.emit(CommandKind::Plane(plane));
    }

    /// Starts or stops the spindle. A running spindle replaces a live tool as what cuts; stopping the spindle while
    /// a live tool cuts emits nothing.
    pub fn set_spindle(&mut self, spindle: SpindleState) {
        let turns = |state: SpindleState| matches!(state, SpindleState::Cw | SpindleState::Ccw);
        if spindle == SpindleState::Off && !turns(self.state.spindle) {
            return;
        }
        self.state.spindle = spindle;
        if turns(spindle) {
            self.state.live = None;
        } else if self.state.live.is_some() {
            return;
        }
        let rpm = if spindle == SpindleState::Off { 0.0 } else { self.state.rpm };
        self.emit(CommandKind::Spindle { state: spindle, rpm });
    }

    /// Starts a live tool, which cuts in place of the spindle, or stops it (`None`), and the spindle cuts again.
    pub fn set_live_tool(&mut self, live: Option<LiveTool>) {
        let before = std::mem::replace(&mut self.state.live, live);
        if let Some(live) = live {
            self.state.live_rpm = live.rpm;
            return self.emit(CommandKind::Spindle { state: live.turns, rpm: live.rpm });
        }
        if before.is_none() {
            return;
        }
        match self.state.spindle {
            SpindleState::Off | SpindleState::Oriented => {
                self.emit(CommandKind::Spindle { state: SpindleState::Off, rpm: 0.0 });
            }
            state => {
                let rpm = self.rev_per_s(self.state.position[0]) * 60.0;
                self.emit(CommandKind::Spindle { state, rpm });
            }
        }
    }

    /// State of what turns during a cut: a live tool, or the spindle.
    #[inline]
    pub(crate) fn turning(&self) -> SpindleState {
        self.state.live.map_or(self.state.spindle, |live| live.turns)
    }

    /// Changes the coolant valves; emits only a change.
    pub fn set_coolant(&mut self, change: impl FnOnce(&mut Coolant)) {
        let before = self.state.coolant;
        change(&mut self.state.coolant);
        if self.state.coolant != before {
            self.emit(CommandKind::Coolant(self.state.coolant));
        }
    }

    /// G96: S is a cutting speed from here on; until an S, the last cutting speed acts.
    pub fn keep_surface_speed(&mut self) {
        if self.state.surface_speed.is_none() {
            self.state.surface_speed = Some(self.state.last_surface_speed);
        }
    }

    /// G97: S is the spindle speed again; until an S, the present speed stays.
    pub fn keep_spindle_speed(&mut self) {
        if let Some(surface) = self.surface_of_spindle() {
            self.state.rpm = surface.rev_per_s(self.state.position[0]) * 60.0;
            self.state.surface_speed = None;
        }
    }

    /// S under G96, mm/s.
    pub fn set_surface_speed(&mut self, mm_per_s: f64) {
        self.state.surface_speed = Some(mm_per_s);
        self.state.last_surface_speed = mm_per_s;
        self.follow_diameter();
    }

    /// Limits the spindle speed, rev/min.
    pub fn limit_speed(&mut self, rpm: f64) {
        self.state.speed_limit = Some(rpm);
        if self.state.surface_speed.is_some() {
            self.follow_diameter();
        }
    }

    /// Sets the spindle to the speed that G96 gives at the present diameter.
    pub(crate) fn follow_diameter(&mut self) {
        if self.surface().is_some() {
            let rpm = self.rev_per_s(self.state.position[0]) * 60.0;
            self.set_speed(rpm);
        }
    }

    /// The cutting speed that the spindle keeps; `None` without G96 and when a live tool cuts.
    pub(crate) fn surface(&self) -> Option<SurfaceSpeed> {
        self.surface_of_spindle().filter(|_| self.state.live.is_none())
    }

    fn surface_of_spindle(&self) -> Option<SurfaceSpeed> {
        let mm_per_s = self.state.surface_speed?;
        let limit = self.state.speed_limit.unwrap_or(f64::INFINITY);
        let most = limit.min(self.machine.spindle_max_rpm.unwrap_or(f64::INFINITY));
        Some(SurfaceSpeed { mm_per_s, most_rev_per_s: most / 60.0, is_limited: limit.is_finite() })
    }

    /// The speed of spindle or live tool with the tool tip at `x` (a radius, mm), rev/s.
    pub(crate) fn rev_per_s(&self, x: f64) -> f64 {
        if let Some(live) = self.state.live {
            return live.rpm / 60.0;
        }
        match self.surface() {
            Some(surface) => surface.rev_per_s(x),
            None => self.state.rpm / 60.0,
        }
    }

    /// The speed of spindle or live tool at the start of a cut at `x` (a radius, mm), rev/s, and the cutting
    /// speed that is kept during it.
    #[inline]
    pub(crate) fn spindle_of_feed(&self, x: f64) -> (f64, Option<SurfaceSpeed>) {
        if self.state.live.is_none() && self.state.surface_speed.is_none() {
            return (self.state.rpm / 60.0, None);
        }
        self.spindle_of_lathe(x)
    }

    #[cold]
    fn spindle_of_lathe(&self, x: f64) -> (f64, Option<SurfaceSpeed>) {
        // On a surface (G12.1, G7.1) the spindle positions the part as an axis: it has no cutting speed.
        let surface = if self.state.surface.is_some() { None } else { self.surface() };
        (self.rev_per_s(x), surface)
    }

    /// Sets the spindle speed, rev/min.
    pub fn set_speed(&mut self, rpm: f64) {
        self.state.rpm = rpm;
        self.state.unknown.speed = false;
        if self.state.spindle != SpindleState::Off && self.state.live.is_none() {
            self.emit(CommandKind::Spindle { state: self.state.spindle, rpm });
        }
    }

    /// An S whose value is not known.
    pub fn set_unknown_speed(&mut self) {
        self.set_speed(0.0);
        self.state.unknown.speed = true;
    }

    /// Makes a tool of unknown number ready.
    pub fn select_unknown_tool(&mut self) {
        self.state.selected_tool = None;
        self.state.unknown.tool = true;
    }

    /// Makes a tool ready for the next change.
    pub fn select_tool(&mut self, number: u32) {
        self.state.selected_tool = Some(number);
        self.state.unknown.tool = false;
        self.emit(CommandKind::ToolSelect { number });
    }

    /// Puts the tool made ready into the spindle; `word` is the code.
    pub fn tool_change(&mut self, word: Span) {
        self.state.arc_over_rapid = false;
        // A tool of unknown number is treated as one that is not in the machine file.
        let unknown = self.state.unknown.tool.then_some(0);
        let Some(number) = self.state.selected_tool.or(unknown) else {
            let message = "a tool change without a tool number".to_string();
            return self.missing_word(word, message, "write T and the tool's number before M6");
        };
        if self.state.side != CompensationSide::Off {
            let code = Code::ToolChangeInCompensation;
            let refused = self.alarms.text(code).is_some();
            self.report(
                Diagnostic::new(code, word, "the tool is changed while cutter compensation is on")
                    .severity(if refused { Severity::Error } else { Severity::Warning })
                    .help("cancel compensation with G40 first"),
            );
        }
        self.end_cycle_if(self.rules.cycles.cancel.by_tool_change);
        self.end_length_if(self.rules.length.ended_by.tool_change);
        self.state.tool = number;
        if self.rules.spindle_stops_at_tool_change {
            self.state.spindle = SpindleState::Off;
        }
        self.emit(CommandKind::Tool { number });
    }

    /// Gives the tool in the spindle another number (M61), without a tool change.
    pub fn set_tool_number(&mut self, number: u32) {
        self.state.tool = number;
        self.emit(CommandKind::ToolNumber { number });
    }

    /// Changes the path mode or its tolerance.
    pub fn change_path_mode(&mut self, change: impl FnOnce(&mut PathState)) {
        change(&mut self.state.path);
        self.emit(CommandKind::PathMode(self.state.path.in_force()));
    }

    /// Ends the exact stop of a single statement (G9), after it.
    pub fn end_exact_stop_once(&mut self) {
        self.change_path_mode(|path| path.once = false);
    }
}
