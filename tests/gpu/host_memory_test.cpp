#include "base/host_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <new>

namespace tessera {
namespace {

TEST(HostMemory, IsZeroAndStartsOnAPage) {
    // Without and with huge pages, whole ones and not.
    for (const std::size_t size : {std::size_t{1}, std::size_t{5000}, (std::size_t{2} << 20) - 1, std::size_t{2} << 20,
                                   (std::size_t{5} << 20) + 3}) {
        const HostMemory memory(size);
        ASSERT_EQ(memory.size(), size);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory.data()) % 4096, 0u);
        EXPECT_TRUE(std::all_of(memory.data(), memory.data() + size, [](std::byte b) { return b == std::byte{0}; }));
        std::fill_n(memory.data(), size, std::byte{0x5a});
    }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)  // the sanitizer ends the program instead
TEST(HostMemory, ThatCannotBeHadIsRefused) {
    EXPECT_THROW(HostMemory(SIZE_MAX), std::bad_alloc);
    EXPECT_THROW(HostMemory(SIZE_MAX / 4), std::bad_alloc);
}
#endif

}  // namespace
}  // namespace tessera
