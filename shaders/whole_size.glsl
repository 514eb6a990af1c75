// Expects: nothing
// Section 3.3.1: points that are neither smooth nor sprites are whole pixels wide.
float wholeSize(float size) { return max(floor(size + 0.5), 1.0); }
