/// A traced picture of the ground from a pose, with its times and memory.
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
/// Describes the operators of settings: "two triangles a cell, Lambert".
[[nodiscard]] std::string describe(const raytrace::TraceSettings& settings);

struct TracedShotPlan {
    AircraftPose pose;
    std::optional<base::Time> time;  ///< time for the position of the sun; nothing: north-west, 45 degrees high
    std::uint32_t width = 1024, height = 768;
    double field_of_view_deg = 60;      ///< over the width
    std::optional<terrain::View> view;  ///< view of a display, instead of pose and field of view; in the size of the picture
    /// Number of times that it is drawn, for the median time, 1 or more; only once if it takes more than 2 s.
    std::uint32_t rounds = 3;
    std::uint32_t block_words = 512;
    const TracedData* data = nullptr;  ///< colours the ground; borrowed
    bool is_direct = false;            ///< the stages are called directly, not by the token stream
};

/// How paged ground was read for a picture.
struct PagedUse {
    std::uint64_t memory_bytes = 0;       ///< allowed for heights
    std::uint64_t held_bytes = 0;         ///< used for them: bounds, chunks, and buffers for reading
    std::uint64_t ray_bytes = 0;          ///< of rays and their hits, by the number of pixels
    std::uint64_t read_bytes = 0;         ///< from the file
    std::uint32_t chunks = 0, slots = 0;  ///< number of chunks of the ground, and of those in memory at a time
    std::uint32_t chunks_read = 0;        ///< number of reads of chunks
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
    std::uint32_t pieces = 0;       ///< number of pieces into which rays are divided, for the Earth's curvature
    std::uint32_t rounds = 0;       ///< of the token stream; 0: called directly
    double ground_share = 0;        ///< fraction of the pixels that show ground, 0..1
    std::optional<PagedUse> paged;  ///< nothing: the ground was in memory
    bool is_sun_too_low = false;    ///< the sun was too low at that time, so the default direction was used
    [[nodiscard]] std::uint64_t bytes() const;
};

[[nodiscard]] terrain::View view_of(const TracedGround& ground, const TracedShotPlan& plan);
/// Throws UserError where the tracer cannot trace from the pose, or there is not enough memory. Paged ground is drawn once, for
/// any `plan.rounds`; require_pageable() must hold for its settings.
[[nodiscard]] TracedShot draw_traced_shot(const TracedGround& ground, const raytrace::TraceSettings& settings,
                                          const TracedShotPlan& plan, base::Workers& workers);

}  // namespace tedavis::host_sim
