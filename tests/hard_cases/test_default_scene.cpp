// What the default flight promises to show can be seen: where an element is left out of the design, or the uncertainty of one,
// the picture is another. In every scenario of the flight, for what surrounds it, and at some time for what it passes.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "host_sim/replay/flight_player.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/default_scene.hpp"

namespace tedavis::test_default_scene {
namespace {

using scene::LayerRole;

constexpr std::uint32_t kWidth = 512, kHeight = 384;
constexpr double kFirst_s = 2, kStep_s = 10;
constexpr int kSeen_px = 30;

struct Moment {
    flight::FrameInput instant;
    base::Time now;
    std::string scenario;
};

/// Without legends, which would change as well.
design::DesignSettings plain_design() {
    design::DesignSettings design = test_support::shipped_design("default");
    design.symbology.legend = false;
    return design;
}

class DefaultScene : public ::testing::Test {
protected:
    DefaultScene() : bytes_(test_support::default_scene()), source_{bytes_} {
        play();
        whole_ = pictures(plain_design());
    }

    void play() {
        const test_support::RecordedFlight flight = test_support::default_flight();
        test_support::HeadlessDisplay headless("egl", "es3-mid", 64, 64, &terrain_.bytes);
        host_sim::FlightPlayer player({folder_.write("flight.log", flight.log), "canaerospace",
                                       folder_.write("flight.switches", flight.switch_log), "one_hot"},
                                      headless.display());
        for (double second = kFirst_s; player.first() + base::Duration::from_seconds(second) < player.last(); second += kStep_s) {
            const base::Time now = player.first() + base::Duration::from_seconds(second);
            const flight::FrameInput instant = player.at(now);
            moments_.push_back({instant, now, flight::scenario_name(instant.phase.phase)});
        }
    }

    std::vector<std::vector<std::uint8_t>> pictures(const design::DesignSettings& design) {
        test_support::HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &terrain_.bytes, design, test_support::as_it_is,
                                               &source_);
        std::vector<std::vector<std::uint8_t>> all;
        for (const Moment& moment : moments_)
            all.push_back(test_support::settled_pixels(headless, moment.instant.state, moment.now, moment.instant.phase));
        return all;
    }

    /// Moments of each scenario in which another design gives another picture.
    std::map<std::string, int> seen_without(const design::DesignSettings& design) {
        const std::vector<std::vector<std::uint8_t>> others = pictures(design);
        std::map<std::string, int> seen;
        for (std::size_t n = 0; n < others.size(); ++n) {
            int changed = 0;
            for (std::size_t at = 0; at < others[n].size(); at += 4) {
                int most = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    most = std::max(most, std::abs(int{others[n][at + k]} - int{whole_[n][at + k]}));
                changed += most >= 8 ? 1 : 0;
            }
            seen[moments_[n].scenario] += changed >= kSeen_px ? 1 : 0;
        }
        return seen;
    }
    std::map<std::string, int> seen_of(LayerRole role) {
        design::DesignSettings design = plain_design();
        design.data.elements.clear();
        for (const design::DataElement& element : plain_design().data.elements)
            if (element.role != role) {
                EXPECT_TRUE(design.data.elements.try_push_back(element));
            }
        return seen_without(design);
    }
    std::map<std::string, int> seen_uncertainty_of(LayerRole role) {
        design::DesignSettings design = plain_design();
        for (design::DataElement& element : design.data.elements)
            if (element.role == role) element.uncertainty = design::ElementUncertainty::none;
        return seen_without(design);
    }

    static int sum_of(const std::map<std::string, int>& seen) {
        int sum = 0;
        for (const auto& [scenario, count] : seen) sum += count;
        return sum;
    }

    test_support::TemporaryFolder folder_;
    test_support::DefaultTerrain terrain_;
    std::vector<std::uint8_t> bytes_;
    test_support::MemoryBytes source_;
    std::vector<Moment> moments_;
    std::vector<std::vector<std::uint8_t>> whole_;
};

/// The planned flight is always in view, the wind on the way, and the storm from the ridge.
bool is_promised(LayerRole role, const std::string& scenario) {
    if (role == LayerRole::trajectory) return true;
    if (role == LayerRole::wind) return scenario != "ground" && scenario != "go_around";
    return role == LayerRole::storm_cell && scenario == "cruise";
}

TEST_F(DefaultScene, ShowsWhatItPromisesWithItsUncertainty) {
    EXPECT_EQ(sum_of(seen_without(plain_design())), 0) << "the same design gives the same pictures";
    for (const LayerRole role : {LayerRole::wind, LayerRole::trajectory, LayerRole::obstacle, LayerRole::storm_cell,
                                 LayerRole::no_go, LayerRole::place}) {
        const std::map<std::string, int> seen = seen_of(role);
        std::string what(scene::name_of(role));
        for (const auto& [scenario, count] : seen) what += " " + scenario + " " + std::to_string(count);
        for (const auto& [scenario, count] : seen)
            EXPECT_TRUE(!is_promised(role, scenario) || count > 0) << scenario << " of " << what;
        EXPECT_GE(sum_of(seen), 3) << what;
        EXPECT_GE(sum_of(seen_uncertainty_of(role)), 2) << what;
    }
}

}  // namespace
}  // namespace tedavis::test_default_scene
