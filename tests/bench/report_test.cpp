// The forms of a report.
#include "bench/report.hpp"
#include "bench/marks.hpp"
#include "bench/plot.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tessera::bench {
namespace {

Report sample() {
    Report report;
    report.quick = true;
    report.cpu = "a CPU";
    report.threads = 4;
    gpu::DeviceInfo info;
    info.id = "opencl:0";
    info.backend = "opencl";
    info.name = "name | with a bar & <tags>";
    info.driver = "driver";
    info.software = true;
    report.devices = {info};
    report.workloads = {{"W1", "patches & more"}};
    report.roofs = {{"W1", "host", streaming_roof_name, {50e9, 45e9, 55e9, 40e9, 60e9, 15}, 1 << 28}};
    Figure good;
    good.workload = "W1";
    good.contestant = "opencl:0";
    good.seconds = {0.01, 0.009, 0.011, 0.008, 0.02, 15};
    good.vertices = 1000000;
    good.triangles = 2000000;
    good.bytes = 56000000;
    good.roof_fraction = 0.112;
    good.dispatches = 10;
    good.stages = {{"vertices", good.seconds}};
    Figure bad = good;
    bad.contestant = "hand";
    bad.peer = true;
    bad.rejected = "It would write 99.0 GB/s.";
    report.figures = {good, bad};
    report.tables = {{"W6", "growth", "a note", {"device", "ms"}, {{"opencl:0", 0.25}}}};
    report.marks = {{"met", 0.6, "x", 0.5, true}, {"missed", 0.6, "ms", 0.5, false}, {"unknown", {}, "x", 1, true}};
    report.missing = {{"OpenSubdiv", "It was not built."}};
    return report;
}

TEST(Json, HasTheMarksWithTheirFiveNames) {
    const nlohmann::ordered_json json = to_json(sample());
    ASSERT_EQ(json["marks"].size(), 3u);
    EXPECT_EQ(json["marks"][0]["name"], "met");
    EXPECT_EQ(json["marks"][0]["value"], 0.6);
    EXPECT_EQ(json["marks"][0]["unit"], "x");
    EXPECT_EQ(json["marks"][0]["mark"], 0.5);
    EXPECT_EQ(json["marks"][0]["met"], true);
    EXPECT_EQ(json["marks"][1]["met"], false);
    EXPECT_TRUE(json["marks"][2]["value"].is_null());
    EXPECT_EQ(json["marks"][2]["met"], false);
}

TEST(Json, HasFiguresInBasicUnits) {
    const nlohmann::ordered_json json = to_json(sample());
    const auto& figure = json["figures"][0];
    EXPECT_EQ(figure["seconds"]["median"], 0.01);
    EXPECT_EQ(figure["seconds"]["lower_quartile"], 0.009);
    EXPECT_EQ(figure["seconds"]["samples"], 15);
    EXPECT_DOUBLE_EQ(figure["vertices_per_second"].get<double>(), 1e8);
    EXPECT_DOUBLE_EQ(figure["triangles_per_second"].get<double>(), 2e8);
    EXPECT_DOUBLE_EQ(figure["bytes_per_second"].get<double>(), 5.6e9);
    EXPECT_EQ(figure["dispatches"], 10);
    EXPECT_EQ(figure["stage_seconds"]["vertices"]["median"], 0.01);
    EXPECT_TRUE(json["figures"][1]["rejected"].get<std::string>().starts_with("It would"));
    EXPECT_EQ(json["devices"][0]["software"], true);
    EXPECT_EQ(json["roofs"][0]["bytes_per_second"]["greatest"], 60e9);
    EXPECT_EQ(json["tables"][0]["rows"][0][1], 0.25);
    EXPECT_EQ(json["missing"][0]["what"], "OpenSubdiv");
}

TEST(Text, SaysWhatWasRejectedAndWhatIsMissing) {
    const std::string text = to_text(sample());
    for (const char* words : {"opencl:0", "driver", "software", "4 threads", "not to be quoted", "rejected",
                              "It would write 99.0 GB/s.", "OpenSubdiv is missing", "not measured", "0.112"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words;
    }
}

TEST(Markdown, HasOneCellPerColumn) {
    const std::string text = to_markdown(sample(), "Why it is so.\n");
    EXPECT_NE(text.find("Why it is so."), std::string::npos);
    EXPECT_NE(text.find("A quick run"), std::string::npos);
    std::istringstream lines(text);
    std::size_t cells = 0;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("|")) {
            cells = 0;
            continue;
        }
        std::size_t bars = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
        }
        EXPECT_TRUE(cells == 0 || bars == cells) << line;
        cells = bars;
    }
}

TEST(Plot, ShowsWhatCountsAndNothingElse) {
    const std::string svg = plot_svg(sample());
    EXPECT_NE(svg.find("opencl:0"), std::string::npos);
    EXPECT_NE(svg.find("patches &amp; more"), std::string::npos);
    EXPECT_EQ(svg.find("hand"), std::string::npos);  // rejected
    const image::Image image = plot_image(sample());
    ASSERT_EQ(image.rgba.size(), std::size_t{image.width} * image.height * 4);
    std::size_t blue = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        blue += image.rgba[i] == 31 && image.rgba[i + 1] == 78 && image.rgba[i + 2] == 121 ? 1 : 0;
    }
    EXPECT_GT(blue, 10000u);  // the one bar
}

}  // namespace
}  // namespace tessera::bench
