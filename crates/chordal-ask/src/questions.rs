//! The questions, by their names.

use crate::answer::{QuestionAnswer, QuestionFailure};
use crate::load_request::LoadRequest;
use crate::request::QuestionRequest;
use crate::{meanings, motion, programs};

/// Answers a request.
///
/// # Errors
/// A wrong use, a file that is not there, a machine that cannot be used.
pub fn answer(request: QuestionRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let mut loading = LoadRequest::of(request);
    match loading.question.as_str() {
        "check" => programs::check(&mut loading),
        "run" => programs::run(&mut loading),
        "commands" => motion::commands(&mut loading),
        "path" => motion::path(&mut loading),
        "curves" => motion::curves(&mut loading),
        "time" => motion::time(&mut loading),
        "sample" => motion::sample(&mut loading),
        "compare" => programs::comparison(&mut loading),
        "convert" => programs::conversion(&mut loading),
        "explain" => meanings::explanation(&mut loading),
        "machines" => meanings::machines(&mut loading),
        "machine" => meanings::machine(&mut loading),
        // So that the tests can see how JavaScript goes on after one.
        #[cfg(feature = "test-questions")]
        "panic" => panic!("asked to panic"),
        other => Err(QuestionFailure::plain(format!("there is no question `{other}`"), None)),
    }
}
