//! The report end to end, from run directories as a run leaves them.

mod synthetic;

use std::fs;
use std::path::Path;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use case_io::exit_code::ExitCode;
use report::{ReportError, report, report_of_sweep};
use tiny_skia::Pixmap;

use synthetic::{empty_directory, summary, write_frames_in_space, write_frames_in_the_plane, write_series};

const SECTIONS: [&str; 7] =
    ["Checks", "Pictures", "Time series", "Convergence", "Time spent", "Ledger", "Work saved"];

fn html(directory: &Path) -> String {
    report(directory).unwrap();
    let html = fs::read_to_string(directory.join("report.html")).unwrap();
    for title in SECTIONS {
        assert!(html.contains(&format!("<h2>{title}</h2>")), "section {title}");
    }
    assert_self_contained(&html);
    html
}

/// No script, and whatever is referred to is inside the page.
fn assert_self_contained(html: &str) {
    for foreign in
        ["<script", "<link", "<iframe", "<object", "http://", "https://", "url(", "@import", "href="]
    {
        assert!(!html.contains(foreign), "{foreign}");
    }
    assert!(html.split("src=\"").skip(1).all(|rest| rest.starts_with("data:image/png;base64,")));
}

fn pictures(html: &str) -> Vec<Pixmap> {
    html.split("data:image/png;base64,")
        .skip(1)
        .map(|rest| {
            let data = &rest[..rest.find('"').unwrap()];
            Pixmap::decode_png(&BASE64_STANDARD.decode(data).unwrap()).unwrap()
        })
        .collect()
}

fn colours(picture: &Pixmap) -> usize {
    let mut colours: Vec<_> = picture.pixels().iter().map(|p| (p.red(), p.green(), p.blue())).collect();
    colours.sort_unstable();
    colours.dedup();
    colours.len()
}

#[test]
fn a_run_in_space_is_reported_with_everything_it_left() {
    let directory = empty_directory("space");
    summary().write(&directory.join("summary.json")).unwrap();
    write_series(&directory, 500);
    write_frames_in_space(&directory);
    let html = html(&directory);
    for expected in
        ["Failed", "1 of 2 checks failed", "bed height", "Di Felice 1994", "kinetic-energy", "[Pa]"]
    {
        assert!(html.contains(expected), "{expected}");
    }
    assert!(!html.contains("class=\"nothing\"") && !html.contains("Could not be read"));
    let pictures = pictures(&html);
    assert_eq!(pictures.len(), 3);
    for picture in &pictures {
        assert!(picture.width() <= 900 && picture.height() <= 640 && colours(picture) > 500);
        assert!(picture.pixels().iter().all(|pixel| pixel.alpha() == 255));
    }
    assert_ne!(pictures[0].data(), pictures[2].data());
    let last = Pixmap::decode_png(&fs::read(directory.join("picture.png")).unwrap()).unwrap();
    assert_eq!(last.data(), pictures[2].data());
}

#[test]
fn a_run_in_the_plane_is_reported() {
    let directory = empty_directory("plane");
    summary().write(&directory.join("summary.json")).unwrap();
    write_series(&directory, 100);
    write_frames_in_the_plane(&directory);
    let pictures = pictures(&html(&directory));
    assert_eq!(pictures.len(), 3);
    assert!(pictures.iter().all(|picture| colours(picture) > 100));
}

#[test]
fn the_same_run_makes_the_same_report() {
    let directory = empty_directory("same");
    write_series(&directory, 20);
    write_frames_in_the_plane(&directory);
    assert_eq!(html(&directory), html(&directory));
}

#[test]
fn a_run_aborted_after_one_row_still_reports() {
    let directory = empty_directory("aborted");
    write_series(&directory, 1);
    let html = html(&directory);
    assert!(html.contains("Unfinished run") && html.contains("<circle"));
}

#[test]
fn a_series_without_rows_says_so() {
    let directory = empty_directory("empty-series");
    summary().write(&directory.join("summary.json")).unwrap();
    write_series(&directory, 0);
    assert_eq!(html(&directory).matches("No row was written.").count(), 4);
}

