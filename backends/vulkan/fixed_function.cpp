#include "backends/vulkan/fixed_function.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "backends/vulkan/device_info.hpp"
#include "backends/vulkan/errors.hpp"
#include "backends/vulkan/fixed_function_capture.hpp"

namespace tessera::backends::vulkan {
namespace {

using verify::CapturedPatch;

/// A captured vertex as fixed_function.tese writes it; without a surface it ends after the patch number.
struct CapturedVertex {
    verify::Triple coordinate;
    std::uint32_t patch;
    verify::CapturedPoint point;
};
static_assert(sizeof(CapturedVertex) == OracleCapture::surface_stride);
static_assert(offsetof(CapturedVertex, point) == OracleCapture::domain_stride);

/// Everything that stands against a device, a clause each.
std::vector<std::string> oracle_objections(const vk::raii::PhysicalDevice& physical, const gpu::DeviceInfo& info) {
    std::vector<std::string> found;
    if (!info.rasteriser) found.emplace_back("it has no graphics queue");
    if (!info.tessellation_stage) found.emplace_back("it has no tessellation stage (tessellationShader)");
    if (!info.transform_feedback) {
        found.emplace_back("it has no " VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME);
        return found;
    }
    using Features = vk::PhysicalDeviceTransformFeedbackFeaturesEXT;
    using Properties = vk::PhysicalDeviceTransformFeedbackPropertiesEXT;
    const auto features = physical.getFeatures2<vk::PhysicalDeviceFeatures2, Features>().get<Features>();
    const auto properties = physical.getProperties2<vk::PhysicalDeviceProperties2, Properties>().get<Properties>();
    if (!features.transformFeedback) found.emplace_back("its transformFeedback is off");
    if (!properties.transformFeedbackQueries) found.emplace_back("it does not count what it captures");
    return found;
}

class VulkanFixedFunction final : public verify::FixedFunctionTessellator {
public:
    VulkanFixedFunction(Context context, gpu::DeviceInfo info) : context_(std::move(context)), info_(std::move(info)) {}

    const gpu::DeviceInfo& info() const override { return info_; }

    std::vector<CapturedPatch> tessellate(Domain domain, Partitioning partitioning, bool clockwise,
                                          std::span<const PatchFactors> factors) override {
        OracleVariant variant;
        variant.domain = domain;
        variant.partitioning = partitioning;
        variant.clockwise = clockwise;
        return run(variant, 0.0f, factors, {});
    }

    std::vector<CapturedPatch> evaluate(const verify::CapturedSurface& surface, Partitioning partitioning,
                                        std::span<const PatchFactors> factors,
                                        std::span<const Vertex> corners) override {
        assert(corners.size() == 3 * factors.size());
        const OracleVariant variant{Domain::triangle, partitioning, true, true, surface.scheme, surface.normals};
        return run(variant, surface.alpha, factors, corners);
    }

private:
    std::vector<CapturedPatch> run(const OracleVariant& variant, float alpha, std::span<const PatchFactors> factors,
                                   std::span<const Vertex> corners) {
        if (variant.partitioning == Partitioning::pow2 || variant.partitioning == Partitioning::uniform) {
            throw Error(ErrorKind::usage,
                        fmt::format("The tessellation stage of Vulkan has no spacing for the partitioning {}; choose "
                                    "integer, fractional_odd or fractional_even.",
                                    name(variant.partitioning)));
        }
        std::vector<CapturedPatch> patches(factors.size());
        constexpr std::size_t most = OracleCapture::run_patches;
        for (std::size_t first = 0; first < factors.size(); first += most) {
            const std::size_t count = std::min(most, factors.size() - first);
            const auto bytes = capture_.run(variant, alpha, factors.subspan(first, count),
                                            variant.surface ? corners.subspan(3 * first, 3 * count) : corners);
            append(variant, bytes, std::span(patches).subspan(first, count));
        }
        return patches;
    }

    /// Sorts captured vertices by the patch that they name.
    void append(const OracleVariant& variant, std::span<const std::byte> bytes, std::span<CapturedPatch> patches) {
        const std::size_t stride = variant.surface ? OracleCapture::surface_stride : OracleCapture::domain_stride;
        for (; !bytes.empty(); bytes = bytes.subspan(stride)) {
            CapturedVertex vertex;
            std::memcpy(&vertex, bytes.data(), stride);
            if (vertex.patch >= patches.size()) {
                throw Error(ErrorKind::device_unavailable,
                            fmt::format("The tessellation stage of '{}' captured a vertex of patch {} where there are "
                                        "{}; its driver cannot serve as an oracle.",
                                        info_.name, vertex.patch, patches.size()));
            }
            patches[vertex.patch].coordinates.push_back(vertex.coordinate);
            if (variant.surface) patches[vertex.patch].points.push_back(vertex.point);
        }
    }

    Context context_;
    gpu::DeviceInfo info_;
    OraclePipelines pipelines_{context_};
    OracleCapture capture_{context_, pipelines_};
};

}  // namespace

std::unique_ptr<verify::FixedFunctionTessellator> open_fixed_function(std::size_t index) {
    std::shared_ptr<const Instance> instance = shared_instance();
    vk::raii::PhysicalDevice physical = usable_device(*instance, index);
    gpu::DeviceInfo info = guarded("describing a device", [&] { return describe(physical, index); });
    const std::vector<std::string> against = oracle_objections(physical, info);
    if (!against.empty()) {
        throw Error(ErrorKind::device_unavailable, fmt::format("The tessellation stage of '{}' cannot be captured: {}.",
                                                               info.name, fmt::join(against, "; ")));
    }
    const std::array extensions = {VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME};
    const vk::PhysicalDeviceTransformFeedbackFeaturesEXT feedback(VK_TRUE);
    vk::PhysicalDeviceFeatures wanted;
    wanted.tessellationShader = VK_TRUE;
    Context context = create_context(std::move(instance), std::move(physical), wanted, extensions, &feedback);
    return std::make_unique<VulkanFixedFunction>(std::move(context), std::move(info));
}

}  // namespace tessera::backends::vulkan
