// Cameras placed by hand and cameras of files.
#include "render/camera_choice.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "render/projection.hpp"

namespace tessera::test {
namespace {

using namespace render;

const Bounds unit_box{glm::vec3(-1.0f), glm::vec3(1.0f)};
const glm::dvec3 origin(0.0);

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST(LookAt, LooksFromTheEyeToTheTarget) {
    LookAt look;
    look.eye = {5, 0, 0};
    look.half_height = 1.0;  // 90 degrees
    const Viewpoint viewpoint = viewpoint_of(look, origin);
    expect_near(viewpoint.axes[0], {0, 0, -1});
    expect_near(viewpoint.axes[1], {0, 1, 0});
    expect_near(viewpoint.axes[2], {1, 0, 0});
    const Camera camera = make_camera(viewpoint, unit_box, 2.0f);
    const glm::vec3 middle = project(camera, {0, 0, 0});
    EXPECT_NEAR(middle.x, 0.0f, 1e-6f);
    EXPECT_NEAR(middle.y, 0.0f, 1e-6f);
    EXPECT_GT(middle.z, 0.0f);
    EXPECT_LT(middle.z, 1.0f);
    // At 5 units the image is 10 high and 20 wide.
    EXPECT_NEAR(project(camera, {0, 5, 0}).y, -1.0f, 1e-6f);
    EXPECT_NEAR(project(camera, {0, 0, -10}).x, 1.0f, 1e-6f);
}

TEST(LookAt, WithoutTargetLooksAtTheMiddleOfTheModel) {
    LookAt look;
    look.eye = {3, 2, 9};
    const Viewpoint viewpoint = viewpoint_of(look, {3, 2, 1});
    expect_near(viewpoint.axes[2], {0, 0, 1});
}

TEST(LookAt, StraightDownHasAnUp) {
    LookAt look;
    look.eye = {0, 7, 0};
    expect_near(viewpoint_of(look, origin).axes[1], {0, 0, -1});
    look.eye = {0, -7, 0};
    expect_near(viewpoint_of(look, origin).axes[1], {0, 0, -1});
    look.up = glm::dvec3(1, 0, 0);
    expect_near(viewpoint_of(look, origin).axes[1], {1, 0, 0});
}

TEST(LookAt, RefusesDirectionsThatAreNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    LookAt look;
    EXPECT_THROW(viewpoint_of(look, origin), Error) << "eye and target are one";
    look.eye = {0, 0, 5};
    look.up = glm::dvec3(0, 0, -2);
    EXPECT_THROW(viewpoint_of(look, origin), Error) << "up is where it looks";
    look.up = origin;
    EXPECT_THROW(viewpoint_of(look, origin), Error);
    look.up = glm::dvec3(nan, 1, 0);
    EXPECT_THROW(viewpoint_of(look, origin), Error);
    look.up.reset();
    look.eye = {0, nan, 5};
    EXPECT_THROW(viewpoint_of(look, origin), Error);
}

TEST(LookAt, IsTheSameInAnyUnits) {
    LookAt look;
    look.eye = {3, 4, 5};
    look.target = glm::dvec3(1, 0, 0);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        look.projection = projection;
        const CameraChoice smaller = scaled(look, 3);
        const Camera one = make_camera(viewpoint_of(look, origin), unit_box, 1.5f);
        const Camera other =
            make_camera(viewpoint_of(std::get<LookAt>(smaller), origin), {glm::vec3(-0.125f), glm::vec3(0.125f)}, 1.5f);
        const glm::vec3 a = project(one, {0.3f, 0.2f, 0.1f});
        const glm::vec3 b = project(other, glm::vec3(0.3f, 0.2f, 0.1f) / 8.0f);
        EXPECT_LT(glm::length(a - b), 1e-5f);
    }
}

TEST(FileCamera, ShowsWhatTheFileSays) {
    scene::Camera camera;
    camera.eye = {0, 0, 4};
    camera.half_height = 0.5;
    camera.near_plane = 0.1;
    camera.far_plane = std::numeric_limits<double>::infinity();
    const Camera perspective = make_camera(viewpoint_of(camera), unit_box, 1.0f);
    EXPECT_NEAR(project(perspective, {0, 2, 0}).y, -1.0f, 1e-6f);
    camera.orthographic = true;
    const Camera orthographic = make_camera(viewpoint_of(camera), unit_box, 1.0f);
    for (const float z : {-0.9f, 0.0f, 0.9f})
        EXPECT_NEAR(project(orthographic, {0, 0.5f, z}).y, -1.0f, 1e-6f);
    EXPECT_LT(project(orthographic, {0, 0, 1}).z, project(orthographic, {0, 0, -1}).z) << "nearer is less";
}

TEST(FileCamera, KeepsItsFrameInsideNarrowAndWideImages) {
    scene::Camera camera;
    camera.eye = {0, 0, 4};
    camera.half_height = 0.5;
    camera.half_width = 1.0;
    camera.far_plane = 100.0;
    for (const float aspect : {0.25f, 1.0f, 2.0f, 5.0f}) {
        const Camera of = make_camera(viewpoint_of(camera), unit_box, aspect);
        const glm::vec3 corner = project(of, {4, 2, 0});
        EXPECT_LE(corner.x, 1.0f + 1e-5f);
        EXPECT_LE(-corner.y, 1.0f + 1e-5f);
        EXPECT_GT(std::max(corner.x, -corner.y), 1.0f - 1e-5f) << "as large as fits";
    }
}

TEST(FileCamera, CutsOffAtItsPlanes) {
    scene::Camera camera;
    camera.eye = {0, 0, 4};
    camera.half_height = 0.5;
    camera.near_plane = 3.5;
    camera.far_plane = 4.5;
    for (const bool orthographic : {false, true}) {
        camera.orthographic = orthographic;
        const Camera of = make_camera(viewpoint_of(camera), unit_box, 1.0f);
        EXPECT_LT(project(of, {0, 0, 0.6f}).z, 0.0f);
        EXPECT_GT(project(of, {0, 0, 0.4f}).z, 0.0f);
        EXPECT_LT(project(of, {0, 0, -0.4f}).z, 1.0f);
        EXPECT_GT(project(of, {0, 0, -0.6f}).z, 1.0f);
    }
    camera.near_plane = 50.0;  // beyond the model
    camera.far_plane = 60.0;
    EXPECT_LT(project(make_camera(viewpoint_of(camera), unit_box, 1.0f), {0, 0, 0}).z, 0.0f);
}

TEST(Turned, GoesAroundAndKeepsLooking) {
    LookAt look;
    look.eye = {0, 1, 5};
    const glm::dvec3 centre(0, 0, 0);
    const Viewpoint front = viewpoint_of(look, centre);
    const Viewpoint right = turned(front, centre, std::acos(0.0));
    expect_near(right.eye, {5, 1, 0});
    expect_near(right.axes[2], glm::normalize(glm::dvec3(5, 1, 0)));
    expect_near(glm::cross(right.axes[0], right.axes[1]), right.axes[2]);
    expect_near(turned(front, {0, 0, 4}, std::acos(-1.0)).eye, {0, 1, 3});
    EXPECT_EQ(turned(front, {7, 8, 9}, 0.0).eye, front.eye);
}

double any_double() {
    const double values[] = {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             1e-300,
                             -1e300,
                             1e38,
                             1e-38,
                             3.0,
                             1e7,
                             -1e-7,
                             std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()};
    return values[*rc::gen::inRange<std::size_t>(0, std::size(values))];
}

RC_GTEST_PROP(MakeCamera, IsFiniteWhateverItGets, ()) {
    Viewpoint viewpoint;
    viewpoint.eye = {any_double(), any_double(), any_double()};
    viewpoint.projection = *rc::gen::arbitrary<bool>() ? Projection::perspective : Projection::orthographic;
    viewpoint.half_height = any_double();
    viewpoint.half_width = any_double();
    viewpoint.near_plane = any_double();
    viewpoint.far_plane = any_double();
    const auto any = [] { return static_cast<float>(any_double()); };
    const Bounds bounds{{any(), any(), any()}, {any(), any(), any()}};
    RC_ASSERT(is_finite(make_camera(viewpoint, bounds, any())));
}

}  // namespace
}  // namespace tessera::test
