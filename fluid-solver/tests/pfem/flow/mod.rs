mod bits;
mod free_fall;
mod ledger;
mod plastic;
mod rest;
mod walls;
mod waves;
