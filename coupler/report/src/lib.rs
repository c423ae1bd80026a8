//! Plots, pictures and the self-contained report of a run.
