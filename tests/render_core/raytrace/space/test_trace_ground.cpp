#include "render_core/raytrace/space/trace_ground.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "platform/threads/thread_workers.hpp"
#include "tests/support/raytrace/traced_view.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::raytrace::test_trace_ground {
namespace {

using test_support::WrittenTdb;

constexpr std::uint32_t kPosts = 257;

/// A database of hills, and its heights as a grid.
class Ground {
public:
    explicit Ground(double north_deg) : tdb(spec(north_deg)), space(tdb.database(), {0, 0, kPosts - 1, kPosts - 1}, 1) {
        for (std::uint32_t n = 0; n < kPosts * kPosts; ++n)
            posts_.push_back(static_cast<float>(tdb.height_m(n % kPosts, n / kPosts)));
        memory_.resize(HeightMipmap<float>::bytes_needed(kPosts, kPosts) / 8 + 1);
        base::Arena arena(memory_.data(), memory_.size() * 8);
        EXPECT_TRUE(maxima_.start({posts_.data(), kPosts, kPosts, kPosts}, arena));
        base::SerialWorkers workers;
        maxima_.build(workers);
    }
    [[nodiscard]] TracedField<float> field() const { return {&maxima_, nullptr, CellSurface::two_triangles}; }
    /// The true surface's height at a place of the grid, and how far the place is from its border, cells.
    [[nodiscard]] double height(const glm::dvec3& place) const {
        const double x = std::min(std::max(place.x, 0.0), kPosts - 1.001), y = std::min(std::max(place.y, 0.0), kPosts - 1.001);
        const auto i = static_cast<std::uint32_t>(x), j = static_cast<std::uint32_t>(y);
        const double u = x - i, v = y - j;
        const auto post = [&](std::uint32_t a, std::uint32_t b) { return static_cast<double>(posts_[(j + b) * kPosts + i + a]); };
        return u + v <= 1 ? post(0, 0) + u * (post(1, 0) - post(0, 0)) + v * (post(0, 1) - post(0, 0))
                          : post(1, 1) + (1 - u) * (post(0, 1) - post(1, 1)) + (1 - v) * (post(1, 0) - post(1, 1));
    }
    [[nodiscard]] static bool is_inside(const glm::dvec3& place) {
        return place.x > 0.01 && place.y > 0.01 && place.x < kPosts - 1.01 && place.y < kPosts - 1.01;
    }

    const WrittenTdb tdb;
    const GroundSpace space;

private:
    static test_support::TdbSpec spec(double north_deg) {
        test_support::TdbSpec all;
        all.columns = all.rows = kPosts;
        all.north_deg = north_deg;
        all.step_lat_deg = all.step_lon_deg = 1 / 400.0;
        all.height_m = [](std::uint32_t i, std::uint32_t j) {
            return 900 + 700 * std::sin(0.11 * i) * std::cos(0.13 * j) + 90 * std::sin(1.3 * i + 0.7 * j);
        };
        all.measured = false;
        return all;
    }

    std::vector<float> posts_;
    std::vector<std::uint64_t> memory_;
    HeightMipmap<float> maxima_{HeightBound::maximum};
};

struct GroundPicture {
    explicit GroundPicture(const terrain::View& view)
        : t(std::size_t{view.width} * view.height), cell(t.size()), side(t.size()), u(t.size()), v(t.size()) {}
    [[nodiscard]] HitPicture hits() { return {t, cell, side, u, v}; }

