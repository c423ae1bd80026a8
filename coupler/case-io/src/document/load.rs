//! From a case on disk to the checked documents of its runs.

use std::fmt::Display;
use std::fs;
use std::path::{Path, PathBuf};

use super::Document;
use super::sweep::{Planned, runs, variant};
use super::validate::validate;
use crate::checkpoint::checksum;
use crate::error::CaseError;
use crate::tree::{Assignment, KeyPath, Source};

/// What the command line changes in a case.
#[derive(Clone, Debug, Default)]
pub struct Overrides {
    /// `key=value`, applied last, in this order.
    pub set: Vec<String>,
    /// Name of one of `[variants.*]`, applied first.
    pub variant: Option<String>,
}

/// One run of a case: its document, checked, with all changes applied.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name of the case: of its folder, or of the file where that is not `case.toml`.
    pub name: String,
    /// Name of the `[[run]]`, if the case is a sweep.
    pub run: Option<String>,
    /// The folder that relative paths of the document start from.
    pub folder: PathBuf,
    /// What the case states.
    pub document: Document,
    /// 64 bits in hexadecimal over the document and the bytes of all files it names: equal for equal runs.
    pub hash: String,
    source: Source,
}

impl Case {
    /// Reads `path` (a folder with `case.toml`, or the file itself), applies the variant, each `[[run]]` and the
    /// changes of the command line, and checks all that can be checked without the mesh.
    ///
    /// Returns one case for each `[[run]]`, or one if there is none.
    ///
    /// # Errors
    /// The first thing wrong, in one line: place, key, value found, what is allowed, what to do.
    pub fn load(path: &Path, overrides: &Overrides) -> Result<Vec<Self>, CaseError> {
        let file = if path.is_dir() { path.join("case.toml") } else { path.to_path_buf() };
        let source = Source::parse(&file, &read(&file)?)?;
        let folder = file.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let runs = runs(&source)?;
        let variant = variant(&source, overrides.variant.as_deref())?;
        runs.into_iter()
            .map(|Planned { run, set }| {
                let mut source = source.clone();
                for path in variant.iter().chain(&set) {
                    for assignment in Assignment::all(&source, path) {
                        assignment.apply(&mut source)?;
                    }
                }
                for argument in &overrides.set {
                    Assignment::parse(argument)?.apply(&mut source)?;
                }
                let document = resolve(&source)?;
                let hash = hash(&document, folder, &source)?;
                Ok(Self { name: name(&file), run, folder: folder.into(), document, hash, source })
            })
            .collect()
    }

    /// As [`Case::load`], of one run of a sweep by its name, or of the case that is none.
    ///
    /// # Errors
    /// As [`Case::load`]; a run that the case does not have.
    pub fn load_run(path: &Path, overrides: &Overrides, run: Option<&str>) -> Result<Self, CaseError> {
        let cases = Self::load(path, overrides)?;
        cases.into_iter().find(|case| case.run.as_deref() == run).ok_or_else(|| CaseError::CommandLine {
            flag: format!("run {}", run.unwrap_or_default()),
            problem: format!("{} has no such run; restore the case, or start again", path.display()),
        })
    }

    /// The error that a key is wrong, in the words of all others: `key` is a path such as
    /// `insertion[0].diameter`; any of what was `found`, what is `allowed` and the `advice` may be empty.
    pub fn error(
        &self,
        key: &str,
        found: impl Display,
        allowed: impl Display,
        advice: impl Display,
    ) -> CaseError {
        self.source.error(key, found, allowed, advice)
    }

    /// Whether the case states this key (rather than leaving it to its default).
    pub fn states(&self, key: &str) -> bool {
        self.source.has(key)
    }
}

/// The document of a source, checked.
pub(crate) fn resolve(source: &Source) -> Result<Document, CaseError> {
    let document = source.deserialise(KeyPath::default())?;
    validate(&document, source)?;
    Ok(document)
}

fn read(file: &Path) -> Result<String, CaseError> {
    fs::read_to_string(file).map_err(|error| CaseError::Unreadable {
        path: file.into(),
        problem: format!("{error}; a case is a folder with case.toml, or such a file"),
    })
}

fn name(file: &Path) -> String {
    let absolute = fs::canonicalize(file).unwrap_or_else(|_| file.into());
    let named = match absolute.file_stem() {
        Some(stem) if stem != "case" => Some(stem),
        _ => absolute.parent().and_then(Path::file_name),
    };
    named.map_or_else(|| "case".into(), |name| name.to_string_lossy().into_owned())
}

