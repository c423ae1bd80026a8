//! `grains.rolling-law` and `grains.twisting-law`, and what `[pairs.*]` say of them.

use super::rules::Rules;
use crate::document::{Document, NormalLaw, Pair, RollingLaw};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let Some(grains) = &document.grains else { return Ok(()) };
    let (rolling, twisting) = ("grains.rolling-law", "grains.twisting-law");
    if grains.normal_law == NormalLaw::None {
        rules.no_effect(rolling, "with normal-law = \"none\"")?;
        rules.no_effect(twisting, "with normal-law = \"none\"")?;
    }
    if document.pairs.values().all(|pair| pair.sliding_friction == 0.0) {
        rules.no_effect(rolling, "without sliding friction in any pair, since nothing rolls")?;
        rules.no_effect(twisting, "without sliding friction in any pair, since nothing is held")?;
    }
    if document.case.dimension.count() == 2 {
        rules.no_effect(twisting, "in 2D, where nothing spins about a normal")?;
    }
    for (name, pair) in &document.pairs {
        let table = format!("pairs.{name}");
        of_rolling(&table, pair, grains.rolling_law, rules)?;
    }
    Ok(())
}

fn of_rolling(table: &str, pair: &Pair, law: Option<RollingLaw>, rules: &Rules) -> Result<(), CaseError> {
    let friction = format!("{table}.rolling-friction");
    let damping = format!("{table}.rolling-damping-ratio");
    match law {
        None => {
            rules.no_effect(&friction, "without grains.rolling-law")?;
            rules.no_effect(&damping, "without grains.rolling-law")?;
        }
        Some(law) => {
            rules.required(&friction, "rolling-law needs it, for example rolling-friction = 0.05")?;
            match law {
                RollingLaw::Epsd => {
                    rules.required(&damping, "\"epsd\" needs it, for example rolling-damping-ratio = 0.3")?;
                }
                RollingLaw::Cdt => rules.no_effect(&damping, "with rolling-law = \"cdt\"")?,
                RollingLaw::Epsd2 => rules.no_effect(&damping, "with rolling-law = \"epsd2\"")?,
            }
        }
    }
    for (key, value) in [(friction, pair.rolling_friction), (damping, pair.rolling_damping_ratio)] {
        let value = value.unwrap_or(0.0);
        rules.number(&key, value, value >= 0.0, "0 or more")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{DRY, SETTLING, assert_refusals, document};

    const LAWS: &str = "rolling-law = \"epsd\"\n[[insertion]]\nname = \"bed\"";
    const SAID: &str = "sliding-friction = 0.3\nrolling-friction = 0.05\nrolling-damping-ratio = 0.3";

    fn resisting() -> String {
        SETTLING.replace("[[insertion]]\nname = \"bed\"", LAWS).replace("sliding-friction = 0.3", SAID)
    }

    #[test]
    fn a_pair_says_what_the_laws_need() {
        document(&resisting());
        let missing = |key: &str, law: &str, example: &str| {
            format!(
                "case.toml:12: pairs.glass-glass.{key}: missing; {law} needs it, for example {key} = {example}"
            )
        };
        assert_refusals(
            &resisting(),
            &[
                ("rolling-friction = 0.05\n", "", &missing("rolling-friction", "rolling-law", "0.05")),
                ("rolling-damping-ratio = 0.3\n", "", &missing("rolling-damping-ratio", "\"epsd\"", "0.3")),
                (
                    "rolling-friction = 0.05",
                    "rolling-friction = -0.05",
                    "case.toml:15: pairs.glass-glass.rolling-friction: found -0.05; allowed: 0 or more",
                ),
                (
                    "\"epsd\"",
                    "\"epsd3\"",
                    "case.toml:19: grains.rolling-law: unknown law \"epsd3\"; allowed: cdt, epsd, epsd2; did you mean \"epsd\"?",
                ),
            ],
        );
    }

    #[test]
    fn what_no_law_asks_for_is_refused() {
        assert_refusals(
            &resisting(),
            &[
                (
                    "rolling-law = \"epsd\"\n",
                    "",
                    "case.toml:15: pairs.glass-glass.rolling-friction: has no effect without grains.rolling-law; delete it",
                ),
                (
                    "\"epsd\"",
                    "\"cdt\"",
                    "case.toml:16: pairs.glass-glass.rolling-damping-ratio: has no effect with rolling-law = \"cdt\"; delete it",
                ),
                (
                    "sliding-friction = 0.3",
                    "sliding-friction = 0",
                    "case.toml:19: grains.rolling-law: has no effect without sliding friction in any pair, since nothing rolls; delete it",
                ),
            ],
        );
    }
    #[test]
    fn only_spheres_that_rub_are_twisted() {
        let twisted = "twisting-law = \"marshall\"\n[[insertion]]\nname = \"bed\"";
        let base = SETTLING.replace("[[insertion]]\nname = \"bed\"", twisted);
        document(&base);
        assert_refusals(
            &base,
            &[
                (
                    "sliding-friction = 0.3",
                    "sliding-friction = 0",
                    "case.toml:17: grains.twisting-law: has no effect without sliding friction in any pair, since nothing is held; delete it",
                ),
                (
                    "\"marshall\"",
                    "\"marshal\"",
                    "case.toml:17: grains.twisting-law: unknown law \"marshal\"; allowed: marshall; did you mean \"marshall\"?",
                ),
            ],
        );
        assert_refusals(
            DRY,
            &[(
                "[[insertion]]",
                "twisting-law = \"marshall\"\n[[insertion]]",
                "case.toml:27: grains.twisting-law: has no effect in 2D, where nothing spins about a normal; delete it",
            )],
        );
    }
}
