mod free_fall;
mod rest;
