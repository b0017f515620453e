// Kernels that do not build are refused with the compiler's words.
#include "opencl/opencl_fixture.hpp"

#include "base/error.hpp"

namespace tessera::test {
namespace {

class OpenClPipelineTest : public OpenClTest {
protected:
    // The error that making the pipeline throws; empty where it does not throw.
    std::string refusal(const gpu::Kernel& kernel, ErrorKind expected) {
        try {
            device->create_pipeline(kernel);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), expected);
            return error.what();
        }
        return "";
    }
};

TEST_F(OpenClPipelineTest, ABuildErrorGivesTheLog) {
    const std::string reason =
        refusal(opencl_kernel("wrong", {{0, BindingKind::write_storage, 4}},
                              "__kernel void wrong(__global float* restrict out) { out[0] = undeclared_name; }\n"),
                ErrorKind::device_unavailable);
    EXPECT_NE(reason.find("\"wrong\""), std::string::npos) << reason;
    EXPECT_NE(reason.find("opencl:0"), std::string::npos) << reason;
    EXPECT_NE(reason.find("undeclared_name"), std::string::npos) << reason;
}

TEST_F(OpenClPipelineTest, AKernelOfAnotherNameIsRefused) {
    gpu::Kernel kernel = scale_kernel();
    kernel.name = "other";
    const std::string reason = refusal(kernel, ErrorKind::device_unavailable);
    EXPECT_NE(reason.find("\"other\""), std::string::npos) << reason;
    EXPECT_NE(reason.find("CL_INVALID_KERNEL_NAME"), std::string::npos) << reason;
}

TEST_F(OpenClPipelineTest, BindingsThatDoNotFitTheSourceAreRefused) {
    gpu::Kernel kernel = scale_kernel();
    kernel.bindings.pop_back();
    const std::string reason = refusal(kernel, ErrorKind::usage);
    EXPECT_NE(reason.find("3 arguments"), std::string::npos) << reason;
}

}  // namespace
}  // namespace tessera::test
