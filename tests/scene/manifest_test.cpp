// Every glTF and OBJ file of the shared models behaves as their MANIFEST says, counts included. The tables are read
// from the MANIFEST itself, so that a new row is a new test.
#include "scene/gltf_builder.hpp"
#include "support/environment.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <sstream>

namespace tessera::test {
namespace {

struct Row {
    std::string file;
    std::map<std::string, std::string> cells;  ///< by column title
};

std::vector<std::string> split_cells(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line.substr(1));
    for (std::string cell; std::getline(in, cell, '|');) {
        const auto first = cell.find_first_not_of(' ');
        const auto last = cell.find_last_not_of(' ');
        cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    return cells;
}

/// The rows of the table under the heading that begins so.
std::vector<Row> read_table(const std::filesystem::path& manifest, const std::string& heading) {
    std::ifstream in(manifest);
    std::vector<Row> rows;
    std::vector<std::string> titles;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("## ", 0) == 0) inside = line.rfind(heading, 0) == 0;
        if (!inside || line.rfind("|", 0) != 0 || line.rfind("|---", 0) == 0) continue;
        const auto cells = split_cells(line);
        if (titles.empty()) {
            titles = cells;
            continue;
        }
        Row row;
        const std::string& name = cells.at(0);
        row.file = name.substr(1, name.find('`', 1) - 1);
        for (std::size_t i = 0; i < std::min(cells.size(), titles.size()); ++i)
            row.cells[titles[i]] = cells[i];
        rows.push_back(std::move(row));
    }
    return rows;
}

bool is_gltf(const std::string& file) {
    return file.find(".gltf") != std::string::npos || file.find(".glb") != std::string::npos;
}

bool is_obj(const std::string& file) {
    return file.find(".obj") != std::string::npos;
}

struct Counts {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t quads = 0;
};

Counts count(const scene::Scene& scene) {
    Counts counts;
    for (const auto& mesh : scene.meshes) {
        counts.vertices += mesh.positions.size();
        counts.triangles += mesh.triangles.size() / 3;
        counts.quads += mesh.quads.size() / 4;
    }
    return counts;
}

TEST(Manifest, LoadableModelsLoadWithTheirCounts) {
    TESSERA_SHARED_OR_SKIP(shared);
    const auto rows = read_table(shared / "models/MANIFEST.md", "## Public set");
    std::size_t loaded = 0;
    for (const Row& row : rows) {
        if (!is_gltf(row.file) || row.cells.at("expected").rfind("load", 0) != 0) continue;
        SCOPED_TRACE(row.file);
        const scene::Scene scene = scene::load_scene((shared / "models" / row.file).string());
        expect_sound(scene);
        Counts expected{std::stoul(row.cells.at("vertices")), std::stoul(row.cells.at("tri / quad / n-gon")), 0};
        if (expected.triangles == 0) {
            expected.vertices = 0;  // points only: a scene without meshes, and a message
            EXPECT_TRUE(has_message(scene, "no triangles"));
        }
        EXPECT_EQ(count(scene).vertices, expected.vertices);
        EXPECT_EQ(count(scene).triangles, expected.triangles);
        ++loaded;
    }
    EXPECT_GE(loaded, 20u) << "the MANIFEST was not understood";
}

/// Corners of the faces of an OBJ file with more than four of them, counted without the loader.
std::vector<std::size_t> ngon_corners(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::vector<std::size_t> out;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word != "f") continue;
        std::size_t corners = 0;
        while (words >> word)
            ++corners;
        if (corners > 4) out.push_back(corners);
    }
    return out;
}

