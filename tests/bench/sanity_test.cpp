// What makes the bench doubt itself.
#include "bench/sanity.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace tessera::bench {
namespace {

constexpr WriteRoof roof{50e9, 256ull << 20};

TEST(Sanity, AFigureAboveTheRoofIsRejected) {
    const std::uint64_t bytes = 250'000'000;
    EXPECT_EQ(beats_roof(bytes, 0.0051, roof), "");
    const std::string reason = beats_roof(bytes, 0.0049, roof);
    EXPECT_NE(reason.find("51.0 GB/s"), std::string::npos) << reason;
    EXPECT_NE(beats_roof(bytes, 0.0, roof), "");
}

TEST(Sanity, WhatFitsACacheIsNotHeldAgainstTheRoof) {
    EXPECT_EQ(beats_roof(1 << 20, 1e-9, roof), "");
    EXPECT_EQ(beats_roof(250'000'000, 1e-9, {}), "");
}

TEST(Sanity, CountsWhatStillHoldsTheSentinel) {
    EXPECT_EQ(count_unwritten(std::vector<std::uint32_t>{1, sentinel, 3, sentinel}), 2u);
    EXPECT_EQ(count_unwritten({}), 0u);
}

TEST(Sanity, TheHashIsThatOfTheWholeHoweverItIsCut) {
    const std::vector<std::uint32_t> words{1, 2, 3, 4, 5};
    const std::span all(words);
    const std::uint64_t whole = hash_words(all, hash_start);
    EXPECT_EQ(hash_words(all.subspan(2), hash_words(all.first(2), hash_start)), whole);
    EXPECT_NE(hash_words(std::vector<std::uint32_t>{1, 2, 3, 5, 4}, hash_start), whole);
}

}  // namespace
}  // namespace tessera::bench
