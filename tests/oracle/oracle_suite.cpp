#include "oracle/oracle_suite.hpp"

#include "backends/vulkan/validation.hpp"
#include "base/error.hpp"
#include "support/environment.hpp"

namespace tessera::test {

std::unique_ptr<verify::FixedFunctionTessellator> OracleSuite::stage_;
std::string OracleSuite::missing_;

void OracleSuite::SetUpTestSuite() {
    try {
        stage_ = backends::open_fixed_function();
    } catch (const Error& refusal) {
        missing_ = refusal.what();
    }
}

void OracleSuite::SetUp() {
    if (stage_) {
        return;
    }
    if (everything_required()) {
        FAIL() << missing_;
    }
    GTEST_SKIP() << missing_;
}

void OracleSuite::TearDown() {
    for (const std::string& message : backends::vulkan::take_validation_messages()) {
        ADD_FAILURE() << message;
    }
}

}  // namespace tessera::test
