// The options of render about views that have a legend or need more than a shading.
#pragma once

#include "views/view.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace tessera::cli {

/// Raw words of the command line.
struct ViewWords {
    std::string against;  // empty: not given
    std::string range;    // likewise
};

void add_view_options(CLI::App& command, ViewWords& words);

/// Throws Error(usage) where a word does not go with the view, LookWords::view, or makes no sense.
void check(const ViewWords& words, const std::string& view);

/// Whether the view leaves hair out.
bool leaves_hair_out(const std::string& view);

/// The view of that name. Words have been checked.
std::unique_ptr<views::View> make_view(const std::string& view, const ViewWords& words, const views::Subject& subject);

}  // namespace tessera::cli
