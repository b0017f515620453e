// tessera verify --pictures: the same pictures from every device.
#pragma once

#include "cli/command.hpp"
#include "cli/hair_words.hpp"
#include "cli/job_options.hpp"
#include "cli/load.hpp"
#include "gpu/device.hpp"

#include <string>
#include <vector>

namespace tessera::cli {

struct PictureWords {
    std::vector<std::string> inputs;
    std::vector<gpu::Device> devices;  ///< the first is what the others are held against
    LoadWords load;
    HairWords hair;
    std::vector<JobWords> jobs;
    std::uint32_t side = 256;  ///< of the pictures, pixels
    bool json = false;
};

/// Draws every job of every input on every device by the portable rasteriser, metallic-roughness materials with 1 and
/// with 4 samples per pixel, and compares bit by bit. Then tells how close the devices' own rasterisers come. Prints
/// what was found and returns the exit code, which is about bits alone.
int verify_pictures(const Context& context, const PictureWords& words);

}  // namespace tessera::cli
