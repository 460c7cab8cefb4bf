//! Tools, cutting edges and tool radius compensation.

use chordal_command::CompensationSide;
use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};
use chordal_kernel::LengthOffset;

use super::interpreter::Interpreter;
use super::run_state::PathMotion;
use super::tool_edges::edge_offset_number;
use super::words::{BlockStatementView, BlockWords, ToolWord};

/// The largest number of an edge (MD18106 at its default).
const MAX_EDGE: u32 = 9;

impl Interpreter<'_> {
    /// T and D.
    pub(super) fn set_tool(&mut self, words: &BlockWords) {
        if let Some((tool, range)) = &words.tool {
            self.select_tool(tool, *range);
        }
        if let Some(edge) = words.other("D") {
            let number = edge.value.round().max(0.0) as u32;
            self.set_edge(number, edge.range, words);
        }
    }

    fn select_tool(&mut self, tool: &ToolWord, range: TextRange) {
        let number = match tool {
            ToolWord::Number(number) => Some(*number),
            ToolWord::Name(name) => self.tool_named(name),
        };
        match number {
            Some(number) => {
                self.modes.unknown_tool = false;
                self.check_tool_number(number, range);
                self.kernel.select_tool(number);
            }
            None => {
                self.modes.unknown_tool = true;
                self.kernel.select_unknown_tool();
                let ToolWord::Name(name) = tool else { return };
                if self.is_first_report(&format!("T {name}")) {
                    let message = format!(
                        "the machine file has no tool {name}: its length and radius are not known"
                    );
                    let diagnostic = Diagnostic::new(Code::OffsetNotSet, self.span(range), message);
                    let help = "add a tool with this `description` to [tools] of the machine file";
                    self.kernel.report(diagnostic.severity(Severity::Warning).help(help));
                }
            }
        }
        if !self.programs.settings.tool_change_by_m6 {
            self.change_tool(range);
        }
    }

    /// T of a tool that the tool data of the control do not have; without such data nobody knows which tools there are.
    fn check_tool_number(&mut self, number: u32, range: TextRange) {
        let has_data = self.has_tool_tables;
        let is_listed = self.listed_edges.contains(&(number, 1))
            || self.kernel.machine.tools.contains_key(&number);
        if number > 0 && has_data && !is_listed {
            let message = format!("the tool data of the control have no tool {number}");
            self.alarm(17190, Code::OffsetNotSet, range, message);
        }
    }

    /// The number of the tool whose description in the machine file is a name. Names are compared with their case.
    fn tool_named(&self, name: &str) -> Option<u32> {
        let tools = self.kernel.machine.tools.iter();
        let own =
            |(_, tool): &(&u32, &chordal_machine::Tool)| tool.description.as_deref() == Some(name);
        let written = || self.tool_names.get(name).copied();
        written()
            .or_else(|| tools.clone().find(own).map(|(number, _)| *number))
            .or_else(|| name.parse().ok())
    }

    /// M6: the prepared tool into the spindle. Its first edge becomes active (MD20270 = 1).
    pub(super) fn change_tool(&mut self, range: TextRange) {
        if self.kernel.state.selected_tool.is_none() && !self.modes.unknown_tool {
            // M6 without T changes to the tool that is already in the spindle.
            return;
        }
        let span = self.span(range);
        self.kernel.tool_change(span);
        self.set_edge(1, range, &BlockWords::default());
    }

    /// D: the edge whose length and radius act; D0 for none.
    fn set_edge(&mut self, edge: u32, range: TextRange, words: &BlockWords) {
        self.modes.edge = edge;
        let tool = self.kernel.state.tool;
        if edge > MAX_EDGE {
            let message = format!("there is no D{edge}: a tool has {MAX_EDGE} edges at most");
            return self.alarm(17180, Code::OffsetNotSet, range, message);
        }
        let lists_tool = self.listed_edges.contains(&(tool, 1));
        if edge > 0 && tool > 0 && lists_tool && !self.listed_edges.contains(&(tool, edge)) {
            let message = format!("the tool data of the control give tool {tool} no D{edge}");
            return self.alarm(17180, Code::OffsetNotSet, range, message);
        }
        let mut number = edge_offset_number(tool, edge);
        let is_listed =
            number.is_none_or(|number| self.kernel.state.offsets.tool(number).is_some());
        if edge > 1 && !is_listed {
            // The values of the first edge are drawn, so that there is something to see.
            number = edge_offset_number(tool, 1);
            if self.is_first_report(&format!("D {tool} {edge}")) {
                let message = format!("the values of D{edge} of tool {tool} are not given");
                let diagnostic = Diagnostic::new(Code::OffsetNotSet, self.span(range), message);
                let help = "put the control's tool data (TOA or INI) next to the program, or set $TC_DP in it";
                self.kernel.report(diagnostic.severity(Severity::Warning).help(help));
                self.lose_path(range, &format!("D{edge}"), "the tool data of the control");
            }
        }
        let span = self.span(range);
        let at = BlockStatementView { span, words };
        self.kernel.set_length(&at, LengthOffset { number, minus: false });
        self.kernel.state.radius_offset = Some(number.unwrap_or(0));
    }

    /// G41, G42 and G40.
    pub(super) fn set_compensation(&mut self, range: TextRange, words: &BlockWords) {
        let code = words.g_codes.iter().find(|(code, _)| (40..=42).contains(code));
        let Some((code, code_range)) = code.copied() else { return };
        let side = match code {
            41 => CompensationSide::Left,
            42 => CompensationSide::Right,
            _ => CompensationSide::Off,
        };
        let is_mirrored = self.modes.frame.in_plane(self.kernel.state.plane).is_mirrored();
        // A mirrored contour has the tool on its other side.
        let side = side.mirrored_if(is_mirrored);
        let before = self.kernel.state.side;
        if side == before {
            return;
        }
        let is_arc = !matches!(self.modes.motion, PathMotion::Rapid | PathMotion::Linear);
        if is_arc && words.has_path_motion() {
            let (alarm, what) = match side {
                CompensationSide::Off => (10754, "off"),
                _ => (10753, "on"),
            };
            let message =
                format!("tool radius compensation is switched {what} in a block of an arc");
            self.alarm(alarm, Code::CompensationOnArc, code_range, message);
        }
        let is_tool_unknown = self.modes.unknown_tool || self.kernel.state.unknown.tool;
        let has_no_edge = self.modes.edge == 0 || self.kernel.state.tool == 0 && !is_tool_unknown;
        if side != CompensationSide::Off && has_no_edge && !self.modes.is_state_unknown {
            let message = "tool radius compensation is switched on and no tool edge is active";
            self.alarm(10750, Code::CompensationWithoutOffset, code_range, message);
        }
        self.note_approach(side, range, words);
        self.kernel.state.side = side;
        let number = self.kernel.state.radius_offset;
        let number = number.filter(|_| side != CompensationSide::Off);
        let span = self.span(range);
        self.kernel.emit_compensation(number, None, span);
    }
}
