//! The case document with units and spans, the plan, exit codes, and everything a run leaves on disk.
