// Peers are timed only if what they make is right; here they are seen to be right, and to be caught when not.
#include "bench/peers/peers.hpp"
#include "bench/fixed_function_peer.hpp"
#include "bench/marks.hpp"
#include "bench/serial_kernel.hpp"
#include "bench/small_workload.hpp"
#include "support/devices.hpp"
#include "support/wrapped_backend.hpp"

#include <gtest/gtest.h>

namespace tessera::bench {
namespace {

class SerialKernel : public testing::TestWithParam<gpu::DeviceInfo> {};

TEST_P(SerialKernel, GivesTheBitsOfTheStages) {
    const PeerMaker maker = serial_kernel_peer(test::open_device(GetParam().id));
    for (const Partitioning partitioning :
         {Partitioning::integer, Partitioning::pow2, Partitioning::fractional_odd, Partitioning::fractional_even}) {
        Workload workload = test::uneven_workload();
        workload.options.partitioning = partitioning;
        const auto peer = maker.make(workload);
        ASSERT_NE(peer, nullptr);
        EXPECT_EQ(peer->check(), "") << name(partitioning);
    }
    for (const float factor : {1.0f, 2.0f, 3.0f, 64.0f}) {
        const Workload workload = test::small_workload("shape:icosahedron", factor);
        EXPECT_EQ(maker.make(workload)->check(), "") << factor;
    }
}

TESSERA_ON_EVERY_DEVICE(SerialKernel);

TEST(HostPeers, AgreeWithTheReference) {
    for (const PeerMaker& maker : peers::host_peers()) {
        for (const float factor : {2.0f, 5.0f, 16.0f}) {
            const Workload workload = test::small_workload("shape:sphere:3", factor);
            const auto peer = maker.make(workload);
            ASSERT_NE(peer, nullptr) << maker.name;
            peer->run();
            EXPECT_EQ(peer->check(), "") << maker.name << ", factor " << factor;
            EXPECT_GT(peer->bytes(), 0u);
        }
        EXPECT_EQ(maker.make(test::uneven_workload()), nullptr) << maker.name;
    }
}

TEST(HostPeers, TheHandWrittenOneIsHeldAgainstTheWorkload) {
    for (const PeerMaker& maker : peers::host_peers()) {
        if (maker.name != hand_written_peer) continue;
        Workload workload = test::small_workload("shape:sphere:3", 5.0f);
        const auto peer = maker.make(workload);
        workload.options.alpha = 0.5f;  // of no account to PN
        EXPECT_EQ(peer->check(), "");
        workload.options.scheme = Scheme::phong;  // now the reference makes another surface
        EXPECT_NE(peer->check(), "");
    }
}

TEST(FixedFunctionPeer, CapturesEveryTriangle) {
    bool any = false;
    for (const gpu::DeviceInfo& info : test::machine().devices) {
        if (!info.tessellation_stage) continue;
        any = true;
        const Workload workload = test::small_workload("shape:icosahedron", 16.0f);
        for (const PeerMaker& maker : fixed_function_peers(backends::open_timed_stage(info.id))) {
            const auto peer = maker.make(workload);
            peer->run();
            EXPECT_EQ(peer->check(), "") << maker.name;
            if (maker.name.starts_with(captured_peer_prefix)) {
                EXPECT_EQ(peer->size().triangles, 20u * 384u);
                EXPECT_EQ(peer->bytes(), 20u * 384u * 96u);
            } else {
                EXPECT_EQ(peer->bytes(), 0u);
            }
        }
    }
    if (!any) GTEST_SKIP() << "no device here has a tessellation stage";
}

}  // namespace
}  // namespace tessera::bench
