#include "cli/hair_words.hpp"

#include <fmt/format.h>

namespace tessera::cli {

void add_hair_options(CLI::App& command, HairWords& words, const std::string& default_ribbons) {
    command.add_option("--hairs", words.hairs, "Hairs per patch of neighbouring guides (line strips of a glTF file)")
        ->capture_default_str();
    command.add_option("--hair-segments", words.segments, "Segments along a hair, 1 to 64")->capture_default_str();
    command.add_option("--hair-width", words.width,
                       "Full width of hair at its root, in the model's units (default: the attribute _WIDTH of the "
                       "guides, else a hundredth of their mean length)");
    command.add_option("--hair-taper", words.taper, "Share of the width that hair loses towards its tip, 0 to 1")
        ->capture_default_str();
    command
        .add_option("--hair-variation", words.variation,
                    "Share of its length that the shortest hair lacks, 0 to 1; every hair has a length of its own")
        ->capture_default_str();
    command.add_option("--ribbons", words.ribbons,
                       fmt::format("Hair is drawn as ribbons that face the camera, or flat ones that stay as they are "
                                   "(default: {})",
                                   default_ribbons));
    command
        .add_option("--eye", words.eye, "X,Y,Z in the model's units: what ribbons face with --ribbons camera instead")
        ->delimiter(',')
        ->expected(3);
}

patches::PatchSet surface_patches(const scene::Scene& scene) {
    return scene.meshes.empty() && !scene.guides.empty() ? patches::PatchSet{} : patches::make_patches(scene);
}

HairOptions resolve_hair(const HairWords& words, Ribbons default_ribbons, std::uint64_t memory_budget) {
    HairOptions options;
    options.hairs = words.hairs;
    options.segments = words.segments;
    options.taper = words.taper;
    options.variation = words.variation;
    options.ribbons = words.ribbons.empty() ? default_ribbons : ribbons_from_name(words.ribbons);
    if (!words.eye.empty()) options.eye = {words.eye[0], words.eye[1], words.eye[2]};
    options.memory_budget = memory_budget;
    check(options);
    return options;
}

}  // namespace tessera::cli