fn hash(document: &Document, folder: &Path, source: &Source) -> Result<String, CaseError> {
    let json = serde_json::to_vec(document)
        .map_err(|error| source.error("case", format_args!("cannot be written as JSON: {error}"), "", ""))?;
    let mut parts = checksum(&json).to_le_bytes().to_vec();
    for (key, path) in document.files() {
        let path = folder.join(path);
        let bytes = fs::read(&path).map_err(|error| {
            let found = format!("cannot read \"{}\": {error}", path.display());
            source.error(&key, found, "", "the path starts from the case's folder")
        })?;
        parts.extend(checksum(&bytes).to_le_bytes());
    }
    Ok(format!("{:016x}", checksum(&parts)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::fixture::{CHANNEL, DRY, Folder, SETTLING};
    use crate::exit_code::ExitCode;

    const RUNS: &str = "
[variants.full]
set = { \"time.end\" = \"10 s\", \"insertion[0].diameter\" = \"3 mm\" }
[variants.wrong]
set = { \"time.ende\" = \"10 s\" }
[[run]]
name = \"h1\"
[[run]]
name = \"h2\"
set = { \"fluid.mesh.box.cells\" = [20, 20, 40], \"time.window\" = \"0.5 ms\" }
";

    #[test]
    fn a_case_is_named_by_its_folder_or_its_file() {
        let folder = Folder::new(SETTLING);
        let case = &folder.load(&[], None).unwrap()[0];
        assert_eq!((case.name.as_str(), &case.run), ("settling", &None));
        assert_eq!(case.folder, folder.0.path("settling"));
        fs::rename(folder.0.path("settling/case.toml"), folder.0.path("settling/other.toml")).unwrap();
        let case = &Case::load(&folder.0.path("settling/other.toml"), &Overrides::default()).unwrap()[0];
        assert_eq!(case.name, "other");
    }

    #[test]
    fn what_is_not_there_is_refused() {
        let folder = Folder::new(SETTLING);
        fs::remove_file(folder.0.path("settling/case.toml")).unwrap();
        assert_eq!(
            folder.refusal(&[], None),
            "settling/case.toml: No such file or directory (os error 2); a case is a folder with case.toml, or such a file"
        );
        let folder = Folder::new(&SETTLING.replace(
            "plane = { point = [\"0 m\", \"0 m\", \"0 m\"], normal = [0, 0, 1] }",
            "stl = { path = \"pipe.stl\" }",
        ));
        assert_eq!(
            folder.refusal(&[], None),
            "settling/case.toml:25: wall[0].stl.path: cannot read \"settling/pipe.stl\": No such file or directory (os error 2); the path starts from the case's folder"
        );
    }

    #[test]
    fn the_variant_comes_first_then_the_run_then_the_command_line() {
        let folder = Folder::new(&format!("{SETTLING}{RUNS}"));
        let cases = folder.load(&["time.window=2 ms"], Some("full")).unwrap();
        assert_eq!(
            cases.iter().map(|case| case.run.as_deref()).collect::<Vec<_>>(),
            [Some("h1"), Some("h2")]
        );
        for case in &cases {
            assert_eq!((case.document.time.end.si(), case.document.window()), (10.0, 0.002));
            assert_eq!(case.document.insertion[0].diameters(), Some([0.003; 2]));
        }
        let cells = |case: &Case| {
            case.document
                .fluid
                .as_ref()
                .unwrap()
                .mesh
                .as_ref()
                .unwrap()
                .box_mesh
                .as_ref()
                .unwrap()
                .cells::<3>()
        };
        assert_eq!((cells(&cases[0]), cells(&cases[1])), ([10, 10, 20], [20, 20, 40]));
        assert_eq!(folder.load(&[], None).unwrap()[1].document.window(), 0.0005);
    }

    #[test]
    fn a_set_value_is_toml_or_else_a_word() {
        let folder = Folder::new(SETTLING);
        let case = |set: &[&str]| folder.load(set, None).unwrap().remove(0);
        assert_eq!(case(&["case.title=a = b"]).document.case.title, "a = b");
        assert_eq!(case(&["case.title=\"quoted\""]).document.case.title, "quoted");
        assert_eq!(
            case(&["pairs.glass-glass.restitution=0.5"]).document.pairs["glass-glass"].restitution,
            0.5
        );
        assert_eq!(
            case(&["insertion[0].at=[[\"0 m\", \"1 m\", \"2 m\"]]", "wall[0].plane.normal=[0, 0, 2]"])
                .document
                .insertion[0]
                .at
                .as_ref()
                .unwrap()
                .len(),
            1
        );
        assert_eq!(
            case(&["output.frames=none"])
                .document
                .output
                .frames(crate::document::quantity::Time::from_si(1.0)),
            None
        );
        // A table that is not there yet is made.
        assert_eq!(case(&["coupling.tolerance.force=1e-6"]).document.coupling.unwrap().tolerance.force, 1e-6);
    }

    #[test]
    fn a_wrong_set_is_refused_as_such() {
        let folder = Folder::new(&format!("{SETTLING}{RUNS}"));
        for (set, message) in [
            (
                "time.end",
                "--set time.end: no \"=\" found; write --set key=value, for example --set time.end=\"10 s\"",
            ),
            ("=3", "--set : is no key; write for example time.end or insertion[0].diameter"),
            (
                "time.ende=3 s",
                "--set time.ende: unknown key; allowed: end, window, smallest-window, substep, substep-safety; did you mean \"end\"?",
            ),
            (
                "tme.end=3 s",
                "--set tme: unknown key; allowed: case, time, output, materials, pairs, grains, clump, insertion, bond, deletion, wall, fluid, coupling, probe, variants, run; did you mean \"time\"?",
            ),
            ("time.end=3", "--set time.end: value 3 has no unit; write \"3 s\" (a time)"),
            ("time.end.x=3", "--set time.end.x: time.end has no keys; set it as a whole"),
            (
                "grains.normal-law=herz",
                "--set grains.normal-law: unknown law \"herz\"; allowed: hooke, hertz, onate, liggghts-hooke, liggghts-hertz, none; did you mean \"hertz\"?",
            ),
            (
                "insertion[3].diameter=1 mm",
                "--set insertion[3].diameter: there is no such entry; allowed: insertion[0]",
            ),
            (
                "insertion.diameter=1 mm",
                "--set insertion.diameter: insertion is an array; write the number of its entry, from 0: insertion[0]",
            ),
            ("time[0].end=1 s", "--set time[0].end: time is no array"),
            (
                "materials.glas.density=1 kg/m^3",
                "--set materials.glas.density: there is no \"glas\" in [materials]; allowed: glass; did you mean \"glass\"?",
            ),
            ("run[0].name=a", "--set run[0].name: cannot be set; set a key of the case itself"),
            ("insertion[0].diameter=0 mm", "--set insertion[0].diameter: found 0 m; allowed: more than 0 m"),
        ] {
            assert_eq!(folder.refusal(&[set], None), message);
        }
        for (set, message) in [
            (
                "materials.glass.density=1 kg/m^3",
                "--set materials.glass.density: there is no [materials]; add [materials.glass] to the case",
            ),
            (
                "insertion[0].diameter=1 mm",
                "--set insertion[0].diameter: there is no insertion; add it to the case, entries and all",
            ),
        ] {
            assert_eq!(Folder::new(CHANNEL).refusal(&[set], None), message);
        }
        let code = |set: &[&str], variant| folder.load(set, variant).unwrap_err().exit_code();
        assert_eq!(code(&["time.end"], None), ExitCode::CommandLine);
        assert_eq!(code(&["time.end=3"], None), ExitCode::CaseRefused);
        assert_eq!(code(&[], Some("ful")), ExitCode::CommandLine);
        assert_eq!(
            folder.refusal(&[], Some("ful")),
            "--variant ful: settling/case.toml has no such variant; allowed: full, wrong; did you mean \"full\"?"
        );
        assert_eq!(
            Folder::new(DRY).refusal(&[], Some("full")),
            "--variant full: settling/case.toml has no variants; leave the flag out"
        );
        assert_eq!(
            folder.refusal(&[], Some("wrong")),
            "settling/case.toml:48: time.ende: unknown key; allowed: end, window, smallest-window, substep, substep-safety; did you mean \"end\"?"
        );
    }

    #[test]
    fn the_hash_knows_what_runs_and_nothing_else() {
        let hash = |text: &str, set: &[&str]| Folder::new(text).load(set, None).unwrap()[0].hash.clone();
        let plain = hash(SETTLING, &[]);
        assert_eq!(plain.len(), 16);
        assert_eq!(plain, hash(&format!("# a remark\n{}", SETTLING.replace("\"2 s\"", "\"2000 ms\"")), &[]));
        assert_eq!(plain, hash(&format!("{SETTLING}\n[variants.a]\nset = {{}}\n"), &[]));
        assert_ne!(plain, hash(SETTLING, &["time.end=3 s"]));
        assert_eq!(hash(SETTLING, &["time.end=3 s"]), hash(&SETTLING.replace("\"2 s\"", "\"3 s\""), &[]));
        let folder = Folder::new(&SETTLING.replace(
            "at = [[\"0 m\", \"0 m\", \"0.5 m\"], [\"0 m\", \"0 m\", \"0.6 m\"]]",
            "file = { path = \"grains.csv\" }",
        ));
        let of_file = |content: &str| {
            fs::write(folder.0.path("settling/grains.csv"), content).unwrap();
            folder.load(&[], None).unwrap()[0].hash.clone()
        };
        assert_ne!(of_file("x[m],y[m],z[m]\n0,0,0.5\n"), of_file("x[m],y[m],z[m]\n0,0,0.6\n"));
    }

    #[test]
    fn a_solver_words_its_own_errors_alike() {
        let case = &Folder::new(SETTLING).load(&["time.window=2 ms"], None).unwrap()[0];
        let message = |key: &str| case.error(key, "found 1", "2", "write 2").to_string();
        assert!(
            message("insertion[0].diameter")
                .ends_with("settling/case.toml:20: insertion[0].diameter: found 1; allowed: 2; write 2")
        );
        assert!(
            message("insertion[0].velocity")
                .ends_with("settling/case.toml:17: insertion[0].velocity: found 1; allowed: 2; write 2")
        );
        assert_eq!(message("time.window"), "--set time.window: found 1; allowed: 2; write 2");
        assert!(case.error("case", "found 1", "", "").to_string().ends_with(":1: case: found 1"));
        assert!(case.states("time.window") && !case.states("time.substep"));
    }
}
