// Lines and words of OBJ text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tessera::scene {

/// A line cut into its first word and the rest, both without white space around them.
struct ObjLine {
    std::uint32_t number = 0;  ///< from 1; of the first line where a backslash joins several
    std::string_view keyword;
    std::string_view rest;
};

/// Goes through text line by line: LF, CR LF and CR end one, a backslash before the end joins the next.
class ObjLines {
public:
    explicit ObjLines(std::span<const std::byte> bytes);

    /// The next line that is neither empty nor a comment; valid until the next call.
    std::optional<ObjLine> next();

private:
    std::string_view physical_line();

    std::string_view text_;
    std::uint32_t number_ = 0;
    std::string joined_;
};

/// Text before a word that begins with '#' (1.#INF is how some C libraries print an infinity).
std::string_view without_comment(std::string_view text);

/// Words between white space.
void split_words(std::string_view text, std::vector<std::string_view>& words);

/// The whole word as a number; nothing if it is none or does not fit a float or an int.
std::optional<float> parse_float(std::string_view word);
std::optional<std::int32_t> parse_int(std::string_view word);

}  // namespace tessera::scene
