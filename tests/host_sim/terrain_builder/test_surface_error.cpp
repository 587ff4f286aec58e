#include "host_sim/terrain_builder/surface_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tedavis::host_sim::test_surface_error {
namespace {

using terrain::PostClass;

/// Posts with a corner anywhere on the lattice.
struct Posts {
    std::int64_t i0 = 0, j0 = 0;
    std::uint32_t columns = 0, rows = 0;
    std::vector<float> surface_m;
    std::vector<PostClass> post_class;

    [[nodiscard]] std::size_t at(std::int64_t i, std::int64_t j) const {
        return static_cast<std::size_t>((j - j0) * columns + (i - i0));
    }
    [[nodiscard]] PostWindowView view() const { return {i0, j0, columns, rows, surface_m.data(), post_class.data()}; }
    [[nodiscard]] MeshCorner corner(std::int64_t i, std::int64_t j) const { return {i, j, surface_m[at(i, j)]}; }
    [[nodiscard]] bool has_cell(std::int64_t i, std::int64_t j) const {
        for (const auto& [a, b] : {std::pair{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}})
            if (post_class[at(a, b)] >= PostClass::void_) return false;
        return true;
    }
    [[nodiscard]] Posts window(std::int64_t i, std::int64_t j, std::uint32_t width, std::uint32_t height) const {
        Posts part{i, j, width, height, {}, {}};
        for (std::int64_t b = j; b < j + height; ++b)
            for (std::int64_t a = i; a < i + width; ++a) {
                part.surface_m.push_back(surface_m[at(a, b)]);
                part.post_class.push_back(post_class[at(a, b)]);
            }
        return part;
    }
};

template <class F>
Posts posts_of(std::uint32_t columns, std::uint32_t rows, F height) {
    Posts posts{0, 0, columns, rows, {}, {}};
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) posts.surface_m.push_back(static_cast<float>(height(i, j)));
    posts.post_class.assign(posts.surface_m.size(), PostClass::land);
    return posts;
}

Posts rough_posts(std::uint32_t columns, std::uint32_t rows, std::uint32_t seed) {
    std::mt19937 random(seed);
    return posts_of(columns, rows, [&](std::uint32_t, std::uint32_t) { return static_cast<double>(random() % 10000) / 100; });
}

struct Point {
    long double i, j;
};

long double cross(Point a, Point b, Point c) { return (b.i - a.i) * (c.j - a.j) - (b.j - a.j) * (c.i - a.i); }

/// The plane through three corners, by barycentric coordinates.
long double plane_at(const MeshCorner (&t)[3], Point p) {
    const Point a{static_cast<long double>(t[0].i), static_cast<long double>(t[0].j)},
        b{static_cast<long double>(t[1].i), static_cast<long double>(t[1].j)},
        c{static_cast<long double>(t[2].i), static_cast<long double>(t[2].j)};
    const long double area = cross(a, b, c);
    return (t[0].surface_m * cross(p, b, c) + t[1].surface_m * cross(a, p, c) + t[2].surface_m * cross(a, b, p)) / area;
}

/// What of a convex polygon lies on the inner side of a line, its border included (Sutherland, Hodgman 1974).
std::vector<Point> clipped(const std::vector<Point>& polygon, Point a, Point b) {
    std::vector<Point> kept;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Point p = polygon[n], q = polygon[(n + 1) % polygon.size()];
        const long double dp = cross(a, b, p), dq = cross(a, b, q);
        if (dp >= 0) kept.push_back(p);
        if ((dp < 0) != (dq < 0) && dp != 0 && dq != 0)
            kept.push_back({p.i + (q.i - p.i) * dp / (dp - dq), p.j + (q.j - p.j) * dp / (dp - dq)});
    }
    return kept;
}

/// Oracle: the overlay itself. Every half cell is cut with the triangle, and planes compared at the corners of what is left.
SignedError overlay_error(const Posts& posts, const MeshCorner& a, const MeshCorner& b, const MeshCorner& c) {
    const auto point = [](const MeshCorner& m) { return Point{static_cast<long double>(m.i), static_cast<long double>(m.j)}; };
    const MeshCorner drawn[3] = {a, b, c};
    std::vector<Point> sides{point(a), point(b), point(c)};
    if (cross(sides[0], sides[1], sides[2]) < 0) std::swap(sides[1], sides[2]);
    SignedError error;
    for (std::int64_t j = posts.j0; j + 1 < posts.j0 + posts.rows; ++j) {
        for (std::int64_t i = posts.i0; i + 1 < posts.i0 + posts.columns; ++i) {
            if (!posts.has_cell(i, j)) continue;
            const MeshCorner halves[2][3] = {{posts.corner(i, j), posts.corner(i + 1, j), posts.corner(i, j + 1)},
                                             {posts.corner(i + 1, j + 1), posts.corner(i, j + 1), posts.corner(i + 1, j)}};
            for (const auto& half : halves) {
                std::vector<Point> polygon{point(half[0]), point(half[1]), point(half[2])};
                for (int k = 0; k < 3 && !polygon.empty(); ++k) polygon = clipped(polygon, sides[k], sides[(k + 1) % 3]);
                for (const Point& p : polygon) {
                    const auto difference = static_cast<double>(plane_at(drawn, p) - plane_at(half, p));
                    error.include({std::max(difference, 0.0), std::max(-difference, 0.0)});
                }
            }
        }
    }
    return error;
}