TEST(Manifest, LoadableObjFilesLoadWithTheirCounts) {
    TESSERA_SHARED_OR_SKIP(shared);
    std::size_t loaded = 0;
    for (const Row& row : read_table(shared / "models/MANIFEST.md", "## Public set")) {
        if (!is_obj(row.file) || row.cells.at("expected").rfind("load", 0) != 0) continue;
        SCOPED_TRACE(row.file);
        std::istringstream cells(row.cells.at("tri / quad / n-gon"));
        std::size_t triangles = 0, quads = 0, ngons = 0;
        char slash = 0;
        cells >> triangles >> slash >> quads >> slash >> ngons;
        const auto path = shared / "models" / row.file;
        const auto corners = ngon_corners(path);
        ASSERT_EQ(corners.size(), ngons);
        const std::size_t ngon_sum = std::accumulate(corners.begin(), corners.end(), std::size_t{0});

        const scene::Scene fanned = scene::load_scene(path.string(), {.ngons = scene::NgonMode::fan});
        expect_sound(fanned);
        const scene::Scene split = scene::load_scene(path.string(), {.ngons = scene::NgonMode::split});
        expect_sound(split);
        ++loaded;
        const std::string& features = row.cells.at("features");
        if (const auto tag = features.find("holex"); tag != std::string::npos)
            quads -= std::stoul(features.substr(tag + 5));
        if (features.find("deg ") != std::string::npos && ngons == 0) {
            // Degenerate faces are dropped or lose a corner.
            EXPECT_TRUE(has_message(fanned, "corner"));
            EXPECT_LT(3 * count(fanned).triangles + 4 * count(fanned).quads, 3 * triangles + 4 * quads);
            EXPECT_GT(count(fanned).triangles + count(fanned).quads, (triangles + quads) / 2);
            continue;
        }
        EXPECT_EQ(count(fanned).quads, quads);
        EXPECT_EQ(count(fanned).triangles, triangles + ngon_sum - 2 * ngons);
        if (ngons == 0) {
            EXPECT_EQ(count(split).quads, quads);
            EXPECT_EQ(count(split).triangles, triangles);
        } else if (has_message(split, "too concave")) {
            EXPECT_EQ(count(split).triangles, 0u);
        } else {
            EXPECT_EQ(count(split).quads, 3 * triangles + 4 * quads + ngon_sum);
            EXPECT_EQ(count(split).triangles, 0u);
        }
        if (features.find("bd 0, nm 0, flip 0") != std::string::npos && features.find("hole") == std::string::npos) {
            // Two faces that share three corners may be cut along the same diagonal: closed, but not a manifold.
            if (ngons == 0) expect_closed(fanned.meshes);
            expect_closed(split.meshes);
        }
    }
    EXPECT_EQ(loaded, 24u) << "the MANIFEST was not understood";
}

TEST(Manifest, CreaseTagsOfOpenSubdivFilesAreKept) {
    TESSERA_SHARED_OR_SKIP(shared);
    std::size_t tagged = 0;
    for (const Row& row : read_table(shared / "models/MANIFEST.md", "## Public set")) {
        const std::string& features = row.cells.at("features");
        const auto tag = features.find("creasex");
        if (!is_obj(row.file) || tag == std::string::npos) continue;
        SCOPED_TRACE(row.file);
        const auto load = [&](scene::NgonMode mode) {
            return scene::load_scene((shared / "models" / row.file).string(), {.ngons = mode}).meshes;
        };
        const auto meshes = load(scene::NgonMode::fan);
        ASSERT_EQ(meshes.size(), 1u);
        EXPECT_EQ(meshes[0].tags.creases.size(), std::stoul(features.substr(tag + 7)));
        const auto split = load(scene::NgonMode::split);
        if (split[0].positions.size() != meshes[0].positions.size()) {
            EXPECT_EQ(split[0].tags.creases.size(), 2 * meshes[0].tags.creases.size());
        }
        ++tagged;
    }
    EXPECT_GE(tagged, 5u) << "the MANIFEST was not understood";
}

TEST(Manifest, UnsupportedExtensionsAreRefusedByName) {
    TESSERA_SHARED_OR_SKIP(shared);
    std::size_t refused = 0;
    for (const Row& row : read_table(shared / "models/MANIFEST.md", "## Public set")) {
        const std::string& expected = row.cells.at("expected");
        if (expected.rfind("refuse", 0) != 0) continue;
        const std::string extension = expected.substr(expected.rfind(' ') + 1);
        const std::string sentence = refusal((shared / "models" / row.file).string());
        EXPECT_NE(sentence.find(extension), std::string::npos) << sentence;
        ++refused;
    }
    EXPECT_GE(refused, 2u) << "the MANIFEST was not understood";
}

TEST(Manifest, BrokenFilesAreRefusedOrLoadSoundly) {
    TESSERA_SHARED_OR_SKIP(shared);
    const auto rows = read_table(shared / "models/MANIFEST.md", "## Broken inputs");
    for (const Row& row : rows) {
        SCOPED_TRACE(row.file);
        const std::string path = (shared / "broken" / row.file).string();
        try {
            const scene::Scene scene = scene::load_scene(path);
            expect_sound(scene);
            EXPECT_EQ(row.cells.at("expected").find("must fail"), std::string::npos) << "was loaded";
            EXPECT_FALSE(scene.messages.empty()) << "nothing is silent";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            const std::string sentence = error.what();
            EXPECT_NE(sentence.find(path), std::string::npos) << sentence;
            EXPECT_EQ(sentence.back(), '.') << sentence;
        }
    }
    EXPECT_GE(rows.size(), 30u) << "the MANIFEST was not understood";
}

}  // namespace
}  // namespace tessera::test
