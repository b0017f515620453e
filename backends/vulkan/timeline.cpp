#include "backends/vulkan/timeline.hpp"

#include <algorithm>
#include <limits>

namespace tessera::backends::vulkan {
namespace {

/// Nothing of ours is waited for with a limit; a device that hangs is reported lost by its driver.
constexpr std::uint64_t forever = std::numeric_limits<std::uint64_t>::max();

/// Device writes must be made visible to the host before the fence, or reading mapped memory after it is a race.
void end_with_host_barrier(const vk::raii::CommandBuffer& commands) {
    using Access = vk::AccessFlagBits;
    using Stage = vk::PipelineStageFlagBits;
    const vk::MemoryBarrier barrier(Access::eShaderWrite | Access::eTransferWrite,
                                    Access::eHostRead | Access::eHostWrite);
    commands.pipelineBarrier(Stage::eComputeShader | Stage::eTransfer, Stage::eHost, {}, barrier, {}, {});
    commands.end();
}

}  // namespace

Timeline::Timeline(const Context& context) : context_(context) {
    for (Slot& slot : slots_) {
        slot.pool = vk::raii::CommandPool(
            context.device, vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eTransient, context.queue_family));
        const vk::CommandBufferAllocateInfo info(*slot.pool, vk::CommandBufferLevel::ePrimary, 1);
        slot.commands = std::move(vk::raii::CommandBuffers(context.device, info).front());
        slot.done = vk::raii::Fence(context.device, vk::FenceCreateInfo());
    }
}

void Timeline::drain() noexcept {
    try {
        context_.device.waitIdle();
    } catch (const vk::SystemError&) {
        // The device is lost: nothing runs any more, and everything may go.
    }
}

const vk::raii::CommandBuffer& Timeline::recording() {
    Slot& next = slot(current());
    if (!open_) {
        if (current() > slots_.size()) wait(current() - slots_.size());
        next.pool.reset();
        next.commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
        open_ = true;
    }
    return next.commands;
}

void Timeline::submit() {
    if (!open_) return;
    open_ = false;
    Slot& next = slot(current());
    end_with_host_barrier(next.commands);
    context_.device.resetFences(*next.done);
    context_.queue.submit(vk::SubmitInfo({}, {}, *next.commands), *next.done);
    ++submitted_;
    poll();
}

bool Timeline::is_done(Serial serial) {
    if (serial > done_) poll();
    return serial <= done_;
}

void Timeline::wait(Serial serial) {
    if (serial > submitted_) submit();
    if (serial > done_) {
        const vk::Result result = context_.device.waitForFences(*slot(serial).done, VK_TRUE, forever);
        if (result != vk::Result::eSuccess) throw vk::SystemError(vk::make_error_code(result));
        done_ = serial;  // one queue: all earlier ones are done as well
    }
    poll();
}

void Timeline::keep_until(Serial serial, std::shared_ptr<void> thing) noexcept {
    try {
        if (!is_done(serial)) kept_.push_back({serial, std::move(thing)});
    } catch (const vk::SystemError&) {
        // The device is lost: nothing runs any more, and the thing may go.
    }
}

void Timeline::poll() {
    while (done_ < submitted_ && slot(done_ + 1).done.getStatus() == vk::Result::eSuccess)
        ++done_;
    std::erase_if(kept_, [&](const Kept& one) { return one.serial <= done_; });
}

}  // namespace tessera::backends::vulkan
