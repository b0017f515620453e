#include "bench/contest.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <thread>

namespace tessera::bench {
namespace {

TEST(Interleave, TakesTurnsAfterWarmingUp) {
    std::string order;
    std::vector<Contestant> contestants;
    contestants.push_back({"a", [&] { order += 'A'; }});
    contestants.push_back({"b", [&] { order += 'B'; }});
    interleave(contestants, {3, 1, 10.0, 0.0});
    EXPECT_EQ(order, "ABABABAB");
    EXPECT_EQ(contestants[0].seconds.size(), 3u);
    EXPECT_EQ(contestants[1].seconds.size(), 3u);
}

TEST(Interleave, TurnsBeginWithRunsThatAreNotTimed) {
    std::string order;
    std::vector<Contestant> contestants;
    contestants.push_back({"a", [&] { order += 'A'; }});
    contestants.push_back({"b", [&] { order += 'B'; }});
    interleave(contestants, {2, 0, 10.0, 1e-5});
    EXPECT_EQ(contestants[0].seconds.size(), 2u);
    EXPECT_EQ(order.find("AA"), 0u);
    order.erase(std::unique(order.begin(), order.end()), order.end());
    EXPECT_EQ(order, "ABAB");
}

TEST(Interleave, LooksAtResultsOffTheClock) {
    int looked = 0;
    std::vector<Contestant> contestants;
    contestants.push_back({"a", [] {}, [&] { ++looked; }});
    interleave(contestants, {4, 2, 10.0});
    EXPECT_EQ(looked, 5);  // once after warming up
}

TEST(Interleave, WhoeverUsedUpItsTimeSitsOut) {
    std::vector<Contestant> contestants;
    contestants.push_back({"slow", [] { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }});
    contestants.push_back({"fast", [] {}});
    interleave(contestants, {20, 0, 0.001});
    EXPECT_EQ(contestants[0].seconds.size(), 3u);
    EXPECT_EQ(contestants[1].seconds.size(), 20u);
}

}  // namespace
}  // namespace tessera::bench
