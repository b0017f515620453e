// Framing: every corner of every box is inside the picture, and no nearer would do.
#include "render/camera.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

namespace tessera::render {
namespace {

glm::vec3 corner_of(const Bounds& bounds, int corner) {
    return {(corner & 1) != 0 ? bounds.max.x : bounds.min.x, (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
            (corner & 4) != 0 ? bounds.max.z : bounds.min.z};
}

/// Where the camera puts a point: x, y in [-1, 1] inside the image, z the depth.
glm::vec3 project(const Camera& camera, const glm::vec3& point) {
    const glm::vec4 clip = camera.projection * (camera.view * glm::vec4(point, 1.0f));
    return glm::vec3(clip) / clip.w;
}

/// The share of the image's width or height, whichever is larger, that the box takes; fails outside the clip volume.
float reach(const Camera& camera, const Bounds& bounds) {
    float largest = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 clip = camera.projection * (camera.view * glm::vec4(corner_of(bounds, corner), 1.0f));
        EXPECT_GT(clip.w, 0.0f);
        const glm::vec3 p = glm::vec3(clip) / clip.w;
        EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        EXPECT_GT(p.z, 0.0f);
        EXPECT_LT(p.z, 1.0f);
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
    return largest;
}

/// True where the camera keeps its least distance from the nearest point instead of filling the image.
bool keeps_clear(const Camera& camera, const std::vector<glm::vec3>& points) {
    float nearest = std::numeric_limits<float>::max();
    Bounds box;
    for (const glm::vec3& point : points) {
        nearest = std::min(nearest, -(camera.view * glm::vec4(point, 1.0f)).z);
        box.min = glm::min(box.min, point);
        box.max = glm::max(box.max, point);
    }
    const float scale = glm::length(glm::vec3(camera.view[0]));
    return nearest < 0.0101f * glm::length((box.max - box.min) * scale);
}

float decimal(int low, int high) {
    return static_cast<float>(*rc::gen::inRange(low * 1000, high * 1000 + 1)) / 1000.0f;
}

RC_GTEST_PROP(FrameBounds, FitsEveryBoxTightly, ()) {
    const float scale = std::ldexp(1.0f, *rc::gen::inRange(-100, 100));
    const glm::vec3 size(decimal(0, 4), decimal(0, 4), decimal(0, 4));
    RC_PRE(std::max({size.x, size.y, size.z}) > 0.1f);
    const glm::vec3 centre(decimal(-3, 3), decimal(-3, 3), decimal(-3, 3));
    const Bounds bounds{(centre - size) * scale, (centre + size) * scale};
    // Not quite level, so that flat boxes are not seen from their edge.
    const View view{decimal(-4, 4), decimal(-1, 1) * 1.5f + 0.0123f, decimal(0, 1) + 0.2f, 1.0f};
    const float aspect = decimal(0, 4) + 0.2f;
    const Camera camera = frame_bounds(bounds, view, aspect);
    const float filled = reach(camera, bounds);
    std::vector<glm::vec3> corners;
    for (int corner = 0; corner < 8; ++corner)
        corners.push_back(corner_of(bounds, corner));
    RC_ASSERT(filled < fill + 0.002f);
    RC_ASSERT(filled > fill - 0.003f || keeps_clear(camera, corners));
}

RC_GTEST_PROP(FrameBounds, LeavesRoomToSwellInDepth, ()) {
    const Bounds bounds{glm::vec3(-1.0f), glm::vec3(decimal(0, 3), decimal(0, 3), decimal(0, 3))};
    const glm::vec3 margin = (bounds.max - bounds.min) * 0.25f;
    const Camera camera = frame_bounds(bounds, {decimal(-4, 4), decimal(-1, 1)}, 1.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const float depth = project(camera, corner_of({bounds.min - margin, bounds.max + margin}, corner)).z;
        RC_ASSERT(depth > 0.0f);
        RC_ASSERT(depth < 1.0f);
    }
}

Camera frame_points(const std::vector<glm::vec3>& points, const View& view, float aspect) {
    Framing framing(view, aspect);
    for (const glm::vec3& point : points)
        framing.add(point);
    return framing.camera();
}

RC_GTEST_PROP(Framing, FitsEveryCloudTightly, ()) {
    const float scale = std::ldexp(1.0f, *rc::gen::inRange(-100, 100));
    std::vector<glm::vec3> points(*rc::gen::inRange<std::size_t>(3, 30));
    for (glm::vec3& point : points)
        point = glm::vec3(decimal(-3, 3), decimal(-3, 3), decimal(-3, 3)) * scale;
    RC_PRE(glm::length(points[0] / scale - points[1] / scale) > 0.1f);
    const Camera camera = frame_points(points, {decimal(-4, 4), decimal(-1, 1)}, decimal(0, 4) + 0.2f);
    glm::vec2 low(2.0f);
    glm::vec2 high(-2.0f);
    for (const glm::vec3& point : points) {
        const glm::vec3 p = project(camera, point);
        RC_ASSERT(p.z > 0.0f);
        RC_ASSERT(p.z < 1.0f);
        low = glm::min(low, glm::vec2(p));
        high = glm::max(high, glm::vec2(p));
    }
    const auto touches = [](float a, float b) { return a < -fill + 0.002f && b > fill - 0.002f; };
    RC_ASSERT(std::min(low.x, low.y) > -fill - 0.002f);
    RC_ASSERT(std::max(high.x, high.y) < fill + 0.002f);
    RC_ASSERT(touches(low.x, high.x) || touches(low.y, high.y) || keeps_clear(camera, points));
}

TEST(Framing, LeavesOutWhatIsNotFinite) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<glm::vec3> sound{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<glm::vec3> mixed{{-1, 0, 0}, {nan, 0, 0}, {1, 0, 0}, {0, -nan, 1}, {0, 1, 0}};
    EXPECT_EQ(frame_points(sound, {}, 1.0f).view, frame_points(mixed, {}, 1.0f).view);
    EXPECT_EQ(frame_points({}, {}, 1.0f).view, frame_bounds({}, {}, 1.0f).view);
    EXPECT_EQ(frame_points(std::vector<glm::vec3>(3, glm::vec3(5.0f)), {}, 1.0f).view,
              frame_bounds({glm::vec3(5.0f), glm::vec3(5.0f)}, {}, 1.0f).view);
}

TEST(FrameBounds, LooksFromTheFrontWithYUp) {
    const Bounds bounds{glm::vec3(-1.0f), glm::vec3(1.0f)};
    const Camera camera = frame_bounds(bounds, {0.0f, 0.0f, 0.6f, 1.0f}, 1.5f);
    EXPECT_GT(camera.eye.z, 1.0f);
    EXPECT_NEAR(camera.eye.x, 0.0f, 1e-6f);
    EXPECT_NEAR(camera.eye.y, 0.0f, 1e-6f);
    EXPECT_GT(project(camera, {0.5f, 0.0f, 0.0f}).x, 0.0f);  // +x is on the right
    EXPECT_LT(project(camera, {0.0f, 0.5f, 0.0f}).y, 0.0f);  // +y is up: Vulkan's y points down
    EXPECT_LT(project(camera, {0.0f, 0.0f, 0.5f}).z, project(camera, {0.0f, 0.0f, -0.5f}).z);  // nearer is less
}

TEST(FrameBounds, TurnsFromFrontToRight) {
    const Bounds bounds{glm::vec3(-1.0f), glm::vec3(1.0f)};
    const Camera right = frame_bounds(bounds, {glm::half_pi<float>(), 0.0f, 0.6f, 1.0f}, 1.0f);
    EXPECT_GT(right.eye.x, 1.0f);
    EXPECT_GT(project(right, {0.0f, 0.0f, -0.5f}).x, 0.0f);  // seen from +x, -z is on the right
    const Camera above = frame_bounds(bounds, {0.0f, glm::half_pi<float>(), 0.6f, 1.0f}, 1.0f);
    EXPECT_GT(above.eye.y, 1.0f);
    EXPECT_LT(project(above, {0.0f, 0.0f, -0.5f}).y, 0.0f);  // seen from above, -z is up
}

TEST(FrameBounds, DistanceMovesTheEyeAway) {
    const Bounds bounds{glm::vec3(-1.0f), glm::vec3(1.0f)};
    View view;
    const float near_eye = glm::length(frame_bounds(bounds, view, 1.0f).eye);
    view.distance = 3.0f;
    EXPECT_NEAR(glm::length(frame_bounds(bounds, view, 1.0f).eye), 3.0f * near_eye, 0.02f * near_eye);
}

TEST(FrameBounds, CameraSpaceHasSizesNearOne) {
    for (const float size : {1e-30f, 1e-10f, 1.0f, 1e10f, 1e30f}) {
        const Bounds bounds{glm::vec3(-size), glm::vec3(size)};
        const Camera camera = frame_bounds(bounds, {}, 1.0f);
        const float across = glm::length(glm::vec3(camera.view * glm::vec4(size, 0.0f, 0.0f, 0.0f)));
        EXPECT_GE(across, 0.99f) << size;
        EXPECT_LE(across, 2.01f) << size;
        EXPECT_NEAR(reach(camera, bounds), fill, 0.002f) << size;
    }
}

TEST(FrameBounds, IsSaneForBoxesWithoutSize) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float huge = std::numeric_limits<float>::max();
    for (const Bounds& bounds :
         {Bounds{}, Bounds{glm::vec3(0.0f), glm::vec3(0.0f)}, Bounds{glm::vec3(7.0f), glm::vec3(7.0f)},
          Bounds{glm::vec3(1e30f), glm::vec3(1e30f)}, Bounds{glm::vec3(-1e-30f), glm::vec3(-1e-30f)},
          Bounds{glm::vec3(0.0f, 0.0f, -1.0f), glm::vec3(0.0f, 0.0f, 1.0f)}, Bounds{glm::vec3(-huge), glm::vec3(huge)},
          Bounds{glm::vec3(1e-38f), glm::vec3(2e-38f)}, Bounds{glm::vec3(-infinity), glm::vec3(infinity)},
          Bounds{glm::vec3(nan), glm::vec3(nan)}}) {
        for (const View& view : {View{}, View{0.0f, 0.0f, 0.6f, 1.0f}, View{nan, infinity, 0.0f, -1.0f}}) {
            for (const float aspect : {1.0f, 0.0f, nan, 8192.0f, 1.0f / 8192.0f}) {
                const Camera camera = frame_bounds(bounds, view, aspect);
                for (int i = 0; i < 16; ++i) {
                    EXPECT_TRUE(std::isfinite(camera.view[i / 4][i % 4])) << bounds.min.x << ", entry " << i;
                    EXPECT_TRUE(std::isfinite(camera.projection[i / 4][i % 4])) << bounds.min.x << ", entry " << i;
                }
                const bool finite = std::isfinite(bounds.min.x) && bounds.min.x <= bounds.max.x;
                if (finite && view.distance == 1.0f) {
                    EXPECT_LT(reach(camera, bounds), fill + 0.01f);
                }
            }
        }
    }
}

}  // namespace
}  // namespace tessera::render
