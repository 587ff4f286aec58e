/// A picture of the ground by the tracer, from a pose, and what it took.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"
#include "host_sim/tracing/traced_data.hpp"
#include "host_sim/tracing/traced_ground.hpp"
#include "render_core/raytrace/picture/trace_settings.hpp"

namespace tedavis::host_sim {

enum class TracePreset : std::uint8_t { time, quality, memory };
inline constexpr TracePreset kTracePresets[] = {TracePreset::time, TracePreset::memory, TracePreset::quality};

[[nodiscard]] const char* to_string(TracePreset preset) noexcept;
[[nodiscard]] raytrace::TraceSettings settings_of(TracePreset preset);
[[nodiscard]] const char* to_string(raytrace::SearchKind kind) noexcept;
/// What a preset's operators are, in words: "two triangles a cell, Lambert".
[[nodiscard]] std::string describe(const raytrace::TraceSettings& settings);

struct TracedShotPlan {
    AircraftPose pose;
    std::optional<base::Time> time;  ///< the sun stands where it does then; nothing: in the north-west, 45 degrees high
    std::uint32_t width = 1024, height = 768;
    double field_of_view_deg = 60;  ///< over the width
    std::uint32_t rounds = 3;  ///< drawn so many times, for the median of its times, but once where it takes over 2 s; 1 or more
    std::uint32_t block_words = 512;
    const TracedData* data = nullptr;  ///< colours the ground; borrowed
    bool is_direct = false;            ///< the stages are called directly, not by the token stream
};

/// How paged ground was read for a picture.
struct PagedUse {
    std::uint64_t memory_bytes = 0;       ///< that heights might take
    std::uint64_t held_bytes = 0;         ///< that they took: bounds, chunks, and what reads them
    std::uint64_t ray_bytes = 0;          ///< of rays and their hits, by the number of pixels
    std::uint64_t read_bytes = 0;         ///< from the file
    std::uint32_t chunks = 0, slots = 0;  ///< of the ground, and in memory at a time
    std::uint32_t chunks_read = 0;        ///< a chunk counts each time that it is read
    std::uint32_t passes = 0;
};

struct TracedShot {
    struct Item {
        std::string name;
        std::uint64_t bytes = 0;
    };
    RgbaPicture pixels;
    double build_ms = 0;    ///< bounds and maps
    double picture_ms = 0;  ///< the median
    std::vector<Item> items;
    std::string kernel;
    std::uint32_t pieces = 0;       ///< in which rays are cut, for the Earth's curvature
    std::uint32_t rounds = 0;       ///< of the token stream; 0: called directly
    double ground_share = 0;        ///< of the pixels
    std::optional<PagedUse> paged;  ///< nothing: the ground was in memory
    bool is_sun_too_low = false;    ///< at that time: it stands where it does without one
    [[nodiscard]] std::uint64_t bytes() const;
};

[[nodiscard]] terrain::View view_of(const TracedGround& ground, const TracedShotPlan& plan);
/// Throws UserError: from there the tracer cannot see, or there is no memory. Paged ground is drawn once, whatever
/// `plan.rounds` is; require_pageable() must hold for its settings.
[[nodiscard]] TracedShot draw_traced_shot(const TracedGround& ground, const raytrace::TraceSettings& settings,
                                          const TracedShotPlan& plan, base::Workers& workers);

}  // namespace tedavis::host_sim
