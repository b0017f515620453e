#include "bench/run_bench.hpp"

#include "base/error.hpp"
#include "bench/drawing.hpp"
#include "bench/growth.hpp"
#include "bench/marks.hpp"
#include "bench/roofs.hpp"
#include "bench/streaming_stores.hpp"
#include "bench/upload.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera::bench {
namespace {

using Say = std::function<void(const std::string&)>;

struct Ours {
    gpu::Device device;
    std::unique_ptr<JobRun> job;
    std::string unsound;
    std::vector<std::vector<double>> stages = std::vector<std::vector<double>>(stage_count);
};

struct Theirs {
    const PeerMaker* maker;
    std::unique_ptr<Peer> peer;
    std::string unsound;
};

std::string wrong_with(const OutputCheck& check, const std::optional<OutputCheck>& expected) {
    if (check.unwritten > 0) {
        return fmt::format("{} words of the output were not written.", check.unwritten);
    }
    if (expected && (check.vertex_hash != expected->vertex_hash || check.index_hash != expected->index_hash)) {
        return "The output differs from that of the first device.";
    }
    return {};
}

/// The fastest way to write that was seen in this run, beside whatever workload.
WriteRoof host_roof(const Report& report) {
    WriteRoof best;
    for (const Roof& roof : report.roofs) {
        if (roof.where == "host" && roof.name != "copy" && roof.rate.greatest > best.bytes_per_second) {
            best = {roof.rate.greatest, roof.bytes};
        }
    }
    return best;
}

void set_fraction(Figure& figure, const Report& report, const std::string& where, const std::string& name) {
    const Roof* roof = report.find_roof(figure.workload, where, name);
    if (roof != nullptr && figure.seconds.median > 0.0 && roof->rate.median > 0.0) {
        figure.roof_fraction = static_cast<double>(figure.bytes) / figure.seconds.median / roof->rate.median;
    }
}

void judge(Figure& figure, const Report& report, bool on_host, const std::string& unsound) {
    figure.unsound = !unsound.empty();
    figure.rejected = unsound;
    if (on_host && figure.rejected.empty()) {
        figure.rejected = beats_roof(figure.bytes, figure.seconds.median, host_roof(report));
    }
}

Figure figure_of(const Workload& workload, const Ours& ours, const Contestant& timed, const Report& report) {
    Figure figure;
    const gpu::DeviceInfo& info = ours.device.info();
    figure.workload = workload.id;
    figure.contestant = info.id;
    figure.seconds = summarise(timed.seconds);
    figure.vertices = ours.job->size().vertices;
    figure.triangles = ours.job->size().triangles;
    figure.bytes = ours.job->size().bytes();
    figure.dispatches = ours.job->traffic().dispatches;
    figure.extra_memory = ours.job->extra_memory();
    if (info.timestamps) {
        for (std::size_t s = 0; s < stage_count; ++s) {
            figure.stages.emplace_back(name(static_cast<StageId>(s)), summarise(ours.stages[s]));
        }
    }
    set_fraction(figure, report, info.software ? "host" : info.id, info.software ? streaming_roof_name : "fill");
    judge(figure, report, info.software, ours.unsound);
    return figure;
}

Figure figure_of(const Workload& workload, const Theirs& theirs, const Contestant& timed, const Report& report) {
    Figure figure;
    figure.workload = workload.id;
    figure.contestant = theirs.maker->name;
    figure.peer = true;
    std::vector<double> seconds = timed.seconds;
    for (double& s : seconds) {
        s *= theirs.peer->scale();
    }
    const auto whole = [&](std::uint64_t part) {
        return static_cast<std::uint64_t>(static_cast<double>(part) * theirs.peer->scale() + 0.5);
    };
    figure.seconds = summarise(seconds);
    figure.vertices = whole(theirs.peer->size().vertices);
    figure.triangles = whole(theirs.peer->size().triangles);
    figure.bytes = whole(theirs.peer->bytes());
    figure.note = theirs.peer->note();
    if (theirs.maker->on_host) {
        set_fraction(figure, report, "host", streaming_roof_name);
    }
    judge(figure, report, theirs.maker->on_host, theirs.unsound);
    return figure;
}

void add_roofs(Report& report, const std::string& workload, const std::vector<Contestant>& contestants,
               std::size_t first, std::size_t count, const std::string& where, std::uint64_t bytes) {
    for (std::size_t i = first; i < first + count; ++i) {
        std::vector<double> rates;
        for (const double seconds : contestants[i].seconds) {
            rates.push_back(static_cast<double>(bytes) / seconds);
        }
        report.roofs.push_back(
            {workload, where, where == "host" ? contestants[i].name : "fill", summarise(rates), bytes});
    }
}

class Run {
public:
    Run(const Settings& settings, const Say& say) : settings_(settings), say_(say) {}

