// A progress bar on stderr, on a terminal only, for work that takes longer than a second.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace tessera::cli {

/// "what [#######-------]  50 %", at most `columns` long; without the bar where there is no room for it.
std::string progress_line(const std::string& what, double fraction, std::size_t columns);

class Progress {
public:
    Progress(std::string what, bool quiet);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `fraction` of the work is done, 0 to 1.
    void update(double fraction);
    /// Clears the line, for other words on the terminal.
    void clear();
    std::function<void(double)> callback() {
        return [this](double fraction) { update(fraction); };
    }

private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    bool shown_ = false;
    bool active_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

}  // namespace tessera::cli
