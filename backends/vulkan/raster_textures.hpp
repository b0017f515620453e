// Base colour textures: uploaded once with all their mip levels, sampled by repeat and trilinear filtering.
#pragma once

#include <map>
#include <vector>

#include "backends/vulkan/raster_stream.hpp"
#include "scene/scene.hpp"

namespace tessera::backends::vulkan {

class RasterTextures {
public:
    RasterTextures(const Context& context, vk::DescriptorSetLayout layout);

    /// Uploads the images that materials use, through `stream`, which has no frame set. Sides over the device's limit
    /// are halved until they fit. Throws Error(usage) for a material whose image is not there.
    void upload(RasterStream& stream, const std::vector<scene::Material>& materials,
                const std::vector<scene::SceneImage>& images);

    /// The descriptor set (one combined image sampler) of a material; white where it has no image.
    vk::DescriptorSet of(const scene::Material& material) const;

private:
    struct Texture {
        ImageAllocation image;
        vk::raii::ImageView view{nullptr};
        vk::DescriptorSet set;
    };

    Texture create(RasterStream& stream, const image::Image& pixels);

    const Context& context_;
    vk::DescriptorSetLayout layout_;
    vk::raii::Sampler sampler_{nullptr};
    vk::raii::DescriptorPool pool_{nullptr};
    std::map<std::uint32_t, Texture> textures_;  ///< by index into the scene's images
    Texture white_;
};

}  // namespace tessera::backends::vulkan