    Report take() {
        describe_machine();
        for (const std::string& id : job_workloads()) {
            if (wanted(id)) guarded(id, [&] { measure(make_workload(id, settings_.source)); });
        }
        if (wanted("W5")) {
            guarded("W5", [&] {
                say_("W5: many copies of one model");
                std::ranges::move(
                    measure_copies(settings_.devices, settings_.source, settings_.effort, settings_.rasterisers),
                    std::back_inserter(report_.tables));
            });
        }
        if (wanted("W6")) {
            guarded("W6", [&] {
                say_("W6: from one patch to many");
                report_.tables.push_back(measure_growth(settings_.devices, settings_.effort, settings_.source.quick));
            });
        }
        if (wanted("W7")) {
            guarded("W7", [&] {
                say_("W7: drawing");
                measure_drawing(report_, settings_.devices, settings_.effort, settings_.rasterisers,
                                settings_.source.quick);
            });
        }
        measure_traffic();
        report_.marks = make_marks(report_);
        return std::move(report_);
    }

private:
    // "W3" asks for W3-1 too. Factor 64 is for GPUs.
    bool wanted(const std::string& id) const {
        const bool gpu =
            std::ranges::any_of(settings_.devices, [](const gpu::Device& d) { return !d.info().software; });
        return (id != "W1-64" || gpu) &&
               std::ranges::any_of(settings_.workloads, [&](const std::string& w) { return id.starts_with(w); });
    }

    template <typename Body>
    void guarded(const std::string& what, Body&& body) {
        try {
            body();
        } catch (const Error& error) {
            report_.missing.push_back({what, error.what()});
        }
    }

    void measure_traffic() {
        Table table = upload_table();
        for (const char* id : {"W1", "W3"}) {
            if (!wanted(id)) continue;
            guarded(fmt::format("memory traffic of {}", id), [&] {
                say_(fmt::format("memory traffic of {}", id));
                measure_upload(table, settings_.devices, make_workload(id, settings_.source), settings_.effort);
            });
        }
        if (!table.rows.empty()) report_.tables.push_back(std::move(table));
    }

    void describe_machine() {
        report_.quick = settings_.source.quick;
        report_.missing = settings_.missing;
        report_.threads = thread_count();
        report_.streaming_stores = streaming_store_name();
        for (const gpu::Device& device : settings_.devices) {
            report_.devices.push_back(device.info());
            if (device.info().backend == "reference") report_.cpu = device.info().name;
        }
    }

    std::vector<Ours> open_jobs(const Workload& workload) {
        std::vector<Ours> jobs;
        std::optional<OutputCheck> expected;
        for (const gpu::Device& device : settings_.devices) {
            guarded(fmt::format("{} on {}", workload.id, device.info().id), [&] {
                const OutputCheck check = check_output(device, workload);
                Ours ours{device, std::make_unique<JobRun>(device, workload), wrong_with(check, expected)};
                if (!expected) expected = check;
                jobs.push_back(std::move(ours));
            });
        }
        return jobs;
    }

