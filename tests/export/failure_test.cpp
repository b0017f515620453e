// What fails leaves no file behind and an old file untouched, and says why.
#include "base/error.hpp"
#include "export/mesh_readers.hpp"
#include "export/sample_mesh.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <csignal>
#include <fstream>
#include <functional>
#include <limits>

namespace tessera::test {
namespace {

namespace fs = std::filesystem;

class Failure : public testing::TestWithParam<const char*> {
protected:
    fs::path target() const { return folder_ / ("mesh" + std::string(GetParam())); }

    /// Expects an Error(output) that names `path` and contains `reason`.
    static void expect_error(const std::function<void()>& action, const fs::path& path, const std::string& reason) {
        try {
            action();
            ADD_FAILURE() << "nothing was thrown";
        } catch (const Error& error) {
            EXPECT_EQ(ErrorKind::output, error.kind());
            const std::string sentence = error.what();
            EXPECT_NE(std::string::npos, sentence.find("'" + path.string() + "'")) << sentence;
            EXPECT_NE(std::string::npos, sentence.find(reason)) << sentence;
        }
    }

    static bool holds_old(const fs::path& path) { return read_bytes(path) == "old"; }

    TemporaryFolder folder_;
    SampleMesh mesh_ = sample_mesh(300);
};

TEST_P(Failure, UnfinishedLeavesTheOldFile) {
    std::ofstream(target()) << "old";
    {
        const auto writer = exporting::create_mesh_writer(target(), mesh_.totals, mesh_.scene);
        append_patches(*writer, mesh_, 0, 100);
        EXPECT_LT(1u, folder_.entries()) << "a temporary file is beside the target";
    }
    EXPECT_EQ(1u, folder_.entries());
    EXPECT_TRUE(holds_old(target()));
}

TEST_P(Failure, UnfinishedLeavesNothing) {
    { append_patches(*exporting::create_mesh_writer(target(), mesh_.totals, mesh_.scene), mesh_, 0, 100); }
    EXPECT_EQ(0u, folder_.entries());
}

TEST_P(Failure, NoSpace) {  // a limit on file sizes stands for a full disk: write() fails half way
    rlimit old{};
    ASSERT_EQ(0, ::getrlimit(RLIMIT_FSIZE, &old));
    const rlimit small{4096, old.rlim_max};
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(0, ::setrlimit(RLIMIT_FSIZE, &small));
    expect_error([&] { write_sample(target(), mesh_, 100); }, target(), "larger than");
    ::setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_EQ(0u, folder_.entries());
}

TEST_P(Failure, MissingFolder) {
    const fs::path path = folder_ / "missing" / target().filename();
    expect_error([&] { write_sample(path, mesh_, 100); }, path, "folder does not exist");
    const fs::path below_a_file = target() / target().filename();
    std::ofstream(target()) << "a file";
    expect_error([&] { write_sample(below_a_file, mesh_, 100); }, below_a_file, "folder does not exist");
}

TEST_P(Failure, TargetIsAFolder) {
    fs::create_directory(target());
    expect_error([&] { write_sample(target(), mesh_, 100); }, target(), "it is a folder");
    EXPECT_EQ(1u, folder_.entries());
}

TEST_P(Failure, TargetIsADevice) {
    fs::create_symlink("/dev/null", target());
    expect_error([&] { write_sample(target(), mesh_, 100); }, target(), "not a regular file");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_P(Failure, ReadOnlyFolderOrFile) {
    std::ofstream(target()) << "old";
    const bool root = ::geteuid() == 0;  // whom no permission stops
    const auto as_nobody = [&](const auto& action) {
        EXPECT_TRUE(!root || ::seteuid(65534) == 0);
        action();
        EXPECT_TRUE(!root || ::seteuid(0) == 0);
    };
    fs::permissions(folder_.path(), fs::perms(0555));
    const fs::path fresh = folder_ / ("new" + std::string(GetParam()));
    as_nobody([&] { expect_error([&] { write_sample(fresh, mesh_, 100); }, fresh, "permission denied"); });
    fs::permissions(folder_.path(), fs::perms(0777));
    fs::permissions(target(), fs::perms(0444));
    as_nobody([&] { expect_error([&] { write_sample(target(), mesh_, 100); }, target(), "permission denied"); });
    EXPECT_EQ(1u, folder_.entries());
    EXPECT_TRUE(holds_old(target()));
}

TEST_P(Failure, VertexThatIsNotFinite) {
    for (std::size_t number = 0; number < 8; ++number) {
        for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
            SampleMesh mesh = sample_mesh(300);
            reinterpret_cast<float*>(&mesh.vertices[500])[number] = bad;
            expect_error([&] { write_sample(target(), mesh, 100); }, target(), "vertex 500 is not finite");
        }
    }
    EXPECT_EQ(0u, folder_.entries());
}

TEST_P(Failure, BatchesThatContradictTheTotals) {
    const auto attempt = [&](const std::function<void(exporting::MeshWriter&)>& action) {
        const auto writer = exporting::create_mesh_writer(target(), mesh_.totals, mesh_.scene);
        EXPECT_THROW(action(*writer), std::logic_error);
    };
    attempt([&](auto& writer) { writer.finish(); });
    attempt([&](auto& writer) { append_patches(writer, mesh_, 1, 2); });
    attempt([&](auto& writer) {
        append_patches(writer, mesh_, 0, 299);
        writer.finish();
    });
    const SampleMesh longer = sample_mesh(301);
    attempt([&](auto& writer) { append_patches(writer, longer, 0, 301); });
    SampleMesh foreign = mesh_;
    foreign.indices[0] = 400;  // within the batch, but of another part
    attempt([&](auto& writer) { append_patches(writer, foreign, 0, 300); });
    foreign.indices[0] = 60;  // of the same part, but of a later batch
    attempt([&](auto& writer) { append_patches(writer, foreign, 0, 10); });
    EXPECT_EQ(0u, folder_.entries());
}

TEST_P(Failure, TotalsThatDoNotAddUp) {
    SampleMesh gap = mesh_;
    gap.totals.parts[2].first_vertex += 1;
    EXPECT_THROW(exporting::create_mesh_writer(target(), gap.totals, gap.scene), std::logic_error);
    SampleMesh unknown = mesh_;
    unknown.totals.parts[2].material = 3;
    EXPECT_THROW(exporting::create_mesh_writer(target(), unknown.totals, unknown.scene), std::logic_error);
    EXPECT_EQ(0u, folder_.entries());
}

TEST_P(Failure, MoreThan32BitVertices) {
    MeshTotals totals;
    totals.vertex_count = (std::uint64_t{1} << 32) + 1;
    totals.parts = {{"huge", 0, 0, totals.vertex_count, 0, 0}};
    expect_error([&] { exporting::create_mesh_writer(target(), totals, mesh_.scene); }, target(),
                 "4294967297 vertices");
    EXPECT_EQ(0u, folder_.entries());
}

TEST_P(Failure, PermissionsAreThoseOfAnyNewFileOrOfTheOldOne) {
    const mode_t old_mask = ::umask(027);
    write_sample(target(), mesh_, 100);
    ::umask(old_mask);
    EXPECT_EQ(fs::perms(0640), fs::status(target()).permissions());
    fs::permissions(target(), fs::perms(0600));
    write_sample(target(), mesh_, 100);
    EXPECT_EQ(fs::perms(0600), fs::status(target()).permissions());
}

TEST_P(Failure, TakenTemporaryNamesAreLeftAlone) {
    constexpr int names = 900;  // the process has used fewer so far
    const auto taken = [&](int n) {
        return folder_ / (".tessera-" + std::to_string(::getpid()) + "-" + std::to_string(n) + ".tmp");
    };
    for (int n = 0; n < names; ++n)
        std::ofstream(taken(n)) << "old";
    write_sample(target(), mesh_, 100);
    EXPECT_EQ(mesh_.vertices.size(), read_mesh(target()).vertices.size());
    for (int n = 0; n < names; ++n)
        ASSERT_TRUE(holds_old(taken(n))) << n;
}

TEST_P(Failure, ALinkIsFollowed) {
    const fs::path link = folder_ / ("link" + std::string(GetParam()));
    std::ofstream(target()) << "old";
    fs::create_symlink(target().filename(), link);
    write_sample(link, mesh_, 100);
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(mesh_.vertices.size(), read_mesh(target()).vertices.size());
}

INSTANTIATE_TEST_SUITE_P(Formats, Failure, testing::Values(".glb", ".obj", ".ply"),
                         [](const auto& info) { return std::string(info.param + 1); });

TEST(FailureGlb, MoreThan4GiB) {
    const TemporaryFolder folder;
    MeshTotals totals;
    totals.vertex_count = std::uint64_t{1} << 27;
    totals.index_count = 3;
    totals.parts = {{"huge", 0, 0, totals.vertex_count, 0, 3}};
    EXPECT_THROW(exporting::create_mesh_writer(folder / "mesh.glb", totals, sample_mesh(3).scene), Error);
    EXPECT_EQ(0u, folder.entries());
}

TEST(FailureFormat, UnknownExtension) {
    const TemporaryFolder folder;
    for (const char* name : {"mesh.stl", "mesh", ".glb", "mesh.glb.gz"}) {
        try {
            exporting::create_mesh_writer(folder / name, {}, sample_mesh(3).scene);
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(ErrorKind::usage, error.kind());
        }
    }
    EXPECT_EQ(0u, folder.entries());
}

}  // namespace
}  // namespace tessera::test
