//! Why there is no run on stock, for `chordal stock` and `chordal optimize`.

use std::path::Path;

use chordal::stock::StockRunError;
use chordal_load::LoadError;

use crate::failure::CommandFailure;

/// What is wrong with a setup, drawn where it was written; `setup`: the setup file.
pub fn failure_of(error: StockRunError, setup: Option<&Path>) -> CommandFailure {
    match error {
        StockRunError::Setup(setup) => match setup.location {
            Some(at) => LoadError::Machine(vec![chordal::machine::MachineError {
                message: setup.message,
                help: Some(setup.help),
                file: at.file.to_string(),
                span: Some(at.span),
                text: at.text,
            }])
            .into(),
            None => CommandFailure::wrong(setup.message, setup.help),
        },
        StockRunError::NoStock => {
            CommandFailure::wrong("there is no stock to cut", where_to_write(setup))
        }
        StockRunError::StockNotPlaced(_) => {
            CommandFailure::wrong(error.to_string(), where_to_write(setup))
        }
        StockRunError::Turns => CommandFailure::wrong(
            error.to_string(),
            "run `chordal stock` on it: this command answers for mills",
        ),
        other => CommandFailure::wrong(
            other.to_string(),
            "choose a larger --resolution, or more --memory",
        ),
    }
}

fn where_to_write(setup: Option<&Path>) -> String {
    match setup {
        Some(setup) => format!("write `[stock]` in {}", setup.display()),
        None => "name a setup file with --setup".to_string(),
    }
}