    // Three runs after one that warms up: measured apart, for measuring costs.
    static void time_stages(Ours& ours, const Workload& workload) {
        JobRun timed(ours.device, workload, true);
        timed.run();
        for (int run = 0; run < 3; ++run) {
            timed.run();
            for (std::size_t s = 0; s < stage_count; ++s) {
                ours.stages[s].push_back(timed.stage_seconds()[s]);
            }
        }
    }

    std::vector<Theirs> open_peers(const Workload& workload) {
        std::vector<Theirs> peers;
        for (const PeerMaker& maker : settings_.peers) {
            guarded(fmt::format("{} for {}", maker.name, workload.id), [&] {
                Theirs theirs{&maker, maker.make(workload), {}};
                if (theirs.peer == nullptr) return;
                // Each check runs the peer in a way of its own, so this comes first: it tells the size.
                theirs.peer->run();
                theirs.unsound = theirs.peer->check();
                peers.push_back(std::move(theirs));
            });
        }
        return peers;
    }

    // The roofs run among the contestants, so that they have the machine as it is just then.
    void measure(const Workload& workload) {
        say_(fmt::format("{}: {}", workload.id, workload.description));
        report_.workloads.emplace_back(workload.id, workload.description);
        std::vector<Ours> jobs = open_jobs(workload);
        std::vector<Theirs> peers = open_peers(workload);
        std::vector<Contestant> contestants;
        const std::uint64_t roof_bytes = settings_.source.quick ? 16ull << 20 : 256ull << 20;
        HostRoofs roofs(roof_bytes);
        roofs.add_to(contestants);
        std::vector<std::unique_ptr<FillRoof>> fills;
        for (const gpu::Device& device : settings_.devices) {
            fills.push_back(std::make_unique<FillRoof>(device, roof_bytes));
            contestants.push_back({"fill", [fill = fills.back().get()] { fill->fill(); }});
        }
        const std::size_t first_job = contestants.size();
        for (Ours& ours : jobs) {
            Ours* o = &ours;
            contestants.push_back({ours.device.info().id, [o] { o->job->run(); }});
        }
        for (Theirs& theirs : peers) {
            contestants.push_back({theirs.maker->name, [p = theirs.peer.get()] { p->run(); }});
        }
        interleave(contestants, settings_.effort);
        for (Ours& ours : jobs) {
            time_stages(ours, workload);
        }
        add_roofs(report_, workload.id, contestants, 0, 3, "host", roofs.bytes());
        for (std::size_t i = 0; i < fills.size(); ++i) {
            add_roofs(report_, workload.id, contestants, 3 + i, 1, settings_.devices[i].info().id, fills[i]->bytes());
        }
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            report_.figures.push_back(figure_of(workload, jobs[i], contestants[first_job + i], report_));
        }
        for (std::size_t i = 0; i < peers.size(); ++i) {
            Figure figure = figure_of(workload, peers[i], contestants[first_job + jobs.size() + i], report_);
            if (figure.vertices == 0 && !jobs.empty()) {  // it keeps nothing that could be counted
                figure.vertices = jobs.front().job->size().vertices;
                figure.triangles = jobs.front().job->size().triangles;
            }
            report_.figures.push_back(std::move(figure));
        }
    }

    const Settings& settings_;
    const Say& say_;
    Report report_;
};

}  // namespace

const Roof* Report::find_roof(const std::string& workload, const std::string& where, const std::string& name) const {
    const auto found = std::ranges::find_if(
        roofs, [&](const Roof& roof) { return roof.workload == workload && roof.where == where && roof.name == name; });
    return found == roofs.end() ? nullptr : &*found;
}

const Figure* Report::find_figure(const std::string& workload, const std::string& contestant) const {
    const auto found = std::ranges::find_if(figures, [&](const Figure& figure) {
        return figure.workload == workload && figure.contestant == contestant && figure.rejected.empty();
    });
    return found == figures.end() ? nullptr : &*found;
}

Report run_bench(const Settings& settings, const std::function<void(const std::string&)>& say) {
    return Run(settings, say).take();
}

}  // namespace tessera::bench
