/// A planner of frames over the hills, without a GL: what a painter can do is said to it.
#pragma once

#include <memory>
#include <stdexcept>

#include "render_core/base/ports/async_reader.hpp"
#include "render_core/display/planner/frame_planner.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/files/kept_reservation.hpp"

namespace tedavis::test_support {

class HillsPlanner {
public:
    /// `scene`: a scene database, which is read whole, or null. Data elements are planned only with a scene.
    explicit HillsPlanner(const design::DesignSettings& design, const char* device = "es3-mid",
                          const design::PhaseDesigns* phases = nullptr, base::ByteSource* scene = nullptr)
        : bytes_(hills().image), reader_(bytes_, base::kMaxReadTickets) {
        display::DisplaySettings settings;
        settings.device = shipped_device(device);
        settings.design = design;
        settings.phases = phases;
        settings.width_px = 320;
        settings.height_px = 240;
        reservation_ = std::make_unique<KeptReservation>(display::DisplayMemory::bytes_needed(settings.device.budget));
        base::Arena reservation = reservation_->arena();
        must(planner_.take_designs(settings, memory));
        must(arenas_.cut(planner_.settings().device.budget, reservation));
        const draw::DrawnDesign only = draw::drawn_as(planner_.design_at(0), {}, false);
        must(planner_.start_symbology(arenas_.symbology()));
        must(planner_.start_intervals(arenas_.frames(), arenas_.memories()));
        must(planner_.start_terrain({&bytes_, &reader_, terrain::ArrivalMode::exact}, {&only, 1}, arenas_.terrain()));
        must(planner_.start_scene(scene, arenas_.scene(), 0));
        const bool has_instances = settings.device.capability.lane == effects::Lane::es3;
        if (scene != nullptr) must(planner_.start_elements(has_instances, arenas_.elements()));
        display::PainterAbilities painter;
        painter.fades = design.effects.fade_s > 0;
        planner_.start_memory({&only, 1}, memory);
        planner_.follow_painter(painter, {&only, 1});
    }

    [[nodiscard]] display::FramePlanner& planner() { return planner_; }
    /// The input's frame, from a memory that it goes on in.
    [[nodiscard]] std::unique_ptr<display::PlannedFrame> plan(const flight::FrameInput& input, display::PlannerMemory& from) {
        auto frame = std::make_unique<display::PlannedFrame>();
        planner_.plan(input, from, *frame);
        return frame;
    }
    /// Until every chunk that the input's frame needs has arrived.
    void settle(const flight::FrameInput& input) {
        constexpr int kMaxTimes = 64;
        for (int n = 0; n < kMaxTimes; ++n)
            if (plan(input, memory)->terrain.pending == 0) return;
    }

    display::PlannerMemory memory;

private:
    static void must(const base::Error& error) {
        if (error) throw std::runtime_error(error.message.c_str());
    }

    MemoryBytes bytes_;
    base::SynchronousReader reader_;
    std::unique_ptr<KeptReservation> reservation_;
    display::DisplayMemory arenas_;
    display::FramePlanner planner_;
};

}  // namespace tedavis::test_support