#[test]
fn parts_of_a_sum_share_a_plot_and_audits_a_table() {
    let directory = empty_directory("audits");
    summary().write(&directory.join("summary.json")).unwrap();
    let columns = "t[s],volume[m^3],volume-by-flow[m^3],volume-by-overlap[m^3],lost[m^3]";
    let rows = "0.0,1.0,1e-12,1e-3,1e-3\n0.1,1.0,2e-12,2e-3,1e-3\n";
    fs::write(directory.join("series/fluid.csv"), format!("{columns}\n{rows}")).unwrap();
    let html = html(&directory);
    assert_eq!(html.matches("<figure").count(), 3, "the volume, its parts, what was lost");
    assert!(html.contains("Audits of the fluid") && html.contains("volume-by-overlap[m^3]"));
}

#[test]
fn values_that_are_not_numbers_do_not_break_it() {
    let directory = empty_directory("nan");
    let mut summary = summary();
    summary.checks[0].value = f64::NAN;
    summary.checks[0].pass = false;
    summary.time = f64::INFINITY;
    summary.ledger.get_mut("mass").unwrap().residual = f64::NAN;
    summary.write(&directory.join("summary.json")).unwrap();
    fs::write(directory.join("series/grains.csv"), "t[s],v[m/s],w[m/s]\n0.0,NaN,1.0\n0.1,inf,NaN\n").unwrap();
    let html = html(&directory);
    assert!(html.contains("NaN") && html.contains("beyond"));
}

#[test]
fn text_from_outside_cannot_become_markup() {
    let directory = empty_directory("markup");
    let mut summary = summary();
    summary.case = "<script>alert(1)</script>".to_owned();
    summary.checks[0].why = "<img src=\"x\">".to_owned();
    summary.write(&directory.join("summary.json")).unwrap();
    fs::write(directory.join("series/a<b>.csv"), "t[s],<i>[m]\n0.0,1.0\n").unwrap();
    assert!(html(&directory).contains("&lt;script&gt;"));
}

#[test]
fn what_cannot_be_read_is_named_and_the_rest_is_shown() {
    let directory = empty_directory("damaged");
    fs::write(directory.join("summary.json"), "{\"schema_version\": 99}").unwrap();
    write_series(&directory, 10);
    fs::write(directory.join("series/odd.csv"), "no titles\n1,2\n").unwrap();
    write_frames_in_the_plane(&directory);
    fs::write(directory.join("frames/fluid-1.vtu"), "cut").unwrap();
    let html = html(&directory);
    for named in ["summary.json", "odd.csv", "fluid-1.vtu"] {
        assert!(html.split("Could not be read").nth(1).unwrap().contains(named), "{named}");
    }
    assert_eq!(pictures(&html).len(), 3);
}

#[test]
fn a_sweep_is_listed_with_the_verdict_the_checks_and_the_report_of_each_run() {
    let directory = empty_directory("sweep");
    let mut passed = summary();
    passed.exit.code = ExitCode::Done;
    passed.checks.truncate(1);
    let runs = [("h1.5".to_owned(), passed), ("h<3".to_owned(), summary())];
    report_of_sweep(&directory, "settling", &runs).unwrap();
    let html = fs::read_to_string(directory.join("report.html")).unwrap();
    for expected in [
        "<h1>settling</h1>",
        "1 of 2 runs pass.",
        "<span class=\"mark good\">Passed</span> <a href=\"h1.5/report.html\">h1.5</a>",
        "<span class=\"mark bad\">Failed</span> <a href=\"h&lt;3/report.html\">",
        "1 of 2 checks failed",
        "bed height",
        "Di Felice 1994",
    ] {
        assert!(html.contains(expected), "{expected}");
    }
    assert_self_contained(&html.replace("href=\"h1.5/", "").replace("href=\"h&lt;3/", ""));
    assert!(html.len() < 10_000, "{}", html.len());
}

#[test]
fn a_directory_without_a_run_is_refused() {
    let error = report(Path::new("/nowhere")).unwrap_err();
    assert!(matches!(error, ReportError::NoRun { .. }) && error.to_string().contains("/nowhere"));
}
