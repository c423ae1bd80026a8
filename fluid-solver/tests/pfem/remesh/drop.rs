//! A drop falls into a tank.

use super::Seeds;
use super::dam_break::run;
use crate::support::tank;
use fluid_solver::backend::pfem::wall::Grip;

#[test]
fn a_drop_that_falls_into_a_tank_keeps_its_volume() {
    for (h, allowed) in [(0.0146, 3e-3), (0.0073, 8e-4)] {
        let walls = tank::<2>([0.584, 1.0], Grip::Slip);
        let mut seeds = Seeds::new(&walls);
        seeds.add_box([0.584, 0.146], h, 1, |x| x);
        seeds.add_disc([0.2935, 0.216], 0.05, h, [0.0, -1.0]);
        let outcome = run(&mut seeds.mesh(h, 0.9), 0.3, h / 14.6);
        assert!(outcome.volume_error < allowed, "h = {h}: {}", outcome.volume_error);
        assert!(outcome.energy <= 1.0, "h = {h}: E/E0 = {}", outcome.energy);
    }
}
