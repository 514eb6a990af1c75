// Expects: nothing
// Equation 3.22; density is for powers of 2.
float fogExp(float depth, float density) { return clamp(exp2(-density * abs(depth)), 0.0, 1.0); }
