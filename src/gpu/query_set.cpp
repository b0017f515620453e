#include "gpu/validation.hpp"

namespace tessera::gpu {

QuerySet Device::create_query_set(std::uint32_t count) {
    detail::not_null(state_, "create_query_set", "device");
    if (!info().timestamps) {
        detail::refuse("create_query_set needs timestamps, which device {} ({}) does not have.", info().id,
                       info().name);
    }
    if (count == 0 || count > max_query_set_size) {
        detail::refuse("create_query_set got a count of {}; it must be 1 to {}.", count, max_query_set_size);
    }
    QuerySet queries;
    queries.state_ = std::make_shared<detail::QuerySetState>();
    queries.state_->device = state_;
    queries.state_->count = count;
    queries.state_->written.resize(count);
    queries.state_->object = state_->backend->create_query_set(count);
    return queries;
}

}  // namespace tessera::gpu
