//! `[[wall]]`: `motion.table`

use super::rules::Rules;
use super::wall::direction;
use crate::document::{Dimension, MotionTable};
use crate::error::CaseError;

pub(super) fn check(
    rules: &Rules,
    table: &str,
    stated: &MotionTable,
    rotates: bool,
) -> Result<(), CaseError> {
    let key = |key: &str| format!("{table}.{key}");
    rules.exactly_one(table, &["path", "time"])?;
    if stated.path.is_some() {
        rules.no_effect(&key("place"), "with path")?;
        rules.no_effect(&key("angle"), "with path")?;
    } else {
        lists(rules, table, stated)?;
    }
    if rotates {
        return ["angle", "axis", "point"].iter().try_for_each(|name| {
            rules.no_effect(&key(name), "beside rotation: a wall turns about one axis")
        });
    }
    // A file says only when it is read whether there is an angle.
    let turns = stated.angle.is_some() || (stated.path.is_some() && stated.point.is_some());
    if !turns {
        rules.no_effect(&key("axis"), "without angle, or point")?;
        return rules.no_effect(&key("point"), "without angle");
    }
    rules.required(&key("point"), "state a point of the axis of the angle")?;
    rules.optional_vector(&key("point"), stated.point.as_ref())?;
    match (&stated.axis, rules.dimension) {
        (None, Dimension::Three) => rules.required(&key("axis"), "state its direction"),
        (Some(axis), Dimension::Three) => direction(rules, &key("axis"), axis, "any direction"),
        (_, Dimension::Two) => rules.no_effect(&key("axis"), "in 2D, where the axis is z"),
    }
}

fn lists(rules: &Rules, table: &str, stated: &MotionTable) -> Result<(), CaseError> {
    let key = |key: &str| format!("{table}.{key}");
    let times = stated.time.as_deref().unwrap_or_default();
    if times.len() < 2 {
        let found = format!("found {} times", times.len());
        return rules.refuse(&key("time"), found, "2 or more", "");
    }
    if let Some(late) = (1..times.len()).find(|&row| times[row].si() <= times[row - 1].si()) {
        let allowed = format!("more than the time before, {}", times[late - 1]);
        return rules.refuse(
            &key(&format!("time[{late}]")),
            format_args!("found {}", times[late]),
            allowed,
            "",
        );
    }
    if stated.place.is_none() && stated.angle.is_none() {
        return rules.refuse(table, "nothing moves", "place, angle or both", "");
    }
    let places = stated.place.as_ref().map(Vec::len);
    let angles = stated.angle.as_ref().map(Vec::len);
    for (name, found) in [("place", places), ("angle", angles)] {
        if let Some(found) = found.filter(|found| *found != times.len()) {
            let allowed = format!("{}, one for each time", times.len());
            return rules.refuse(&key(name), format_args!("found {found} entries"), allowed, "");
        }
    }
    let places = stated.place.iter().flatten().enumerate();
    places.into_iter().try_for_each(|(row, place)| rules.vector(&key(&format!("place[{row}]")), place))
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{SETTLING, assert_refusals, document};

    const NORMAL: &str = "normal = [0, 0, 1] }";

    fn moving(table: &str) -> String {
        format!("{NORMAL}\nmotion = {{ table = {{ {table} }} }}")
    }

    #[test]
    fn a_wall_turns_about_one_axis() {
        let origin = "point = [\"0 m\", \"0 m\", \"0 m\"]";
        let rotation = format!("rotation = {{ axis = [0, 0, 1], {origin}, rate = \"1 rad/s\" }}");
        assert_refusals(
            SETTLING,
            &[(
                NORMAL,
                &format!("{NORMAL}\nmotion = {{ {rotation}, table = {{ path = \"a.csv\", {origin} }} }}"),
                "case.toml:26: wall[0].motion.table.point: has no effect beside rotation: a wall turns about one axis; delete it",
            )],
        );
    }

    #[test]
    fn a_table_is_stated_whole() {
        let rows = [
            (
                "",
                "case.toml:26: wall[0].motion.table: none of these keys is given; allowed: exactly one of path, time",
            ),
            (
                "time = [\"0 s\"], angle = [\"1 rad\"]",
                "case.toml:26: wall[0].motion.table.time: found 1 times; allowed: 2 or more",
            ),
            (
                "time = [\"0 s\", \"1 s\", \"1 s\"]",
                "case.toml:26: wall[0].motion.table.time[2]: found 1 s; allowed: more than the time before, 1 s",
            ),
            (
                "time = [\"0 s\", \"1 s\"]",
                "case.toml:26: wall[0].motion.table: nothing moves; allowed: place, angle or both",
            ),
            (
                "time = [\"0 s\", \"1 s\"], angle = [\"1 rad\"]",
                "case.toml:26: wall[0].motion.table.angle: found 1 entries; allowed: 2, one for each time",
            ),
            (
                "time = [\"0 s\", \"1 s\"], place = [[\"0 m\", \"0 m\", \"0 m\"], [\"0 m\"]]",
                "case.toml:26: wall[0].motion.table.place[1]: found 1 components; allowed: 3; case.dimension is 3",
            ),
            (
                "time = [\"0 s\", \"1 s\"], angle = [\"0 rad\", \"1 rad\"]",
                "case.toml:26: wall[0].motion.table.point: missing; state a point of the axis of the angle",
            ),
            (
                "time = [\"0 s\", \"1 s\"], angle = [\"0 rad\", \"1 rad\"], point = [\"0 m\", \"0 m\", \"0 m\"]",
                "case.toml:26: wall[0].motion.table.axis: missing; state its direction",
            ),
            (
                "path = \"a.csv\", axis = [0, 0, 1]",
                "case.toml:26: wall[0].motion.table.axis: has no effect without angle, or point; delete it",
            ),
            (
                "path = \"a.csv\", angle = [\"0 rad\", \"1 rad\"]",
                "case.toml:26: wall[0].motion.table.angle: has no effect with path; delete it",
            ),
        ];
        for (table, message) in rows {
            assert_refusals(SETTLING, &[(NORMAL, &moving(table), message)]);
        }
        for sound in [
            "path = \"a.csv\"",
            "path = \"a.csv\", axis = [0, 0, 1], point = [\"0 m\", \"0 m\", \"0 m\"]",
            "time = [\"0 s\", \"1 s\"], angle = [\"0 deg\", \"90 deg\"], axis = [1, 0, 0], point = [\"0 m\", \"0 m\", \"0 m\"]",
        ] {
            document(&SETTLING.replace(NORMAL, &moving(sound)));
        }
    }
}
