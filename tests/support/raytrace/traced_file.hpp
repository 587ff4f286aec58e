/// A small database as the display's tracer has it: land, sea in the west and ground without data in the east.
#pragma once

#include <vector>

#include "render_core/draw/traced_ground.hpp"
#include "tests/support/terrain/ground_files.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::test_support {

inline TdbSpec coast_file() {
    TdbSpec spec = rough_file(161, 129);
    spec.post_class = [](std::uint32_t i, std::uint32_t j) {
        if (i < 40) return terrain::PostClass::sea;
        return i > 120 && j > 60 ? terrain::PostClass::void_ : terrain::PostClass::land;
    };
    return spec;
}

struct TracedFile {
    explicit TracedFile(const TdbSpec& spec) : of(spec), memory(draw::TracedGround::bytes_needed(of.database.lattice()) / 8 + 1) {
        base::Arena arena(memory.data(), memory.size() * 8);
        base::SerialWorkers workers;
        EXPECT_EQ(ground.start(of.query, workers, arena), draw::TracedGroundFault::none);
    }
    [[nodiscard]] raytrace::GroundSpace space() const { return {of.database, of.all(), 1}; }
    /// Over a post, 160 x 120 pixels.
    [[nodiscard]] terrain::View view(double i, double j, double above_m, double heading_deg, double pitch_deg) const {
        terrain::View view = view_from(of.tdb, i, j, above_m, heading_deg, pitch_deg, 10);
        view.focal_px *= 160.0 / view.width;
        view.width = 160;
        view.height = 120;
        return view;
    }

    OpenedGround of;
    std::vector<std::uint64_t> memory;
    draw::TracedGround ground;
};

}  // namespace tedavis::test_support
