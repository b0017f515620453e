// Pixar's tag lines in OBJ files: `t NAME INTS/FLOATS/STRINGS values...`, as the files of OpenSubdiv have them.
#pragma once

#include "scene/diagnostics.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace tessera::scene {

class ObjTagReader {
public:
    explicit ObjTagReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    /// Reads one line, without its `t`, into `tags`: crease (pairs of vertices), corner, hole, interpolateboundary. A
    /// tag that is not known or not understood is skipped with a message.
    void read(std::uint32_t line, std::string_view text, SubdivisionTags& tags);

    /// Removes tags of vertices and faces that do not exist, with a message.
    void check_ranges(std::uint64_t positions, std::uint64_t faces, SubdivisionTags& tags);

private:
    void skip(std::uint32_t line, std::string_view name, const char* reason);

    Diagnostics& diagnostics_;
    std::vector<std::string_view> words_;
    std::vector<std::uint32_t> ints_;
    std::vector<float> floats_;
};

}  // namespace tessera::scene
