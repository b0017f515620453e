#include "base/host_memory.hpp"

#include <sys/mman.h>

#include <cstdint>
#include <cstring>
#include <new>

namespace tessera {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::align_val_t small_alignment{4096};

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
#else
constexpr bool sanitized = false;
#endif

}  // namespace

HostMemory::HostMemory(std::size_t size) : size_(size) {
    if (size < huge_page || sanitized) {
        data_ = static_cast<std::byte*>(::operator new(size, small_alignment));
        std::memset(data_, 0, size);
        return;
    }
    // Huge pages start on multiples of their size, mappings on any page.
    if (size > SIZE_MAX - huge_page) throw std::bad_alloc();
    mapped_ = size + huge_page;
    mapping_ = mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapping_ == MAP_FAILED) throw std::bad_alloc();
    const auto begin = reinterpret_cast<std::uintptr_t>(mapping_);
    data_ = static_cast<std::byte*>(mapping_) + (huge_page - begin % huge_page) % huge_page;
#ifdef MADV_HUGEPAGE
    // Whole ones only, so that no more memory is taken than asked for. A system without them says no, and that is fine.
    (void)madvise(data_, size / huge_page * huge_page, MADV_HUGEPAGE);
#endif
}

HostMemory::~HostMemory() {
    if (mapping_ != nullptr) {
        munmap(mapping_, mapped_);
    } else {
        ::operator delete(data_, small_alignment);
    }
}

}  // namespace tessera
