mod bits;
mod free_fall;
mod ledger;
mod rest;
mod walls;
mod waves;
