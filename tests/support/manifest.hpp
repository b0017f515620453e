// What the MANIFEST of the shared models says can be loaded.
#pragma once

#include <string>
#include <vector>

namespace tessera::test {

/// Files of the shared folder `models`, in the order of the MANIFEST: those of glTF and OBJ that it expects to load and
/// that hold a face. None where the folder is missing.
std::vector<std::string> loadable_models();

bool is_gltf(const std::string& file);

/// What a test of a file is called: its name in letters, digits and underscores.
std::string file_test_name(const std::string& file);

}  // namespace tessera::test
