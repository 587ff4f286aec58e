/// Provides displays on the desk for the bench that measures costs (platform/runtime/cost_bench.hpp). Effects that the user's
/// design does not request are measured with shipped designs that request them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"
#include "platform/runtime/cost_bench.hpp"

namespace tedavis::host_sim {

/// Returns a shipped design that requests an effect, by itself or with effects::with_effect; empty for effects without cost, or
/// with a measurement of their own.
[[nodiscard]] std::string design_requesting(effects::Effect effect);

class DeskBench final : public platform::BenchDisplays {
public:
    struct Events {
        std::function<void(std::size_t done, std::size_t total)> progress;
        std::function<bool()> is_stopped;
    };
    /// Throws UserError where the device or a design cannot be read. The displays need a terrain.
    DeskBench(const PictureOptions& picture, Events events);

    /// Measures the costs of the options' device, design and terrain. `place` has the pose and the time of the data. Throws
    /// UserError where a display cannot be used, and Interrupted. The caller fills in date, design and terrain of the result.
    [[nodiscard]] effects::MeasuredCosts measure(const AircraftPose& place, std::uint32_t rounds);

    void own_picture(platform::BenchPicture& picture) const override;
    [[nodiscard]] platform::BenchNote picture_with(effects::Effect effect, platform::BenchPicture& picture) const override;
    [[nodiscard]] platform::BenchNote picture_with(effects::Overhead overhead, platform::BenchPicture& picture) const override;
    /// Number of pictures for the quality levels: the user's design with all effects of color and geometry that may be given up
    /// and can be added to it, and designs for what it may lack: glyphs of fields, blur round a focus, a view of saliency.
    [[nodiscard]] std::size_t quality_pictures() const override;
    void quality_picture(std::size_t n, platform::BenchPicture& picture) const override;
    [[nodiscard]] base::Error open(const platform::BenchPicture& picture, std::unique_ptr<platform::DisplayHost>& host) override;
    [[nodiscard]] bool draw(platform::DisplayHost& host) override;
    [[nodiscard]] base::Time now() const override;
    [[nodiscard]] bool is_stopped() const override { return events_.is_stopped && events_.is_stopped(); }
    void progress(std::size_t done, std::size_t total) override;

private:
    void load(const std::string& design);
    void set(const std::string& design, platform::BenchPicture& picture) const;
    [[nodiscard]] platform::DisplayHostSettings settings_of(const platform::BenchPicture& picture) const;

    PictureOptions picture_;
    Events events_;
    effects::DeviceSettings device_;
    design::AircraftSettings aircraft_;
    std::map<std::string, design::DesignSettings> designs_;
    std::vector<std::uint8_t> pixels_;  ///< of the drawn picture, read back as in a replay
};

}  // namespace tedavis::host_sim
