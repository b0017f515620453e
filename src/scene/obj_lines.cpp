#include "scene/obj_lines.hpp"

#include <charconv>
#include <cmath>

namespace tessera::scene {
namespace {

constexpr std::string_view blanks = " \t";

std::string_view trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// from_chars takes no plus sign, OBJ files may have one.
std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

ObjLines::ObjLines(std::span<const std::byte> bytes)
    : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

std::string_view ObjLines::physical_line() {
    const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
    const std::string_view line = text_.substr(0, end);
    std::size_t next = end;
    if (next < text_.size()) next += text_.substr(next, 2) == "\r\n" ? 2 : 1;
    text_.remove_prefix(next);
    ++number_;
    return line;
}

std::optional<ObjLine> ObjLines::next() {
    while (!text_.empty()) {
        std::string_view line = physical_line();
        ObjLine out;
        out.number = number_;
        if (line.ends_with('\\')) {
            joined_.assign(line);
            while (joined_.ends_with('\\')) {
                joined_.back() = ' ';
                if (!text_.empty()) joined_ += physical_line();
            }
            line = joined_;
        }
        line = trim(line);
        if (line.empty() || line.front() == '#') continue;
        const std::size_t space = std::min(line.find_first_of(blanks), line.size());
        out.keyword = line.substr(0, space);
        out.rest = trim(line.substr(space));
        return out;
    }
    return std::nullopt;
}

std::string_view without_comment(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '#' && (i == 0 || blanks.find(text[i - 1]) != std::string_view::npos))
            return trim(text.substr(0, i));
    }
    return trim(text);
}

void split_words(std::string_view text, std::vector<std::string_view>& words) {
    words.clear();
    while (!(text = trim(text)).empty()) {
        const std::size_t end = std::min(text.find_first_of(blanks), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
}

std::optional<float> parse_float(std::string_view word) {
    word = without_plus(word);
    float value = 0.0f;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size()) return std::nullopt;
    // "Out of range" is said of numbers too small for a float as well, which are as good as zero.
    if (error == std::errc::result_out_of_range) {
        double wide = 0.0;
        const auto again = std::from_chars(word.data(), word.data() + word.size(), wide);
        if (again.ec == std::errc() && std::abs(wide) < 1.0) return 0.0f;
        return std::nullopt;
    }
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::int32_t> parse_int(std::string_view word) {
    word = without_plus(word);
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

}  // namespace tessera::scene
