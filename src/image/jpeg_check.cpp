#include "image/jpeg_check.hpp"

#include <cstdint>

namespace tessera::image {

namespace {

constexpr std::uint8_t define_huffman_tables = 0xc4;
constexpr std::uint8_t start_of_scan = 0xda;

/// Bytes that read as 0 past the end, as stb reads them.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}
    std::uint8_t byte(std::size_t at) const {
        return at < bytes_.size() ? static_cast<std::uint8_t>(bytes_[at]) : std::uint8_t{0};
    }
    std::size_t length(std::size_t at) const { return byte(at) * std::size_t{256} + byte(at + 1); }
    std::size_t size() const { return bytes_.size(); }

private:
    std::span<const std::byte> bytes_;
};

/// Walks the tables of one segment: a byte of class and number, 16 counts, then as many symbols as they add up to.
bool segment_fits(const Reader& in, std::size_t segment) {
    const std::size_t end = segment + in.length(segment);
    std::size_t table = segment + 2;
    while (table < end) {
        if ((in.byte(table) >> 4) > 1 || (in.byte(table) & 15) > 3) return true;  // refused by stb
        std::size_t symbols = 0;
        for (std::size_t i = 1; i <= 16; ++i)
            symbols += in.byte(table + i);
        if (symbols > 256) return false;
        table += 17 + symbols;
    }
    return true;
}

}  // namespace

bool jpeg_tables_fit(std::span<const std::byte> bytes) {
    const Reader in(bytes);
    if (in.byte(0) != 0xff || in.byte(1) != 0xd8) return true;
    // Up to the first scan segments follow one another by their lengths. After it tables may stand between scans, and
    // every place that could begin one is looked at: coded data never holds the bytes of a marker.
    bool scanning = false;
    for (std::size_t at = 2; at + 1 < in.size();) {
        if (in.byte(at) != 0xff || in.byte(at + 1) == 0xff) {
            ++at;
            continue;
        }
        const std::uint8_t marker = in.byte(at + 1);
        at += 2;
        if (marker == define_huffman_tables && !segment_fits(in, at)) return false;
        scanning = scanning || marker == start_of_scan;
        if (!scanning) at += in.length(at);
    }
    return true;
}

}  // namespace tessera::image
