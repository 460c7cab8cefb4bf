//! What a page is told where Chordal itself has failed: whoever holds the view catches it, and the view goes on.

use serde_json::json;

use crate::View;
use crate::view::Work;

/// What to do about it.
pub const HELP: &str = "please report it with the program";

/// The sentence about a failure of ours.
pub fn sentence(why: &str) -> String {
    format!("Chordal failed: {why}")
}

impl View {
    /// Work was broken off by a failure of ours: the page waits for it no longer.
    pub fn failed(&self, work: Work, why: &str) {
        let (message, help, number) = (sentence(why), HELP, work.number());
        let run = self.held().ran.as_ref().map_or(0, |ran| ran.number);
        let told = match work {
            Work::Run(_) => {
                json!({ "type": "refused", "run": number, "message": message, "help": help })
            }
            Work::Plan(_) => json!({ "type": "no_times", "run": number, "message": message }),
            Work::Compare(_) => json!({
                "type": "no_comparison", "run": run, "version": number, "message": message,
            }),
            Work::Cut(_) => {
                json!({ "type": "no_stock", "run": run, "message": message, "help": help })
            }
        };
        self.out().json(&told);
    }

    /// A question was broken off by a failure of ours. The text is sent again: nobody knows whether the question
    /// has changed it.
    pub fn failed_to_answer(&self, id: u64, why: &str) {
        self.out().refuse(id, &sentence(why), Some(HELP));
        self.send_text();
    }
}
