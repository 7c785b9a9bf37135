// Solids.
