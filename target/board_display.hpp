/// The drawing half of a board from its settings: surface, reservation, terrain, core, costs. The program and its self-test start
/// the same one.
///
///   open_surface() · start() · hold_deadline()
///
/// Terrain that cannot be had (no file, not readable, damaged) does not keep a board from flying: the display starts without
/// it, says TERRAIN FAIL, and terrain_fault() says why.
///
/// Thread  one. Failure  one sentence a step; an empty one means success. After a failure it may only be destroyed.
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
    /// The settings must outlive it.
    explicit BoardDisplay(const BoardSettings& settings);
    ~BoardDisplay();
    BoardDisplay(const BoardDisplay&) = delete;
    BoardDisplay& operator=(const BoardDisplay&) = delete;

    [[nodiscard]] base::Error open_surface();
    /// Takes the memory, and everything that the device's budgets are cut into.
    [[nodiscard]] base::Error start();
    /// With the costs that the board file names, if any.
    [[nodiscard]] base::Error hold_deadline();

    /// Why there is no terrain though the board file names one; empty where there is.
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
    std::unique_ptr<base::Workers> workers_;  ///< where terrain is traced
    std::unique_ptr<display::Display> display_;
    bool is_started_ = false;
    base::Error terrain_fault_;
};

}  // namespace tedavis::target
