#include "cli/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <algorithm>

namespace tessera::cli {
namespace {

std::size_t terminal_columns() {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return known ? size.ws_col : 80;
}

}  // namespace

std::string progress_line(const std::string& what, double fraction, std::size_t columns) {
    constexpr std::size_t longest = 40, shortest = 4;
    const double done = std::clamp(fraction, 0.0, 1.0);
    const std::string percent = fmt::format("{:3.0f} %", done * 100.0);
    const std::size_t words = what.size() + percent.size() + 4;  // and brackets, and spaces
    if (columns < words + shortest) return fmt::format("{} {}", what, percent).substr(0, columns);
    const std::size_t length = std::min(columns - words, longest);
    const auto full = static_cast<std::size_t>(done * static_cast<double>(length));
    return fmt::format("{} [{}{}] {}", what, std::string(full, '#'), std::string(length - full, '-'), percent);
}

Progress::Progress(std::string what, bool quiet)
    : what_(std::move(what)), active_(!quiet && isatty(STDERR_FILENO) != 0) {}

void Progress::clear() {
    if (shown_) fmt::print(stderr, "\r\033[K");
    shown_ = false;
}

void Progress::update(double fraction) {
    using namespace std::chrono_literals;
    const Clock::time_point now = Clock::now();
    if (!active_ || now - start_ < 1s || now - last_ < 100ms) {
        return;
    }
    last_ = now;
    shown_ = true;
    fmt::print(stderr, "\r\033[K{}", progress_line(what_, fraction, terminal_columns() - 1));
    std::fflush(stderr);
}

}  // namespace tessera::cli
