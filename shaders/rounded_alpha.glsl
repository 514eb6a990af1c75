// Expects: nothing
// Section 4.1.4: alpha as the framebuffer holds it.
float roundedAlpha(float alpha, float scale) { return floor(alpha * scale + 0.5); }
