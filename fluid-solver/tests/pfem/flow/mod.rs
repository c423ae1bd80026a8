mod free_fall;
mod rest;
mod waves;
