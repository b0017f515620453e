// A file that appears whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace tessera {

/// Grows under a temporary name in the folder of `target` and takes its place in publish(). Without publish() the
/// temporary file is removed and `target` stays as it was. Every failure throws Error(output) with path and reason.
class OutputFile {
public:
    /// Refuses a target that is not a regular file or may not be written. A symbolic link is followed. The file gets
    /// the permissions of the one it replaces, else those the umask leaves.
    explicit OutputFile(const std::filesystem::path& target);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes all bytes at `offset` from the start of the file; what lies between is zero until written.
    void write_at(std::uint64_t offset, std::span<const std::byte> bytes);

    /// Ends writing. Some file systems report a full disk only here, so close every file before publishing any.
    void close();

    /// Closes, then renames to the target.
    void publish();

private:
    [[noreturn]] void fail(int error_number) const;

    std::filesystem::path named_;   // as the caller named it, for messages
    std::filesystem::path target_;  // with links followed
    std::filesystem::path temporary_;
    int descriptor_ = -1;
};

/// Each writes a whole file at once. They throw Error(output) like OutputFile.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_text(const std::filesystem::path& path, const std::string& text);

/// Appends text to an OutputFile in large pieces.
class TextOutput {
public:
    explicit TextOutput(OutputFile& file) : file_(file) {}

    /// The text not yet written; append to it, then call flush_if_large() now and then and flush() at the end.
    std::string& pending() { return pending_; }
    void flush_if_large();
    void flush();

private:
    OutputFile& file_;
    std::string pending_;
    std::uint64_t written_ = 0;
};

}  // namespace tessera
