// The one order in which work reaches the device: numbered submissions, recorded one at a time, run asynchronously.
// A small ring of command buffers and fences is reused; what the user destroys is kept until its last submission ends.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "backends/vulkan/context.hpp"

namespace tessera::backends::vulkan {

class Timeline {
public:
    /// The number of a submission, counted from 1. 0 is done before anything starts.
    using Serial = std::uint64_t;

    explicit Timeline(const Context& context);
    ~Timeline() { drain(); }
    Timeline(const Timeline&) = delete;
    Timeline& operator=(const Timeline&) = delete;

    /// The open command buffer, begun where there is none yet. May wait for the submission whose place it takes.
    const vk::raii::CommandBuffer& recording();
    /// The number that commands recorded now will have.
    Serial current() const { return submitted_ + 1; }

    /// Sends what has been recorded, if anything.
    void submit();
    bool is_done(Serial serial);
    /// Waits for a submission; sends it first where it is still being recorded.
    void wait(Serial serial);
    void wait_all() { wait(open_ ? current() : submitted_); }

    /// Waits until the device has nothing to do, lost or not. Call it before destroying what its work uses.
    void drain() noexcept;

    /// Destroys `thing` once submission `serial` is done.
    void keep_until(Serial serial, std::shared_ptr<void> thing) noexcept;
    std::size_t kept() const { return kept_.size(); }

private:
    struct Slot {
        vk::raii::CommandPool pool{nullptr};
        vk::raii::CommandBuffer commands{nullptr};
        vk::raii::Fence done{nullptr};
    };
    struct Kept {
        Serial serial;
        std::shared_ptr<void> thing;
    };

    Slot& slot(Serial serial) { return slots_[serial % slots_.size()]; }
    void poll();

    const Context& context_;
    std::array<Slot, 8> slots_;
    bool open_ = false;
    Serial submitted_ = 0, done_ = 0;
    std::vector<Kept> kept_;
};

}  // namespace tessera::backends::vulkan
