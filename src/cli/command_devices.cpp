// tessera devices: what this machine has, and what it lacks and why.
#include "backends/registry.hpp"
#include "cli/command.hpp"

#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace tessera::cli {
namespace {

using Json = nlohmann::ordered_json;

Json optional_json(const std::optional<bool>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json to_json(const gpu::DeviceInfo& info) {
    const gpu::Limits& l = info.limits;
    return {{"id", info.id},
            {"backend", info.backend},
            {"name", info.name},
            {"driver", info.driver},
            {"version", info.version},
            {"software", info.software},
            {"tessellation_stage", info.tessellation_stage},
            {"transform_feedback", info.transform_feedback},
            {"rasteriser", info.rasteriser},
            {"timestamps", info.timestamps},
            {"compute_units", info.compute_units},
            {"limits",
             {{"max_storage_buffers", l.max_storage_buffers},
              {"max_storage_binding_size", l.max_storage_binding_size},
              {"max_uniform_binding_size", l.max_uniform_binding_size},
              {"max_buffer_size", l.max_buffer_size},
              {"max_workgroup_invocations", l.max_workgroup_invocations},
              {"max_workgroups_per_dimension", l.max_workgroups_per_dimension},
              {"storage_offset_alignment", l.storage_offset_alignment},
              {"uniform_offset_alignment", l.uniform_offset_alignment}}},
            {"float_controls",
             {{"preserves_denormals", optional_json(info.float_controls.preserves_denormals)},
              {"flushes_denormals", optional_json(info.float_controls.flushes_denormals)},
              {"preserves_nan_and_infinity", optional_json(info.float_controls.preserves_nan_and_infinity)},
              {"rounds_to_nearest_even", optional_json(info.float_controls.rounds_to_nearest_even)}}}};
}

std::string mebibytes(std::uint64_t bytes) {
    return fmt::format("{} MiB", bytes >> 20);
}

const char* word(const std::optional<bool>& value) {
    return !value ? "unknown" : (*value ? "yes" : "no");
}

void print(const gpu::DeviceInfo& info) {
    const gpu::Limits& l = info.limits;
    const gpu::FloatControls& f = info.float_controls;
    fmt::print("{}\n", info.id);
    fmt::print("  name                {}{}\n", info.name, info.software ? " (software)" : "");
    fmt::print("  driver              {}, {}\n", info.driver, info.version);
    fmt::print("  tessellation stage  {}\n", info.tessellation_stage ? "yes" : "no");
    fmt::print("  rasteriser          {}\n", info.rasteriser ? "yes" : "no");
    fmt::print("  timestamps          {}\n", info.timestamps ? "yes" : "no");
    fmt::print("  limits              binding {}, buffer {}, {} invocations per group, {} groups per dimension\n",
               mebibytes(l.max_storage_binding_size), mebibytes(l.max_buffer_size), l.max_workgroup_invocations,
               l.max_workgroups_per_dimension);
    fmt::print("  32-bit floats       denormals kept: {}, flushed: {}; NaN and infinity kept: {}; nearest even: {}\n",
               word(f.preserves_denormals), word(f.flushes_denormals), word(f.preserves_nan_and_infinity),
               word(f.rounds_to_nearest_even));
}

int list(bool json) {
    const backends::Inventory inventory = backends::list_devices();
    if (json) {
        Json document{{"devices", Json::array()}, {"unusable", Json::array()}};
        for (const gpu::DeviceInfo& info : inventory.devices) {
            document["devices"].push_back(to_json(info));
        }
        for (const gpu::UnusableDevice& device : inventory.unusable) {
            document["unusable"].push_back({{"id", device.id}, {"name", device.name}, {"reason", device.reason}});
        }
        fmt::print("{}\n", document.dump(2));
        return exit_fine;
    }
    for (const gpu::DeviceInfo& info : inventory.devices) {
        print(info);
    }
    for (const gpu::UnusableDevice& device : inventory.unusable) {
        fmt::print("{} is not usable{}: {}\n", device.id, device.name.empty() ? "" : " (" + device.name + ")",
                   device.reason);
    }
    return exit_fine;
}

}  // namespace

void add_devices_command(CLI::App& app, Context& context) {
    CLI::App* command =
        app.add_subcommand("devices", "List the devices of this machine, and why others are not usable");
    command->footer("Example: tessera devices --json");
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print JSON");
    command->callback([&context, json] { context.chosen = [json] { return list(*json); }; });
}

}  // namespace tessera::cli
