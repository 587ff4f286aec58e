/// The drawing half of a board: surface, memory reservation, terrain, display and costs, made from the board's settings. The
/// program and its self-test use the same class.
///
///   open_surface() · start() · hold_deadline()
///
/// Terrain that cannot be opened (no file, not readable, damaged) does not prevent the start: the display runs without it and
/// shows TERRAIN FAIL, and terrain_fault() gives the reason.
///
/// Thread  one. Failure  each step returns an error, empty on success. After a failure the object may only be destroyed.
#pragma once

#include <memory>

#include "platform/files/file_byte_source.hpp"
#include "platform/reservation/memory_reservation.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/display/display.hpp"
#include "target/board_config.hpp"

namespace tedavis::target {

class BoardDisplay {
public:
    /// The settings must outlive the object.
    explicit BoardDisplay(const BoardSettings& settings);
    ~BoardDisplay();
    BoardDisplay(const BoardDisplay&) = delete;
    BoardDisplay& operator=(const BoardDisplay&) = delete;

    [[nodiscard]] base::Error open_surface();
    /// Reserves the memory and starts everything that the device's budgets are divided among.
    [[nodiscard]] base::Error start();
    /// Applies the costs that the board file names, if any, so that the device's deadline is held.
    [[nodiscard]] base::Error hold_deadline();

    /// The reason why the terrain that the board file names could not be opened; empty otherwise.
    [[nodiscard]] const base::Error& terrain_fault() const { return terrain_fault_; }
    [[nodiscard]] display::Display& core() { return *display_; }
    [[nodiscard]] const base::Surface& surface() const { return *surface_; }
    [[nodiscard]] base::Surface& surface() { return *surface_; }

private:
    [[nodiscard]] base::Error open_terrain();
    [[nodiscard]] base::Error start_workers(const display::DisplaySettings& settings);
    [[nodiscard]] base::Error start_core(display::DisplaySettings& settings);
    void give_up_terrain(const base::Error& why);

    const BoardSettings& settings_;
    std::unique_ptr<base::Surface> surface_;
    platform::MemoryReservation reservation_;
    platform::FileByteSource terrain_file_;
    std::unique_ptr<base::AsyncReader> terrain_reader_;
    std::unique_ptr<base::Workers> workers_;  ///< for terrain that is drawn by ray tracing
    std::unique_ptr<display::Display> display_;
    bool is_started_ = false;
    base::Error terrain_fault_;
};

}  // namespace tedavis::target
