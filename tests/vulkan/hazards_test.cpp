// Where the backend places barriers.
#include "backends/vulkan/hazards.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace tessera::backends::vulkan {
namespace {

bool next(Hazards& hazards, std::vector<BufferAccess> accesses) {
    return hazards.next_command(accesses);
}

TEST(VulkanHazards, ReadsDoNotWaitForReads) {
    Hazards hazards;
    LastAccess a, b;
    EXPECT_FALSE(next(hazards, {{&a, false}, {&b, true}}));
    EXPECT_FALSE(next(hazards, {{&a, false}}));
}

TEST(VulkanHazards, EachConflictWaitsOnce) {
    const std::array conflicts = {std::pair(true, false), std::pair(false, true), std::pair(true, true)};
    for (const auto& [first, second] : conflicts) {
        Hazards hazards;
        LastAccess a, b;
        EXPECT_FALSE(next(hazards, {{&a, first}}));
        EXPECT_FALSE(next(hazards, {{&b, second}}));
        EXPECT_TRUE(next(hazards, {{&a, second}})) << first << second;
        EXPECT_FALSE(next(hazards, {{&b, true}})) << "the barrier served all buffers";
    }
}

// Against a slow model: every pair of conflicting commands has a barrier between them, and each barrier was needed.
RC_GTEST_PROP(VulkanHazards, BarriersAreEnoughAndNeeded, ()) {
    Hazards hazards;
    std::array<LastAccess, 4> buffers;
    std::set<std::size_t> read, written;  // since the last barrier
    const auto count = *rc::gen::inRange(1, 60);
    for (int i = 0; i < count; ++i) {
        const auto target = *rc::gen::inRange<std::size_t>(0, buffers.size());
        const auto source = *rc::gen::inRange<std::size_t>(0, buffers.size());
        std::vector<BufferAccess> accesses = {{&buffers[target], true}};
        if (source != target) accesses.push_back({&buffers[source], false});
        const bool needed = written.contains(target) || read.contains(target) || written.contains(source);
        RC_ASSERT(hazards.next_command(accesses) == needed);
        if (needed) {
            read.clear();
            written.clear();
        }
        written.insert(target);
        if (source != target) read.insert(source);
    }
}

}  // namespace
}  // namespace tessera::backends::vulkan
