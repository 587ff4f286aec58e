/// The display of a program with everything that it runs on: surface, memory reservation, databases with their reader, threads
/// for traced terrain, and the costs by which a frame's deadline is held. Every program and test starts its display here.
///
///   start(settings) · hold_deadline(...) · display(), surface() · the destructor stops
///
/// Memory   all of it at start().
/// Thread   one. Hosts of one thread draw in turn: one must have released its surface before another one makes its own current.
/// Failure  start() says what could not be started and why; the host may then only be destroyed. Where the settings say so,
///          terrain that cannot be used (no file, not readable, damaged) does not prevent it: terrain_fault() gives the reason.
#pragma once

#include <memory>
#include <string_view>

#include "platform/files/file_byte_source.hpp"
#include "platform/programs/program_folder.hpp"
#include "platform/runtime/display_host_settings.hpp"
#include "render_core/display/display.hpp"

namespace tedavis::platform {

/// The part of a host that could not be started.
enum class HostPart : std::uint8_t { none, terrain, scene, surface, context, memory, workers, programs, display };

/// Part none: everything was started.
struct HostFault {
    HostPart part = HostPart::none;
    base::Error error;

    [[nodiscard]] explicit operator bool() const { return part != HostPart::none; }
};

/// A calibration file that has been read. Without a name there is none, and no costs are known.
struct CostsFile {
    std::string_view name, text;
};

class DisplayHost {
public:
    DisplayHost() = default;
    ~DisplayHost();
    DisplayHost(const DisplayHost&) = delete;
    DisplayHost& operator=(const DisplayHost&) = delete;

    /// Starts the display; may be called once. The settings need not outlive the call, except for what they point to where they
    /// say so. Afterwards the surface is current.
    [[nodiscard]] HostFault start(const DisplayHostSettings& settings);
    /// Holds a deadline (0: none) by these costs, which must be of this display. After start().
    [[nodiscard]] base::Error hold_deadline(double deadline_ms, const CostsFile& costs);

    /// The display; valid after start().
    [[nodiscard]] display::Display& display() { return *display_; }
    /// The surface; valid after start(), also where it failed in a part that comes after the surface.
    [[nodiscard]] base::Surface& surface() { return *surface_; }
    [[nodiscard]] const base::Surface& surface() const { return *surface_; }
    /// The reason why the display runs without the terrain of the settings; empty otherwise.
    [[nodiscard]] const base::Error& terrain_fault() const { return terrain_fault_; }

    /// Makes the surface current again after release_current(), and the display's GL with it. Returns false where the surface is
    /// lost.
    [[nodiscard]] bool make_current();
    void release_current() { surface_->release_current(); }

private:
    [[nodiscard]] HostFault open_databases(const DisplayHostSettings& settings);
    [[nodiscard]] base::Error open_terrain(const DisplayHostSettings& settings);
    [[nodiscard]] HostFault open_surface(const DisplayHostSettings& settings);
    [[nodiscard]] HostFault reserve(const DisplayHostSettings& settings);
    [[nodiscard]] HostFault start_workers(const DisplayHostSettings& settings);
    [[nodiscard]] HostFault open_programs(const DisplayHostSettings& settings, ProgramFolder& folder,
                                          base::ProgramStore*& programs);
    [[nodiscard]] HostFault start_display(const DisplayHostSettings& settings, base::ProgramStore* programs);
    [[nodiscard]] base::Error start_core(const DisplayHostSettings& settings, base::ProgramStore* programs);
    void give_up_terrain(const base::Error& why);

    std::unique_ptr<base::Surface> surface_;
    MemoryReservation reservation_;
    base::Arena memory_;
    FileByteSource terrain_file_, scene_file_;
    base::ByteSource *terrain_ = nullptr, *scene_ = nullptr;
    std::unique_ptr<base::AsyncReader> terrain_reader_;
    std::unique_ptr<base::Workers> own_workers_;
    base::Workers* workers_ = nullptr;
    base::Error terrain_fault_;
    std::unique_ptr<display::Display> display_;
};

}  // namespace tedavis::platform
