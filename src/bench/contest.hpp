// Times contestants side by side: A B A B ..., so that what else the machine does hits all of them alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tessera::bench {

struct Effort {
    int repetitions = 15;
    int warm_ups = 2;           ///< runs that do not count
    double seconds_each = 8.0;  ///< a contestant that has used these sits out, but not before its third sample
    /// A turn begins with runs that are not timed, for so many seconds: the threads of whoever had the turn before come
    /// to rest, and one's own wake up.
    double settling = 0.02;
};

/// Something that is timed. One call of `run` is one sample and returns when the work is done.
struct Contestant {
    std::string name;
    std::function<void()> run;
    std::function<void()> after = {};  ///< called after each timed run, off the clock
    std::vector<double> seconds = {};  ///< the samples
};

/// Warms up, settles and times all contestants in turn. Exceptions of a contestant pass through.
void interleave(std::vector<Contestant>& contestants, const Effort& effort);

/// Seconds that one call takes, by the steady clock.
double time_once(const std::function<void()>& run);

}  // namespace tessera::bench
