// A test against the device's own tessellation stage: skipped where there is none (a failure where everything is
// required), and failed by any message of the validation layer.
#pragma once

#include "support/devices.hpp"
#include "verify/oracle.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace tessera::test {

/// Opens the stage once per suite.
class OracleSuite : public testing::Test {
protected:
    static void SetUpTestSuite();
    static void TearDownTestSuite() { stage_.reset(); }
    void SetUp() override;
    void TearDown() override;

    static verify::FixedFunctionTessellator& stage() { return *stage_; }

private:
    static std::unique_ptr<verify::FixedFunctionTessellator> stage_;
    static std::string missing_;  // why there is none
};

}  // namespace tessera::test
