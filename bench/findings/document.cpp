#include "document.hpp"

#include <algorithm>
#include <string_view>

namespace tessera::findings {
namespace {

/// Breaks lines at 120 columns; `indent` begins all but the first.
std::string wrapped(const std::string& text, const std::string& indent) {
    std::string result;
    std::size_t column = indent.size();
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string_view word(text.data() + at, end - at);
        if (at > 0) {
            const bool breaks = column + 1 + word.size() > 120;
            result += breaks ? "\n" + indent : " ";
            column = breaks ? indent.size() : column + 1;
        }
        result += word;
        column += word.size();
        at = end + 1;
    }
    return result;
}

}  // namespace

void Document::block(const std::string& text) {
    in_list_ = false;
    markdown_ += "\n" + text + "\n";
}

void Document::paragraph(const std::string& text) {
    block(wrapped(text, ""));
}

void Document::table(const Rows& rows) {
    in_list_ = false;
    markdown_ += "\n";
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::string line = "|";
        for (const std::string& cell : rows[r])
            line += " " + cell + " |";
        markdown_ += line + "\n";
        if (r > 0) continue;
        markdown_ += "|---|";
        for (std::size_t c = 1; c < rows[0].size(); ++c)
            markdown_ += "---:|";
        markdown_ += "\n";
    }
}

void Document::claim(bool holds, const std::string& sentence) {
    if (!in_list_) markdown_ += "\n";
    in_list_ = true;
    markdown_ += "- " + wrapped(sentence, "  ") + "\n";
    if (!holds) broken_.push_back(sentence);
}

}  // namespace tessera::findings
