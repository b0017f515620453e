#include "backends/reference/run_commands.hpp"

#include "backends/reference/objects.hpp"
#include "kernels/dialect.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cstring>

namespace tessera::backends::reference {

namespace {

static_assert(gpu::workgroup_size == WORKGROUP_SIZE);

/// Bytes that one thread copies or fills at a time: more than waking a thread costs, less than a cache.
constexpr std::uint64_t memory_block = 1ull << 20;

template <typename Body>
void for_each_memory_block(std::uint64_t size, const Body& body) {
    if (size <= memory_block) {
        body(std::uint64_t{0}, size);
        return;
    }
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::uint64_t>(0, size / memory_block + (size % memory_block != 0), 1),
        [&](const auto& blocks) { body(blocks.begin() * memory_block, std::min(blocks.end() * memory_block, size)); });
}

/// Items are independent, so the result does not depend on how the range is cut. A single group, the common size of a
/// scan's upper levels, stays on this thread.
void run_items(const gpu::Kernel& kernel, const Slots& slots, std::uint32_t items) {
    if (items <= gpu::workgroup_size) {
        kernel.reference(0, items, slots.data());
        return;
    }
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::uint32_t>(0, items / gpu::workgroup_size), [&](const auto& groups) {
            kernel.reference(groups.begin() * gpu::workgroup_size, groups.end() * gpu::workgroup_size, slots.data());
        });
}

void dispatch(const gpu::BackendObject& pipeline, const gpu::BackendObject& bind_group, std::uint32_t uniform_offset,
              std::uint32_t groups_x, std::uint32_t groups_y) {
    const auto& group = static_cast<const BindGroup&>(bind_group);
    Slots slots = group.slots;
    if (group.uniform_slot) {
        slots[*group.uniform_slot] += uniform_offset;
    }
    run_items(static_cast<const Pipeline&>(pipeline).kernel, slots, groups_x * groups_y * gpu::workgroup_size);
}

std::byte* memory_of(gpu::BackendObject* buffer) {
    return static_cast<Buffer*>(buffer)->memory;
}

struct Runner {
    const gpu::Limits& limits;

    void operator()(const gpu::Dispatch& c) const {
        dispatch(*c.pipeline, *c.bind_group, c.uniform_offset, c.groups_x, c.groups_y);
    }

    void operator()(const gpu::DispatchIndirect& c) const {
        std::array<std::uint32_t, 3> groups;
        std::memcpy(groups.data(), memory_of(c.arguments) + c.arguments_offset, sizeof(groups));
        const auto [x, y, z] = groups;
        const std::uint32_t most = limits.max_workgroups_per_dimension;
        const bool countable = std::uint64_t{x} * y <= UINT32_MAX / gpu::workgroup_size;
        if (x != 0 && y != 0 && z == 1 && x <= most && y <= most && countable) {
            dispatch(*c.pipeline, *c.bind_group, c.uniform_offset, x, y);
        }
    }

    void operator()(const gpu::CopyBuffer& c) const {
        const std::byte* source = memory_of(c.source) + c.source_offset;
        std::byte* destination = memory_of(c.destination) + c.destination_offset;
        for_each_memory_block(c.size, [&](std::uint64_t first, std::uint64_t last) {
            std::memcpy(destination + first, source + first, last - first);
        });
    }

    void operator()(const gpu::FillBuffer& c) const { fill_memory(memory_of(c.buffer) + c.offset, c.size, c.value); }

    void operator()(const gpu::WriteTimestamp& c) const {
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        static_cast<QuerySet*>(c.query_set)->nanoseconds[c.index] =
            static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
    }

    void operator()(const gpu::ResolveQuerySet& c) const {
        const auto& nanoseconds = static_cast<QuerySet*>(c.query_set)->nanoseconds;
        std::memcpy(memory_of(c.destination) + c.offset, nanoseconds.data() + c.first, c.count * sizeof(std::uint64_t));
    }
};

}  // namespace

void fill_memory(std::byte* memory, std::uint64_t size, std::uint32_t value) {
    for_each_memory_block(size, [&](std::uint64_t first, std::uint64_t last) {
        std::fill(reinterpret_cast<std::uint32_t*>(memory + first), reinterpret_cast<std::uint32_t*>(memory + last),
                  value);
    });
}

void run_commands(std::span<const gpu::Command> commands, const gpu::Limits& limits) {
    for (const gpu::Command& command : commands) {
        std::visit(Runner{limits}, command);
    }
}

}  // namespace tessera::backends::reference
