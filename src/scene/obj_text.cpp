#include "scene/obj_text.hpp"

#include "scene/limits.hpp"
#include "scene/obj_lines.hpp"
#include "scene/obj_tags.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace tessera::scene {
namespace {

/// One of the three kinds of element that a face corner names.
struct ElementKind {
    const char* name;
    std::uint64_t count = 0;
    std::int32_t greatest = 0;  ///< index seen in a face: elements may follow the faces that use them
    std::uint32_t greatest_line = 0;
};

class Checker {
public:
    explicit Checker(Diagnostics& diagnostics) : diagnostics_(diagnostics), tags_(diagnostics) {}

    ObjText check(std::span<const std::byte> bytes) {
        ObjLines lines(bytes);
        while (const auto line = lines.next())
            statement(*line);
        finish();
        return std::move(out_);
    }

private:
    [[noreturn]] void refuse(const ObjLine& line, const std::string& reason) const {
        diagnostics_.refuse(fmt::format("line {}: {}", line.number, in_quotes(line.keyword)), reason);
    }

    void statement(const ObjLine& line) {
        const std::string_view k = line.keyword;
        if (k == "v") return position(line);
        if (k == "vt") return uv(line);
        if (k == "vn") return normal(line);
        if (k == "f") return face(line);
        if (k == "s") return smoothing(line);
        if (k == "g" || k == "o" || k == "usemtl") return pass_on(line, line.rest);
        if (k == "mtllib") return out_.libraries.emplace_back(line.rest), void();
        if (k == "t") return tags_.read(line.number, without_comment(line.rest), out_.tags);
        if (k == "l" || k == "p") return ++lines_and_points_, void();
        diagnostics_.note(fmt::format("Statements {} are not supported and are skipped.", in_quotes(k, 24)));
    }

    /// tinyobjloader reads lines as C strings.
    void pass_on(const ObjLine& line, std::string_view rest) {
        if (rest.find('\0') != std::string_view::npos) refuse(line, "is followed by a zero byte");
        out_.statements.append(line.keyword).append(" ").append(rest).append("\n");
    }

    /// Counts an element and passes it on; returns true if the numbers it has are finite.
    bool element(const ObjLine& line, ElementKind& kind, std::size_t least, std::size_t most) {
        split_words(without_comment(line.rest), words_);
        if (words_.size() < least) {
            refuse(line, fmt::format("has only {} of the {} numbers that it needs", words_.size(), least));
        }
        if (++kind.count > max_vertices) {
            refuse(line, fmt::format("brings the file to more than the {} supported {}", max_vertices, kind.name));
        }
        pass_on(line, without_comment(line.rest));
        const auto last = words_.begin() + static_cast<std::ptrdiff_t>(std::min(most, words_.size()));
        return std::all_of(words_.begin(), last, [](std::string_view word) { return parse_float(word).has_value(); });
    }

    void position(const ObjLine& line) {
        if (!element(line, positions_, 3, 3)) {
            out_.unusable_positions.push_back(static_cast<std::uint32_t>(positions_.count - 1));
        }
        if (words_.size() >= 6) diagnostics_.note("Vertex colours are ignored.");
    }

    void normal(const ObjLine& line) {
        if (!element(line, normals_, 3, 3)) {
            out_.unusable_normals.push_back(static_cast<std::uint32_t>(normals_.count - 1));
        }
    }

    void uv(const ObjLine& line) {
        if (!element(line, uvs_, 1, 2)) ++unusable_uvs_;
    }

    void index(const ObjLine& line, std::string_view word, ElementKind& kind) const {
        const auto number = parse_int(word);
        if (!number) refuse(line, fmt::format("has the corner index {}, which is not a whole number", in_quotes(word)));
        if (*number == 0) refuse(line, fmt::format("names one of the {} by 0, but they count from 1", kind.name));
        if (*number < 0 && static_cast<std::uint64_t>(-static_cast<std::int64_t>(*number)) > kind.count) {
            refuse(line, fmt::format("names one of the {} by {}, but only {} come before it", kind.name, *number,
                                     kind.count));
        }
        if (*number > kind.greatest) {
            kind.greatest = *number;
            kind.greatest_line = line.number;
        }
    }

