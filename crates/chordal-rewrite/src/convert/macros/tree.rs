//! Expressions as trees.

use chordal::syntax::{Expression, ExpressionParser, Function, Operator, StackOp};

/// Longer expressions are not carried over.
const MAX_STEPS: usize = 200;

/// A variable by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum VariableRef {
    /// `#101`.
    Number(u32),
    /// `V20`, `R3`: by the letters of the language.
    Letter(&'static str, u32),
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum ExpressionTree {
    /// A number as it is written.
    Number(String),
    Variable(VariableRef),
    Negate(Box<ExpressionTree>),
    Binary(Operator, Box<ExpressionTree>, Box<ExpressionTree>),
    Call(Function, Box<ExpressionTree>),
}

impl ExpressionTree {
    pub fn register(index: u8, negative: bool) -> ExpressionTree {
        let register = ExpressionTree::Variable(VariableRef::Letter("R", u32::from(index)));
        if negative { ExpressionTree::Negate(Box::new(register)) } else { register }
    }

    /// The tree of an expression; nothing where it takes more than numbers, variables of fixed numbers,
    /// operators and functions of one value.
    pub fn of(
        parser: &ExpressionParser,
        expression: Expression,
        text: &[u8],
    ) -> Option<ExpressionTree> {
        let steps = parser.steps(expression);
        if steps.len() > MAX_STEPS || !parser.problems.is_empty() {
            return None;
        }
        let mut stack: Vec<ExpressionTree> = Vec::new();
        for step in steps {
            let tree = match step.op {
                StackOp::Number(_) => {
                    let written = String::from_utf8_lossy(step.range.slice(text));
                    ExpressionTree::Number(written.chars().filter(|c| !c.is_whitespace()).collect())
                }
                StackOp::Read => {
                    ExpressionTree::Variable(VariableRef::Number(whole(stack.pop()?)?))
                }
                StackOp::Letters(place) => {
                    let letters = *parser.grammar().letter_variables.get(usize::from(place))?;
                    ExpressionTree::Variable(VariableRef::Letter(letters, whole(stack.pop()?)?))
                }
                StackOp::Negate => ExpressionTree::Negate(Box::new(stack.pop()?)),
                StackOp::Binary(operator) => {
                    let right = Box::new(stack.pop()?);
                    ExpressionTree::Binary(operator, Box::new(stack.pop()?), right)
                }
                StackOp::Call { function, two: false } => {
                    ExpressionTree::Call(function, Box::new(stack.pop()?))
                }
                StackOp::Call { two: true, .. } | StackOp::Unreadable | StackOp::ReadNamed(_) => {
                    return None;
                }
            };
            stack.push(tree);
        }
        let tree = stack.pop()?;
        stack.is_empty().then_some(tree)
    }

    /// All variables in it.
    pub fn variables(&self, see: &mut impl FnMut(VariableRef)) {
        match self {
            ExpressionTree::Number(_) => {}
            ExpressionTree::Variable(variable) => see(*variable),
            ExpressionTree::Negate(one) | ExpressionTree::Call(_, one) => one.variables(see),
            ExpressionTree::Binary(_, one, other) => {
                one.variables(see);
                other.variables(see);
            }
        }
    }

    /// The condition that holds where this one does not; nothing where it is no comparison.
    pub fn inverted(&self) -> Option<ExpressionTree> {
        let ExpressionTree::Binary(operator, one, other) = self else { return None };
        let operator = match operator {
            Operator::Equal => Operator::NotEqual,
            Operator::NotEqual => Operator::Equal,
            Operator::Greater => Operator::LessOrEqual,
            Operator::GreaterOrEqual => Operator::Less,
            Operator::Less => Operator::GreaterOrEqual,
            Operator::LessOrEqual => Operator::Greater,
            _ => return None,
        };
        Some(ExpressionTree::Binary(operator, one.clone(), other.clone()))
    }
}

/// A number that is whole and not below zero.
fn whole(tree: ExpressionTree) -> Option<u32> {
    match tree {
        ExpressionTree::Number(text) => text.trim_end_matches('.').parse().ok(),
        _ => None,
    }
}
