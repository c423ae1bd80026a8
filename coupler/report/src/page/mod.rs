//! Reports as one HTML page without script and without anything external.

mod audits;
mod bench;
mod checks;
mod head;
mod ledger;
mod pictures;
mod seconds;
mod series;
mod sweep;
mod text;

use crate::ReportError;
use crate::run::Run;
pub(crate) use bench::html as bench_html;
pub(crate) use pictures::Figure;
pub(crate) use sweep::html as sweep_html;
use text::escape;
pub(crate) use text::number;

/// The whole page.
///
/// # Errors
/// A plot that cannot be drawn.
pub(crate) fn html(run: &Run, figures: &[Figure]) -> Result<String, ReportError> {
    let summary = run.summary.as_ref();
    let title = summary.map_or("Unfinished run", |summary| &summary.case);
    let body = [
        head::html(run),
        section("Checks", &checks::html(summary)),
        section("Pictures", &pictures::html(figures)),
        section("Time series", &series::time_series(run)?),
        section("Convergence", &series::convergence(run)?),
        section("Time spent", &seconds::html(summary)),
        section("Ledger", &ledger::html(run)?),
        audits::html(summary),
        section("Work saved", &seconds::thrift(summary)),
        notes(&run.notes),
    ]
    .concat();
    Ok(document(title, &body))
}

/// The document around a body.
fn document(title: &str, body: &str) -> String {
    let title = escape(title);
    let style = include_str!("style.css");
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n{body}</main>\n</body>\n</html>\n"
    )
}

fn section(title: &str, content: &str) -> String {
    format!("<section>\n<h2>{title}</h2>\n{content}\n</section>\n")
}

/// A sentence where there is nothing to show.
fn nothing(sentence: &str) -> String {
    format!("<p class=\"nothing\">{sentence}</p>")
}

/// A table whose cells are HTML already.
fn table(heads: &[&str], rows: &[Vec<String>]) -> String {
    let cells = |tag: &str, cells: &[String]| -> String {
        cells.iter().map(|cell| format!("<{tag}>{cell}</{tag}>")).collect()
    };
    let heads: Vec<String> = heads.iter().map(|&head| head.to_owned()).collect();
    let rows: String = rows.iter().map(|row| format!("<tr>{}</tr>\n", cells("td", row))).collect();
    format!(
        "<div class=\"wide\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>",
        cells("th", &heads)
    )
}

fn notes(notes: &[String]) -> String {
    if notes.is_empty() {
        return String::new();
    }
    let items: String = notes.iter().map(|note| format!("<li>{}</li>\n", escape(note))).collect();
    section("Could not be read", &format!("<ul class=\"notes\">\n{items}</ul>"))
}
