//! The shift of a settable frame that is written as a chain: `CTRANS(X,10,Y,20):CROT(Z,0):CFINE(X,0.1)`.

use super::system_variables::linear_axis;
use crate::syntax::{BinaryOperator, Expression, ExpressionKind};

/// Why a chain gives no shift.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ChainFault {
    /// It is no chain of CTRANS, CFINE, CROT, CSCALE and CMIRROR over the axes X, Y and Z.
    OtherForm,
    /// It rotates, scales or mirrors.
    MoreThanShift,
    /// A number in it is not known.
    NoNumber,
}

/// The shift of X, Y and Z by a chain of frames, in the unit of its numbers. An axis that it does not name is 0, because
/// an assignment replaces the whole frame. `number` gives the value of an expression.
///
/// # Errors
/// The chain does more than shift, has another form, or a number in it is not known.
pub fn shift_of_chain(
    chain: &Expression,
    number: &mut impl FnMut(&Expression) -> Option<f64>,
) -> Result<[f64; 3], ChainFault> {
    let mut shift = [0.0; 3];
    add_frames(chain, number, &mut shift)?;
    Ok(shift)
}

fn add_frames(
    chain: &Expression,
    number: &mut impl FnMut(&Expression) -> Option<f64>,
    shift: &mut [f64; 3],
) -> Result<(), ChainFault> {
    let (function, arguments) = match &chain.kind {
        ExpressionKind::Binary(BinaryOperator::Chain, first, second) => {
            add_frames(first, number, shift)?;
            return add_frames(second, number, shift);
        }
        ExpressionKind::Function(function, arguments) => (&**function, arguments),
        _ => return Err(ChainFault::OtherForm),
    };
    let neutral = match function {
        "CTRANS" | "CFINE" | "CROT" => 0.0,
        "CSCALE" => 1.0,
        "CMIRROR" if arguments.iter().all(Option::is_none) => return Ok(()),
        "CMIRROR" => return Err(ChainFault::MoreThanShift),
        _ => return Err(ChainFault::OtherForm),
    };
    for pair in arguments.chunks(2) {
        let [Some(axis), Some(value)] = pair else { return Err(ChainFault::OtherForm) };
        let axis = axis_of(axis).ok_or(ChainFault::OtherForm)?;
        let value = number(value).ok_or(ChainFault::NoNumber)?;
        if matches!(function, "CTRANS" | "CFINE") {
            shift[axis] += value;
        } else if value != neutral {
            return Err(ChainFault::MoreThanShift);
        }
    }
    Ok(())
}

/// The index of the linear axis that an expression names.
pub fn axis_of(expression: &Expression) -> Option<usize> {
    let ExpressionKind::Variable(address) = &expression.kind else { return None };
    linear_axis(&address.name)
}
