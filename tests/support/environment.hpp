// What tests ask of the machine: the shared test data, and which devices must be there.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace tessera::test {

/// The folder of shared models and vectors (TESSERA_SHARED, default ../shared beside the project), if it is there.
inline std::optional<std::filesystem::path> shared_folder() {
    const char* set = std::getenv("TESSERA_SHARED");
    const std::filesystem::path folder =
        set != nullptr ? std::filesystem::path(set) : std::filesystem::path(TESSERA_SOURCE_DIR) / ".." / "shared";
    if (std::filesystem::is_directory(folder)) {
        return std::filesystem::canonical(folder);
    }
    return std::nullopt;
}

/// True in CI, where everything optional is required: a missing device or data folder fails instead of skipping.
inline bool everything_required() {
    return std::getenv("TESSERA_REQUIRE_ALL") != nullptr;
}

}  // namespace tessera::test

/// Names the shared folder `variable`, or skips the test with a message (fails where everything is required).
#define TESSERA_SHARED_OR_SKIP(variable)                                                                        \
    const auto variable##_found = tessera::test::shared_folder();                                               \
    if (!variable##_found) {                                                                                    \
        if (tessera::test::everything_required()) FAIL() << "the shared test data is missing (TESSERA_SHARED)"; \
        GTEST_SKIP() << "needs the shared test data: set TESSERA_SHARED to its folder";                         \
    }                                                                                                           \
    const std::filesystem::path variable = *variable##_found
