// The recorded patterns of the fixed-function tessellator, on every device: all cases by hash, the small ones in full.
#include "verify/golden.hpp"
#include "support/devices.hpp"
#include "support/environment.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace tessera {
namespace {

class Golden : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(Golden, EveryCaseHasItsHash) {
    TESSERA_SHARED_OR_SKIP(shared);
    const std::vector<verify::GoldenCase> cases = verify::read_golden_file(shared / "golden/tessellator.csv");
    EXPECT_GE(cases.size(), 2900u);
    const std::vector<verify::GoldenMismatch> mismatches =
        verify::check_golden_cases(test::open_device(GetParam().id), cases);
    EXPECT_EQ(mismatches.size(), 0u) << "the first: " << describe(mismatches.front());
}

struct Listing {
    std::string title;
    Domain domain;
    Partitioning partitioning;
    bool clockwise = true;
    PatchFactors factors{};
    std::vector<std::uint32_t> points, indices;
};

std::vector<std::uint32_t> numbers(const std::string& line) {
    std::string text = line.substr(line.find(' ') == std::string::npos ? line.size() : line.find(' '));
    std::ranges::replace(text, ',', ' ');
    std::istringstream in(text);
    return {std::istream_iterator<std::uint32_t>(in), {}};
}

std::vector<Listing> read_listings(const std::filesystem::path& path) {
    const std::map<std::string, Domain> domains{
        {"tri", Domain::triangle}, {"quad", Domain::quad}, {"iso", Domain::isoline}, {"isoline", Domain::isoline}};
    const std::map<std::string, Partitioning> partitionings{{"int", Partitioning::integer},
                                                            {"integer", Partitioning::integer},
                                                            {"pow2", Partitioning::pow2},
                                                            {"odd", Partitioning::fractional_odd},
                                                            {"fractional_odd", Partitioning::fractional_odd},
                                                            {"even", Partitioning::fractional_even},
                                                            {"fractional_even", Partitioning::fractional_even}};
    std::ifstream file(path);
    std::vector<Listing> listings;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("case ")) {
            std::istringstream words(line);
            std::string word, domain, partitioning, topology;
            words >> word >> domain >> partitioning >> topology;
            Listing listing{line, domains.at(domain), partitionings.at(partitioning), topology != "ccw", {}, {}, {}};
            for (std::size_t i = 0; words >> word && i < 6; ++i) {
                listing.factors[i] = std::strtof(word.c_str(), nullptr);
            }
            listings.push_back(listing);
        } else if (line.starts_with("points") && !listings.empty()) {
            listings.back().points = numbers(line);
        } else if (line.starts_with("indices") && !listings.empty()) {
            listings.back().indices = numbers(line);
        }
    }
    return listings;
}

TEST_P(Golden, SmallCasesMatchInFull) {
    TESSERA_SHARED_OR_SKIP(shared);
    const std::vector<Listing> listings = read_listings(shared / "golden/tessellator-small.txt");
    EXPECT_GE(listings.size(), 100u);
    for (const Listing& listing : listings) {
        SCOPED_TRACE(listing.title);
        const Pattern found = make_patterns(test::open_device(GetParam().id), listing.domain, listing.partitioning,
                                            listing.clockwise, std::span(&listing.factors, 1))
                                  .front();
        std::vector<std::uint32_t> points;
        for (const DomainPoint& point : found.points) {
            points.insert(points.end(), {point.u, point.v});
        }
        EXPECT_EQ(points, listing.points);
        EXPECT_EQ(found.indices, listing.indices);
    }
}

TESSERA_ON_EVERY_DEVICE(Golden);

}  // namespace
}  // namespace tessera
