#include "backends/registry.hpp"

#include "backends/opencl/opencl_backend.hpp"
#include "backends/reference/reference_backend.hpp"
#include "backends/vulkan/fixed_function.hpp"
#include "backends/vulkan/timed_draw.hpp"
#include "backends/vulkan/vulkan_backend.hpp"
#include "backends/vulkan/vulkan_rasteriser.hpp"
#include "base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace tessera::backends {

namespace {

struct Entry {
    std::string_view name;
    Inventory (*list)();
    std::unique_ptr<gpu::Backend> (*open)(std::size_t index);
    std::unique_ptr<render::Rasteriser> (*open_rasteriser)(const gpu::Device& device);            // null: draws nothing
    std::unique_ptr<verify::FixedFunctionTessellator> (*open_fixed_function)(std::size_t index);  // null: has none
    std::unique_ptr<bench::TimedStage> (*open_timed_stage)(std::size_t index);                    // likewise
};

constexpr std::array entries{
    Entry{"reference", reference::list, reference::open, nullptr, nullptr, nullptr},
    Entry{"vulkan", vulkan::list, [](std::size_t index) { return vulkan::open(index); }, vulkan::open_rasteriser,
          vulkan::open_fixed_function, vulkan::open_timed_stage},
    Entry{"opencl", opencl::list, opencl::open, nullptr, nullptr, nullptr},
};

/// A device and how to open it.
struct Found {
    const Entry* entry;
    std::size_t index;  // in the list of its backend
    gpu::DeviceInfo info;
};

struct Search {
    std::vector<Found> devices;
    std::vector<gpu::UnusableDevice> unusable;
};

/// The devices of one backend; what it throws becomes the reason why it is not usable.
void look_in(const Entry& entry, Search& search) {
    try {
        Inventory inventory = entry.list();
        for (std::size_t i = 0; i < inventory.devices.size(); ++i) {
            search.devices.push_back({&entry, i, std::move(inventory.devices[i])});
        }
        std::ranges::move(inventory.unusable, std::back_inserter(search.unusable));
    } catch (const std::exception& failure) {
        search.unusable.push_back({std::string(entry.name), std::string(entry.name), failure.what()});
    }
}

Search look_everywhere() {
    Search search;
    for (const Entry& entry : entries) {
        look_in(entry, search);
    }
    return search;
}

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// What was found and every reason, as the end of an error sentence.
std::string describe(const Search& search) {
    std::string text = "found:";
    for (const Found& device : search.devices) {
        text += fmt::format("\n  {} ({})", device.info.id, device.info.name);
    }
    if (search.devices.empty()) {
        text += " nothing";
    }
    for (const gpu::UnusableDevice& device : search.unusable) {
        const std::string name = device.name.empty() ? "" : fmt::format(" ({})", device.name);
        text += fmt::format("\n  {}{} cannot be used: {}", device.id, name, device.reason);
    }
    return text;
}

/// What `--device` takes: a backend, and an index or a part of a name (lower case) or nothing.
struct Wish {
    const Entry* entry;
    std::string selector;
};

Wish parse(const std::string& id) {
    const std::string words = lower(id);
    const std::size_t colon = words.find(':');
    const auto entry = std::ranges::find(entries, words.substr(0, colon), &Entry::name);
    if (entry == entries.end()) {
        throw Error(ErrorKind::usage, fmt::format("Device '{}' names no backend; write reference, vulkan or opencl, "
                                                  "where wanted with :INDEX or :NAME after it.",
                                                  id));
    }
    if (colon == std::string::npos) {
        return {&*entry, ""};
    }
    if (colon + 1 == words.size()) {
        throw Error(ErrorKind::usage, fmt::format("Device '{}' has nothing after its colon; write an index or a part "
                                                  "of a name there.",
                                                  id));
    }
    return {&*entry, words.substr(colon + 1)};
}

bool fits(const Found& device, const Wish& wish) {
    if (device.entry != wish.entry) {
        return false;
    }
    if (std::ranges::all_of(wish.selector, [](unsigned char c) { return std::isdigit(c) != 0; })) {
        return wish.selector.empty() || device.info.id == fmt::format("{}:{}", wish.entry->name, wish.selector);
    }
    return lower(device.info.name).find(wish.selector) != std::string::npos;
}

Found choose(const std::string& id) {
    const Wish wish = parse(id);
    Search search;
    look_in(*wish.entry, search);
    const auto chosen = std::ranges::find_if(search.devices, [&](const Found& device) { return fits(device, wish); });
    if (chosen == search.devices.end()) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("Device '{}' is not there; {}", id, describe(look_everywhere())));
    }
    return *chosen;
}

