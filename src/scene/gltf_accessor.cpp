#include "scene/gltf_accessor.hpp"

#include "scene/limits.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstring>

namespace tessera::scene {
namespace {

std::uint64_t component_bytes(int component_type) {
    return static_cast<std::uint64_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type)));
}

/// Columns of small matrices are padded to 4 bytes (glTF 2.0, section 3.6.2.4).
std::uint64_t element_bytes(const tinygltf::Accessor& accessor) {
    const std::uint64_t component = component_bytes(accessor.componentType);
    const auto matrix = [&](std::uint64_t side) { return side * ((side * component + 3) / 4 * 4); };
    switch (accessor.type) {
        case TINYGLTF_TYPE_MAT2:
            return matrix(2);
        case TINYGLTF_TYPE_MAT3:
            return matrix(3);
        case TINYGLTF_TYPE_MAT4:
            return matrix(4);
        default:
            return static_cast<std::uint64_t>(components_of(accessor)) * component;
    }
}

/// Where an array of elements lies.
struct Strided {
    int view;
    std::uint64_t offset, stride, element, count;
};

/// All terms are below 2^32, so the sum fits 64 bits.
void check_range(const Document& document, const Strided& range, const std::string& element) {
    const std::uint64_t available = document.model.bufferViews[static_cast<std::size_t>(range.view)].byteLength;
    const std::uint64_t end = range.offset + (range.count - 1) * range.stride + range.element;
    if (end > available) {
        document.diagnostics.refuse(
            element, fmt::format("needs {} bytes of bufferViews[{}], which has {}", end, range.view, available));
    }
}

Strided base_range(const Document& document, const tinygltf::Accessor& accessor) {
    const auto& view = document.model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    const std::uint64_t element = element_bytes(accessor);
    return {accessor.bufferView, accessor.byteOffset, view.byteStride != 0 ? view.byteStride : element, element,
            accessor.count};
}

Strided sparse_indices_range(const tinygltf::Accessor& accessor) {
    const auto& indices = accessor.sparse.indices;
    const std::uint64_t element = component_bytes(indices.componentType);
    return {indices.bufferView, static_cast<std::uint64_t>(indices.byteOffset), element, element,
            static_cast<std::uint64_t>(accessor.sparse.count)};
}

Strided sparse_values_range(const tinygltf::Accessor& accessor) {
    const auto& values = accessor.sparse.values;
    const std::uint64_t element = element_bytes(accessor);
    return {values.bufferView, static_cast<std::uint64_t>(values.byteOffset), element, element,
            static_cast<std::uint64_t>(accessor.sparse.count)};
}

template <typename T>
T load(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

template <typename T, typename Out>
Out convert(const std::byte* at, bool normalized) {
    const T value = load<T>(at);
    if constexpr (std::is_integral_v<T> && std::is_floating_point_v<Out>) {
        if (normalized) {
            return std::max(static_cast<Out>(value) / static_cast<Out>(std::numeric_limits<T>::max()), Out{-1});
        }
    }
    return static_cast<Out>(value);
}

template <typename Out>
using Converter = Out (*)(const std::byte*, bool);

template <typename Out>
Converter<Out> converter(int component_type) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return convert<std::int8_t, Out>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return convert<std::uint8_t, Out>;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return convert<std::int16_t, Out>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return convert<std::uint16_t, Out>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return convert<std::uint32_t, Out>;
        default:
            break;
    }
    if constexpr (std::is_floating_point_v<Out>) {
        return convert<float, Out>;
    } else {
        return nullptr;  // callers of read_unsigned have checked the type
    }
}

template <typename Out>
void read_range(const Document& document, const tinygltf::Accessor& accessor, const Strided& range,
                const std::vector<std::uint32_t>* targets, std::vector<Out>& out) {
    const auto bytes = view_bytes(document, range.view);
    const auto read = converter<Out>(accessor.componentType);
    const auto components = static_cast<std::size_t>(components_of(accessor));
    const std::size_t component = component_bytes(accessor.componentType);
    for (std::size_t i = 0; i < range.count; ++i) {
        const std::byte* element = bytes.data() + range.offset + i * range.stride;
        Out* to = out.data() + (targets != nullptr ? (*targets)[i] : i) * components;
        for (std::size_t c = 0; c < components; ++c)
            to[c] = read(element + c * component, accessor.normalized);
    }
}

