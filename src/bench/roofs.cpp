#include "bench/roofs.hpp"

#include "bench/streaming_stores.hpp"

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

namespace tessera::bench {
namespace {

constexpr std::uint64_t block = 1ull << 20;

// Same blocks to the same threads every time would be fairer still to plain stores, but jobs are not run that way.
template <typename Body>
void for_each_block(std::uint64_t bytes, const Body& body) {
    oneapi::tbb::parallel_for(std::uint64_t{0}, bytes / block, [&](std::uint64_t i) { body(i * block); });
}

}  // namespace

HostRoofs::HostRoofs(std::uint64_t bytes)
    : bytes_(std::max<std::uint64_t>((bytes + block - 1) / block, 1) * block), first_(bytes_), second_(bytes_) {
    for_each_block(bytes_, [&](std::uint64_t at) {
        std::memset(first_.data() + at, 0, block);
        std::memset(second_.data() + at, 0, block);
    });
}

void HostRoofs::write_plain() {
    ++word_;
    for_each_block(bytes_, [&](std::uint64_t at) { plain_fill(first_.data() + at, block, word_); });
}

void HostRoofs::write_streaming() {
    ++word_;
    for_each_block(bytes_, [&](std::uint64_t at) { stream_fill(first_.data() + at, block, word_); });
}

void HostRoofs::copy() {
    for_each_block(bytes_, [&](std::uint64_t at) { std::memcpy(second_.data() + at, first_.data() + at, block); });
}

void HostRoofs::add_to(std::vector<Contestant>& contestants) {
    contestants.push_back({"write, plain", [this] { write_plain(); }});
    contestants.push_back({"write, non-temporal", [this] { write_streaming(); }});
    contestants.push_back({"copy", [this] { copy(); }});
}

FillRoof::FillRoof(const gpu::Device& device, std::uint64_t bytes) : device_(device) {
    const std::uint64_t most = std::min(device_.limits().max_buffer_size, device_.limits().max_storage_binding_size);
    buffer_ = device_.create_buffer(
        {"fill roof", std::min(bytes, most) / 64 * 64, gpu::BufferUsage::storage | gpu::BufferUsage::copy_destination});
}

void FillRoof::fill() {
    gpu::CommandEncoder encoder = device_.create_command_encoder();
    encoder.fill_buffer(buffer_, 0, buffer_.size(), sentinel);
    device_.queue().submit(encoder.finish());
    device_.queue().wait();
}

unsigned thread_count() {
    return static_cast<unsigned>(oneapi::tbb::info::default_concurrency());
}

}  // namespace tessera::bench
