// What is written reads back to the same bits, however it was divided into batches.
#include "export/mesh_readers.hpp"
#include "export/sample_mesh.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <cstring>

namespace tessera::test {
namespace {

class RoundTrip : public testing::TestWithParam<const char*> {};

void expect_equal_bits(const std::vector<Vertex>& expected, const std::vector<Vertex>& found) {
    ASSERT_EQ(expected.size(), found.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Vertex& e = expected[i];
        const Vertex& f = found[i];
        ASSERT_EQ(0, std::memcmp(&e, &f, sizeof(Vertex))) << fmt::format(
            "vertex {}: ({} {} {}) ({} {} {}) ({} {}) became ({} {} {}) ({} {} {}) ({} {})", i, e.position[0],
            e.position[1], e.position[2], e.normal[0], e.normal[1], e.normal[2], e.uv[0], e.uv[1], f.position[0],
            f.position[1], f.position[2], f.normal[0], f.normal[1], f.normal[2], f.uv[0], f.uv[1]);
    }
}

std::vector<std::uint32_t> all_indices(const ReadMesh& mesh) {
    std::vector<std::uint32_t> all;
    for (const ReadPart& part : mesh.parts)
        all.insert(all.end(), part.indices.begin(), part.indices.end());
    return all;
}

TEST_P(RoundTrip, KeepsEveryBit) {
    const TemporaryFolder folder;
    const SampleMesh mesh = sample_mesh(3000);
    for (const std::size_t batch : {3000, 1000, 7, 1}) {  // 1000 ends with the first part; others cross it
        SCOPED_TRACE(fmt::format("batches of {} patches", batch));
        const auto path = folder / ("mesh" + std::string(GetParam()));
        write_sample(path, mesh, batch);
        const ReadMesh read = read_mesh(path);
        expect_equal_bits(mesh.vertices, read.vertices);
        EXPECT_EQ(mesh.indices, all_indices(read));
    }
}

TEST_P(RoundTrip, KeepsManyIndicesOfOneBatch) {  // more than the writers convert at a time
    const TemporaryFolder folder;
    const SampleMesh mesh = sample_mesh(40000);
    write_sample(folder / ("mesh" + std::string(GetParam())), mesh, 40000);
    EXPECT_EQ(mesh.indices, all_indices(read_mesh(folder / ("mesh" + std::string(GetParam())))));
}

TEST_P(RoundTrip, AcceptsUpperCaseExtension) {
    const TemporaryFolder folder;
    std::string name = "mesh" + std::string(GetParam());
    for (char& c : name)
        c = static_cast<char>(std::toupper(c));
    write_sample(folder / name, sample_mesh(3), 1);
    EXPECT_TRUE(std::filesystem::exists(folder / name));
}

TEST_P(RoundTrip, WritesAnEmptyMesh) {  // every patch was culled
    const TemporaryFolder folder;
    const auto path = folder / ("mesh" + std::string(GetParam()));
    SampleMesh mesh = sample_mesh(0);
    write_sample(path, mesh, 1);
    if (path.extension() != ".glb") {
        EXPECT_TRUE(read_mesh(path).vertices.empty());
    } else {
        EXPECT_FALSE(read_glb_file(path).json.contains("meshes"));
    }
}

TEST(RoundTripBinary, FilesDoNotDependOnBatches) {  // in .obj, vertices and faces take turns batch by batch
    const TemporaryFolder folder;
    const SampleMesh mesh = sample_mesh(500);
    for (const char* name : {"mesh.glb", "mesh.ply"}) {
        write_sample(folder / name, mesh, 500);
        const std::string one_batch = read_bytes(folder / name);
        write_sample(folder / name, mesh, 3);
        EXPECT_TRUE(one_batch == read_bytes(folder / name)) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, testing::Values(".glb", ".obj", ".ply"),
                         [](const auto& info) { return std::string(info.param + 1); });

}  // namespace
}  // namespace tessera::test
