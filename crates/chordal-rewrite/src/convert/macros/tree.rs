//! Expressions as trees.

use chordal::syntax::{Expression, ExpressionParser, Function, Op, Operator};

/// Longer expressions are not carried over.
const MOST_STEPS: usize = 200;

/// A variable by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Variable {
    /// `#101`.
    Number(u32),
    /// `V20`, `R3`: by the letters of the language.
    Letter(&'static str, u32),
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Tree {
    /// A number as it is written.
    Number(String),
    Variable(Variable),
    Negate(Box<Tree>),
    Binary(Operator, Box<Tree>, Box<Tree>),
    Call(Function, Box<Tree>),
}

impl Tree {
    pub fn register(index: u8, negative: bool) -> Tree {
        let register = Tree::Variable(Variable::Letter("R", u32::from(index)));
        if negative { Tree::Negate(Box::new(register)) } else { register }
    }

    /// The tree of an expression; nothing where it takes more than numbers, variables of fixed numbers,
    /// operators and functions of one value.
    pub fn of(parser: &ExpressionParser, expression: Expression, text: &[u8]) -> Option<Tree> {
        let steps = parser.steps(expression);
        if steps.len() > MOST_STEPS || !parser.problems.is_empty() {
            return None;
        }
        let mut stack: Vec<Tree> = Vec::new();
        for step in steps {
            let tree = match step.op {
                Op::Number(_) => {
                    let written = String::from_utf8_lossy(step.range.slice(text));
                    Tree::Number(written.chars().filter(|c| !c.is_whitespace()).collect())
                }
                Op::Read => Tree::Variable(Variable::Number(whole(stack.pop()?)?)),
                Op::Letters(place) => {
                    let letters = *parser.grammar().letter_variables.get(usize::from(place))?;
                    Tree::Variable(Variable::Letter(letters, whole(stack.pop()?)?))
                }
                Op::Negate => Tree::Negate(Box::new(stack.pop()?)),
                Op::Binary(operator) => {
                    let right = Box::new(stack.pop()?);
                    Tree::Binary(operator, Box::new(stack.pop()?), right)
                }
                Op::Call { function, two: false } => Tree::Call(function, Box::new(stack.pop()?)),
                Op::Call { two: true, .. } | Op::Unreadable | Op::ReadNamed(_) => return None,
            };
            stack.push(tree);
        }
        let tree = stack.pop()?;
        stack.is_empty().then_some(tree)
    }

    /// All variables in it.
    pub fn variables(&self, see: &mut impl FnMut(Variable)) {
        match self {
            Tree::Number(_) => {}
            Tree::Variable(variable) => see(*variable),
            Tree::Negate(one) | Tree::Call(_, one) => one.variables(see),
            Tree::Binary(_, one, other) => {
                one.variables(see);
                other.variables(see);
            }
        }
    }

    /// The condition that holds where this one does not; nothing where it is no comparison.
    pub fn inverted(&self) -> Option<Tree> {
        let Tree::Binary(operator, one, other) = self else { return None };
        let operator = match operator {
            Operator::Equal => Operator::NotEqual,
            Operator::NotEqual => Operator::Equal,
            Operator::Greater => Operator::LessOrEqual,
            Operator::GreaterOrEqual => Operator::Less,
            Operator::Less => Operator::GreaterOrEqual,
            Operator::LessOrEqual => Operator::Greater,
            _ => return None,
        };
        Some(Tree::Binary(operator, one.clone(), other.clone()))
    }
}

/// A number that is whole and not below zero.
fn whole(tree: Tree) -> Option<u32> {
    match tree {
        Tree::Number(text) => text.trim_end_matches('.').parse().ok(),
        _ => None,
    }
}
