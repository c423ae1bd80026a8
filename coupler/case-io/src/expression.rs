//! Expressions of x, y, z and t: parsed once into a flat postfix program, evaluated without allocation.

mod parse;

use std::borrow::Cow;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// Values that may wait on the stack of one evaluation.
const STACK: usize = 32;

/// One step of the postfix program.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Operation {
    Constant(f64),
    X,
    Y,
    Z,
    T,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Negate,
    Sin,
    Cos,
    Tan,
    Tanh,
    Exp,
    Log,
    Sqrt,
    Abs,
    Step,
    Min,
    Max,
    If,
}

impl Operation {
    /// Number of values it takes from the stack; it leaves one.
    fn arguments(self) -> usize {
        match self {
            Self::Constant(_) | Self::X | Self::Y | Self::Z | Self::T => 0,
            Self::Negate
            | Self::Sin
            | Self::Cos
            | Self::Tan
            | Self::Tanh
            | Self::Exp
            | Self::Log
            | Self::Sqrt
            | Self::Abs
            | Self::Step => 1,
            Self::Add
            | Self::Subtract
            | Self::Multiply
            | Self::Divide
            | Self::Power
            | Self::Min
            | Self::Max => 2,
            Self::If => 3,
        }
    }
}

/// An expression of x, y, z (m) and t (s).
///
/// Operators `+ - * / ^` and parentheses (`-x^2` is −(x²), `2^3^2` is 2⁹); `sin cos tan tanh exp log sqrt abs`,
/// `min(a, b)`, `max(a, b)`, `pow(a, b)`, `step(a)` (0 below 0, else 1), `if(c, a, b)` (a where c > 0, else b); `pi`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Expression {
    text: String,
    program: Vec<Operation>,
}

/// Why a text is no expression.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expression \"{text}\", column {column}: {problem}")]
pub struct ExpressionError {
    /// The text as given.
    pub text: String,
    /// Where, in characters from 1.
    pub column: usize,
    /// What is wrong, what is allowed.
    pub problem: String,
}

impl Expression {
    /// The value at `position` (m; z = 0 in 2D) and time `t` (s), in SI. It is not finite where the mathematics
    /// is not.
    pub fn evaluate(&self, [x, y, z]: [f64; 3], t: f64) -> f64 {
        let mut stack = [0.0; STACK];
        let mut top = 0;
        for &operation in &self.program {
            // The arguments lie at stack[base..]; the parser has checked that they exist and that they fit.
            let base = top - operation.arguments();
            let argument = |k: usize| stack[base + k];
            stack[base] = match operation {
                Operation::Constant(value) => value,
                Operation::X => x,
                Operation::Y => y,
                Operation::Z => z,
                Operation::T => t,
                Operation::Add => argument(0) + argument(1),
                Operation::Subtract => argument(0) - argument(1),
                Operation::Multiply => argument(0) * argument(1),
                Operation::Divide => argument(0) / argument(1),
                Operation::Power => power(argument(0), argument(1)),
                Operation::Negate => -argument(0),
                Operation::Sin => argument(0).sin(),
                Operation::Cos => argument(0).cos(),
                Operation::Tan => argument(0).tan(),
                Operation::Tanh => argument(0).tanh(),
                Operation::Exp => argument(0).exp(),
                Operation::Log => argument(0).ln(),
                Operation::Sqrt => argument(0).sqrt(),
                Operation::Abs => argument(0).abs(),
                Operation::Step => f64::from(argument(0) >= 0.0),
                Operation::Min => argument(0).min(argument(1)),
                Operation::Max => argument(0).max(argument(1)),
                Operation::If => {
                    if argument(0) > 0.0 {
                        argument(1)
                    } else {
                        argument(2)
                    }
                }
            };
            top = base + 1;
        }
        stack[0]
    }

    /// The expression as written.
    pub fn text(&self) -> &str {
        &self.text
    }
}

/// Small whole powers by multiplication: exact for squares, and quick.
fn power(base: f64, exponent: f64) -> f64 {
    if exponent.abs() <= 16.0 && exponent.fract() == 0.0 {
        base.powi(exponent as i32)
    } else {
        base.powf(exponent)
    }
}

impl FromStr for Expression {
    type Err = ExpressionError;

    fn from_str(text: &str) -> Result<Self, ExpressionError> {
        Ok(Self { text: text.into(), program: parse::program(text)? })
    }
}

impl TryFrom<String> for Expression {
    type Error = ExpressionError;

    fn try_from(text: String) -> Result<Self, ExpressionError> {
        text.parse()
    }
}

impl From<Expression> for String {
    fn from(expression: Expression) -> Self {
        expression.text
    }
}

impl JsonSchema for Expression {
    fn schema_name() -> Cow<'static, str> {
        "Expression".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "string",
            "description": "an expression of x, y, z, t in SI",
            "examples": ["0.1*sin(2*pi*t)", "if(z-0.1, 0, 1-z^2)"],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> f64 {
        text.parse::<Expression>().unwrap().evaluate([2.0, 3.0, 5.0], 7.0)
    }

