// The colour spaces of FLIP (Andersson et al. 2020, section 4.1).
#pragma once

#include "compare/backdrop.hpp"

namespace tessera::compare {

/// Luminance and two opponent chrominances.
struct Opponent {
    float luminance, red_green, blue_yellow;
};

/// Linear sRGB to the linear opponent space YCxCz (Flohr et al. 1993), white D65: luminance in [-16, 100].
Opponent to_ycxcz(const Rgb& linear);

/// Back to linear sRGB; what lies outside the gamut is clamped into [0, 1].
Rgb from_ycxcz(const Opponent& colour);

/// Linear sRGB to L*a*b* (CIE 15, white D65) with a* and b* scaled by L*/100: colours are told apart less well in the
/// dark (the Hunt effect, section 4.1.2).
Opponent to_adjusted_lab(const Rgb& linear);

/// How far two adjusted colours are apart (Abasi et al. 2020): cityblock in luminance, Euclidean in chrominance.
float hyab(const Opponent& a, const Opponent& b);

}  // namespace tessera::compare
