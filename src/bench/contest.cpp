#include "bench/contest.hpp"

#include <chrono>
#include <numeric>

namespace tessera::bench {
namespace {

constexpr std::size_t least_samples = 3;
constexpr double long_run = 0.1;  // seconds; hardly touched by how a turn begins

void settle(const Contestant& contestant, double settling) {
    if (settling <= 0.0 || (!contestant.seconds.empty() && contestant.seconds.back() > long_run)) return;
    for (double settled = 0.0; settled < settling;) {
        settled += time_once(contestant.run);
    }
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
            settle(contestant, effort.settling);
            contestant.seconds.push_back(time_once(contestant.run));
            if (contestant.after) contestant.after();
        }
    }
}

}  // namespace tessera::bench
