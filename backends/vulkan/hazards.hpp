// Decides where a barrier is needed. A barrier here orders everything before it with everything after it; epochs count
// barriers, and a buffer remembers in which epoch it was last read and written. A command needs a barrier where it
// reads what was written, or writes what was read or written, in the epoch that still runs. The epoch runs on from one
// submission to the next, as a barrier reaches back over all work submitted earlier.
#pragma once

#include <cstdint>
#include <span>

namespace tessera::backends::vulkan {

/// Lives in each buffer. Whole buffers are tracked, not ranges of them.
struct LastAccess {
    std::uint64_t read_epoch = 0;
    std::uint64_t write_epoch = 0;
};

struct BufferAccess {
    LastAccess* target;
    bool writes;
};

class Hazards {
public:
    /// Notes the accesses of the next command; true where a barrier must come before it.
    bool next_command(std::span<const BufferAccess> accesses) {
        bool conflict = false;
        for (const BufferAccess& access : accesses) {
            conflict |= access.target->write_epoch == epoch_ || (access.writes && access.target->read_epoch == epoch_);
        }
        if (conflict) ++epoch_;
        for (const BufferAccess& access : accesses) {
            (access.writes ? access.target->write_epoch : access.target->read_epoch) = epoch_;
        }
        return conflict;
    }

private:
    std::uint64_t epoch_ = 1;  // 0 in LastAccess: never
};

}  // namespace tessera::backends::vulkan
