/// Pictures of one kernel, bit for bit against single rays.
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/raytrace/traced_view.hpp"

namespace tedavis::test_support {

template <class Height>
const raytrace::ViewKernel<Height>* kernel_of(int lanes) {
    for (const raytrace::ViewKernel<Height>& kernel : raytrace::view_kernels<Height>())
        if (kernel.lanes == lanes) return &kernel;
    return nullptr;
}

/// False where the machine cannot run it.
template <class Height>
bool expect_bits_of_single_rays(int lanes, raytrace::CellSurface surface) {
    const raytrace::ViewKernel<Height>* const kernel = kernel_of<Height>(lanes);
    if (kernel == nullptr) return false;
    base::SerialWorkers workers;
    std::mt19937 random(31);
    std::size_t hit_count[3] = {};
    for (const bool has_holes : {false, true}) {
        const ViewedHills<Height> hills(271, 190, has_holes);
        const auto field = hills.field(surface);
        for (int round = 0; round < 24; ++round) {
            const std::uint32_t width = 33 + 6 * static_cast<std::uint32_t>(round), height = 71;
            const raytrace::GridCamera camera =
                round % 2 == 0 ? any_camera(random, 271, 190, width) : upright_camera(random, 271, 190, width, round % 4 == 1);
            const TracedPicture singly = traced_singly(field, camera, width, height);
            EXPECT_EQ(traced_by(*kernel, field, camera, width, height, workers).differences(singly), 0u)
                << kernel->name << ", camera " << round;
            for (const raytrace::HitSide side : singly.side) ++hit_count[static_cast<std::size_t>(side)];
        }
    }
    for (const std::size_t count : hit_count) EXPECT_GT(count, 1000u) << "misses, hits from above and from below";
    return true;
}

template <class Height>
void expect_bits_of_both_surfaces(int lanes) {
    for (const raytrace::CellSurface surface : {raytrace::CellSurface::two_triangles, raytrace::CellSurface::bilinear})
        if (!expect_bits_of_single_rays<Height>(lanes, surface)) std::puts("this machine has no such vectors");
}

}  // namespace tedavis::test_support
