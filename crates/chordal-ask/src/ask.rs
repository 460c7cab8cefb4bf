//! The questions, by their names.

use crate::answer::{Answer, Failure};
use crate::loading::Asked;
use crate::request::Request;
use crate::{motion, programs, words};

/// Answers a request.
///
/// # Errors
/// A wrong use, a file that is not there, a machine that cannot be used.
pub fn ask(request: Request) -> Result<Answer, Failure> {
    let mut asked = Asked::of(request);
    match asked.ask.as_str() {
        "check" => programs::check(&mut asked),
        "run" => programs::run(&mut asked),
        "commands" => motion::commands(&mut asked),
        "path" => motion::path(&mut asked),
        "curves" => motion::curves(&mut asked),
        "time" => motion::time(&mut asked),
        "sample" => motion::sample(&mut asked),
        "compare" => programs::compared(&mut asked),
        "convert" => programs::converted(&mut asked),
        "explain" => words::explained(&mut asked),
        "machines" => words::machines(&mut asked),
        "machine" => words::machine(&mut asked),
        // So that the tests can see how JavaScript goes on after one.
        "panic" => panic!("asked to panic"),
        other => Err(Failure::plain(format!("there is no question `{other}`"), None)),
    }
}
