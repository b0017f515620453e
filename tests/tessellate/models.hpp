// Models for tests of the whole pipeline.
#pragma once

#include "patches/patches.hpp"

#include <string>
#include <vector>

namespace tessera::test {

/// The patches of a built-in shape or a file. Throws tessera::Error.
patches::PatchSet load_patches(const std::string& name);

/// True where every edge lies between exactly two triangles, told by positions, and control vertices at one position
/// share one normal: then the schemes leave no crack.
bool closed_and_smooth(const patches::PatchSet& set);

}  // namespace tessera::test
