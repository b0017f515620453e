#include "bench/serial_kernel.hpp"

#include "base/error.hpp"
#include "bench/marks.hpp"
#include "bench/sanity.hpp"
#include "layout.h"
#include "tessellate/stage.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace tessera::bench {
namespace {

class SerialKernel final : public Peer {
public:
    SerialKernel(gpu::Device device, const Workload& workload)
        : device_(std::move(device)),
          workload_(workload),
          job_(device_, workload.patches, workload.options, device_.limits()),
          parameters_(device_, 1) {
        std::uint64_t vertex_bytes = 4;
        std::uint64_t index_bytes = 4;
        for (std::size_t chunk = 0; chunk < job_.chunk_count(); ++chunk) {
            job_.count(chunk);
            for (const Batch& batch : job_.prepare()) {
                vertex_bytes = std::max<std::uint64_t>(vertex_bytes, std::uint64_t{batch.vertex_count} * 32);
                index_bytes = std::max<std::uint64_t>(index_bytes, std::uint64_t{batch.index_count} * 4);
            }
        }
        constexpr auto usage =
            gpu::BufferUsage::storage | gpu::BufferUsage::copy_source | gpu::BufferUsage::copy_destination;
        vertices_ = device_.create_buffer({"vertices of the serial kernel", vertex_bytes, usage});
        indices_ = device_.create_buffer({"indices of the serial kernel", index_bytes, usage});
        stage_ = Stage(device_, "serial_cubic_quadratic_triangle",
                       {view(StageId::control_nets), view(StageId::factors), view(StageId::scan), vertices_, indices_},
                       parameters_);
    }

    void run() override {
        go([](const Batch&) {});
        device_.queue().wait();
    }

    OutputSize size() const override { return size_; }

    // To the bit what our own kernels write.
    std::string check() override {
        poison_ = true;
        OutputCheck own{0, hash_start, hash_start};
        go([&](const Batch& batch) {
            look_at(vertices_, std::uint64_t{batch.vertex_count} * VERTEX_FLOATS, own.unwritten, own.vertex_hash);
            look_at(indices_, batch.index_count, own.unwritten, own.index_hash);
        });
        poison_ = false;
        const OutputCheck expected = check_output(device_, workload_);
        if (own.unwritten > 0) return fmt::format("{} words of the output were not written.", own.unwritten);
        if (own.vertex_hash != expected.vertex_hash) return "Its vertices differ from those of the stages.";
        if (own.index_hash != expected.index_hash) return "Its triangles differ from those of the stages.";
        return {};
    }

    std::string note() const override { return "one work item walks its patch, points and triangles in turn"; }

private:
    gpu::Buffer view(StageId stage) const {
        for (const StageView& view : job_.prepared_views()) {
            if (view.stage == stage) return view.buffer;
        }
        throw Error(ErrorKind::usage, fmt::format("A job has no buffer of the stage {}.", name(stage)));
    }

    void look_at(const gpu::Buffer& buffer, std::uint64_t count, std::uint64_t& unwritten, std::uint64_t& hash) {
        std::vector<std::uint32_t> words(count);
        device_.queue().read_buffer(buffer, 0, std::as_writable_bytes(std::span(words)));
        unwritten += count_unwritten(words);
        hash = hash_words(words, hash);
    }

    template <typename Look>
    void go(Look&& look) {
        OutputSize size;
        for (std::size_t chunk = 0; chunk < job_.chunk_count(); ++chunk) {
            job_.count(chunk);
            for (const Batch& batch : job_.prepare()) {
                emit(batch, static_cast<std::uint32_t>(size.vertices));
                size.vertices += batch.vertex_count;
                size.triangles += batch.index_count / 3;
                look(batch);
            }
        }
        size_ = size;
    }

    void emit(const Batch& batch, std::uint32_t vertex_base) {
        kernels::EmitParams params{};
        params.first = batch.first_patch;
        params.count = batch.patch_count;
        params.first_vertex = batch.first_vertex;
        params.first_index = batch.first_index;
        params.vertex_base = vertex_base;
        params.net_stride = net_stride(workload_.options, false);
        parameters_.reset();
        gpu::CommandEncoder encoder = device_.create_command_encoder();
        if (poison_) {
            encoder.fill_buffer(vertices_, 0, vertices_.size(), sentinel);
            encoder.fill_buffer(indices_, 0, indices_.size(), sentinel);
        }
        gpu::ComputePass pass = encoder.begin_compute_pass();
        stage_.record(pass, parameters_.push(params), batch.patch_count);
        pass.end();
        parameters_.upload(device_);
        device_.queue().submit(encoder.finish());
    }

    gpu::Device device_;
    const Workload& workload_;
    Job job_;
    ParameterRing parameters_;
    gpu::Buffer vertices_, indices_;
    Stage stage_;
    OutputSize size_;
    bool poison_ = false;
};

}  // namespace

PeerMaker serial_kernel_peer(const gpu::Device& device) {
    return {serial_peer_prefix + device.info().id,
            [device](const Workload& workload) -> std::unique_ptr<Peer> {
                if (workload.patches.has_quads || workload.options.scheme != Scheme::pn ||
                    workload.options.normals != Normals::quadratic) {
                    return nullptr;
                }
                return std::make_unique<SerialKernel>(device, workload);
            },
            device.info().software};
}

}  // namespace tessera::bench
