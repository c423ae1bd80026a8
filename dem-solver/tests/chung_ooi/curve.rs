//! Tables of numbers, and curves read off figures.

/// The published curves were read off their figures to this part of full scale.
pub const READING: f64 = 0.02;

/// A CSV of numbers below one line of titles.
pub fn rows(text: &str) -> Vec<Vec<f64>> {
    let row = |line: &str| line.split(',').map(|cell| cell.parse().unwrap()).collect();
    text.lines().skip(1).map(row).collect()
}

/// Points (x, y), x ascending.
pub struct Curve(Vec<(f64, f64)>);

impl Curve {
    /// The rows of `series` of a published table: name, x, y.
    pub fn published(text: &str, series: &str) -> Self {
        let rows = text.lines().filter_map(|line| line.strip_prefix(series)?.strip_prefix(','));
        let point =
            |row: &str| row.split_once(',').map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap())).unwrap();
        let points: Vec<_> = rows.map(point).collect();
        assert!(!points.is_empty(), "no series {series}");
        Self(points)
    }

    /// y at x, linear between points; nothing beyond the ends.
    pub fn at(&self, x: f64) -> Option<f64> {
        let segment = self.0.windows(2).find(|pair| pair[0].0 <= x && x <= pair[1].0)?;
        let [(x0, y0), (x1, y1)] = [segment[0], segment[1]];
        Some(y0 + (x - x0) / (x1 - x0) * (y1 - y0))
    }

    /// The points up to this x.
    pub fn up_to(&self, x: f64) -> Vec<(f64, f64)> {
        self.0.iter().copied().filter(|point| point.0 <= x).collect()
    }

    /// Largest less smallest y.
    pub fn span(&self) -> f64 {
        let fold = |join: fn(f64, f64) -> f64| self.0.iter().map(|point| point.1).reduce(join).unwrap();
        fold(f64::max) - fold(f64::min)
    }
}