    void corner(const ObjLine& line, std::string_view word) {
        const std::array<ElementKind*, 3> kinds{&positions_, &uvs_, &normals_};
        for (std::size_t k = 0;; ++k) {
            if (k == kinds.size()) refuse(line, "has a corner of more than three indices");
            const std::size_t slash = word.find('/');
            const std::string_view part = word.substr(0, slash);
            if (k == 0 || !part.empty()) index(line, part, *kinds[k]);
            if (slash == std::string_view::npos) return;
            word.remove_prefix(slash + 1);
        }
    }

    void face(const ObjLine& line) {
        const std::uint32_t number = out_.face_statements++;
        split_words(without_comment(line.rest), words_);
        face_.clear();
        for (std::string_view word : words_) {
            // Behind a slash, tinyobjloader would take the number of the next corner for this one's.
            while (word.ends_with('/'))
                word.remove_suffix(1);
            corner(line, word);
            face_.append(word).append(" ");
        }
        if (words_.size() < 3) {
            ++short_faces_;
            return;
        }
        if (words_.size() > max_face_corners) {
            refuse(line, fmt::format("has {} corners, more than the {} supported", words_.size(), max_face_corners));
        }
        out_.corners += words_.size();
        if (out_.corners > max_corners) {
            refuse(line, fmt::format("brings the faces to more than the {} supported corners", max_corners));
        }
        out_.faces.push_back({line.number, number, smoothing_});
        pass_on(line, face_);
    }

    void smoothing(const ObjLine& line) {
        const std::string_view rest = without_comment(line.rest);
        const auto number = parse_int(rest);
        if (rest == "off") {
            smoothing_ = 0;
        } else if (rest == "on") {
            smoothing_ = 1;
        } else if (number && *number >= 0) {
            smoothing_ = static_cast<std::uint32_t>(*number);
        } else {
            diagnostics_.note(
                fmt::format("Line {}: the smoothing group {} is not understood.", line.number, in_quotes(rest)));
        }
    }

    void finish() {
        if (positions_.count == 0) diagnostics_.refuse("the file", "holds no vertices (v statements)");
        for (const ElementKind* kind : {&positions_, &uvs_, &normals_}) {
            if (static_cast<std::uint64_t>(kind->greatest) > kind->count) {
                diagnostics_.refuse(fmt::format("line {}: \"f\"", kind->greatest_line),
                                    fmt::format("names one of the {} by {}, but there are only {}", kind->name,
                                                kind->greatest, kind->count));
            }
        }
        tags_.check_ranges(positions_.count, out_.face_statements, out_.tags);
        if (unusable_uvs_ > 0) {
            diagnostics_.note(
                fmt::format("{} texture coordinates are not finite numbers and became zero.", unusable_uvs_));
        }
        if (short_faces_ > 0) {
            diagnostics_.note(fmt::format("{} faces of fewer than three corners are skipped.", short_faces_));
        }
        if (lines_and_points_ > 0) {
            diagnostics_.note(fmt::format("{} statements of lines or points are skipped.", lines_and_points_));
        }
        out_.positions = positions_.count;
        out_.uvs = uvs_.count;
        out_.normals = normals_.count;
    }

    Diagnostics& diagnostics_;
    ObjTagReader tags_;
    ObjText out_;
    ElementKind positions_{"positions"};
    ElementKind uvs_{"texture coordinates"};
    ElementKind normals_{"normals"};
    std::uint32_t smoothing_ = unstated_group;
    std::uint64_t unusable_uvs_ = 0;
    std::uint64_t short_faces_ = 0;
    std::uint64_t lines_and_points_ = 0;
    std::vector<std::string_view> words_;
    std::string face_;
};

}  // namespace

ObjText check_obj_text(std::span<const std::byte> bytes, Diagnostics& diagnostics) {
    return Checker(diagnostics).check(bytes);
}

}  // namespace tessera::scene
