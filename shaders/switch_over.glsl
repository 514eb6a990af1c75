// Expects: nothing
// Section 3.7.8 with c = 0.5: a bias that makes any smaller level of detail one of magnification.
float switchOver(float lod) { return lod > 0.5 ? 0.0 : -1.0; }