/// Two triangles a cell, joined along (i+1,j)-(i,j+1).
long double true_height(const Posts& posts, Point p) {
    const std::int64_t i = std::min(static_cast<std::int64_t>(p.i), posts.i0 + posts.columns - 2),
                       j = std::min(static_cast<std::int64_t>(p.j), posts.j0 + posts.rows - 2);
    if (p.i - i + (p.j - j) <= 1) return plane_at({posts.corner(i, j), posts.corner(i + 1, j), posts.corner(i, j + 1)}, p);
    return plane_at({posts.corner(i + 1, j + 1), posts.corner(i, j + 1), posts.corner(i + 1, j)}, p);
}

struct RandomTriangles {
    std::mt19937 random;
    const Posts& posts;

    [[nodiscard]] MeshCorner corner() {
        MeshCorner c = posts.corner(posts.i0 + random() % posts.columns, posts.j0 + random() % posts.rows);
        c.surface_m += static_cast<double>(random() % 1000) / 50;
        return c;
    }
};

bool has_no_area(const MeshCorner& a, const MeshCorner& b, const MeshCorner& c) {
    return (b.i - a.i) * (c.j - a.j) == (b.j - a.j) * (c.i - a.i);
}

TEST(SurfaceError, IsThatOfTheOverlayOfBothSurfaces) {
    const Posts posts = rough_posts(23, 19, 1);
    RandomTriangles triangles{std::mt19937(2), posts};
    int degenerate = 0;
    for (int n = 0; n < 400; ++n) {
        const MeshCorner a = triangles.corner(), b = triangles.corner(), c = triangles.corner();
        const bool flat = has_no_area(a, b, c);
        degenerate += flat ? 1 : 0;
        const SignedError measured = triangle_error(posts.view(), a, b, c);
        const SignedError expected = flat ? SignedError() : overlay_error(posts, a, b, c);
        ASSERT_NEAR(measured.above_m, expected.above_m, 1e-9) << n;
        ASSERT_NEAR(measured.below_m, expected.below_m, 1e-9) << n;
        const SignedError turned = triangle_error(posts.view(), c, b, a);
        ASSERT_NEAR(turned.largest_m(), measured.largest_m(), 1e-9);
    }
    EXPECT_GT(degenerate, 0);
}

TEST(SurfaceError, DenseSamplingNeverFindsMoreAndComesClose) {
    const Posts posts = rough_posts(17, 17, 3);
    RandomTriangles triangles{std::mt19937(4), posts};
    for (int n = 0; n < 40; ++n) {
        const MeshCorner t[3] = {triangles.corner(), triangles.corner(), triangles.corner()};
        if (has_no_area(t[0], t[1], t[2])) continue;
        const SignedError measured = triangle_error(posts.view(), t[0], t[1], t[2]);
        long double above = 0, below = 0;
        constexpr int kSteps = 160;  // a side, at least ten a cell
        for (int u = 0; u <= kSteps; ++u) {
            for (int v = 0; u + v <= kSteps; ++v) {
                const long double s = u / static_cast<long double>(kSteps), r = v / static_cast<long double>(kSteps),
                                  w = 1 - s - r;
                const Point p{w * t[0].i + s * t[1].i + r * t[2].i, w * t[0].j + s * t[1].j + r * t[2].j};
                const long double d = w * t[0].surface_m + s * t[1].surface_m + r * t[2].surface_m - true_height(posts, p);
                above = std::max(above, d);
                below = std::max(below, -d);
            }
        }
        ASSERT_LE(above, measured.above_m + 1e-9) << n;
        ASSERT_LE(below, measured.below_m + 1e-9) << n;
        ASSERT_GE(std::max(above, below), 0.9 * measured.largest_m()) << n;
    }
}

TEST(SurfaceError, APlaneHasNone) {
    const Posts plane = posts_of(40, 30, [](double i, double j) { return 100 + 3 * i - 0.5 * j; });
    const SignedError error = triangle_error(plane.view(), plane.corner(1, 2), plane.corner(38, 11), plane.corner(7, 29));
    EXPECT_NEAR(error.largest_m(), 0, 1e-12);
    EXPECT_FALSE(std::signbit(error.below_m)) << "no negative zero in a file";
    MeshCorner raised = plane.corner(38, 11);
    raised.surface_m += 1;
    const SignedError found = triangle_error(plane.view(), plane.corner(1, 2), raised, plane.corner(7, 29));
    EXPECT_NEAR(found.above_m, 1, 1e-12) << "a vertex changed by a metre";
    EXPECT_NEAR(found.below_m, 0, 1e-12);
}

