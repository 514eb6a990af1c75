// What the parlour is made of. Functions of texture coordinates in [0,1).
#pragma once

#include "room/image.h"

namespace skinning {

inline constexpr double kDamaskExtent = 0.62;  // metres that one repeat covers

room::Texel damask(double u, double v);
room::Texel floorboards(double u, double v);
room::Texel velvet(double u, double v);
// The table's cloth from above, its middle at (0.5, 0.5): the wheel of the year in gold on blue.
room::Texel zodiacCloth(double u, double v);
// Four cards side by side, each a quarter of the width: sun, moon, star and the back.
room::Texel cards(double u, double v);
// A framed chart of the heavens.
room::Texel starChart(double u, double v);
room::Texel brass(double u, double v);
room::Texel leather(double u, double v);
room::Texel pages(double u, double v);
room::Texel china(double u, double v);
// What the window shows: a moon in thin clouds.
room::Texel nightSky(double u, double v);

}  // namespace skinning
