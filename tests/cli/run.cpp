#include "cli/run.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace tessera::test {
namespace {

std::string quoted(const std::string& word) {
    std::string result = "'";
    for (const char c : word) {
        result += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return result + "'";
}

}  // namespace

Result run(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
    const Folder folder;
    std::string command = "env";
    for (const std::string& change : environment) {
        command += change.find('=') == std::string::npos ? " -u " + quoted(change) : " " + quoted(change);
    }
    command += " " + quoted(TESSERA_BINARY);
    for (const std::string& argument : arguments) {
        command += " " + quoted(argument);
    }
    command += " >" + quoted(folder.file("output")) + " 2>" + quoted(folder.file("errors")) + " </dev/null";
    const int status = std::system(command.c_str());
    Result result;
    // The shell tells of a signal by 128 and its number.
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.code = code > 128 ? 128 - code : code;
    result.output = read_file(folder.file("output"));
    result.errors = read_file(folder.file("errors"));
    return result;
}

std::vector<std::string> no_devices() {
    return {"VK_ADD_DRIVER_FILES", "VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent",
            "OCL_ICD_VENDORS=/nonexistent"};
}

Folder::Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "tessera-cli-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
        throw std::runtime_error("no temporary folder");
    }
    path_ = pattern;
}

Folder::~Folder() {
    std::filesystem::remove_all(path_);
}

std::vector<std::string> Folder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
        names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

std::string read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

bool is_one_sentence(const std::string& errors) {
    return errors.starts_with("tessera: ") && errors.ends_with(".\n") && std::ranges::count(errors, '\n') == 1;
}

}  // namespace tessera::test