bool draws(const Entry& entry, const gpu::DeviceInfo& info) {
    return info.rasteriser && entry.open_rasteriser != nullptr;
}

std::unique_ptr<render::Rasteriser> open_rasteriser_of(const Found& device) {
    return device.entry->open_rasteriser(gpu::Device(device.entry->open(device.index)));
}

}  // namespace

Inventory list_devices() {
    Search search = look_everywhere();
    Inventory inventory;
    for (Found& device : search.devices) {
        inventory.devices.push_back(std::move(device.info));
    }
    inventory.unusable = std::move(search.unusable);
    return inventory;
}

gpu::Device open_device(const std::string& id) {
    const Found device = choose(id);
    return gpu::Device(device.entry->open(device.index));
}

std::unique_ptr<render::Rasteriser> open_rasteriser(const std::string& id) {
    if (!id.empty()) {
        const Found wanted = choose(id);
        if (draws(*wanted.entry, wanted.info)) return open_rasteriser_of(wanted);
    }
    const Search search = look_everywhere();
    const auto first =
        std::ranges::find_if(search.devices, [](const Found& device) { return draws(*device.entry, device.info); });
    if (first == search.devices.end()) {
        throw Error(ErrorKind::device_unavailable,
                    fmt::format("No device here draws triangles, which a picture needs; {}", describe(search)));
    }
    return open_rasteriser_of(*first);
}

std::unique_ptr<render::Rasteriser> open_rasteriser(const gpu::Device& device) {
    const auto entry = std::ranges::find(entries, device.info().backend, &Entry::name);
    if (entry == entries.end() || !draws(*entry, device.info())) {
        throw Error(ErrorKind::device_unavailable, fmt::format("{} has no rasteriser of its own.", device.info().id));
    }
    return entry->open_rasteriser(device);
}

std::unique_ptr<verify::FixedFunctionTessellator> open_fixed_function(const std::string& id) {
    const std::vector<Found> devices = id.empty() ? look_everywhere().devices : std::vector<Found>{choose(id)};
    std::string reasons;
    for (const Found& device : devices) {
        if (device.entry->open_fixed_function == nullptr) {
            reasons += fmt::format("\n  {}: {} has no tessellation stage.", device.info.id, device.entry->name);
            continue;
        }
        try {
            return device.entry->open_fixed_function(device.index);
        } catch (const Error& refusal) {
            reasons += fmt::format("\n  {}: {}", device.info.id, refusal.what());
        }
    }
    throw Error(ErrorKind::device_unavailable,
                fmt::format("No tessellation stage here can be captured to judge the kernels; with Mesa's lavapipe "
                            "(mesa-vulkan-drivers on Debian) any machine has one:{}",
                            reasons.empty() ? " no device was found." : reasons));
}

std::unique_ptr<bench::TimedStage> open_timed_stage(const std::string& id) {
    const Found device = choose(id);
    if (device.entry->open_timed_stage == nullptr) {
        throw Error(ErrorKind::device_unavailable, fmt::format("{} has no tessellation stage.", device.info.id));
    }
    return device.entry->open_timed_stage(device.index);
}

}  // namespace tessera::backends
