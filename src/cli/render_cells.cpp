#include "cli/render_cells.hpp"

#include <fmt/format.h>

namespace tessera::cli {
namespace {

std::string label(const std::string& words) {
    const std::size_t colon = words.find(':');
    if (colon == std::string::npos) return words;
    return fmt::format("{}, {} normals", words.substr(0, colon), words.substr(colon + 1));
}

}  // namespace

std::vector<views::Cell> make_cells(const JobWords& job, const std::vector<std::string>& compare,
                                    const views::Subject& subject) {
    std::vector<std::string> wanted = compare;
    if (wanted.empty()) wanted.push_back(job.scheme);
    std::vector<views::Cell> cells;
    for (const std::string& words : wanted) {
        JobWords own = job;
        const std::size_t colon = words.find(':');
        own.scheme = words.substr(0, colon);
        if (colon != std::string::npos) own.normals = words.substr(colon + 1);
        const TessellationOptions options = resolve(own, subject.patches);
        cells.push_back({label(words), options,
                         std::make_unique<SceneTessellator>(subject.device, subject.patches, options, subject.hair,
                                                            subject.hair_options)});
    }
    return cells;
}

}  // namespace tessera::cli
