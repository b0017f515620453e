// The two wrappings of a glTF document: plain JSON text, or the binary container GLB.
#pragma once

#include "scene/diagnostics.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace tessera::scene {

/// Views into the file's bytes.
struct Container {
    std::string_view json;
    std::optional<std::span<const std::byte>> binary;  ///< the BIN chunk, where there is one
};

/// Tells GLB from text by the magic number, not by the file's name, and checks every length of a GLB (glTF 2.0,
/// section 4.4) against the bytes there are. Throws Error(usage).
Container open_container(std::span<const std::byte> file, const Diagnostics& diagnostics);

}  // namespace tessera::scene
