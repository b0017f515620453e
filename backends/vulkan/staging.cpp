#include "backends/vulkan/staging.hpp"

#include <algorithm>

namespace tessera::backends::vulkan {

void Staging::make_room(std::uint64_t begin, std::uint64_t end) {
    const auto taken = [&](const Region& region) { return region.begin < end && begin < region.end; };
    // Regions are freed in order, so that "oldest" stays the front.
    while (std::any_of(regions_.begin(), regions_.end(), taken)) {
        timeline_.wait(regions_.front().serial);
        regions_.pop_front();
    }
    while (!regions_.empty() && timeline_.is_done(regions_.front().serial))
        regions_.pop_front();
}

Staging::Piece Staging::upload(std::uint64_t size) {
    if (!*ring_.buffer) {
        ring_ =
            create_buffer(context_, ring_size, vk::BufferUsageFlagBits::eTransferSrc, MemoryUse::upload, "upload ring");
    }
    // Parts that the device reads and parts that the host writes must not share a unit of non-coherent memory.
    const std::uint64_t unit = std::max<std::uint64_t>(context_.properties.limits.nonCoherentAtomSize, 16);
    const std::uint64_t rounded = (size + unit - 1) / unit * unit;
    if (next_ + rounded > ring_size) next_ = 0;
    make_room(next_, next_ + rounded);
    const Piece piece{*ring_.buffer, next_, ring_.allocation.mapped + next_};
    regions_.push_back({timeline_.current(), next_, next_ + rounded});
    next_ += rounded;
    return piece;
}

void Staging::uploaded(const Piece& piece, std::uint64_t size) {
    flush(context_, ring_.allocation, piece.offset, size);
}

Staging::Piece Staging::readback() {
    if (!*block_.buffer) {
        block_ = create_buffer(context_, piece_size, vk::BufferUsageFlagBits::eTransferDst, MemoryUse::readback,
                               "read-back block");
    }
    return {*block_.buffer, 0, block_.allocation.mapped};
}

void Staging::arrived(std::uint64_t size) {
    invalidate(context_, block_.allocation, 0, size);
}

}  // namespace tessera::backends::vulkan
