#include "bench/contest.hpp"

#include <chrono>
#include <numeric>

namespace tessera::bench {
namespace {

constexpr std::size_t least_samples = 3;
// A turn begins with runs that are not timed, for as long as this: the threads of whoever had the turn before come to
// rest, and one's own wake up. Long runs are hardly touched by either.
constexpr std::chrono::milliseconds settling{2};
constexpr double long_run = 0.1;

void settle(const Contestant& contestant) {
    if (!contestant.seconds.empty() && contestant.seconds.back() > long_run) return;
    const auto end = std::chrono::steady_clock::now() + settling;
    do {
        contestant.run();
    } while (std::chrono::steady_clock::now() < end);
}

bool sits_out(const Contestant& contestant, const Effort& effort) {
    return contestant.seconds.size() >= least_samples &&
           std::accumulate(contestant.seconds.begin(), contestant.seconds.end(), 0.0) > effort.seconds_each;
}

}  // namespace

double time_once(const std::function<void()>& run) {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void interleave(std::vector<Contestant>& contestants, const Effort& effort) {
    for (Contestant& contestant : contestants) {
        for (int i = 0; i < effort.warm_ups; ++i) {
            // What takes long is warm after one run.
            if (time_once(contestant.run) > 1.0) break;
        }
        if (contestant.after) contestant.after();
        contestant.seconds.clear();
    }
    for (int i = 0; i < effort.repetitions; ++i) {
        for (Contestant& contestant : contestants) {
            if (sits_out(contestant, effort)) continue;
            settle(contestant);
            contestant.seconds.push_back(time_once(contestant.run));
            if (contestant.after) contestant.after();
        }
    }
}

}  // namespace tessera::bench
