//! Grains: contact, walls, insertion and explicit time integration; knows no mesh and no drag law.
