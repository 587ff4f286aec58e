#include "render_core/raytrace/search/bicubic_crossing.hpp"

namespace tedavis::raytrace {
namespace {

constexpr int kDegree = 6;
constexpr int kDeepest = 40;

double linearly(double a, double b, double t) { return (1 - t) * a + t * b; }

/// A cubic's value of three arguments, symmetric in them; with three equal ones it is the curve.
double blossom(const double c[4], double t1, double t2, double t3) {
    const double a = linearly(c[0], c[1], t1), b = linearly(c[1], c[2], t1), d = linearly(c[2], c[3], t1);
    return linearly(linearly(a, b, t2), linearly(b, d, t2), t3);
}

/// Control values of the part of a cubic from one parameter to another.
void cut_curve(const double c[4], double from, double to, double part[4]) {
    part[0] = blossom(c, from, from, from);
    part[1] = blossom(c, from, from, to);
    part[2] = blossom(c, from, to, to);
    part[3] = blossom(c, to, to, to);
}

struct Half {
    GapCurve curve;
    double from;
    int depth;  ///< it is 2^-depth long
};

bool is_all_above(const GapCurve& curve) {
    double least = curve.c[0];
    for (const double c : curve.c) least = std::min(least, c);
    return least > 0;
}

void halve_curve(const GapCurve& curve, GapCurve& left, GapCurve& right) {
    GapCurve row = curve;
    for (int n = 0; n <= kDegree; ++n) {
        left.c[n] = row.c[0];
        right.c[kDegree - n] = row.c[kDegree - n];
        for (int k = 0; k < kDegree - n; ++k) row.c[k] = 0.5 * (row.c[k] + row.c[k + 1]);
    }
}

/// The first place at which a curve that begins above zero is not above it.
Crossing first_descent(const GapCurve& whole) {
    Half waiting[kDeepest + 1];
    int count = 1;
    waiting[0] = {whole, 0, 0};
    for (int steps = 0; count > 0 && steps < kMaxHalvings; ++steps) {
        const Half half = waiting[--count];
        if (half.curve.c[0] <= 0) return {true, false, half.from};
        if (is_all_above(half.curve)) continue;
        const double length = 1.0 / static_cast<double>(std::uint64_t{1} << half.depth);
        if (half.depth == kDeepest) {
            if (half.curve.c[kDegree] <= 0) return {true, false, half.from};
            continue;
        }
        Half &right = waiting[count], &left = waiting[count + 1];
        halve_curve(half.curve, left.curve, right.curve);
        left.from = half.from;
        right.from = half.from + length / 2;
        left.depth = right.depth = half.depth + 1;
        count += 2;
    }
    return count > 0 ? Crossing{true, false, waiting[count - 1].from} : Crossing{};
}

}  // namespace

GapCurve gap_curve(const BicubicPatch& patch, const CellRay& ray) {
    // The part of the patch whose diagonal the line is over; its corners may lie the other way round.
    double cut[4][4], part[4][4];
    for (int j = 0; j < 4; ++j) cut_curve(patch.control[j], ray.from.place.u, ray.to.place.u, cut[j]);
    for (int i = 0; i < 4; ++i) {
        const double column[4] = {cut[0][i], cut[1][i], cut[2][i], cut[3][i]};
        double down[4];
        cut_curve(column, ray.from.place.v, ray.to.place.v, down);
        for (int j = 0; j < 4; ++j) part[j][i] = down[j];
    }
    static constexpr double kOf3[4] = {1, 3, 3, 1}, kOf6[7] = {1, 6, 15, 20, 15, 6, 1};
    GapCurve gap{};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) gap.c[i + j] += kOf3[i] * kOf3[j] * part[j][i];
    for (int k = 0; k <= kDegree; ++k) gap.c[k] = linearly(ray.from.z, ray.to.z, k / 6.0) - gap.c[k] / (kOf6[k] * kControlScale);
    return gap;
}

Crossing bicubic_crossing(const BicubicPatch& patch, const CellRay& ray, double sign) {
    GapCurve gap = gap_curve(patch, ray);
    // At the ends the patch itself is asked: neighbours agree about it.
    gap.c[0] = ray.from.z - patch.at(ray.from.place.u, ray.from.place.v).height;
    gap.c[kDegree] = ray.to.z - patch.at(ray.to.place.u, ray.to.place.v).height;
    for (double& c : gap.c) c *= sign;
    return first_descent(gap);
}

}  // namespace tedavis::raytrace