TEST(SurfaceError, FindsWhatPassesBetweenPosts) {
    // The triangle holds no posts but its corners, which are on the surface: rows, columns and diagonals betray the ridge.
    const Posts ridge = posts_of(4, 3, [](std::uint32_t i, std::uint32_t j) { return i == 1 && j == 0 ? 100 : 0; });
    const SignedError column = triangle_error(ridge.view(), ridge.corner(0, 0), ridge.corner(2, 1), ridge.corner(1, 1));
    EXPECT_DOUBLE_EQ(column.below_m, 200.0 / 3) << "on the diagonal, nearer to the ridge than the column's 50";
    EXPECT_DOUBLE_EQ(column.above_m, 0);
    const Posts turned = posts_of(3, 4, [](std::uint32_t i, std::uint32_t j) { return i == 0 && j == 1 ? 100 : 0; });
    EXPECT_DOUBLE_EQ(triangle_error(turned.view(), turned.corner(0, 0), turned.corner(1, 1), turned.corner(1, 2)).below_m,
                     200.0 / 3);
    const Posts saddle = posts_of(2, 2, [](std::uint32_t i, std::uint32_t j) { return i == j ? 0 : 100; });
    EXPECT_DOUBLE_EQ(triangle_error(saddle.view(), saddle.corner(0, 0), saddle.corner(1, 1), saddle.corner(1, 0)).below_m, 100)
        << "the wrong diagonal of a cell";
    EXPECT_DOUBLE_EQ(triangle_error(saddle.view(), saddle.corner(0, 1), saddle.corner(1, 1), saddle.corner(1, 0)).largest_m(), 0)
        << "half a cell is the surface itself";
}

TEST(SurfaceError, CellsWithVoidCornersDoNotCount) {
    Posts posts = rough_posts(21, 21, 5);
    std::mt19937 random(6);
    for (PostClass& c : posts.post_class) c = random() % 12 == 0 ? PostClass::void_ : random() % 3 == 0 ? PostClass::sea : c;
    for (std::int64_t j = 12; j < 18; ++j)
        for (std::int64_t i = 3; i < 17; ++i) posts.post_class[posts.at(i, j)] = PostClass::void_;
    for (std::size_t n = 0; n < posts.post_class.size(); ++n)
        if (posts.post_class[n] == PostClass::void_) posts.surface_m[n] = 1e6f;
    const auto on_ground = [&](std::int64_t west, std::int64_t north, std::uint32_t reach) {
        const std::int64_t i = west + random() % reach, j = north + random() % reach;
        return MeshCorner{i, j, static_cast<double>(random() % 100)};
    };
    for (int n = 0; n < 2000; ++n) {
        const std::uint32_t reach = n < 200 ? 21 : 4;
        const std::int64_t west = random() % (22 - reach), north = random() % (22 - reach);
        const MeshCorner a = on_ground(west, north, reach), b = on_ground(west, north, reach), c = on_ground(west, north, reach);
        if (has_no_area(a, b, c)) continue;
        const SignedError measured = triangle_error(posts.view(), a, b, c), expected = overlay_error(posts, a, b, c);
        ASSERT_NEAR(measured.above_m, expected.above_m, 1e-9) << n;
        ASSERT_NEAR(measured.below_m, expected.below_m, 1e-9) << n;
        ASSERT_LT(measured.below_m, 1000) << "no void height was looked at";
    }
}

TEST(SurfaceError, APostCountsAsLongAsOneOfItsCellsDoes) {
    Posts posts = posts_of(3, 3, [](std::uint32_t i, std::uint32_t j) { return i == 1 && j == 1 ? 70 : 0; });
    const auto error = [&] { return triangle_error(posts.view(), posts.corner(0, 0), posts.corner(2, 0), {1, 2, 0}).below_m; };
    EXPECT_DOUBLE_EQ(error(), 70);
    posts.post_class[posts.at(0, 0)] = posts.post_class[posts.at(2, 0)] = posts.post_class[posts.at(0, 2)] = PostClass::void_;
    EXPECT_DOUBLE_EQ(error(), 70);
    posts.post_class[posts.at(2, 2)] = PostClass::outside;
    EXPECT_DOUBLE_EQ(error(), 0);
}

