#include "support/manifest.hpp"

#include "support/environment.hpp"

#include <algorithm>
#include <fstream>

namespace tessera::test {

bool is_gltf(const std::string& file) {
    return file.ends_with(".gltf") || file.ends_with(".glb");
}

std::vector<std::string> loadable_models() {
    const auto shared = shared_folder();
    std::vector<std::string> files;
    if (!shared) return files;
    std::ifstream manifest(*shared / "models/MANIFEST.md");
    for (std::string line; std::getline(manifest, line) && !line.starts_with("## Broken");) {
        if (!line.starts_with("| `") || line.find("| load") == std::string::npos) continue;
        const std::string file = line.substr(3, line.find('`', 3) - 3);
        const bool has_faces = line.find("| 0 / 0 / 0 |") == std::string::npos;
        if (has_faces && (is_gltf(file) || file.ends_with(".obj"))) files.push_back(file);
    }
    return files;
}

std::string file_test_name(const std::string& file) {
    std::string word = file;
    std::ranges::replace_if(
        word, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return word;
}

}  // namespace tessera::test
