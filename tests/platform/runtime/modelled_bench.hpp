/// A bench whose displays really draw, small and over the self-test's terrain, but whose clock is a model: a frame takes what
/// the test says that its parts cost. What the bench finds must be what the model has.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "platform/runtime/cost_bench.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"
#include "render_core/effects/design_effects.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::platform {

struct ModelledCosts {
    double frame_ms = 5, ms_per_thousand_triangles = 2, antialiasing_ms = 3, rays_ms = 7;
};

class ModelledBench final : public BenchDisplays {
public:
    static constexpr std::uint32_t kWidth = 96, kHeight = 64;

    static BenchPlace place() {
        BenchPlace place;
        place.pose = {base::radians(36.6), base::radians(-84.19), 1500, base::radians(90), base::radians(-14), 0};
        return place;
    }

    void own_picture(BenchPicture& picture) const override {
        picture.name = "own";
        picture.design = design_;
        picture.has_terrain = picture.has_scene = true;
    }
    [[nodiscard]] BenchNote picture_with(effects::Effect effect, BenchPicture& picture) const override {
        own_picture(picture);
        if (effect != effects::Effect::antialiasing && effect != effects::Effect::haze) return "not asked for here";
        picture.design = effects::with_effect(picture.design, effect);
        return {};
    }
    [[nodiscard]] BenchNote picture_with(effects::Overhead, BenchPicture& picture) const override {
        own_picture(picture);
        return {};
    }
    [[nodiscard]] std::size_t quality_pictures() const override { return 1; }
    void quality_picture(std::size_t, BenchPicture& picture) const override {
        own_picture(picture);
        picture.design = effects::with_effect(picture.design, effects::Effect::antialiasing);
    }
    [[nodiscard]] base::Error open(const BenchPicture& picture, std::unique_ptr<DisplayHost>& host) override {
        DisplayHostSettings settings;
        settings.display.device = device;
        settings.display.design = picture.design;
        settings.display.width_px = kWidth;
        settings.display.height_px = kHeight;
        if (picture.has_terrain) settings.terrain.path = terrain.c_str();
        host = std::make_unique<DisplayHost>();
        return host->start(settings).error;
    }
    [[nodiscard]] bool draw(DisplayHost& host) override {
        host.display().draw(host.surface());
        clock_.ns += base::Duration::from_seconds(frame_ms(host.display()) / 1000).ns;
        ++drawn;
        return drawn != lost_at;
    }
    [[nodiscard]] base::Time now() const override { return clock_; }
    [[nodiscard]] bool is_stopped() const override { return drawn >= stopped_at; }
    void progress(std::size_t done, std::size_t total) override {
        EXPECT_TRUE(done == 0 || done == steps + 1) << done;
        steps = done;
        of_steps = total;
    }

    std::string terrain = test_support::source_dir() + "/target/self_test_data/terrain.tdb";
    ModelledCosts costs;
    effects::DeviceSettings device = test_support::shipped_device("es3-mid");
    int drawn = 0, lost_at = -1, stopped_at = 1 << 30;
    std::size_t steps = 0, of_steps = 0;

private:
    /// Fine enough for both levels of the terrain to be chosen at the bench's tolerances.
    static design::DesignSettings fine_design() {
        design::DesignSettings design = test_support::shipped_design("default");
        design.terrain.tau_px = 0.3;
        return design;
    }
    [[nodiscard]] double frame_ms(display::Display& display) const {
        double ms = costs.frame_ms + costs.ms_per_thousand_triangles * display.planned().counters.triangles / 1000;
        if (display.record().terrain.renderer.view() == "trace") ms += costs.rays_ms;
        for (const display::EffectRecord& effect : display.record().effects) {
            if (effect.state != display::EffectState::run) continue;
            if (effect.name.view() == "antialiasing") ms += costs.antialiasing_ms;
        }
        return ms;
    }

    design::DesignSettings design_ = fine_design();
    base::Time clock_{1};
};

}  // namespace tedavis::platform
