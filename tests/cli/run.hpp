// Runs the built program as a user would.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tessera::test {

struct Result {
    int code = -1;  ///< exit code, or minus the signal that ended the program
    std::string output, errors;
};

/// Runs `tessera` with these arguments; `environment` holds NAME=VALUE additions, or NAME alone to remove one.
Result run(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {});

/// No Vulkan driver and no OpenCL platform: the reference alone.
std::vector<std::string> no_devices();

/// An empty folder that goes away with the test.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string file(const std::string& name) const { return (path_ / name).string(); }
    /// Names of what is there, sorted.
    std::vector<std::string> names() const;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& text);

/// True for "tessera: A sentence.\n" and nothing else.
bool is_one_sentence(const std::string& errors);

}  // namespace tessera::test
