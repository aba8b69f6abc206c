//! What a student's picture does differently.
