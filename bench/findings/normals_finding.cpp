#include "findings.hpp"

#include "figures.hpp"
#include "kernel_costs.hpp"
#include "measure/patch_edges.hpp"
#include "measure/silhouette.hpp"
#include "raster/portable_rasteriser.hpp"

#include <glm/glm.hpp>

namespace tessera::findings {
namespace {

constexpr float factor = 16.0f;
constexpr std::uint32_t picture_size = 512;
constexpr std::uint32_t visible_steps = 8;

struct NormalsRow {
    std::string name;
    std::size_t patches = 0;
    measure::AngleStatistics apart, gap, quadratic_gap;
    std::size_t turned = 0;   // patches with a vertex where the two are more than a right angle apart
    std::size_t leaning = 0;  // of those with a corner normal more than a right angle off its face
    std::size_t edges = 0;
    std::uint64_t split = 0;
    double visible = 0.0;  // share of the covered pixels
};

bool turns_over(std::span<const Vertex> a, std::span<const Vertex> b) {
    return !std::ranges::equal(a, b, [](const Vertex& v, const Vertex& w) {
        return measure::angle_between(v.normal, w.normal) <= std::numbers::pi / 2.0;
    });
}

/// Whether the normal at a corner points behind the plane of the corner's two edges.
bool has_leaning_corner(const patches::PatchSet& patches, std::size_t patch) {
    const patches::PatchCorners& corners = patches.corners[patch];
    const std::size_t count = patches::is_quad(corners) ? 4 : 3;
    const auto vector = [](const float(&v)[3]) { return glm::dvec3(v[0], v[1], v[2]); };
    const auto position = [&](std::size_t c) { return vector(patches.control_vertices[corners[c % count]].position); };
    for (std::size_t c = 0; c < count; ++c) {
        const glm::dvec3 face = glm::cross(position(c + 1) - position(c), position(c + count - 1) - position(c));
        if (glm::dot(face, vector(patches.control_vertices[corners[c]].normal)) < 0.0) return true;
    }
    return false;
}

double visible_share(render::Rasteriser& rasteriser, const measure::PatchSurface& a, const measure::PatchSurface& b) {
    const render::Camera camera = measure::frame_surface(a, render::View{}.azimuth);
    const image::Image of_a = measure::draw_surface(rasteriser, a, camera, picture_size);
    const image::Image of_b = measure::draw_surface(rasteriser, b, camera, picture_size);
    std::uint64_t covered = 0;
    for (std::size_t i = 3; i < of_a.rgba.size(); i += 4)
        covered += of_a.rgba[i] > 0 ? 1 : 0;
    return static_cast<double>(image::difference(of_a, of_b, visible_steps).count_over) / static_cast<double>(covered);
}

NormalsRow measure_model(const Bench& bench, const Model& model, render::Rasteriser& rasteriser) {
    TessellationOptions options;
    options.partitioning = Partitioning::integer;
    options.factors = equal_factors(factor);
    const auto quadratic = measure::make_patch_surface(bench.device, model.patches, options);
    options.normals = Normals::surface;
    const auto surface = measure::make_patch_surface(bench.device, model.patches, options);
    const measure::PatchEdges edges = measure::find_edges(model.patches);
    NormalsRow row;
    row.name = model.name;
    row.patches = surface.patch_count();
    row.apart = measure::normal_angles(surface, quadratic);
    for (std::size_t p = 0; p < surface.patch_count(); ++p) {
        if (!turns_over(surface.patch_vertices(p), quadratic.patch_vertices(p))) continue;
        ++row.turned;
        row.leaning += has_leaning_corner(model.patches, p) ? 1 : 0;
    }
    row.gap = measure::discontinuity(surface, edges);
    row.quadratic_gap = measure::discontinuity(quadratic, edges);
    row.edges = edges.smooth.size();
    row.split = edges.split;
    row.visible = visible_share(rasteriser, surface, quadratic);
    return row;
}

void write_angles(const std::vector<NormalsRow>& rows, Document& document) {
    Rows table{{"model", "patches", "apart: mean", "95 %", "max", "turned over", "pixels", "edges (split)",
                "true jumps: mean", "95 %", "max", "quadratic jumps: max"}};
    for (const NormalsRow& r : rows) {
        table.push_back({r.name, fmt::to_string(r.patches), degrees(r.apart.mean), degrees(r.apart.most_95),
                         degrees(r.apart.max), fmt::to_string(r.turned), percent(r.visible),
                         fmt::format("{} ({})", r.edges, r.split), degrees(r.gap.mean), degrees(r.gap.most_95),
                         degrees(r.gap.max), degrees(r.quadratic_gap.max)});
    }
    document.table(table);
    document.paragraph(
        fmt::format("Degrees. *Apart*: the angle between the two normals, over all vertices of the model. *Turned "
                    "over*: patches with a vertex where they are more than 90 degrees apart. *Pixels*: of those that "
                    "the model covers in a picture of {} x {}, plain material, the share that differs by more than {} "
                    "of 255 steps in a channel. *Jumps*: the angle between the normals that two patches give at the "
                    "same point of a shared edge, {:.0f} points per edge with its ends; edges whose corner normals the "
                    "file splits do not count, their number is in brackets.",
                    picture_size, picture_size, visible_steps, factor + 1));
}

void write_angle_claims(const std::vector<NormalsRow>& rows, Document& document) {
    const NormalsRow& cube = rows.front();
    const Range mean = range(rows, [](const NormalsRow& r) { return r.apart.mean; });
    const Range visible = range(rows, [](const NormalsRow& r) { return r.visible; });
    document.claim(
        mean.least > 0.01 && cube.apart.mean > 0.2,
        fmt::format("The two are not the same on any model: {} to {} degrees apart in the mean, and on the cube, where "
                    "the paper's difference image shows none, {} in the mean and {} at most. How much of it shows "
                    "depends on the model: from {} to {} of its pixels change by more than {} steps.",
                    degrees(mean.least), degrees(mean.greatest), degrees(cube.apart.mean), degrees(cube.apart.max),
                    percent(visible.least), percent(visible.greatest), visible_steps));
    const Range gap = range(rows, [](const NormalsRow& r) { return r.gap.mean; });
    document.claim(
        std::ranges::all_of(rows, [](const NormalsRow& r) { return r.quadratic_gap.max == 0.0; }) && gap.least > 0.001,
        fmt::format("Quadratic normals are continuous across every edge of every model, bit by bit. True normals jump "
                    "on all of them, by {} to {} degrees in the mean: PN triangles meet without a crack but with a "
                    "crease, which true normals show and quadratic normals hide.",
                    degrees(gap.least), degrees(gap.greatest)));
    const auto turned = [](const NormalsRow& r) { return r.turned > 0; };
    std::size_t all_turned = 0, leaning = 0;
    for (const NormalsRow& r : rows) {
        all_turned += r.turned;
        leaning += r.leaning;
    }
    document.claim(
        2 * leaning > all_turned && leaning < all_turned,
        fmt::format("Angles above 90 degrees are patches that turn over ({}). In {} of these {} patches a corner "
                    "normal of the model leans more than a right angle off its face, so that the surface leaves the "
                    "corner upside down; the others turn over between their corners. A true normal then points to the "
                    "other side of the surface, a quadratic one stays with the corners'.",
                    names_of(rows, turned), leaning, all_turned));
}

void write_operations(Document& document) {
    const KernelCosts linear = triangle_costs(Scheme::pn, Normals::linear);
    const KernelCosts quadratic = triangle_costs(Scheme::pn, Normals::quadratic);
    const KernelCosts real = triangle_costs(Scheme::pn, Normals::surface);
    const measure::FloatOperations coefficients = quadratic.net - linear.net;
    const auto row = [](const std::string& what, const measure::FloatOperations& f) {
        return std::vector<std::string>{what, fmt::to_string(f.additions), fmt::to_string(f.multiplications),
                                        fmt::to_string(f.total()), fmt::to_string(f.with_roots_as_one())};
    };
    document.subheading("What they cost");
    document.table({{"normals of a PN triangle", "+ -", "x", "all", "roots and divisions as one"},
                    row("quadratic, per patch: three edge coefficients", coefficients),
                    row("quadratic, per vertex", quadratic.normal()),
                    row("true, per patch", real.net - linear.net),
                    row("true, per vertex", real.normal()),
                    row("of that the linear normal for where the derivatives vanish", linear.normal())});
    document.paragraph(
        "Operations on single floats, counted in the SPIR-V that the kernels are compiled to, through all calls: the "
        "difference of the kernels with and without quadratic normals, and of a vertex what is neither position nor "
        "texture coordinate. Comparisons, conversions and integers do not count. The kernels make reciprocal square "
        "roots and reciprocals of several operations (`kernels/exact.h`); the last column takes each as one, as papers "
        "do. All normals are made unit length.");
    const auto crossing = [](std::uint64_t once, std::uint64_t fake, std::uint64_t real_each) {
        return static_cast<double>(once) / (static_cast<double>(real_each) - static_cast<double>(fake));
    };
    const double all = crossing(coefficients.total(), quadratic.normal().total(), real.normal().total());
    const double as_one = crossing(coefficients.with_roots_as_one(), quadratic.normal().with_roots_as_one(),
                                   real.normal().with_roots_as_one());
    const double bare = crossing(coefficients.with_roots_as_one(), quadratic.normal().with_roots_as_one(),
                                 (real.normal() - linear.normal()).with_roots_as_one());
    document.claim(
        all < 3.0 && as_one < 3.0 && bare < 3.0 && real.normal().total() > 2 * quadratic.normal().total(),
        fmt::format(
            "For q vertices of a patch: {} + {}q operations for quadratic normals, {}q for true ones; with roots as "
            "one {} + {}q and {}q, where the paper counts 150 + 23q and 59q. (A blend of six coefficients of three "
            "components takes 18 multiplications and 15 additions by itself, so the paper counts otherwise, perhaps an "
            "operation on a vector as one.) Quadratic normals are cheaper from q = {:.1f} on, with roots as one from "
            "{:.1f}, and from {:.1f} if true normals had no fallback: for every patch, since a patch has three "
            "vertices at least. The paper says from about five.",
            coefficients.total(), quadratic.normal().total(), real.normal().total(), coefficients.with_roots_as_one(),
            quadratic.normal().with_roots_as_one(), real.normal().with_roots_as_one(), all, as_one, bare));
}

}  // namespace

void write_normals_finding(const Bench& bench, Document& document) {
    const auto rasteriser = raster::open_portable(bench.device);
    std::vector<NormalsRow> rows;
    for (const Model& model : bench.models)
        rows.push_back(measure_model(bench, model, *rasteriser));
    document.heading("1. True normals are not the quadratic ones");
    document.paragraph(
        "Van Veen and Baakman (*A Discussion of Curved Point-Normal Triangles*) find no difference between \"real\" "
        "normals, those of the surface, and the \"fake\", quadratic ones of Vlachos et al., on a cube and on other "
        "models. Measured on PN triangles and quads, integer partitioning, factor 16:");
    document.commands(
        "build/release/findings --only normals\n"
        "build/release/tessera render shape:cube -o true.png --factor 16 --normals true\n"
        "build/release/tessera render shape:cube -o quadratic.png --factor 16 --normals quadratic\n"
        "build/release/tessera diff true.png quadratic.png");
    write_angles(rows, document);
    write_angle_claims(rows, document);
    write_operations(document);
}

}  // namespace tessera::findings
