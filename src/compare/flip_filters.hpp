// The filters of FLIP for a viewing distance. All are sums of products of a row and a column filter.
#pragma once

#include <vector>

namespace tessera::compare {

/// Taps at -radius .. radius.
using Taps = std::vector<float>;

/// How eyes blur what they cannot resolve (Andersson et al. 2020, section 4.1.1): a Gaussian for each opponent channel,
/// two for blue-yellow. Each is normalised, so that flat areas keep their colour.
struct ContrastSensitivity {
    int radius = 0;
    Taps luminance, red_green, blue_yellow_wide, blue_yellow_narrow;
    float narrow_share = 0.0f;  ///< of blue_yellow_narrow in the sum of the two
};

/// Edge and point detectors (section 4.2): first and second derivatives of a Gaussian. Positive and negative taps each
/// add up to 1 in magnitude.
struct FeatureDetectors {
    int radius = 0;
    Taps smooth, edge, point;
};

ContrastSensitivity make_contrast_sensitivity(double pixels_per_degree);
FeatureDetectors make_feature_detectors(double pixels_per_degree);

}  // namespace tessera::compare
