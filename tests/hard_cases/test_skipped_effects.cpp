// What the planner leaves out for being too small to be seen is not seen, over three flights: the same frames with nothing left
// out differ by one step of eight bits where only colours were left out, and where sharpness was, each pixel lies within what its
// neighbours are. What is left out has done no work.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host_sim/replay/flight_player.hpp"
#include "platform/files/file_byte_source.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::test_skipped_effects {
namespace {

using display::EffectState;

constexpr int kWidth = 320, kHeight = 240;

struct Instant {
    flight::FrameInput played;
    base::Time now;
};

/// A flight with the ground below it.
struct Flight {
    std::string name;
    base::ByteSource* terrain;
    std::vector<Instant> instants;
};

std::vector<Instant> played(const host_sim::PlayerFiles& files, base::ByteSource& terrain, double step_s) {
    test_support::HeadlessDisplay headless("egl", "desktop", 64, 48, &terrain);
    host_sim::FlightPlayer player(files, headless.display());
    std::vector<Instant> instants;
    for (base::Time now = player.first() + base::Duration::seconds(3); now < player.last();
         now = now + base::Duration::from_seconds(step_s))
        instants.push_back({player.at(now), now});
    return instants;
}

class SkippedEffects : public ::testing::Test {
protected:
    SkippedEffects() {
        const test_support::RecordedFlight recorded = test_support::default_flight();
        const host_sim::PlayerFiles default_files{folder_.write("flight.log", recorded.log), "canaerospace",
                                                  folder_.write("flight.switches", recorded.switch_log), "one_hot"};
        const host_sim::PlayerFiles circle_files{circle_.log, "canaerospace", "", "one_hot"};
        flights_ = {{"default", &terrain_.bytes, played(default_files, terrain_.bytes, 40)},
                    {"circle", &rough_, played(circle_files, rough_, 1)},
                    {"steep", &rough_, played(circle_files, rough_, 1)}};
        for (Instant& instant : flights_[2].instants) {  // the same way, looking down at the ground
            instant.played.state[flight::Signal::pitch] = {-0.5, instant.now};
            instant.played.state[flight::Signal::roll] = {0.1, instant.now};
        }
    }

    struct Frame {
        std::vector<std::uint8_t> rgba;
        display::FrameRecord record;
    };
    static std::vector<Frame> drawn(const Flight& flight, const design::DesignSettings& design, bool forced) {
        test_support::HeadlessDisplay headless("egl", "desktop", kWidth, kHeight, flight.terrain, design);
        headless.display().planner().force_effects(forced);
        std::vector<Frame> frames;
        for (const Instant& at : flight.instants) {
            Frame frame;
            headless.display().planner().clear_free_view();
            display::settle(headless.display(), {at.played.state, at.played.phase, at.now});
            headless.display().planner().set_free_view(
                headless.display().planned().picture.camera.view);  // the same eye, without symbology
            headless.display().plan({at.played.state, at.played.phase, at.now});
            frame.rgba = test_support::drawn_pixels(headless);
            frame.record = headless.display().record();
            frames.push_back(std::move(frame));
        }
        return frames;
    }

    test_support::TemporaryFolder folder_;
    test_support::DefaultTerrain terrain_;
    test_support::FlownFiles circle_;
    platform::FileByteSource file_ = std::move(platform::open_file(circle_.terrain.c_str()).value());
    base::ByteSource& rough_ = file_;
    std::vector<Flight> flights_;
};

const display::EffectRecord* effect_of(const display::FrameRecord& record, std::string_view name) {
    for (const display::EffectRecord& effect : record.effects)
        if (effect.name.view() == name) return &effect;
    return nullptr;
}

bool is_unseen(const display::FrameRecord& record, std::string_view name) {
    const display::EffectRecord* const effect = effect_of(record, name);
    return effect != nullptr && effect->state == EffectState::skipped && effect->reason.view() == "too small to be seen";
}

int greatest_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int most = 0;
    for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(int{a[n]} - int{b[n]}));
    return most;
}

