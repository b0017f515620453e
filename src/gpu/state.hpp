// What the handles of device.hpp point to. For the shared code of this room only.
//
// Lifetimes: a device owns its backend and its pipelines; every other object owns the device, so the backend goes last
// whatever the order in which handles are dropped. Command buffers own what they use until they are submitted.
#pragma once

#include "gpu/device.hpp"

#include <map>

namespace tessera::gpu::detail {

struct PipelineState {
    DeviceState* device = nullptr;  // its owner; handles own the device instead
    Kernel kernel;
    std::unique_ptr<BackendObject> object;
};

struct DeviceState {
    std::unique_ptr<Backend> backend;
    std::map<std::string, std::unique_ptr<PipelineState>, std::less<>> pipelines;  // by name of the kernel
    std::uint64_t recordings = 0;                                                  // made so far; numbers them from 1
    Traffic traffic;
};

struct BufferState {
    std::shared_ptr<DeviceState> device;
    BufferDescriptor descriptor;
    std::unique_ptr<BackendObject> object;  // null once destroyed
    std::uint64_t held_by = 0;              // the last recording that holds this object, so that it is held once
};

struct BindGroupState {
    std::shared_ptr<DeviceState> device;
    const PipelineState* pipeline = nullptr;
    std::vector<std::shared_ptr<BufferState>> buffers;  // by slot
    std::optional<std::uint32_t> uniform_slot;
    std::uint64_t largest_uniform_offset = 0;  // what a dispatch may add before the binding leaves its buffer
    std::unique_ptr<BackendObject> object;
    std::uint64_t held_by = 0;
};

struct QuerySetState {
    std::shared_ptr<DeviceState> device;
    std::uint32_t count = 0;
    std::unique_ptr<BackendObject> object;
    std::vector<bool> written;  // by commands submitted so far
};

/// How a recording uses a query set. A timestamp that nobody wrote must not be resolved: Vulkan would wait for ever.
struct QueryUse {
    std::shared_ptr<QuerySetState> set;
    std::vector<bool> written;  // by this recording
    std::vector<bool> awaited;  // resolved here before this recording writes it: an earlier submit must have
};

/// Commands and the objects that they use.
struct Recording {
    std::uint64_t number = 0;
    std::vector<Command> commands;
    std::vector<std::shared_ptr<BufferState>> buffers;
    std::vector<std::shared_ptr<BindGroupState>> bind_groups;
    std::vector<QueryUse> queries;

    /// Adds `object` to `list` unless this recording holds it already.
    template <typename State>
    void hold(std::vector<std::shared_ptr<State>>& list, const std::shared_ptr<State>& object) {
        if (object->held_by != number) {
            list.push_back(object);
            object->held_by = number;
        }
    }
};

struct EncoderState {
    std::shared_ptr<DeviceState> device;
    Recording recording;
    bool finished = false;
    std::uint32_t passes = 0;     // begun so far; numbers them from 1
    std::uint32_t open_pass = 0;  // 0: none
    const PipelineState* pipeline = nullptr;
    const BindGroupState* bind_group = nullptr;
    std::uint32_t uniform_offset = 0;
};

struct CommandBufferState {
    std::shared_ptr<DeviceState> device;
    Recording recording;
    bool submitted = false;
};

}  // namespace tessera::gpu::detail
