#include "base/output_file.hpp"

#include "base/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

namespace tessera {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t text_piece = std::size_t{1} << 18;

std::string cause_and_cure(int error_number) {
    switch (error_number) {
        case ENOENT:
        case ENOTDIR:
            return "its folder does not exist; create the folder or choose another path";
        case EACCES:
        case EPERM:
            return "permission denied; choose a place you may write to";
        case EROFS:
            return "the file system is read-only; choose another place";
        case EISDIR:
            return "it is a folder; name a file in it";
        case ENOSPC:
        case EDQUOT:
            return "no space is left; free some or choose another place";
        case EFBIG:
            return "the file became larger than the file system or the process limit allows";
        default:
            return std::generic_category().message(error_number);
    }
}

/// A name that no other writer of this process uses; O_EXCL guards against those of other processes. It does not
/// contain the target's name, which may already be as long as names can be.
fs::path temporary_name(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    return target.parent_path() / fmt::format(".tessera-{}-{}.tmp", ::getpid(), counter++);
}

}  // namespace

OutputFile::OutputFile(const fs::path& target) : named_(target), target_(target) {
    std::error_code ignored;
    if (fs::is_symlink(target, ignored)) {
        const fs::path resolved = fs::weakly_canonical(target, ignored);
        if (!ignored) target_ = resolved;
    }
    struct stat old = {};
    const bool replaces = ::stat(target_.c_str(), &old) == 0;
    if (replaces && S_ISDIR(old.st_mode)) fail(EISDIR);
    if (replaces && !S_ISREG(old.st_mode)) {
        throw Error(ErrorKind::output, fmt::format("Cannot write '{}': it is not a regular file, and a finished file "
                                                   "would take its place; name a file.",
                                                   named_.string()));
    }
    if (replaces && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);

    constexpr int attempts = 1000;  // a name is taken only by what a crash left behind
    for (int attempt = 0; attempt < attempts && descriptor_ < 0; ++attempt) {
        temporary_ = temporary_name(target_);
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) fail(errno);
    // Not fatal: some file systems have no permissions, and the umask has already kept the file from being too open.
    if (replaces) [[maybe_unused]]
        const int unsupported = ::fchmod(descriptor_, old.st_mode & 0777);
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::fail(int error_number) const {
    throw Error(ErrorKind::output,
                fmt::format("Cannot write '{}': {}.", named_.string(), cause_and_cure(error_number)));
}

void OutputFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(errno);
        if (written == 0) fail(ENOSPC);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
}

void OutputFile::close() {
    if (descriptor_ < 0) return;
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) fail(errno);
}

void OutputFile::publish() {
    close();
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    temporary_.clear();
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
    OutputFile file(path);
    file.write_at(0, bytes);
    file.publish();
}

void write_text(const fs::path& path, const std::string& text) {
    write_file(path, std::as_bytes(std::span(text)));
}

void TextOutput::flush_if_large() {
    if (pending_.size() >= text_piece) flush();
}

void TextOutput::flush() {
    file_.write_at(written_, std::as_bytes(std::span(pending_)));
    written_ += pending_.size();
    pending_.clear();
}

}  // namespace tessera