    std::vector<float> t;
    std::vector<std::int32_t> cell;
    std::vector<HitSide> side;
    std::vector<float> u, v;
};

terrain::View small(terrain::View view) {
    view.width = 190;
    view.height = 120;
    view.focal_px = 260;
    view.far_m = 120000;
    return view;
}

glm::dvec3 direction_of(const terrain::View& view, std::uint32_t x, std::uint32_t y) {
    return view.forward + view.right * ((x + 0.5 - 0.5 * view.width) / view.focal_px) +
           view.down * ((y + 0.5 - 0.5 * view.height) / view.focal_px);
}

/// Walks rays of the world in double over the true surface. A pixel is right where the ray, moved by no more than a tenth of a
/// pixel, is above the surface all the way to its meeting, and meets it there.
struct Verdict {
    std::uint32_t hits = 0, misses = 0, wrong = 0;
};

Verdict judge(const Ground& ground, const terrain::View& view, const GroundPicture& picture, double most_off_px) {
    Verdict verdict;
    for (std::uint32_t y = 3; y < view.height; y += 7)
        for (std::uint32_t x = 1; x < view.width; x += 5) {
            const std::size_t pixel = std::size_t{y} * view.width + x;
            const glm::dvec3 direction = direction_of(view, x, y);
            const bool is_hit = picture.cell[pixel] >= 0;
            const double end = is_hit ? static_cast<double>(picture.t[pixel]) : view.far_m;
            ++(is_hit ? verdict.hits : verdict.misses);
            const auto clear_m = [&](double t) {
                const glm::dvec3 place = ground.space.place(view.eye + t * direction);
                return Ground::is_inside(place) ? place.z - ground.height(place) : std::numeric_limits<double>::infinity();
            };
            // What is aside by e is lower or higher by the surface's slope times that; slopes are below 1 here.
            const auto may_be_off_m = [&](double t) { return 1.5 * most_off_px * t / view.focal_px + 1e-3; };
            const bool ends_at_border = is_hit && !Ground::is_inside(ground.space.place(view.eye + end * direction));
            bool is_right = !is_hit || ends_at_border || std::abs(clear_m(end)) <= may_be_off_m(end);
            for (double t = 60; t < end && is_right; t += 60) is_right = clear_m(t) > -may_be_off_m(t);
            if (!is_right) ++verdict.wrong;
        }
    return verdict;
}

GroundPicture traced(const Ground& ground, const terrain::View& view, const ViewKernel<float>& kernel, base::Workers& workers) {
    GroundPicture picture(view);
    trace_ground(ground.field(), ground.space, view, kernel, workers, picture.hits());
    return picture;
}

TEST(TraceGround, MeetsWhatRaysOfTheWorldMeet) {
    base::SerialWorkers workers;
    for (const double north_deg : {0.3, 47.0, 66.0}) {
        const Ground ground(north_deg);
        Verdict all;
        for (const terrain::View& seen : test_support::some_views(ground.tdb, 10, 7, 4)) {
            const terrain::View view = small(seen);
            ASSERT_TRUE(can_trace(ground.space, view));
            const Verdict one = judge(ground, view, traced(ground, view, view_kernels<float>()[0], workers), kMaxOff_px);
            all.hits += one.hits;
            all.misses += one.misses;
            all.wrong += one.wrong;
        }
        EXPECT_EQ(all.wrong, 0u) << north_deg;
        EXPECT_GT(all.hits, 1000u);
        EXPECT_GT(all.misses, 500u);
    }
}

/// The judge sees the Earth's curvature: with one straight piece for all the same pictures are wrong.
TEST(TraceGround, ControlWithoutCurvature) {
    const Ground ground(47);
    base::SerialWorkers workers;
    std::uint32_t wrong = 0;
    for (const terrain::View& seen : test_support::some_views(ground.tdb, 6, 7, 4)) {
        const terrain::View view = small(seen);
        const GridCamera flat = fit_camera(ground.space, view, {0, 0, view.width, view.height}, 0, 200);
        GroundPicture picture(view);
        test_support::trace_view(ground.field(), flat, view_kernels<float>()[0], workers, view.width, view.height,
                                 picture.hits());
        wrong += judge(ground, view, picture, kMaxOff_px).wrong;
    }
    EXPECT_GT(wrong, 100u);
}

TEST(TraceGround, IsTheSameForEveryKernelAndEveryNumberOfWorkers) {
    const Ground ground(47);
    base::SerialWorkers serial;
    for (const terrain::View& seen : test_support::some_views(ground.tdb, 3, 11, 3)) {
        const terrain::View view = small(seen);
        const GroundPicture first = traced(ground, view, view_kernels<float>()[0], serial);
        const auto differs = [&](const GroundPicture& other) {
            std::size_t count = 0;
            for (std::size_t n = 0; n < first.t.size(); ++n)
                if (std::memcmp(&first.t[n], &other.t[n], sizeof(float)) != 0 || first.cell[n] != other.cell[n] ||
                    (first.cell[n] >= 0 && (first.u[n] != other.u[n] || first.v[n] != other.v[n])))
                    ++count;
            return count;
        };
        for (const ViewKernel<float>& kernel : view_kernels<float>())
            EXPECT_EQ(differs(traced(ground, view, kernel, serial)), 0u) << kernel.name;
        for (const std::uint32_t threads : {2u, 3u, 7u}) {
            const auto workers = platform::make_thread_workers({threads, nullptr});
            EXPECT_EQ(differs(traced(ground, view, view_kernels<float>()[0], *workers.value())), 0u);
        }
    }
}

/// Rays of a whole tile against rays of the world, in pixels of the picture.
TEST(FitCamera, IsOffByNoMoreThanItMay) {
    const Ground ground(47);
    double worst = 0;
    for (const terrain::View& seen : test_support::some_views(ground.tdb, 40, 3, 10)) {
        terrain::View view = seen;  // 1024 x 768
        view.far_m = 400000;
        const PieceEnds ends = cut_view(view);
        for (const PixelTile& tile : {PixelTile{0, 0, 32, 32}, PixelTile{992, 736, 1024, 768}, PixelTile{512, 352, 544, 384}})
            for (int piece = 0; piece < ends.count; ++piece) {
                const GridCamera camera = fit_camera(ground.space, view, tile, ends.end[piece], ends.end[piece + 1]);
                for (int n = 0; n < 12; ++n) {
                    const std::uint32_t x = tile.left + n % 2 * (tile.right - tile.left - 1),
                                        y = tile.top + n / 2 % 2 * (tile.bottom - tile.top - 1);
                    const double t = ends.end[piece] + (ends.end[piece + 1] - ends.end[piece]) * (0.02 + 0.49 * (n / 4));
                    if (ground.space.place(view.eye + t * direction_of(view, x, y)).z < -500)
                        continue;  // meets the ground before
                    const Ray ray = camera.ray(x, y);
                    const glm::dvec3 off = ground.space.position(ray.origin + t * glm::dvec3(ray.direction)) -
                                           (view.eye + t * direction_of(view, x, y));
                    const glm::dvec3 d = direction_of(view, x, y);
                    const double z = glm::dot(off, view.forward);
                    const double dx = glm::dot(off, view.right) - glm::dot(d, view.right) * z;
                    const double dy = glm::dot(off, view.down) - glm::dot(d, view.down) * z;
                    worst = std::max(worst, std::hypot(dx, dy) * view.focal_px / t);
                }
            }
    }
    EXPECT_LT(worst, kMaxOff_px);
    EXPECT_GT(worst, 0.5 * kMaxOff_px);  // the bound is a close one
}

}  // namespace
}  // namespace tedavis::raytrace::test_trace_ground
