// Memory for large arrays that processors stream into.
#pragma once

#include <cstddef>

namespace tessera {

/// Zeroed memory that starts on a page, or throws std::bad_alloc. From 2 MiB on it asks the system for huge pages:
/// emission writes hundreds of megabytes past the caches, and with pages of 4 KiB it waits for address translation as
/// long as for memory. Under the address sanitizer it is an ordinary allocation of exactly `size` bytes, so that a
/// kernel that leaves its buffer by one byte is seen.
class HostMemory {
public:
    explicit HostMemory(std::size_t size);
    ~HostMemory();
    HostMemory(const HostMemory&) = delete;
    HostMemory& operator=(const HostMemory&) = delete;

    std::byte* data() const { return data_; }
    std::size_t size() const { return size_; }

private:
    std::size_t size_;
    std::byte* data_;
    void* mapping_ = nullptr;  // what data_ lies in
    std::size_t mapped_ = 0;
};

}  // namespace tessera
