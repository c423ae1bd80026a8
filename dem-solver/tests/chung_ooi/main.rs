//! Tests 1 to 8 of Y. C. Chung & J. Y. Ooi, Granular Matter 13 (2011) 643–656: single impacts whose answers are known in closed
//! form, from finite elements, or from the experiment of Kharaz, Gorham & Salman. `--nocapture` prints the tables.
#![allow(clippy::print_stdout, reason = "the tables are figures of the documentation")]

mod compare;
mod constant_normal_velocity;
mod constant_speed;
mod curve;
mod impact;
mod normal;
mod partial_slip;
mod spinning;
mod spinning_pairs;
