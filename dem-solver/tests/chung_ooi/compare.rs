//! The same impacts by LIGGGHTS, LAMMPS and YADE beside ours.

/// The stored rows of a file by LIGGGHTS, LAMMPS and YADE.
macro_rules! peers {
    ($file:literal) => {
        [
            include_str!(concat!("reference/liggghts/", $file)),
            include_str!(concat!("reference/lammps/", $file)),
            include_str!(concat!("reference/yade/", $file)),
        ]
        .map($crate::curve::rows)
    };
}

pub(crate) use peers;

/// The rows of the three programs: the same abscissae in the first column of each.
pub type Peers = [Vec<Vec<f64>>; 3];

/// The abscissae.
pub fn abscissae(peers: &Peers) -> Vec<f64> {
    peers[0].iter().map(|row| row[0]).collect()
}

/// Prints the errors of four programs where the answer is known, and returns the root mean square of each: ours,
/// LIGGGHTS', LAMMPS', YADE's.
///
/// The value of a program is `column` of its row, ours what is `found` for the abscissa.
pub fn compare(
    title: &str,
    peers: &Peers,
    column: usize,
    answer: impl Fn(f64) -> Option<f64>,
    found: impl Fn(f64) -> f64,
) -> [f64; 4] {
    println!("{title}: x, answer | errors here, LIGGGHTS, LAMMPS, YADE");
    let line = |errors: [f64; 4]| errors.map(|error| format!("{error:+10.5}")).join(" ");
    let (mut squares, mut count) = ([0.0; 4], 0.0);
    for (row, x) in abscissae(peers).into_iter().enumerate() {
        let Some(answer) = answer(x) else { continue };
        let [liggghts, lammps, yade] = [0, 1, 2].map(|peer| peers[peer][row][column]);
        let errors = [found(x), liggghts, lammps, yade].map(|value| value - answer);
        println!("{x:8.3} {answer:10.4} | {}", line(errors));
        (0..4).for_each(|k| squares[k] += errors[k] * errors[k]);
        count += 1.0;
    }
    let root_mean_square = squares.map(|square| (square / count).sqrt());
    println!("{:>19} | {}", "root mean square", line(root_mean_square));
    root_mean_square
}
