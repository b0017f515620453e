#include "scene/uri.hpp"

#include <array>
#include <cstdint>

namespace tessera::scene {
namespace {

constexpr std::string_view data_prefix = "data:";

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+') return 62;
    if (c == '/') return 63;
    return -1;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::optional<std::string> percent_decode(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i];
            continue;
        }
        if (i + 2 >= text.size()) return std::nullopt;
        const int high = hex_digit(text[i + 1]);
        const int low = hex_digit(text[i + 2]);
        if (high < 0 || low < 0) return std::nullopt;
        out += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return out;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
    return uri.substr(0, data_prefix.size()) == data_prefix;
}

std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri) {
    constexpr std::string_view marker = ";base64";
    const std::size_t comma = uri.find(',');
    if (!is_data_uri(uri) || comma == std::string_view::npos) return std::nullopt;
    const std::string_view header = uri.substr(0, comma);
    if (header.size() < marker.size() || header.substr(header.size() - marker.size()) != marker) return std::nullopt;

    std::string_view text = uri.substr(comma + 1);
    for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding)
        text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;

    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        const int digit = base64_digit(c);
        if (digit < 0) return std::nullopt;
        bits = (bits << 6) | static_cast<std::uint32_t>(digit);
        held += 6;
        if (held >= 8) {
            held -= 8;
            bytes.push_back(static_cast<std::byte>((bits >> held) & 0xff));
        }
    }
    return bytes;
}

LocalPath resolve_uri(std::string_view uri, const std::filesystem::path& folder) {
    const auto decoded = percent_decode(uri);
    if (!decoded) return {{}, "has a percent sign that no two hexadecimal digits follow"};
    return resolve_path(*decoded, folder);
}

LocalPath resolve_path(const std::string& name, const std::filesystem::path& folder) {
    if (name.empty()) return {{}, "is empty"};
    if (name.find('\0') != std::string::npos) return {{}, "holds a zero byte"};
    // A backslash separates folders on some systems, and a colon marks a scheme or a drive: neither is portable.
    if (name.find_first_of("\\:") != std::string::npos) {
        return {{}, "is not a relative path (only files beside the document are read)"};
    }
    const auto relative = std::filesystem::path(name).lexically_normal();
    if (relative.is_absolute()) return {{}, "is an absolute path (only files beside the document are read)"};
    if (relative.begin() != relative.end() && *relative.begin() == "..") {
        return {{}, "leaves the document's folder"};
    }
    return {folder / relative, std::nullopt};
}

}  // namespace tessera::scene
