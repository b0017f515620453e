#include "cli/view_options.hpp"

#include "base/error.hpp"
#include "raster/portable_rasteriser.hpp"
#include "views/factor_view.hpp"
#include "views/scheme_difference.hpp"
#include "views/silhouette_view.hpp"

#include <fmt/format.h>
#include <charconv>
#include <cmath>
#include <optional>

namespace tessera::cli {
namespace {

constexpr const char* default_against = "linear";

std::optional<double> parse_number(std::string_view words) {
    double number = 0.0;
    const char* const end = words.data() + words.size();
    const auto read = std::from_chars(words.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(number)) return std::nullopt;
    return number;
}

std::optional<views::Scale> parse_range(const std::string& words) {
    if (words.empty()) return std::nullopt;
    const std::size_t dots = words.find("..");
    if (dots != std::string::npos) {
        const auto least = parse_number(std::string_view(words).substr(0, dots));
        const auto greatest = parse_number(std::string_view(words).substr(dots + 2));
        if (least && greatest && *least < *greatest) return views::Scale{*least, *greatest};
    }
    throw Error(ErrorKind::usage,
                fmt::format("The range \"{}\" is not understood; write LEAST..GREATEST, such as 0..2.5.", words));
}

}  // namespace

void add_view_options(CLI::App& command, ViewWords& words) {
    command.add_option("--against", words.against,
                       "The scheme that --view scheme-difference measures from: linear (as without it), phong, pn or "
                       "stpn");
    command.add_option(
        "--range", words.range,
        "LEAST..GREATEST: the ends of the colour bar of --view factors and scheme-difference, instead of "
        "those of the model");
}

void check(const ViewWords& words, const std::string& view) {
    if (!words.against.empty()) {
        if (view != "scheme-difference") {
            throw Error(ErrorKind::usage, fmt::format("--against is for --view scheme-difference, not for {}; leave it "
                                                      "out.",
                                                      view));
        }
        scheme_from_name(words.against);
    }
    if (!words.range.empty() && view != "factors" && view != "scheme-difference") {
        throw Error(ErrorKind::usage,
                    fmt::format("--range is for views with a colour bar, factors and scheme-difference, not for {}; "
                                "leave it out.",
                                view));
    }
    parse_range(words.range);
}

bool leaves_hair_out(const std::string& view) {
    return view == "silhouette";
}

std::unique_ptr<views::View> make_view(const std::string& view, const ViewWords& words, const views::Subject& subject) {
    const std::optional<views::Scale> range = parse_range(words.range);
    if (view == "factors") return views::make_factor_view(subject, range);
    if (view == "scheme-difference") {
        const std::string against = words.against.empty() ? default_against : words.against;
        return views::make_difference_view(subject, scheme_from_name(against), against, range);
    }
    if (view == "silhouette") return views::make_silhouette_view(subject, raster::open_portable(subject.device));
    return views::make_plain_view(subject);
}

}  // namespace tessera::cli
