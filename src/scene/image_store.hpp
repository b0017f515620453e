// The images of a scene: told apart by content, decoded, and counted against the limit.
#pragma once

#include "scene/diagnostics.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tessera::scene {

class ImageStore {
public:
    ImageStore(Scene& scene, Diagnostics& diagnostics) : scene_(scene), diagnostics_(diagnostics) {}

    /// Decodes a PNG or JPEG file and adds it under `name`; returns its place in Scene::images. What cannot be decoded
    /// is left out with a message about `element`. Throws Error(usage) beyond max_image_bytes.
    std::optional<std::uint32_t> add(std::vector<std::byte> encoded, const std::string& name,
                                     const std::string& element);

    /// Says that the image is left out, and why; returns nothing.
    std::optional<std::uint32_t> drop(const std::string& element, const std::string& reason);

private:
    Scene& scene_;
    Diagnostics& diagnostics_;
    std::uint64_t decoded_bytes_ = 0;
};

}  // namespace tessera::scene
