/// The choices of a program for its display: plain values, in which desk, board, self-test and tests differ.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "platform/reservation/memory_reservation.hpp"
#include "platform/surface_settings.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/base/result.hpp"
#include "render_core/display/planner/display_settings.hpp"
#include "render_core/terrain/arrival_mode.hpp"

namespace tedavis::platform {

/// Where a database lies. Without a path and without bytes there is none.
struct DatabaseSource {
    const char* path = "";              ///< of a file, which is opened at start
    base::ByteSource* bytes = nullptr;  ///< the caller's source, in place of a file; must outlive the host

    [[nodiscard]] bool exists() const { return bytes != nullptr || *path != '\0'; }
};

/// How the surface is made: by the name of its backend, or by a function of the program's own.
struct SurfaceSource {
    using Make = base::Result<std::unique_ptr<base::Surface>, base::Error> (*)(const void* self, const SurfaceSettings& settings);

    std::string_view backend = "egl";  ///< for make_surface()
    Make make = nullptr;               ///< in place of make_surface(); it must not throw
    const void* self = nullptr;        ///< handed to `make`
};

enum class TerrainFaultPolicy : std::uint8_t {
    refuse,      ///< terrain that cannot be used is a fault of the start
    run_without  ///< the display starts without it and shows TERRAIN FAIL
};

struct DisplayHostSettings {
    display::DisplaySettings display;  ///< the host sets `terrain_failed_at_start`
    SurfaceSource surface;
    DatabaseSource terrain;
    TerrainFaultPolicy terrain_fault = TerrainFaultPolicy::refuse;
    terrain::ArrivalMode arrival = terrain::ArrivalMode::exact;
    base::Workers* workers = nullptr;  ///< for terrain that is traced; null: threads of the host, one per processor
    DatabaseSource scene;              ///< read at start; for one that comes later set `display.expects_scene`
    std::string_view programs;         ///< folder of programs for a device without a compiler; empty: `display.programs`
    Residency residency = Residency::lazy;
    base::Arena memory;  ///< reserved and kept by the caller; with capacity 0 the host reserves its own
};

}  // namespace tedavis::platform
