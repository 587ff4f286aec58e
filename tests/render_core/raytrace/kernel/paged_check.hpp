/// Pictures of the paged tracer, bit for bit against single rays over the whole grid.
#pragma once

#include <gtest/gtest.h>

#include "tests/support/raytrace/held_chunks.hpp"

namespace tedavis::test_support {

template <class Height>
void expect_paged_bits(std::uint32_t lanes) {
    const raytrace::PacketKernel<Height>* kernel = nullptr;
    for (const raytrace::PacketKernel<Height>& one : raytrace::packet_kernels<Height>())
        if (one.lanes == lanes) kernel = &one;
    if (kernel == nullptr) {
        std::puts("this machine has no such vectors");
        return;
    }
    base::SerialWorkers workers;
    std::mt19937 random(77);
    std::size_t hit_count[3] = {};
    for (const bool has_holes : {false, true}) {
        const ViewedHills<Height> hills(271, 190, has_holes);
        for (const raytrace::CellSurface surface : {raytrace::CellSurface::two_triangles, raytrace::CellSurface::bilinear}) {
            const auto field = hills.field(surface);
            HeldChunks<Height> chunks(field.grid());
            chunks.slack = has_holes ? 0 : 500;
            const std::uint32_t all = chunks.chunk_columns() * chunks.chunk_rows();
            for (const std::uint32_t slots : {1u, 4u, 64u, all}) {
                StartedPages<Height> pages(chunks, {slots, 90 * 61, 1});
                ASSERT_EQ(pages.started, raytrace::PagedTracer<Height>::Started::yes);
                for (int round = 0; round < 4; ++round) {
                    const std::uint32_t width = 30 + 20 * static_cast<std::uint32_t>(round), height = 61;
                    const raytrace::GridCamera camera =
                        round == 3 ? upright_camera(random, 271, 190, width, slots == 4) : any_camera(random, 271, 190, width);
                    const TracedPicture singly = traced_singly(field, camera, width, height);
                    const TracedPicture paged = pages.trace(camera, width, height, 270, surface, *kernel, workers);
                    EXPECT_EQ(paged.differences(singly), 0u) << kernel->name << ", camera " << round << ", slots " << slots;
                    for (const raytrace::HitSide side : singly.side) ++hit_count[static_cast<std::size_t>(side)];
                }
            }
        }
    }
    for (const std::size_t count : hit_count) EXPECT_GT(count, 1000u) << "misses, hits from above and from below";
}

}  // namespace tedavis::test_support
