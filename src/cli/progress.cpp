#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace tessera::cli {

Progress::Progress(std::string what, bool quiet)
    : what_(std::move(what)), active_(!quiet && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (shown_) {
        fmt::print(stderr, "\r\033[K");
    }
}

void Progress::update(double fraction) {
    using namespace std::chrono_literals;
    const Clock::time_point now = Clock::now();
    if (!active_ || now - start_ < 1s || now - last_ < 100ms) {
        return;
    }
    last_ = now;
    shown_ = true;
    fmt::print(stderr, "\r\033[K{} {:3.0f} %", what_, fraction * 100.0);
    std::fflush(stderr);
}

}  // namespace tessera::cli
