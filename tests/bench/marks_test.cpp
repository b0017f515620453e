#include "bench/marks.hpp"
#include "bench/drawing.hpp"
#include "bench/growth.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace tessera::bench {
namespace {

gpu::DeviceInfo device(const std::string& id, const std::string& backend, const std::string& name, bool software) {
    gpu::DeviceInfo info;
    info.id = id;
    info.backend = backend;
    info.name = name;
    info.software = software;
    info.tessellation_stage = backend == "vulkan";
    return info;
}

Figure figure(const std::string& workload, const std::string& contestant, double milliseconds) {
    Figure f;
    f.workload = workload;
    f.contestant = contestant;
    f.seconds.median = milliseconds * 1e-3;
    return f;
}

Report software_report() {
    Report report;
    report.devices = {device("reference", "reference", "a CPU", true),
                      device("vulkan:0", "vulkan", "llvmpipe (LLVM)", true),
                      device("opencl:0", "opencl", "pthread", true)};
    report.figures = {figure("W1", "opencl:0", 10),
                      figure("W1", "vulkan:0", 50),
                      figure("W1", "reference", 30),
                      figure("W1", hand_written_peer, 12),
                      figure("W1", "fixed function captured on vulkan:0", 500),
                      figure("W1", "fixed function discarded on vulkan:0", 100)};
    report.figures[0].roof_fraction = 0.5;
    report.figures[0].extra_memory = 0.02;
    return report;
}

const Mark& find(const std::vector<Mark>& marks, const std::string& words) {
    const auto found =
        std::ranges::find_if(marks, [&](const Mark& m) { return m.name.find(words) != std::string::npos; });
    if (found == marks.end()) throw std::runtime_error("no mark is named " + words);
    return *found;
}

TEST(Marks, AreRatiosOfMedians) {
    const std::vector<Mark> marks = make_marks(software_report());
    EXPECT_EQ(marks.size(), 12u);
    EXPECT_DOUBLE_EQ(*find(marks, "W1 on PoCL against the hand-written").value, 1.2);
    EXPECT_TRUE(find(marks, "W1 on PoCL against the hand-written").met());
    EXPECT_DOUBLE_EQ(*find(marks, "PoCL against lavapipe fixed function").value, 50.0);
    EXPECT_DOUBLE_EQ(*find(marks, "lavapipe compute against lavapipe fixed function, discarded").value, 2.0);
    EXPECT_FALSE(find(marks, "lavapipe compute against lavapipe fixed function, discarded").met());
    EXPECT_DOUBLE_EQ(*find(marks, "reference backend").value, 0.4);
    EXPECT_TRUE(find(marks, "W1 on PoCL, whole job").met());
    EXPECT_TRUE(find(marks, "peak memory").met());
}

TEST(Marks, OfDrawingCompareMeshesOnDevices) {
    Report report = software_report();
    report.figures.push_back(figure("W7", portable_contestant("opencl:0", 4, false), 100));
    report.figures.push_back(figure("W7", portable_contestant("opencl:0", 4, true), 150));
    report.figures.push_back(figure("W7", portable_contestant("reference", 4, false), 80));
    report.figures.push_back(figure("W7", own_contestant("vulkan:0", false), 450));
    report.figures.push_back(figure("W7", own_contestant("vulkan:0", true), 500));
    const std::vector<Mark> marks = make_marks(report);
    EXPECT_DOUBLE_EQ(*find(marks, "W7 portable on PoCL").value, 4.5);
    EXPECT_DOUBLE_EQ(*find(marks, "W7 reference").value, 1.25);
}

TEST(Marks, WhatWasNotMeasuredIsNotMet) {
    const std::vector<Mark> marks = make_marks(software_report());
    EXPECT_FALSE(find(marks, "W2 on PoCL, fraction").value);
    EXPECT_FALSE(find(marks, "W2 on PoCL, fraction").met());
    EXPECT_FALSE(find(marks, "fixed cost").met());
    for (const Mark& mark : make_marks({})) {
        EXPECT_FALSE(mark.met()) << mark.name;
    }
}

TEST(Marks, ARejectedFigureCountsForNothing) {
    Report report = software_report();
    report.figures[0].rejected = "It would write more than memory takes.";
    const std::vector<Mark> marks = make_marks(report);
    EXPECT_FALSE(find(marks, "W1 on PoCL, whole job").value);
    EXPECT_FALSE(find(marks, "W1 on PoCL against the hand-written").value);
    EXPECT_TRUE(find(marks, "reference backend").value);
}

TEST(Marks, TheFixedCostComesFromTheTableOfGrowth) {
    Report report = software_report();
    report.tables = {{"W6", "", "", {"device", one_patch_column}, {{"reference", 0.1}, {"opencl:0", 0.6}}}};
    EXPECT_DOUBLE_EQ(*find(make_marks(report), "fixed cost").value, 0.6);
    EXPECT_FALSE(find(make_marks(report), "fixed cost").met());
}

TEST(Marks, AGpuIsHeldAgainstItsOwnStage) {
    Report report = software_report();
    report.devices.push_back(device("vulkan:1", "vulkan", "a GPU", false));
    report.figures.push_back(figure("W1", "vulkan:1", 2));
    report.figures.push_back(figure("W1", "fixed function discarded on vulkan:1", 3));
    const std::vector<Mark> marks = make_marks(report);
    EXPECT_EQ(marks.size(), 16u);
    EXPECT_TRUE(find(marks, "W1 on vulkan:1 against its tessellation stage, discarded").met());
    EXPECT_FALSE(find(marks, "W1-64 on vulkan:1").value);
}

}  // namespace
}  // namespace tessera::bench
