//! Recursive descent from text to the postfix program.

use super::{ExpressionError, Operation, STACK};
use crate::nearest::did_you_mean;

/// Parentheses, signs and powers within each other.
const DEPTH: usize = 64;

const NAMES: &[(&str, Operation)] = &[
    ("x", Operation::X),
    ("y", Operation::Y),
    ("z", Operation::Z),
    ("t", Operation::T),
    ("pi", Operation::Constant(std::f64::consts::PI)),
    ("sin", Operation::Sin),
    ("cos", Operation::Cos),
    ("tan", Operation::Tan),
    ("tanh", Operation::Tanh),
    ("exp", Operation::Exp),
    ("log", Operation::Log),
    ("sqrt", Operation::Sqrt),
    ("abs", Operation::Abs),
    ("step", Operation::Step),
    ("min", Operation::Min),
    ("max", Operation::Max),
    ("pow", Operation::Power),
    ("if", Operation::If),
];

pub(super) fn program(text: &str) -> Result<Vec<Operation>, ExpressionError> {
    let mut parser = Parser { text, at: 0, depth: 0, waiting: 0, program: Vec::new() };
    parser.sum()?;
    match parser.peek() {
        None => Ok(parser.program),
        Some(found) => Err(parser.error(format!(
            "found \"{found}\" after a complete value; write an operator + - * / ^ before it"
        ))),
    }
}

struct Parser<'a> {
    text: &'a str,
    /// Byte offset of what comes next.
    at: usize,
    depth: usize,
    /// Values on the stack at this point of the program.
    waiting: usize,
    program: Vec<Operation>,
}

impl Parser<'_> {
    fn error_at(&self, at: usize, problem: String) -> ExpressionError {
        ExpressionError { text: self.text.into(), column: self.text[..at].chars().count() + 1, problem }
    }

    fn error(&self, problem: String) -> ExpressionError {
        self.error_at(self.at, problem)
    }

    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    /// The next character that is not blank.
    fn peek(&mut self) -> Option<char> {
        self.at += self.rest().len() - self.rest().trim_start().len();
        self.rest().chars().next()
    }

    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    fn push(&mut self, operation: Operation) -> Result<(), ExpressionError> {
        self.waiting = self.waiting + 1 - operation.arguments();
        if self.waiting > STACK {
            return Err(self.error("is too deeply nested; write it with fewer parentheses".into()));
        }
        self.program.push(operation);
        Ok(())
    }

    /// Runs `parse` one level deeper.
    fn deeper(
        &mut self,
        parse: impl Fn(&mut Self) -> Result<(), ExpressionError>,
    ) -> Result<(), ExpressionError> {
        if self.depth == DEPTH {
            return Err(self.error("is too deeply nested; write it with fewer parentheses".into()));
        }
        self.depth += 1;
        parse(self)?;
        self.depth -= 1;
        Ok(())
    }

    /// sum := product { ("+" | "-") product }
    fn sum(&mut self) -> Result<(), ExpressionError> {
        self.product()?;
        loop {
            let operation = match self.peek() {
                Some('+') => Operation::Add,
                Some('-') => Operation::Subtract,
                _ => return Ok(()),
            };
            self.at += 1;
            self.product()?;
            self.push(operation)?;
        }
    }

    /// product := signed { ("*" | "/") signed }
    fn product(&mut self) -> Result<(), ExpressionError> {
        self.signed()?;
        loop {
            let operation = match self.peek() {
                Some('*') => Operation::Multiply,
                Some('/') => Operation::Divide,
                _ => return Ok(()),
            };
            self.at += 1;
            self.signed()?;
            self.push(operation)?;
        }
    }

    /// signed := { "+" | "-" } value [ "^" signed ]
    fn signed(&mut self) -> Result<(), ExpressionError> {
        if self.take('-') {
            self.deeper(Self::signed)?;
            return self.push(Operation::Negate);
        }
        if self.take('+') {
            return self.deeper(Self::signed);
        }
        self.value()?;
        if self.take('^') {
            self.deeper(Self::signed)?;
            self.push(Operation::Power)?;
        }
        Ok(())
    }

    /// value := number | name | name "(" sum { "," sum } ")" | "(" sum ")"
    fn value(&mut self) -> Result<(), ExpressionError> {
        match self.peek() {
            Some('(') => {
                self.at += 1;
                self.deeper(Self::sum)?;
                self.close()
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() => self.name(),
            Some(found) => Err(self.error(format!(
                "found \"{found}\" where a value is due; write a number, x, y, z, t or a function"
            ))),
            None => {
                Err(self.error("ends where a value is due; write a number, x, y, z, t or a function".into()))
            }
        }
    }

    fn close(&mut self) -> Result<(), ExpressionError> {
        if self.take(')') {
            Ok(())
        } else {
            Err(self.error("the parenthesis is not closed; write \")\"".into()))
        }
    }

    fn number(&mut self) -> Result<(), ExpressionError> {
        let rest = self.rest();
        let digits = |from: usize| rest[from..].bytes().take_while(u8::is_ascii_digit).count();
        let mut end = digits(0);
        if rest[end..].starts_with('.') {
            end += 1 + digits(end + 1);
        }
        if rest[end..].starts_with(['e', 'E']) {
            let signed = end + 1 + usize::from(rest[end + 1..].starts_with(['+', '-']));
            if digits(signed) > 0 {
                end = signed + digits(signed);
            }
        }
        let number = &rest[..end];
        let value: f64 = number.parse().map_err(|_| self.error(format!("\"{number}\" is not a number")))?;
        if !value.is_finite() {
            return Err(self.error(format!("number {number} is too large")));
        }
        self.at += end;
        self.push(Operation::Constant(value))
    }

    fn name(&mut self) -> Result<(), ExpressionError> {
        let start = self.at;
        let length =
            self.rest().find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(self.rest().len());
        let name = self.text[start..start + length].to_string();
        let Some(&(_, operation)) = NAMES.iter().find(|(known, _)| *known == name) else {
            let allowed: Vec<&str> = NAMES.iter().map(|(known, _)| *known).collect();
            let problem = format!(
                "unknown name \"{name}\"; allowed: {}; {}",
                allowed.join(", "),
                did_you_mean(&name, &allowed)
            );
            return Err(self.error_at(start, problem.trim_end_matches("; ").into()));
        };
        self.at += length;
        let count = operation.arguments();
        if count == 0 {
            return self.push(operation);
        }
        let takes = format!("{name} takes {count} argument{}", if count == 1 { "" } else { "s" });
        if !self.take('(') {
            return Err(self.error(format!("{takes}; write \"(\" after its name")));
        }
        for given in 0..count {
            if given > 0 && !self.take(',') {
                return Err(self
                    .error(format!("{takes}, and {given} {} given", if given == 1 { "is" } else { "are" })));
            }
            self.deeper(Self::sum)?;
        }
        if self.peek() == Some(',') {
            return Err(self.error(format!("{takes}, and more are given")));
        }
        self.close()?;
        self.push(operation)
    }
}