/// Where the sparse values go. They must rise strictly (glTF 2.0, section 3.6.2.3).
std::vector<std::uint32_t> sparse_targets(const Document& document, int index, const tinygltf::Accessor& accessor) {
    const Strided range = sparse_indices_range(accessor);
    const auto bytes = view_bytes(document, range.view);
    const auto read = converter<std::uint32_t>(accessor.sparse.indices.componentType);
    std::vector<std::uint32_t> targets(range.count);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        targets[i] = read(bytes.data() + range.offset + i * range.stride, false);
        if (targets[i] >= accessor.count || (i > 0 && targets[i] <= targets[i - 1])) {
            document.diagnostics.refuse(fmt::format("accessors[{}].sparse.indices", index),
                                        fmt::format("holds {} at place {}, but they must rise strictly and stay below "
                                                    "{}",
                                                    targets[i], i, accessor.count));
        }
    }
    return targets;
}

template <typename Out>
std::vector<Out> read(const Document& document, int index) {
    const auto& accessor = document.model.accessors[static_cast<std::size_t>(index)];
    std::vector<Out> out(accessor.count * static_cast<std::size_t>(components_of(accessor)));
    if (accessor.bufferView >= 0) {
        read_range(document, accessor, base_range(document, accessor), nullptr, out);
    }
    if (accessor.sparse.isSparse) {
        const auto targets = sparse_targets(document, index, accessor);
        read_range(document, accessor, sparse_values_range(accessor), &targets, out);
    }
    return out;
}

}  // namespace

int components_of(const tinygltf::Accessor& accessor) {
    return tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
}

void check_accessors(const Document& document) {
    const auto& model = document.model;
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        const auto& view = model.bufferViews[i];
        const std::uint64_t size = document.buffers[static_cast<std::size_t>(view.buffer)].size();
        if (view.byteOffset + view.byteLength > size) {
            document.diagnostics.refuse(fmt::format("bufferViews[{}]", i),
                                        fmt::format("ends at byte {} of buffers[{}], which has {}",
                                                    view.byteOffset + view.byteLength, view.buffer, size));
        }
    }
    for (std::size_t i = 0; i < model.accessors.size(); ++i) {
        const auto& accessor = model.accessors[i];
        const std::string element = fmt::format("accessors[{}]", i);
        if (accessor.bufferView >= 0) {
            const Strided range = base_range(document, accessor);
            if (range.stride < range.element) {
                document.diagnostics.refuse(element, fmt::format("has elements of {} bytes, but its view a byteStride "
                                                                 "of {}",
                                                                 range.element, range.stride));
            }
            check_range(document, range, element);
        } else if (accessor.count > max_zero_elements) {
            document.diagnostics.refuse(element + ".count", fmt::format("is {} without a bufferView; at most {} such "
                                                                        "elements are supported",
                                                                        accessor.count, max_zero_elements));
        }
        if (accessor.sparse.isSparse) {
            if (static_cast<std::uint64_t>(accessor.sparse.count) > accessor.count) {
                document.diagnostics.refuse(
                    element + ".sparse.count",
                    fmt::format("is {}, more than the {} elements", accessor.sparse.count, accessor.count));
            }
            check_range(document, sparse_indices_range(accessor), element + ".sparse.indices");
            check_range(document, sparse_values_range(accessor), element + ".sparse.values");
        }
    }
}

std::vector<float> read_floats(const Document& document, int accessor) {
    return read<float>(document, accessor);
}

std::vector<std::uint32_t> read_unsigned(const Document& document, int accessor) {
    return read<std::uint32_t>(document, accessor);
}

std::span<const std::byte> view_bytes(const Document& document, int buffer_view) {
    const auto& view = document.model.bufferViews[static_cast<std::size_t>(buffer_view)];
    return document.buffers[static_cast<std::size_t>(view.buffer)].subspan(view.byteOffset, view.byteLength);
}

}  // namespace tessera::scene