/// Of the scene alone: beside translucent symbology what is soft mixes what that hides there.
/// Channels of `soft` beyond the range of the 3 x 3 pixels round the same place of `sharp`, by more than one step.
int out_of_neighbourhood(const std::vector<std::uint8_t>& soft, const std::vector<std::uint8_t>& sharp) {
    int count = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                int least = 255, most = 0;
                for (int dy = std::max(y - 1, 0); dy <= std::min(y + 1, kHeight - 1); ++dy)
                    for (int dx = std::max(x - 1, 0); dx <= std::min(x + 1, kWidth - 1); ++dx) {
                        const int value = sharp[(static_cast<std::size_t>(dy) * kWidth + static_cast<std::size_t>(dx)) * 4 +
                                                static_cast<std::size_t>(channel)];
                        least = std::min(least, value);
                        most = std::max(most, value);
                    }
                const int value = soft[(static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) * 4 +
                                       static_cast<std::size_t>(channel)];
                count += value < least - 1 || value > most + 1 ? 1 : 0;
            }
    return count;
}

/// Without antialiasing: which pixels it smooths depends on thresholds, so that one step before it may be many behind it.
design::DesignSettings plain() {
    design::DesignSettings design = test_support::shipped_design("default");
    design.data = {};
    design.effects.antialiasing = design::Antialiasing::off;
    return design;
}

TEST_F(SkippedEffects, OfColorChangeNoPixelByMoreThanOneStep) {
    design::DesignSettings hazy = plain();
    hazy.sky.haze_distance_m = 3'000'000;
    design::DesignSettings clear = plain();
    clear.sky.haze_distance_m = 30'000;
    int left_out = 0, frames = 0, seen = 0;
    for (const Flight& flight : flights_) {
        const auto planned = drawn(flight, hazy, false), forced = drawn(flight, hazy, true), near = drawn(flight, clear, false);
        for (std::size_t n = 0; n < planned.size(); ++n) {
            ++frames;
            ASSERT_LE(greatest_difference(planned[n].rgba, forced[n].rgba), 1) << flight.name << " " << n;
            if (!is_unseen(planned[n].record, "haze")) continue;
            ++left_out;
            seen += greatest_difference(near[n].rgba, planned[n].rgba) > 1 ? 1 : 0;
        }
    }
    EXPECT_GT(left_out, frames / 4) << "the flights call for it in most frames, which proves little";
    EXPECT_EQ(seen, left_out) << "haze that may not be left out would be seen";
}

TEST_F(SkippedEffects, OfSharpnessStayWithinThePixelsBesideAndDoNoWork) {
    design::DesignSettings soft = plain();
    soft.effects.depth_of_field = {0.6, 16, 0, 4000};
    design::DesignSettings blurred = plain();
    blurred.effects.depth_of_field = {6, 16, 0, 4000};
    int left_out = 0, ran = 0, seen = 0;
    for (const Flight& flight : flights_) {
        const auto planned = drawn(flight, soft, false), forced = drawn(flight, soft, true), much = drawn(flight, blurred, true);
        for (std::size_t n = 0; n < planned.size(); ++n) {
            const display::EffectRecord* const field = effect_of(planned[n].record, "depth_of_field");
            if (field == nullptr || !is_unseen(planned[n].record, "depth_of_field")) continue;
            ++left_out;
            EXPECT_EQ(field->draws + field->passes + field->bytes, 0u);
            const display::EffectRecord* const whole = effect_of(forced[n].record, "depth_of_field");
            ran += whole != nullptr && whole->passes == 1 && whole->draws > 0 ? 1 : 0;
            ASSERT_EQ(out_of_neighbourhood(forced[n].rgba, planned[n].rgba), 0) << flight.name << " " << n;
            seen += out_of_neighbourhood(much[n].rgba, planned[n].rgba) > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(left_out, 3);
    EXPECT_EQ(ran, left_out) << "forced, each of them costs its pass";
    EXPECT_GT(seen, 0) << "the measure tells a blur that is seen";
}

}  // namespace
}  // namespace tedavis::test_skipped_effects
