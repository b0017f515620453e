#include "scene/diagnostics.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera::scene {

std::string in_quotes(std::string_view text, std::size_t longest) {
    std::string out = "\"";
    for (const char c : text.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte >= 0x7f) {
            out += fmt::format("\\x{:02x}", byte);
        } else {
            out += c;
        }
    }
    out += text.size() > longest ? "...\"" : "\"";
    return out;
}

void Diagnostics::refuse(const std::string& element, const std::string& reason) const {
    throw Error(ErrorKind::usage, fmt::format("{}: {} {}.", file_, element, reason));
}

void Diagnostics::note(std::string sentence) {
    if (std::find(messages_.begin(), messages_.end(), sentence) != messages_.end()) return;
    if (messages_.size() == message_limit) {
        ++left_out_;
        return;
    }
    messages_.push_back(std::move(sentence));
}

std::vector<std::string> Diagnostics::take_messages() {
    if (left_out_ > 0) {
        messages_.push_back(fmt::format("{} further messages are not shown.", left_out_));
        left_out_ = 0;
    }
    return std::move(messages_);
}

}  // namespace tessera::scene
