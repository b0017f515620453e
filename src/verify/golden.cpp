#include "verify/golden.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <bit>
#include <charconv>
#include <fstream>
#include <map>
#include <tuple>

namespace tessera::verify {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> fields;
    while (true) {
        const std::size_t at = text.find(separator);
        fields.push_back(text.substr(0, at));
        if (at == std::string_view::npos) {
            return fields;
        }
        text.remove_prefix(at + 1);
    }
}

/// Parses one line; problems are thrown as a bare reason and completed by the caller.
class LineParser {
public:
    explicit LineParser(std::string_view line) : fields_(split(line, ',')) {
        if (fields_.size() != 8) {
            throw std::invalid_argument(fmt::format("it has {} fields instead of 8", fields_.size()));
        }
    }

    GoldenCase parse() const {
        GoldenCase result;
        result.domain =
            choose<Domain>(0, {{"tri", Domain::triangle}, {"quad", Domain::quad}, {"iso", Domain::isoline}});
        result.partitioning = choose<Partitioning>(1, {{"int", Partitioning::integer},
                                                       {"pow2", Partitioning::pow2},
                                                       {"odd", Partitioning::fractional_odd},
                                                       {"even", Partitioning::fractional_even}});
        result.clockwise = choose<bool>(2, {{"cw", true}, {"ccw", false}, {"line", true}});
        const std::vector<std::string_view> factors = split(fields_[3], '|');
        const std::size_t expected = result.domain == Domain::triangle ? 4 : (result.domain == Domain::quad ? 6 : 2);
        if (factors.size() != expected) {
            throw std::invalid_argument(fmt::format("it has {} factors instead of {}", factors.size(), expected));
        }
        for (std::size_t i = 0; i < factors.size(); ++i) {
            result.factors[i] = std::bit_cast<float>(number<std::uint32_t>(factors[i], 16));
        }
        result.point_count = number<std::uint64_t>(fields_[4], 10);
        result.index_count = number<std::uint64_t>(fields_[5], 10);
        result.point_hash = number<std::uint64_t>(fields_[6], 16);
        result.index_hash = number<std::uint64_t>(fields_[7], 16);
        return result;
    }

private:
    template <typename T>
    T choose(std::size_t field, const std::map<std::string_view, T>& values) const {
        const auto found = values.find(fields_[field]);
        if (found == values.end()) {
            throw std::invalid_argument(fmt::format("field {} is \"{}\"", field + 1, fields_[field]));
        }
        return found->second;
    }

    template <typename T>
    static T number(std::string_view text, int base) {
        T value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
        if (error != std::errc() || end != text.data() + text.size()) {
            throw std::invalid_argument(fmt::format("\"{}\" is not a number of base {}", text, base));
        }
        return value;
    }

    std::vector<std::string_view> fields_;
};

GoldenMismatch recompute(const GoldenCase& expected, const Pattern& pattern) {
    GoldenMismatch result{expected, pattern.points.size(), pattern.indices.size(), 0, 0};
    std::vector<std::uint32_t> words;
    words.reserve(pattern.points.size() * 2);
    for (const DomainPoint& point : pattern.points) {
        words.push_back(point.u);
        words.push_back(point.v);
    }
    result.point_hash = fnv1a64(words);
    result.index_hash = fnv1a64(pattern.indices);
    return result;
}

bool matches(const GoldenMismatch& result) {
    const GoldenCase& expected = result.expected;
    return result.point_count == expected.point_count && result.index_count == expected.index_count &&
           result.point_hash == expected.point_hash && result.index_hash == expected.index_hash;
}

}  // namespace

std::vector<GoldenCase> read_golden_file(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) {
        throw Error(ErrorKind::usage, fmt::format("{} cannot be read.", path.string()));
    }
    std::vector<GoldenCase> cases;
    std::string line;
    for (std::size_t number = 1; std::getline(file, line); ++number) {
        if (!line.empty() && line.back() == '\r') {
            line.pop_back();
        }
        if (number == 1 && !line.starts_with("domain,")) {
            throw Error(ErrorKind::usage,
                        fmt::format("{} is no golden file: its first line is not the header that begins "
                                    "with \"domain,\".",
                                    path.string()));
        }
        if (number == 1 || line.empty()) {
            continue;
        }
        try {
            cases.push_back(LineParser(line).parse());
            cases.back().line = number;
        } catch (const std::invalid_argument& reason) {
            throw Error(ErrorKind::usage,
                        fmt::format("{}, line {} is not a golden case: {}.", path.string(), number, reason.what()));
        }
    }
    if (cases.empty()) {
        throw Error(ErrorKind::usage, fmt::format("{} holds no golden cases.", path.string()));
    }
    return cases;
}

std::vector<GoldenMismatch> check_golden_cases(const gpu::Device& device, const std::vector<GoldenCase>& cases) {
    // Cases of one domain, partitioning and topology go through the device together.
    std::map<std::tuple<Domain, Partitioning, bool>, std::vector<const GoldenCase*>> groups;
    for (const GoldenCase& one : cases) {
        groups[{one.domain, one.partitioning, one.clockwise}].push_back(&one);
    }
    std::vector<GoldenMismatch> mismatches;
    for (const auto& [key, group] : groups) {
        const auto [domain, partitioning, clockwise] = key;
        std::vector<PatchFactors> factors;
        for (const GoldenCase* one : group) {
            factors.push_back(one->factors);
        }
        const std::vector<Pattern> patterns = make_patterns(device, domain, partitioning, clockwise, factors);
        for (std::size_t i = 0; i < group.size(); ++i) {
            GoldenMismatch result = recompute(*group[i], patterns[i]);
            if (!matches(result)) {
                mismatches.push_back(result);
            }
        }
    }
    return mismatches;
}

std::string describe(const GoldenMismatch& m) {
    return fmt::format(
        "line {}: {} points (expected {}), {} indices ({}), point hash {:016x} ({:016x}), index hash {:016x} ({:016x})",
        m.expected.line, m.point_count, m.expected.point_count, m.index_count, m.expected.index_count, m.point_hash,
        m.expected.point_hash, m.index_hash, m.expected.index_hash);
}

std::uint64_t fnv1a64(std::span<const std::uint32_t> words) {
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const std::uint32_t word : words) {
        for (int shift = 0; shift < 32; shift += 8) {
            hash = (hash ^ ((word >> shift) & 0xffu)) * 0x100000001b3ull;
        }
    }
    return hash;
}

}  // namespace tessera::verify
