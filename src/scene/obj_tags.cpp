#include "scene/obj_tags.hpp"

#include "scene/obj_lines.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <optional>

namespace tessera::scene {
namespace {

struct Counts {
    std::size_t ints = 0;
    std::size_t floats = 0;
};

/// "2/1/0": how many whole numbers, numbers and strings follow.
std::optional<Counts> parse_counts(std::string_view word) {
    std::size_t counts[3] = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t slash = word.find('/');
        const auto number = parse_int(word.substr(0, slash));
        if (!number || *number < 0 || (slash == std::string_view::npos) != (i == 2)) return std::nullopt;
        counts[i] = static_cast<std::size_t>(*number);
        if (i < 2) word.remove_prefix(slash + 1);
    }
    return Counts{counts[0], counts[1]};
}

}  // namespace

void ObjTagReader::skip(std::uint32_t line, std::string_view name, const char* reason) {
    diagnostics_.note(fmt::format("Line {}: the tag {} {} and is skipped.", line, in_quotes(name, 32), reason));
}

void ObjTagReader::read(std::uint32_t line, std::string_view text, SubdivisionTags& tags) {
    split_words(text, words_);
    const std::string_view name = words_.empty() ? std::string_view() : words_[0];
    if (name != "crease" && name != "corner" && name != "hole" && name != "interpolateboundary") {
        diagnostics_.note(fmt::format("Tags {} are not supported and are skipped.", in_quotes(name, 32)));
        return;
    }
    const auto counts = words_.size() > 1 ? parse_counts(words_[1]) : std::nullopt;
    const std::size_t values = words_.size() < 2 ? 0 : words_.size() - 2;
    if (!counts || counts->ints > values || counts->floats > values - counts->ints) {
        return skip(line, name, "does not have the values it announces");
    }
    ints_.clear();
    floats_.clear();
    for (std::size_t i = 0; i < counts->ints; ++i) {
        const auto number = parse_int(words_[2 + i]);
        if (!number || *number < 0) return skip(line, name, "has an index that is not a whole number from 0");
        ints_.push_back(static_cast<std::uint32_t>(*number));
    }
    for (std::size_t i = 0; i < counts->floats; ++i) {
        const auto number = parse_float(words_[2 + counts->ints + i]);
        if (!number) return skip(line, name, "has a sharpness that is not a finite number");
        floats_.push_back(std::max(*number, 0.0f));
    }
    const std::size_t step = name == "crease" ? 2 : 1;
    const std::size_t items = ints_.size() / step;
    if (items == 0 || ints_.size() % step != 0) return skip(line, name, "has the wrong number of values");
    if (name == "interpolateboundary") {
        tags.interpolate_boundary = static_cast<int>(ints_[0]);
        return;
    }
    if (name == "hole") {
        tags.holes.insert(tags.holes.end(), ints_.begin(), ints_.end());
        return;
    }
    if (floats_.size() != 1 && floats_.size() != items) return skip(line, name, "has the wrong number of values");
    for (std::size_t i = 0; i < items; ++i) {
        const float sharpness = floats_[floats_.size() == 1 ? 0 : i];
        if (name == "crease") {
            tags.creases.push_back({ints_[2 * i], ints_[2 * i + 1], sharpness});
        } else {
            tags.corners.push_back({ints_[i], sharpness});
        }
    }
}

void ObjTagReader::check_ranges(std::uint64_t positions, std::uint64_t faces, SubdivisionTags& tags) {
    std::size_t removed = std::erase_if(tags.creases, [&](const Crease& crease) {
        return crease.a >= positions || crease.b >= positions || crease.a == crease.b;
    });
    removed += std::erase_if(tags.corners, [&](const SharpVertex& corner) { return corner.vertex >= positions; });
    removed += std::erase_if(tags.holes, [&](std::uint32_t face) { return face >= faces; });
    if (removed > 0) {
        diagnostics_.note(fmt::format("{} tags name vertices or faces that do not exist; they are left out.", removed));
    }
}

}  // namespace tessera::scene