    fn refusal(text: &str) -> String {
        text.parse::<Expression>().unwrap_err().to_string()
    }

    #[test]
    fn operators_bind_as_in_mathematics() {
        assert_eq!(value("x + y*z - t/2"), 2.0 + 15.0 - 3.5);
        assert_eq!(value("2 - 3 - 4"), -5.0);
        assert_eq!(value("24/4/3"), 2.0);
        assert_eq!(value("-x^2"), -4.0);
        assert_eq!(value("2^-1"), 0.5);
        assert_eq!(value("2^3^2"), 512.0);
        assert_eq!(value("(x + y) * -z"), -25.0);
        assert_eq!(value("--x"), 2.0);
        assert_eq!(value("+1.5e-1*10"), 1.5);
        assert_eq!(value(".5"), 0.5);
    }

    #[test]
    fn functions_are_those_of_mathematics() {
        assert_eq!(value("sin(pi/2) + cos(0) + tan(0)"), 2.0);
        assert_eq!(value("exp(log(x))"), 2.0_f64.ln().exp());
        assert_eq!(value("sqrt(abs(-9))"), 3.0);
        assert_eq!(value("min(x, y) + max(z, t)"), 9.0);
        assert_eq!(value("pow(y, 3)"), 27.0);
        assert_eq!(value("tanh(1)"), 1.0_f64.tanh());
        assert_eq!((value("step(-1e-300)"), value("step(0)"), value("step(1)")), (0.0, 1.0, 1.0));
        assert_eq!((value("if(1, x, y)"), value("if(0, x, y)"), value("if(-1, x, y)")), (2.0, 3.0, 3.0));
    }

    #[test]
    fn a_branch_not_taken_does_no_harm() {
        assert_eq!(value("if(x, 1, log(-1))"), 1.0);
        assert!(value("log(-1)").is_nan());
    }

    #[test]
    fn a_refusal_says_where_and_what_is_allowed() {
        assert_eq!(
            refusal("0.1*sine(t)"),
            "expression \"0.1*sine(t)\", column 5: unknown name \"sine\"; allowed: x, y, z, t, pi, sin, cos, tan, \
             tanh, exp, log, sqrt, abs, step, min, max, pow, if; did you mean \"sin\"?"
        );
        assert_eq!(
            refusal(""),
            "expression \"\", column 1: ends where a value is due; write a number, x, y, z, t or a function"
        );
        assert_eq!(
            refusal("1 +"),
            "expression \"1 +\", column 4: ends where a value is due; write a number, x, y, z, t or a function"
        );
        assert_eq!(
            refusal("2 x"),
            "expression \"2 x\", column 3: found \"x\" after a complete value; write an operator + - * / ^ before it"
        );
        assert_eq!(refusal("(x"), "expression \"(x\", column 3: the parenthesis is not closed; write \")\"");
        assert_eq!(
            refusal("1 , 2"),
            "expression \"1 , 2\", column 3: found \",\" after a complete value; write an operator + - * / ^ before it"
        );
        assert_eq!(
            refusal("sin"),
            "expression \"sin\", column 4: sin takes 1 argument; write \"(\" after its name"
        );
        assert_eq!(
            refusal("min(x)"),
            "expression \"min(x)\", column 6: min takes 2 arguments, and 1 is given"
        );
        assert_eq!(
            refusal("sin(x, y)"),
            "expression \"sin(x, y)\", column 6: sin takes 1 argument, and more are given"
        );
        assert_eq!(
            refusal("x > 1"),
            "expression \"x > 1\", column 3: found \">\" after a complete value; write an operator + - * / ^ before it"
        );
        assert_eq!(refusal("1e999"), "expression \"1e999\", column 1: number 1e999 is too large");
        assert_eq!(
            refusal("1 ° 2"),
            "expression \"1 ° 2\", column 3: found \"°\" after a complete value; write an operator + - * / ^ before it"
        );
    }

    #[test]
    fn hostile_depth_is_refused_and_does_not_overflow_the_stack() {
        for text in ["(".repeat(100_000), "-".repeat(100_000), "2^".repeat(100_000), "sin(".repeat(100_000)] {
            assert!(text.parse::<Expression>().unwrap_err().problem.contains("nested"));
        }
        // Right-leaning sums need stack, not depth of the text.
        let leaning = (0..40).fold("x".to_string(), |inner, _| format!("x+({inner})"));
        assert!(leaning.parse::<Expression>().unwrap_err().problem.contains("nested"));
        let long = vec!["x"; 10_000].join("+");
        assert_eq!(long.parse::<Expression>().unwrap().evaluate([1.0, 0.0, 0.0], 0.0), 10_000.0);
    }
}
