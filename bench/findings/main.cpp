// findings: measures what docs/findings.md says, and writes it.
//
//   build/release/findings -o docs/findings.md      the whole document
//   build/release/findings --only pattern           one finding, to the terminal
//
// TESSERA_SHARED names the folder of shared test data (default ../shared). Exit codes: 0 fine, 1 a conclusion does not
// follow from the figures (nothing is written to the file then), 2 usage, 4 the output could not be written.
#include "findings.hpp"

#include "backends/registry.hpp"
#include "base/error.hpp"
#include "base/output_file.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <array>
#include <cstdlib>
#include <span>

namespace {

using namespace tessera;
using namespace tessera::findings;

struct Chapter {
    const char* name;
    void (*write)(const Bench&, Document&);
};

constexpr std::array<Chapter, 4> chapters{{{"normals", write_normals_finding},
                                           {"pattern", write_pattern_finding},
                                           {"schemes", write_scheme_finding},
                                           {"counts", write_triangle_counts}}};

std::filesystem::path shared_folder() {
    const char* set = std::getenv("TESSERA_SHARED");
    const std::filesystem::path folder = set != nullptr ? set : "../shared";
    if (!std::filesystem::is_directory(folder)) {
        throw Error(
            ErrorKind::usage,
            fmt::format("The shared test data is not at {}; set TESSERA_SHARED to its folder.", folder.string()));
    }
    return folder;
}

int run(const std::string& output, const std::string& only, const std::string& pictures) {
    const Bench bench{backends::open_device("reference"), load_models("assets", shared_folder()), pictures};
    Document document;
    if (only.empty()) {
        document.title("What the papers left open");
        document.paragraph(
            "Written by `build/release/findings -o docs/findings.md`, which measures all of it on the reference device "
            "and refuses to write conclusions that its figures do not bear out. Do not edit. Models are named by their "
            "files: shapes are the built-in ones, `assets/` holds the project's own, all others are of the shared test "
            "data (`TESSERA_SHARED`).");
    }
    for (const Chapter& chapter : chapters) {
        if (only.empty() || only == chapter.name) chapter.write(bench, document);
    }
    const bool sound = document.broken_claims().empty();
    for (const std::string& sentence : document.broken_claims())
        fmt::print(stderr, "The figures do not bear this out: {}\n", sentence);
    if (output.empty()) {
        std::fputs(document.markdown().c_str(), stdout);
    } else if (sound) {
        write_text(output, document.markdown());
    }
    return sound ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Measures what docs/findings.md says, and writes it");
    std::string output, only, pictures;
    app.add_option("-o,--output", output, "The Markdown file to write; without it, the terminal");
    app.add_option("--only", only, "One finding")->check(CLI::IsMember({"normals", "pattern", "schemes", "counts"}));
    app.add_option("--pictures", pictures, "A folder for the silhouettes that finding 2 compares")
        ->check(CLI::ExistingDirectory);
    CLI11_PARSE(app, argc, argv);
    try {
        return run(output, only, pictures);
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return static_cast<int>(error.kind());
    }
}
