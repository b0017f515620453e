// The legend of a colour map: a bar with ticks and a title.
#pragma once

#include "views/colour_map.hpp"
#include "views/view.hpp"

#include <string>
#include <vector>

namespace tessera::views {

/// The numbers written under a bar: both ends, and between them the multiples of 1, 2 or 5 times a power of ten that
/// leave about `wanted` intervals. One number where the scale has no length.
std::vector<double> bar_ticks(const Scale& scale, int wanted);

/// A number with as many digits as tell it from others on its scale.
std::string tick_text(double value, const Scale& scale);

/// Appends a strip of `paper` under the picture, with a bar of the colour map, its ticks and its title in the middle.
/// Letters are as large as those of labels under pictures of the size `panel`, or smaller where the title would not fit
/// the whole picture. Of the ticks' numbers those that would touch another are left out, the ends' never.
void append_colour_bar(image::Image& picture, const PanelSize& panel, const Scale& scale, const std::string& title,
                       const image::Rgba& paper);

/// What a line of a picture stands for.
struct Key {
    image::Rgba colour;
    std::string words;
};

/// Appends a strip of `paper` with keys side by side.
void append_keys(image::Image& picture, const PanelSize& panel, const std::vector<Key>& keys, const image::Rgba& paper);

}  // namespace tessera::views
