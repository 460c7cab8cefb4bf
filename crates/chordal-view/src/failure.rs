//! The messages to a page when Chordal itself has failed: the owner of the view catches the panic, and the view
//! continues.

use serde_json::json;

use crate::ProgramView;
use crate::view::WorkItem;

pub const REPORT_HELP: &str = "please report it with the program";

/// The message about a panic.
pub fn failure_message(why: &str) -> String {
    format!("Chordal failed: {why}")
}

impl ProgramView {
    /// Reports that a work item ended with a panic, so that the page does not wait for its result.
    pub fn work_failed(&self, work: WorkItem, why: &str) {
        let (message, help, number) = (failure_message(why), REPORT_HELP, work.number());
        let run = self.state().finished_run.as_ref().map_or(0, |finished| finished.number);
        let reply = match work {
            WorkItem::Run(_) => {
                json!({ "type": "refused", "run": number, "message": message, "help": help })
            }
            WorkItem::Plan(_) => json!({ "type": "no_times", "run": number, "message": message }),
            WorkItem::Compare(_) => json!({
                "type": "no_comparison", "run": run, "version": number, "message": message,
            }),
            WorkItem::Cut(_) => {
                json!({ "type": "no_stock", "run": run, "message": message, "help": help })
            }
        };
        self.out().json(&reply);
    }

    /// Reports that a request ended with a panic. The text is sent again, because the request may have changed it.
    pub fn answer_failed(&self, id: u64, why: &str) {
        self.out().refuse(id, &failure_message(why), Some(REPORT_HELP));
        self.send_text();
    }
}