TEST(SurfaceError, WindowsTogetherGiveTheWhole) {
    Posts posts = rough_posts(41, 37, 8);
    posts.post_class[posts.at(20, 12)] = PostClass::void_;
    RandomTriangles triangles{std::mt19937(9), posts};
    int partial = 0;
    for (int n = 0; n < 60; ++n) {
        const MeshCorner a = triangles.corner(), b = triangles.corner(), c = triangles.corner();
        const PlacedError whole = placed_triangle_error(posts.view(), a, b, c);
        PlacedError sum;
        for (std::int64_t j = 0; j < 36; j += 12) {
            for (std::int64_t i = 0; i < 40; i += 10) {
                const Posts part = posts.window(i, j, 11, 13);
                const PlacedError error = placed_triangle_error(part.view(), a, b, c);
                partial += error.error.largest_m() < whole.error.largest_m() ? 1 : 0;
                sum.include(error);
            }
        }
        ASSERT_NEAR(sum.error.above_m, whole.error.above_m, 1e-9);
        ASSERT_NEAR(sum.error.below_m, whole.error.below_m, 1e-9);
        if (whole.error.largest_m() > 0) {
            ASSERT_NEAR(sum.i, whole.i, 1e-9);
            ASSERT_NEAR(sum.j, whole.j, 1e-9);
        }
    }
    EXPECT_GT(partial, 60 * 6) << "a control: a window alone sees only its part";
}

TEST(SurfaceError, TheLargerPartIsMetAtItsPlace) {
    const Posts posts = rough_posts(25, 25, 10);
    RandomTriangles triangles{std::mt19937(11), posts};
    for (int n = 0; n < 100; ++n) {
        const MeshCorner t[3] = {triangles.corner(), triangles.corner(), triangles.corner()};
        if (has_no_area(t[0], t[1], t[2])) continue;
        const PlacedError placed = placed_triangle_error(posts.view(), t[0], t[1], t[2]);
        const Point p{placed.i, placed.j};
        ASSERT_NEAR(std::abs(static_cast<double>(plane_at(t, p) - true_height(posts, p))), placed.error.largest_m(), 1e-9);
    }
}

TEST(SurfaceError, DependsNeitherOnThePlaceOfTheWindowNorOnItsMargin) {
    const Posts posts = rough_posts(33, 33, 12);
    Posts far = posts;
    far.i0 = 1295000;
    far.j0 = 647000;
    RandomTriangles triangles{std::mt19937(13), posts};
    for (int n = 0; n < 50; ++n) {
        const MeshCorner a = triangles.corner(), b = triangles.corner(), c = triangles.corner();
        const auto moved = [&](MeshCorner m) { return MeshCorner{m.i + far.i0, m.j + far.j0, m.surface_m}; };
        const PlacedError here = placed_triangle_error(posts.view(), a, b, c),
                          there = placed_triangle_error(far.view(), moved(a), moved(b), moved(c));
        ASSERT_EQ(here.error.above_m, there.error.above_m);
        ASSERT_EQ(here.error.below_m, there.error.below_m);
        const std::int64_t west = std::min({a.i, b.i, c.i}), north = std::min({a.j, b.j, c.j});
        const auto columns = static_cast<std::uint32_t>(std::max({a.i, b.i, c.i}) - west + 1),
                   rows = static_cast<std::uint32_t>(std::max({a.j, b.j, c.j}) - north + 1);
        if (columns < 2 || rows < 2) continue;
        const SignedError tight = triangle_error(posts.window(west, north, columns, rows).view(), a, b, c);
        ASSERT_NEAR(tight.above_m, here.error.above_m, 1e-9);
        ASSERT_NEAR(tight.below_m, here.error.below_m, 1e-9);
    }
    EXPECT_EQ(triangle_error(far.view(), posts.corner(0, 0), posts.corner(9, 1), posts.corner(3, 8)).largest_m(), 0)
        << "nothing of the triangle lies in the window";
}

TEST(SurfaceError, TheLargestTrianglesStayExact) {
    // A slope over the longest chunk, one post off it in the middle of a narrow strip of posts.
    constexpr std::uint32_t kLast = 32768;
    Posts strip = posts_of(kLast + 1, 3, [](double i, double) { return i / 16; });
    strip.j0 = 16383;
    strip.surface_m[strip.at(9000, 16384)] += 25;
    const MeshCorner a{0, 0, 0}, b{0, kLast, 0}, c{kLast, kLast, kLast / 16.0}, d{kLast, 0, kLast / 16.0};
    EXPECT_NEAR(triangle_error(strip.view(), a, b, c).below_m, 25, 1e-9);
    EXPECT_NEAR(triangle_error(strip.view(), a, c, d).below_m, 0, 1e-9);
    EXPECT_NEAR(triangle_error(strip.view(), b, c, d).below_m, 0, 1e-9);
    EXPECT_NEAR(triangle_error(strip.view(), a, b, d).below_m, 25, 1e-9);
}

}  // namespace
}  // namespace tedavis::host_sim::test_surface_error
