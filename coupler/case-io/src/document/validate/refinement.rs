//! `[[fluid.pfem.refine]]`.

use super::rules::Rules;
use crate::document::{Pfem, Refinement, Region};
use crate::error::CaseError;

pub(super) fn check(pfem: &Pfem, rules: &Rules) -> Result<(), CaseError> {
    if let Some(growth) = pfem.growth {
        if pfem.refine.is_empty() {
            return rules.no_effect("fluid.pfem.growth", "without [[fluid.pfem.refine]] all cells are alike");
        }
        rules.number("fluid.pfem.growth", growth, growth > 0.0 && growth <= 1.0, "more than 0, at most 1")?;
    }
    pfem.refine.iter().enumerate().try_for_each(|(index, stated)| refinement(pfem, stated, index, rules))
}

fn refinement(pfem: &Pfem, stated: &Refinement, index: usize, rules: &Rules) -> Result<(), CaseError> {
    let table = format!("fluid.pfem.refine[{index}]");
    rules.exactly_one(&table, &["near", "box", "sphere"])?;
    rules.positive(&format!("{table}.size"), stated.size)?;
    match stated.region() {
        Some(Region::Box(lower, upper)) => rules.corners(&format!("{table}.box"), lower, upper)?,
        Some(Region::Sphere(centre, radius)) => {
            rules.vector(&format!("{table}.sphere.centre"), centre)?;
            rules.positive(&format!("{table}.sphere.radius"), radius)?;
        }
        _ => {}
    }
    match pfem.size {
        Some(coarse) if stated.size.si() > coarse.si() => {
            let found = format_args!("found {}", stated.size);
            let allowed = format!("at most fluid.pfem.size, {coarse}");
            rules.refuse(&format!("{table}.size"), found, allowed, "cells are only ever made finer")
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{TANK, assert_refusals, document};

    const FINE: &str = "[fluid.pfem]\nsize = \"0.1 m\"\ngrowth = 0.5\n[[fluid.pfem.refine]]\nnear = \"surface\"\nsize = \"5 cm\"\n[[wall]]";

    #[test]
    fn a_tank_may_be_fine_at_its_surface() {
        let refined = TANK.replacen("[[wall]]", FINE, 1);
        document(&refined);
        let line = refined.lines().position(|line| line.starts_with("near")).unwrap() + 1;
        assert_refusals(
            &refined,
            &[
                (
                    "growth = 0.5",
                    "growth = 2",
                    &format!(
                        "case.toml:{}: fluid.pfem.growth: found 2; allowed: more than 0, at most 1",
                        line - 2
                    ),
                ),
                (
                    "size = \"5 cm\"",
                    "size = \"20 cm\"",
                    &format!(
                        "case.toml:{}: fluid.pfem.refine[0].size: found 0.2 m; allowed: at most fluid.pfem.size, 0.1 m; cells are only ever made finer",
                        line + 1
                    ),
                ),
                (
                    "near = \"surface\"\n",
                    "",
                    &format!(
                        "case.toml:{}: fluid.pfem.refine[0]: none of these keys is given; allowed: exactly one of near, box, sphere",
                        line - 1
                    ),
                ),
            ],
        );
    }
}
