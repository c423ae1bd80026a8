//! Fluid: meshes, stabilised finite elements, void fraction, sampling and deposition; knows no contact.
