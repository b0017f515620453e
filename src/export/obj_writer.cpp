// Wavefront OBJ and its material library. OBJ counts vertices over the whole file, so vertices and faces can take
// turns, batch after batch.
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "export/batch_check.hpp"
#include "export/writers.hpp"

#include <fmt/format.h>
#include <iterator>
#include <optional>
#include <set>

namespace tessera::exporting {
namespace {

/// A name as one OBJ word: no spaces, no control characters, no comment sign.
std::string word(const std::string& name, const std::string& otherwise) {
    std::string result = name.empty() ? otherwise : name;
    for (char& c : result) {
        const auto code = static_cast<unsigned char>(c);
        if (code <= ' ' || code == 0x7f || c == '#') c = '_';
    }
    return result;
}

/// One distinct word per material.
std::vector<std::string> material_names(const std::vector<scene::Material>& materials) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        std::string name = word(materials[i].name, fmt::format("material_{}", i));
        while (!taken.insert(name).second)
            name += fmt::format("_{}", i);
        names.push_back(name);
    }
    return names;
}

std::filesystem::path library_path(const std::filesystem::path& path) {
    const std::string name = path.stem().string();
    if (name.find_first_of("\r\n") != std::string::npos) {
        throw Error(ErrorKind::output, fmt::format("Cannot write '{}': the .obj must name its .mtl in one line; choose "
                                                   "a file name without line breaks.",
                                                   path.string()));
    }
    return std::filesystem::path(path).replace_extension(".mtl");
}

class ObjWriter : public MeshWriter {
public:
    ObjWriter(const std::filesystem::path& path, const MeshTotals& totals, const scene::Scene& materials)
        : check_(totals, path.string()),
          names_(material_names(materials.materials)),
          file_(path),
          library_file_(library_path(path)),
          text_(file_) {
        write_library(materials.materials);
        put("# Tessera {}\nmtllib {}\n", TESSERA_VERSION, library_path(path).filename().string());
    }

    void append(const MeshBatch& batch) override {
        check_.accept(batch);
        for (const Vertex& v : batch.vertices) {
            put("v {} {} {}\n", v.position[0], v.position[1], v.position[2]);
            put("vn {} {} {}\n", v.normal[0], v.normal[1], v.normal[2]);
            // 1 - v needs more digits than a float has; a double holds it.
            put("vt {} {}\n", v.uv[0], 1.0 - static_cast<double>(v.uv[1]));
            text_.flush_if_large();
        }
        for_each_part(check_.totals(), &MeshPart::first_index, &MeshPart::index_count, batch.first_index,
                      batch.indices.size(), [&](std::size_t part, std::uint64_t first, std::uint64_t count) {
                          const std::uint64_t start = first - batch.first_index;
                          put_faces(part, batch.indices.subspan(start, count),
                                    batch.quads.empty() ? batch.quads : batch.quads.subspan(start / 3, count / 3));
                      });
    }

    void finish() override {
        check_.finish();
        text_.flush();
        file_.close();
        library_file_.publish();  // first: an .obj is never without its library
        file_.publish();
    }

private:
    template <typename... Args>
    void put(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text_.pending()), format, std::forward<Args>(args)...);
    }

    void put_faces(std::size_t part, std::span<const std::uint32_t> indices, std::span<const std::uint8_t> quads) {
        if (part_ != part) {
            part_ = part;
            const MeshPart& now = check_.totals().parts[part];
            put("o {}\nusemtl {}\n", word(now.name, fmt::format("part_{}", part)), names_[now.material]);
        }
        const auto put_corner = [this](std::uint32_t index) {
            const std::uint64_t number = std::uint64_t{index} + 1;
            put(" {}/{}/{}", number, number, number);
        };
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            put("f");
            for (std::size_t k = 0; k < 3; ++k)
                put_corner(indices[i + k]);
            if (!quads.empty() && quads[i / 3] != 0) {
                i += 3;  // the other half has one more corner, its last
                put_corner(indices[i + 2]);
            }
            put("\n");
            text_.flush_if_large();
        }
    }

    void write_library(const std::vector<scene::Material>& materials) {
        std::string text =
            fmt::format("# Tessera {}: base colours (linear) only; textures are kept by .glb\n", TESSERA_VERSION);
        for (std::size_t i = 0; i < materials.size(); ++i) {
            const glm::vec4& color = materials[i].base_color;
            const bool opaque = materials[i].alpha_mode == scene::AlphaMode::opaque;
            fmt::format_to(std::back_inserter(text), "newmtl {}\nKd {} {} {}\nd {}\n", names_[i], color.r, color.g,
                           color.b, opaque ? 1.0f : color.a);
        }
        library_file_.write_at(0, std::as_bytes(std::span(text)));
    }

    BatchCheck check_;
    std::vector<std::string> names_;
    OutputFile file_;
    OutputFile library_file_;
    TextOutput text_;
    std::optional<std::size_t> part_;
};

}  // namespace

std::unique_ptr<MeshWriter> create_obj_writer(const std::filesystem::path& path, const MeshTotals& totals,
                                              const scene::Scene& materials) {
    return std::make_unique<ObjWriter>(path, totals, materials);
}

}  // namespace tessera::exporting
