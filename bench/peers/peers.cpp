#include "bench/peers/peers.hpp"

#include "bench/marks.hpp"
#ifdef TESSERA_HAND_WRITTEN
#include "bench/peers/hand_written.hpp"
#endif
#ifdef TESSERA_OPENSUBDIV
#include "bench/peers/opensubdiv_peer.hpp"
#endif

namespace tessera::peers {

std::vector<bench::PeerMaker> host_peers() {
    std::vector<bench::PeerMaker> peers;
#ifdef TESSERA_HAND_WRITTEN
    peers.push_back({bench::hand_written_peer, make_hand_written, true});
#endif
#ifdef TESSERA_OPENSUBDIV
    peers.push_back({opensubdiv_peer, make_opensubdiv, true});
#endif
    return peers;
}

std::vector<bench::Missing> peers_not_built() {
    std::vector<bench::Missing> missing;
#ifndef TESSERA_HAND_WRITTEN
    missing.push_back({bench::hand_written_peer, "It is written for x86-64 and was not built."});
#endif
#ifndef TESSERA_OPENSUBDIV
    missing.push_back({"OpenSubdiv", "It was not built; libosd-dev was not installed."});
#endif
    return missing;
}

}  // namespace tessera::peers
