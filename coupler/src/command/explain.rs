//! `coupler explain WORD`: a law, a family, an exit code.

use super::say;
use crate::acceleration::Acceleration;
use crate::error::CouplerError;
use crate::interaction::drag::Drag;
use case_io::exit_code::ExitCode;

pub(super) fn explain(word: Option<&str>) -> Result<ExitCode, CouplerError> {
    match word {
        None => say("words: drag, any drag law, acceleration, exit, any exit code"),
        Some("drag") => Drag::ALL.iter().for_each(|law| say_drag(*law)),
        Some("acceleration") => {
            Acceleration::explanations().iter().for_each(|[name, formula, source]| {
                say(&format!("{name}\n  formula   {formula}\n  source    {source}"));
            });
        }
        Some("exit") => ExitCode::ALL.iter().for_each(|code| say_exit(*code)),
        Some(word) => explain_member(word)?,
    }
    Ok(ExitCode::Done)
}

fn explain_member(word: &str) -> Result<(), CouplerError> {
    if let Some(law) = Drag::by_name(word) {
        say_drag(law);
        return Ok(());
    }
    if let Some(code) = ExitCode::ALL.iter().find(|code| code.code().to_string() == word) {
        say_exit(*code);
        return Ok(());
    }
    let laws: Vec<&str> = Drag::ALL.iter().map(|law| law.name()).collect();
    Err(CouplerError::CommandLine {
        message: format!(
            "explain: unknown word {word:?}; allowed: drag, acceleration, exit, an exit code, or one of {}",
            laws.join(", ")
        ),
    })
}

fn say_drag(law: Drag) {
    let explanation = law.explain();
    say(&format!(
        "{}\n  formula   {}\n  validity  {}\n  source    {}",
        law.name(),
        explanation.formula,
        explanation.validity,
        explanation.source
    ));
}

fn say_exit(code: ExitCode) {
    say(&format!("{:>3}  {}; {}", code.code(), code.meaning(), code.advice()));
}
