#include "findings.hpp"

#include "figures.hpp"
#include "kernel_costs.hpp"
#include "measure/patch_edges.hpp"

#include <array>

namespace tessera::findings {
namespace {

constexpr float measured_factor = 16.0f;

struct SchemeRow {
    std::string name;
    measure::AngleStatistics flat, phong, pn;  // jumps of the surfaces' own normals
    double shading = 0.0;                      // greatest jump of the three kinds of shading normals
    measure::AngleStatistics off_phong, off_linear, off_quadratic;  // shading normals from those of their surface
};

SchemeRow measure_model(const Bench& bench, const Model& model) {
    const auto make = [&](Scheme scheme, Normals normals) {
        TessellationOptions options;
        options.partitioning = Partitioning::integer;
        options.factors = equal_factors(measured_factor);
        options.scheme = scheme;
        options.normals = normals;
        return measure::make_patch_surface(bench.device, model.patches, options);
    };
    const measure::PatchEdges edges = measure::find_edges(model.patches);
    SchemeRow row;
    row.name = model.name;
    row.flat = measure::discontinuity(make(Scheme::linear, Normals::surface), edges);
    const auto shaded = [&](Scheme scheme, Normals normals, const measure::PatchSurface& own) {
        const auto surface = make(scheme, normals);
        row.shading = std::max(row.shading, measure::discontinuity(surface, edges).max);
        return measure::normal_angles(surface, own);
    };
    const auto phong = make(Scheme::phong, Normals::surface);
    row.phong = measure::discontinuity(phong, edges);
    row.off_phong = shaded(Scheme::phong, Normals::linear, phong);
    const auto pn = make(Scheme::pn, Normals::surface);
    row.pn = measure::discontinuity(pn, edges);
    row.off_linear = shaded(Scheme::pn, Normals::linear, pn);
    row.off_quadratic = shaded(Scheme::pn, Normals::quadratic, pn);
    return row;
}

void write_continuity(const std::vector<SchemeRow>& rows, Document& document) {
    Rows table{{"model", "flat: mean", "max", "phong: mean", "max", "pn: mean", "max", "shading jumps: max",
                "phong off: mean", "pn linear off: mean", "pn quadratic off: mean"}};
    for (const SchemeRow& r : rows) {
        table.push_back({r.name, degrees(r.flat.mean), degrees(r.flat.max), degrees(r.phong.mean), degrees(r.phong.max),
                         degrees(r.pn.mean), degrees(r.pn.max), degrees(r.shading), degrees(r.off_phong.mean),
                         degrees(r.off_linear.mean), degrees(r.off_quadratic.mean)});
    }
    document.table(table);
    document.paragraph(
        "Degrees. The first six columns: how far the surface itself turns at the edges between its patches (its true "
        "normals, 17 points per edge, edges as in finding 1), for the flat model, for Phong tessellation with alpha "
        "0.75 and for PN. *Shading jumps*: the same for the interpolated normals, the greatest of phong, pn linear and "
        "pn quadratic. *Off*: the angle between interpolated normals and those of the surface that they shade, over "
        "all vertices.");
    document.claim(std::ranges::all_of(rows, [](const SchemeRow& r) { return r.shading == 0.0; }),
                   "The normals that are shaded with are continuous across all edges in all three, bit by bit: they "
                   "depend on the edge's own corners only. What differs is the surface below them.");
    const auto pn_smoother = [](const SchemeRow& r) { return r.pn.mean < r.phong.mean; };
    const auto pn_rougher = [](const SchemeRow& r) { return r.pn.mean >= r.phong.mean; };
    const auto ratio = [](const SchemeRow& r) { return r.phong.mean / r.pn.mean; };
    document.claim(
        std::ranges::count_if(rows, pn_smoother) > 2 * std::ranges::count_if(rows, pn_rougher) &&
            names_of(rows, pn_rougher) == "shape:icosahedron, ball.glb" &&
            std::ranges::all_of(
                rows, [](const SchemeRow& r) { return r.pn.mean < r.flat.mean && r.phong.mean < r.flat.mean; }),
        fmt::format("Neither surface is smooth across edges, and both are far smoother than the model. PN "
                    "is the smoother one in the mean on {}, as Nunes et al. saw, where Phong creases up to "
                    "{:.1f} times as much; on {} Phong is, so it is no rule: these two are coarse spheres.",
                    share_of(rows, pn_smoother), range(rows, ratio).greatest, names_of(rows, pn_rougher)));
    const auto worse_max = [](const SchemeRow& r) { return r.pn.max > r.phong.max; };
    document.claim(
        std::ranges::any_of(rows, worse_max),
        fmt::format(
            "The sharpest crease of a model is another matter: with PN it is sharper than with Phong on {} ({}).",
            share_of(rows, worse_max), names_of(rows, worse_max)));
    const auto helps = [](const SchemeRow& r) { return r.off_quadratic.mean < r.off_linear.mean; };
    document.claim(
        std::ranges::count_if(rows, helps) * 2 > std::ranges::ssize(rows) && !std::ranges::all_of(rows, helps),
        fmt::format("Quadratic normals follow the PN surface better than linear ones on {}, but not on {}.",
                    share_of(rows, helps), names_of(rows, [&](const SchemeRow& r) { return !helps(r); })));
}

struct Scored {
    const char* what;
    Scheme scheme;
    Normals normals;
};
constexpr std::array<Scored, 3> scored{{{"phong, linear normals", Scheme::phong, Normals::linear},
                                        {"pn, linear normals", Scheme::pn, Normals::linear},
                                        {"pn, quadratic normals", Scheme::pn, Normals::quadratic}}};

// What a patch reads besides nets: corners, their indices, its number in the list, three alphas of Phong tessellation;
// then once more its number and two offsets of two words.
std::uint64_t patch_bytes(const Scored& s, const KernelCosts& costs) {
    const std::uint64_t once = 3 * sizeof(Vertex) + 12 + 4 + (s.scheme == Scheme::phong ? 12 : 0);
    return once + 2 * costs.net_bytes + 4 + 16;
}

// Two pattern words read, a vertex written.
constexpr std::uint64_t vertex_bytes = 8 + sizeof(Vertex);

void write_costs(const Bench& bench, Document& document) {
    document.subheading("What they cost");
    std::array<double, 3> factors{1, 4, 16};
    std::array<double, 3> points{};
    for (std::size_t f = 0; f < factors.size(); ++f) {
        const PatchFactors equal = equal_factors(static_cast<float>(factors[f]));
        points[f] = static_cast<double>(
            make_patterns(bench.device, Domain::triangle, Partitioning::integer, true, std::span(&equal, 1))
                .front()
                .points.size());
    }
    Rows table{{"triangles", "operations per patch", "per vertex", "net, bytes", "operations per vertex at factor 1",
                "4", "16", "bytes per vertex at factor 1", "4", "16"}};
    std::array<std::array<double, 3>, 3> operations{};
    std::array<std::array<double, 3>, 3> bytes{};
    for (std::size_t s = 0; s < scored.size(); ++s) {
        const KernelCosts costs = triangle_costs(scored[s].scheme, scored[s].normals);
        std::vector<std::string> row{scored[s].what, fmt::to_string(costs.net.total()),
                                     fmt::to_string(costs.vertex.total()), fmt::to_string(costs.net_bytes)};
        for (std::size_t f = 0; f < factors.size(); ++f) {
            operations[s][f] =
                static_cast<double>(costs.vertex.total()) + static_cast<double>(costs.net.total()) / points[f];
            bytes[s][f] =
                static_cast<double>(vertex_bytes) + static_cast<double>(patch_bytes(scored[s], costs)) / points[f];
            row.push_back(fmt::format("{:.0f}", operations[s][f]));
        }
        for (const double b : bytes[s])
            row.push_back(fmt::format("{:.1f}", b));
        table.push_back(row);
    }
    document.table(table);
    Rows quads{{"quads", "operations per patch", "per vertex", "net, bytes"}};
    for (const Scored& s : scored) {
        const KernelCosts costs = quad_costs(s.scheme, s.normals);
        quads.push_back({s.what, fmt::to_string(costs.net.total()), fmt::to_string(costs.vertex.total()),
                         fmt::to_string(costs.net_bytes)});
    }
    document.table(quads);
    document.paragraph(
        fmt::format("Float operations as in finding 1: the control net once per patch, all else per vertex. Bytes that "
                    "the stages of control nets and vertices move, counted from their buffers: per vertex 32 written "
                    "and 8 of the shared pattern read, per patch the corners, their indices and the net, written once "
                    "and read once. Patches of factors 1, 4 and 16 have {:.0f}, {:.0f} and {:.0f} vertices (integer); "
                    "a triangle's indices, 12 bytes, are the same for all.",
                    points[0], points[1], points[2]));
    const double linear = operations[1][2] / operations[0][2];
    const double quadratic = operations[2][2] / operations[0][2];
    const double moved = bytes[2][2] / bytes[0][2];
    document.claim(
        linear > 1.3 && linear < 1.6 && quadratic > 1.6 && quadratic < 2.0 && moved < 1.05,
        fmt::format("At factor 16 PN takes {:.2f} times the operations of Phong with linear normals and {:.2f} times "
                    "with quadratic ones, but moves only {:.2f} times the bytes. The 40 % by which Nunes et al. found "
                    "Phong faster is near what arithmetic alone would give with linear normals; a device that waits "
                    "for memory has next to nothing to gain. Our Phong evaluates a quadratic net and does not project "
                    "every vertex three times as theirs does.",
                    linear, quadratic, moved));
    document.claim(
        bytes[2][0] > 1.15 * bytes[0][0],
        fmt::format("At factor 1 the nets weigh more: {:.1f} bytes per vertex for Phong, {:.1f} and {:.1f} for PN.",
                    bytes[0][0], bytes[1][0], bytes[2][0]));
    document.paragraph(
        "What this comes to in time depends on the device: `tessera bench` compares whole jobs, `bench_stages` schemes "
        "and stages, on all devices that are there.");
    document.commands("build/release/bench_stages --benchmark_filter='/(phong|pn)/'");
}

}  // namespace

void write_scheme_finding(const Bench& bench, Document& document) {
    std::vector<SchemeRow> rows;
    for (const Model& model : bench.models)
        rows.push_back(measure_model(bench, model));
    document.heading("3. Phong, PN with linear and PN with quadratic normals");
    document.paragraph(
        "Nunes et al. (*Analysis and Implementation of Local Subdivision Algorithms in the GPU*, 2011) measure Phong "
        "tessellation about 40 % faster than PN triangles and see, in pictures, that PN triangles are smoother. "
        "Measured at factor 16, integer partitioning:");
    document.commands(
        "build/release/findings --only schemes\n"
        "build/release/tessera render shape:torus -o schemes.png --compare linear,phong,pn --normals true");
    write_continuity(rows, document);
    write_costs(bench, document);
}

}  // namespace tessera::findings
