// What every object of one opened device shares.
#pragma once

#include "backends/opencl/opencl_inventory.hpp"

namespace tessera::backends::opencl {

/// One device with its context and its one in-order queue, which records times where the device can.
struct Session {
    const Api& api;
    FoundDevice found;
    ContextHandle context;
    QueueHandle queue;

    /// Throws Error(device_unavailable) naming the device, unless `code` is CL_SUCCESS.
    void check(cl_int code, const std::string& action) const {
        if (code != CL_SUCCESS) {
            opencl::check(code, action + " on " + found.info.id + " (" + found.info.name + ")");
        }
    }
};

/// Makes the context and the queue. Throws Error(device_unavailable) where the driver refuses.
Session open_session(const Api& api, FoundDevice found);

}  // namespace tessera::backends::opencl
