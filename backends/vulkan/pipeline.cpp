#include "backends/vulkan/pipeline.hpp"

#include "backends/vulkan/errors.hpp"

namespace tessera::backends::vulkan {
namespace {

vk::DescriptorType descriptor_type(gpu::BindingKind kind) {
    return kind == gpu::BindingKind::uniform ? vk::DescriptorType::eUniformBufferDynamic
                                             : vk::DescriptorType::eStorageBuffer;
}

vk::raii::DescriptorPool create_pool(const Context& context) {
    // A kernel has a uniform and a handful of storage buffers; a set that does not fit opens the next pool early.
    constexpr std::uint32_t sets = 64;
    const std::array sizes = {vk::DescriptorPoolSize(vk::DescriptorType::eStorageBuffer, sets * 8),
                              vk::DescriptorPoolSize(vk::DescriptorType::eUniformBufferDynamic, sets)};
    return {context.device,
            vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, sets, sizes)};
}

std::optional<vk::raii::DescriptorSet> try_allocate(const Context& context, const vk::raii::DescriptorPool& pool,
                                                    const vk::raii::DescriptorSetLayout& layout) {
    try {
        vk::raii::DescriptorSets sets(context.device, vk::DescriptorSetAllocateInfo(*pool, *layout));
        return std::move(sets.front());
    } catch (const vk::OutOfPoolMemoryError&) {
        return std::nullopt;
    } catch (const vk::FragmentedPoolError&) {
        return std::nullopt;
    }
}

}  // namespace

std::unique_ptr<Pipeline> create_pipeline(const Context& context, Timeline& timeline, const PipelineCache& cache,
                                          const gpu::Kernel& kernel) {
    if (kernel.spirv.empty()) {
        throw Error(ErrorKind::usage,
                    fmt::format("The kernel '{}' has no SPIR-V and cannot run on Vulkan.", kernel.name));
    }
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (const gpu::KernelBinding& binding : kernel.bindings) {
        bindings.emplace_back(binding.slot, descriptor_type(binding.kind), 1, vk::ShaderStageFlagBits::eCompute);
    }
    return guarded(fmt::format("compiling the kernel '{}'", kernel.name), [&] {
        PipelineHandles made;
        made.set_layout =
            vk::raii::DescriptorSetLayout(context.device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
        made.layout = vk::raii::PipelineLayout(context.device, vk::PipelineLayoutCreateInfo({}, *made.set_layout));
        const vk::raii::ShaderModule shader(context.device, vk::ShaderModuleCreateInfo({}, kernel.spirv));
        const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main");
        made.pipeline =
            vk::raii::Pipeline(context.device, cache.handle(), vk::ComputePipelineCreateInfo({}, stage, *made.layout));
        set_name(context, made.pipeline, kernel.name);
        return std::make_unique<Pipeline>(timeline, std::move(made), kernel.name, kernel.bindings);
    });
}

vk::raii::DescriptorSet DescriptorPools::allocate(const vk::raii::DescriptorSetLayout& layout) {
    // The newest pool is the one most likely to have room.
    for (auto pool = pools_.rbegin(); pool != pools_.rend(); ++pool) {
        if (auto set = try_allocate(context_, *pool, layout)) return std::move(*set);
    }
    pools_.push_back(create_pool(context_));
    if (auto set = try_allocate(context_, pools_.back(), layout)) return std::move(*set);
    throw Error(ErrorKind::device_unavailable,
                fmt::format("The Vulkan device '{}' has no room for a descriptor set in a new pool; the kernel has "
                            "too many bindings.",
                            context_.properties.deviceName.data()));
}

std::unique_ptr<BindGroup> create_bind_group(const Context& context, Timeline& timeline, DescriptorPools& pools,
                                             Pipeline& pipeline, std::span<const gpu::BoundBuffer> resources) {
    return guarded(fmt::format("binding buffers for the kernel '{}'", pipeline.name), [&] {
        auto group = std::make_unique<BindGroup>(timeline, pools.allocate(pipeline.vulkan->set_layout));
        std::vector<vk::DescriptorBufferInfo> infos;
        infos.reserve(resources.size());  // the writes point into it
        std::vector<vk::WriteDescriptorSet> writes;
        for (std::size_t i = 0; i < resources.size(); ++i) {
            const gpu::KernelBinding& binding = pipeline.bindings[i];
            auto& buffer = static_cast<Buffer&>(*resources[i].buffer);
            group->buffers.push_back(&buffer);
            group->accesses.push_back({&buffer.last_access, binding.kind == gpu::BindingKind::write_storage});
            group->uniforms += binding.kind == gpu::BindingKind::uniform ? 1 : 0;
            infos.emplace_back(*buffer.vulkan->buffer, resources[i].offset, resources[i].size);
            writes.emplace_back(*group->vulkan.get(), binding.slot, 0, 1, descriptor_type(binding.kind), nullptr,
                                &infos.back());
        }
        context.device.updateDescriptorSets(writes, nullptr);
        return group;
    });
}

}  // namespace tessera::backends::vulkan
