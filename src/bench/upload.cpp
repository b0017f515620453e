#include "bench/upload.hpp"

#include "bench/job_run.hpp"

#include <algorithm>
#include <memory>

namespace tessera::bench {
namespace {

constexpr auto usage = gpu::BufferUsage::storage | gpu::BufferUsage::copy_destination;
constexpr std::uint64_t piece_bytes = 64ull << 20;

// Data of a given size on its way to a device, in pieces of one buffer.
class Upload {
public:
    Upload(const gpu::Device& device, std::uint64_t bytes)
        : device_(device), bytes_(bytes), data_(std::min(bytes, piece_bytes)) {
        buffer_ = device_.create_buffer({"upload", data_.size(), usage});
    }

    void run() {
        for (std::uint64_t at = 0; at < bytes_; at += data_.size()) {
            const std::size_t size = std::min<std::uint64_t>(data_.size(), bytes_ - at);
            device_.queue().write_buffer(buffer_, 0, std::span(data_).first(size));
        }
        device_.queue().wait();
    }

private:
    gpu::Device device_;
    std::uint64_t bytes_;
    std::vector<std::byte> data_;
    gpu::Buffer buffer_;
};

}  // namespace

Table upload_table() {
    return {"traffic",
            "memory traffic, a coarse mesh refined on the device against the refined mesh uploaded",
            "Per frame. Coarse: control vertices, patches, factors and parameters go up and the job runs. Refined: "
            "vertices and indices go up, made elsewhere at no cost.",
            {"device", "workload", "coarse, MB up", "refined, MB up", "saving", "coarse, ms", "refined, ms"},
            {}};
}

void measure_upload(Table& table, const std::vector<gpu::Device>& devices, const Workload& workload,
                    const Effort& effort) {
    const std::uint64_t vertices = workload.patches.control_vertices.size() * sizeof(Vertex);
    std::vector<std::unique_ptr<JobRun>> jobs;
    std::vector<std::unique_ptr<Upload>> uploads;
    std::vector<Contestant> contestants;
    for (const gpu::Device& device : devices) {
        auto job = std::make_unique<JobRun>(device, workload);
        job->run();
        auto coarse = std::make_unique<Upload>(device, vertices);
        auto refined = std::make_unique<Upload>(device, job->size().bytes());
        contestants.push_back({"coarse", [j = job.get(), c = coarse.get()] {
                                   c->run();
                                   j->run();
                               }});
        contestants.push_back({"refined", [r = refined.get()] { r->run(); }});
        jobs.push_back(std::move(job));
        uploads.push_back(std::move(coarse));
        uploads.push_back(std::move(refined));
    }
    interleave(contestants, effort);
    for (std::size_t d = 0; d < devices.size(); ++d) {
        const double coarse = static_cast<double>(vertices + jobs[d]->traffic().uploaded) * 1e-6;
        const double refined = static_cast<double>(jobs[d]->size().bytes()) * 1e-6;
        table.rows.push_back({devices[d].info().id, workload.id, coarse, refined, refined / coarse,
                              summarise(contestants[2 * d].seconds).median * 1e3,
                              summarise(contestants[2 * d + 1].seconds).median * 1e3});
    }
}

}  // namespace tessera::bench
