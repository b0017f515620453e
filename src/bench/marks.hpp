// The marks that speed is held to.
#pragma once

#include "bench/report.hpp"

namespace tessera::bench {

/// Names under which peers are looked up.
inline constexpr const char* hand_written_peer = "hand-written C++";
inline constexpr const char* serial_peer_prefix = "serial kernel on ";
inline constexpr const char* captured_peer_prefix = "fixed function captured on ";
inline constexpr const char* discarded_peer_prefix = "fixed function discarded on ";
inline constexpr const char* drawn_peer_prefix = "fixed function drawn on ";

/// All marks, from the figures and tables of the report; those of what was not measured have no value.
std::vector<Mark> make_marks(const Report& report);

}  // namespace tessera::bench
