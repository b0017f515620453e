// Pictures side by side.
#pragma once

#include "image/text.hpp"

#include <vector>

namespace tessera::image {

struct Panel {
    Image picture;
    std::string label;  ///< a line or several
};

/// Pictures of one size side by side, each over its label on a strip of `paper`. Throws Error(usage) where there
/// is none, sizes differ, or the result would be longer than max_side.
Image beside(const std::vector<Panel>& panels, const Rgba& paper);

}  // namespace tessera::image
