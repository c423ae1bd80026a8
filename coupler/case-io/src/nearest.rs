//! The nearest of some known words, for messages about unknown ones.

/// `did you mean "…"?` for the nearest of `known`, or nothing when none is near.
pub(crate) fn did_you_mean(word: &str, known: &[impl AsRef<str>]) -> String {
    nearest(word, known).map_or_else(String::new, |near| format!("did you mean \"{near}\"?"))
}

/// The known word with the fewest edits from `word`, the first of equals; at most half of its letters.
pub(crate) fn nearest<'a>(word: &str, known: &'a [impl AsRef<str>]) -> Option<&'a str> {
    known
        .iter()
        .map(|candidate| (edits(word, candidate.as_ref()), candidate.as_ref()))
        .filter(|(distance, candidate)| 2 * *distance <= candidate.chars().count())
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Levenshtein distance, a swap of neighbours counted once.
fn edits(one: &str, other: &str) -> usize {
    let (one, other): (Vec<char>, Vec<char>) = (one.chars().collect(), other.chars().collect());
    let mut rows: Vec<Vec<usize>> = vec![(0..=other.len()).collect()];
    for i in 1..=one.len() {
        let mut row = vec![i];
        for j in 1..=other.len() {
            let substitute = rows[i - 1][j - 1] + usize::from(one[i - 1] != other[j - 1]);
            let mut least = substitute.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[one.len()][other.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_finger_is_one_edit() {
        assert_eq!(edits("herz", "hertz"), 1);
        assert_eq!(edits("hetrz", "hertz"), 1);
        assert_eq!(edits("", "abc"), 3);
        assert_eq!(edits("kitten", "sitting"), 3);
    }

    #[test]
    fn a_word_far_from_all_has_no_nearest() {
        assert_eq!(nearest("herz", &["hooke", "hertz", "none"]), Some("hertz"));
        assert_eq!(nearest("banana", &["hooke", "hertz", "none"]), None);
        assert_eq!(nearest("q", &["x", "y"]), None);
        assert_eq!(nearest("max-iter", &["tolerance", "max-iterations"]), Some("max-iterations"));
        assert_eq!(nearest("x", &[] as &[&str]), None);
    }
}
