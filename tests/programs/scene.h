// What the programs of these tests draw: something of every stage of the pipeline, and marks that show
// whether a picture fills its window pixel by pixel.
#pragma once

namespace programs {

// Into the current surface, of the size given. The turn of the thing in the middle is in degrees; its texture
// is a name that uploadTexture() gave, or 0.
void drawScene(int width, int height, float turn, unsigned texture);
unsigned uploadTexture();

// Whether the marks in the corners of what has been drawn are where they should be; says on stderr what is
// not.
bool cornersAreRight(int width, int height);

}  // namespace programs
