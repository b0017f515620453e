// Figures as text.
#pragma once

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace tessera::findings {

/// Radians as degrees, two digits.
inline std::string degrees(double radians) {
    return fmt::format("{:.2f}", radians * 180.0 / std::numbers::pi);
}

inline std::string percent(double share) {
    return fmt::format("{:.1f} %", 100.0 * share);
}

struct Range {
    double least = 0.0;
    double greatest = 0.0;
};

/// Of `value(row)` over all rows.
template <typename Rows, typename Value>
Range range(const Rows& rows, const Value& value) {
    Range result{value(rows.front()), value(rows.front())};
    for (const auto& row : rows) {
        result.least = std::min(result.least, value(row));
        result.greatest = std::max(result.greatest, value(row));
    }
    return result;
}

/// "7 of 14 models"; the number of rows for which `holds(row)`.
template <typename Rows, typename Holds>
std::string share_of(const Rows& rows, const Holds& holds) {
    const auto count = std::ranges::count_if(rows, holds);
    return count == std::ranges::ssize(rows) ? fmt::format("all {} models", count)
                                             : fmt::format("{} of {} models", count, rows.size());
}

/// The names of the rows for which `holds(row)`.
template <typename Rows, typename Holds>
std::string names_of(const Rows& rows, const Holds& holds) {
    std::string names;
    for (const auto& row : rows) {
        if (holds(row)) names += (names.empty() ? "" : ", ") + row.name;
    }
    return names.empty() ? "none" : names;
}

}  // namespace tessera::findings
