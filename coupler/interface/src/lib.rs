//! Frames, messages, participant states, transports and liveness: all that crosses between the three programs.
