// What a frame shows must not depend on how a run came to it.
#include "host_sim/replay/frame_preroll.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/frame_instants.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/flights/six_levels.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_frame_preroll {
namespace {

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

constexpr PictureSize kWithLabels{320, 240};  ///< on which the smallest text leaves room for some labels
constexpr PictureSize kSmall{160, 120};       ///< most of what a frame costs here is its pixels
constexpr double kScarce_ms = 3;
constexpr double kStep_s = 1.0 / 30;  ///< of the device: terrain arrives while frames are drawn

ReplayOptions options(double from_s, double to_s, double step_s) {
    ReplayOptions o = files().options("unused");
    o.picture.size = kSmall;
    o.from_s = from_s;
    o.to_s = to_s;
    o.step_s = step_s;
    return o;
}

struct Frame {
    std::uint64_t hash = 0;
    std::uint32_t pending = 0, triangles = 0;
    double tau_px = 0;
    display::LabelRecord labels{};
    double terrain_weight = 1;
    bool is_decluttered = false;  ///< for the budget of clutter
    bool operator==(const Frame& o) const {
        return terrain_weight == o.terrain_weight && is_decluttered == o.is_decluttered && hash == o.hash &&
               pending == o.pending && triangles == o.triangles && tau_px == o.tau_px && labels.placed == o.labels.placed &&
               labels.suppressed == o.labels.suppressed && labels.changed == o.labels.changed;
    }
};

/// Frames by their time, in the order of the run.
std::map<std::int64_t, Frame> run(const ReplayOptions& asked, bool has_preroll) {
    DisplaySession session(asked.picture, false);
    FlightPlayer player({asked.log, asked.picture.bus, asked.switches, asked.switch_config}, session.display());
    const FrameInstants times(asked, player.first(), player.last(), session.device().frame_rate_hz);
    FramePreroll preroll(player, session, session.device().frame_rate_hz);
    std::map<std::int64_t, Frame> frames;
    for (std::uint64_t n = 0; n < times.count(); ++n) {
        EXPECT_TRUE(!has_preroll || preroll.preroll(times.at(n)));
        const flight::FrameInput instant = player.at(times.at(n));
        session.display().plan({instant.state, instant.phase, times.at(n)});
        session.draw();
        const display::TerrainRecord& terrain = session.display().record().terrain;
        frames[times.at(n).ns] = {session.frame_hash(),
                                  terrain.pending,
                                  terrain.triangles,
                                  terrain.tau_reached_px,
                                  session.display().record().labels,
                                  session.display().record().weights[0].weight,
                                  !session.display().record().clutter.left.is_whole()};
    }
    return frames;
}

std::size_t differences(const std::map<std::int64_t, Frame>& whole, const std::map<std::int64_t, Frame>& part) {
    std::size_t different = 0;
    for (const auto& [time, frame] : part) {
        EXPECT_EQ(whole.count(time), 1u) << time;
        different += whole.count(time) == 0 || !(whole.at(time) == frame) ? 1 : 0;
    }
    return different;
}

const std::map<std::int64_t, Frame>& whole() {
    static const std::map<std::int64_t, Frame> kWhole = run(options(0, 2, kStep_s), true);
    return kWhole;
}

/// The bus has not said enough for terrain at the log's start; soon after it has.
TEST(FramePreroll, TerrainAppearsAndArrivesWithinTheWholeRun) {
    ASSERT_EQ(whole().size(), 61u);
    int without = 0, pending = 0, complete = 0;
    for (const auto& [time, frame] : whole()) {
        without += frame.triangles == 0 ? 1 : 0;
        pending += frame.pending > 0 ? 1 : 0;
        complete += frame.triangles > 0 && frame.pending == 0 ? 1 : 0;
    }
    EXPECT_GT(without, 0);
    EXPECT_GT(pending, 0);
    EXPECT_GT(complete, 10);
}

TEST(FramePreroll, APartOfARunHasTheFramesOfTheWhole) {
    for (const double frames : {1.0, 5.0, 8.0, 9.0, 20.0, 33.0, 45.0})
        EXPECT_EQ(differences(whole(), run(options(frames * kStep_s, 2, kStep_s), true)), 0u) << "from frame " << frames;
    EXPECT_GT(differences(whole(), run(options(45 * kStep_s, 2, kStep_s), false)), 0u) << "control";
}

TEST(FramePreroll, BackwardsHasTheFramesOfForwards) {
    EXPECT_EQ(differences(whole(), run(options(0, 2, -kStep_s), true)), 0u);
    EXPECT_GT(differences(whole(), run(options(0, 2, -kStep_s), false)), 0u) << "control";
}

TEST(FramePreroll, OtherStepsMeetTheSameFrames) {
    for (const double frames : {2.0, 7.0, -15.0})
        EXPECT_EQ(differences(whole(), run(options(0, 2, frames * kStep_s), true)), 0u) << "every " << frames << "th";
}

/// Between the frames of the device too.
TEST(FramePreroll, AnInstantIsTheSameHoweverItIsReached) {
    const auto forth = run(options(0.011, 1.811, 0.15), true);
    EXPECT_EQ(differences(forth, run(options(0.011, 1.811, -0.15), true)), 0u);
}

/// So scarce that the governor changes while terrain arrives, and goes back: after half a second, that two seconds may show it.
effects::CostTable costs_of_triangles() {
    effects::CostTable costs;
    costs.is_known = true;
    costs[effects::Effect::terrain].ms_per_thousand = 1;
    return costs;
}

std::map<std::int64_t, Frame> governed(const ReplayOptions& asked, bool has_preroll, std::size_t* most_quality_levels = nullptr) {
    DisplaySession session(asked.picture, false);
    effects::GovernorSettings settings;
    settings.dwell = base::Duration::milliseconds(200);
    session.display().memory().budget.hold(kScarce_ms, costs_of_triangles(), test_support::six_levels(), settings);
    FlightPlayer player({asked.log, asked.picture.bus, asked.switches, asked.switch_config}, session.display());
    const FrameInstants times(asked, player.first(), player.last(), session.device().frame_rate_hz);
    FramePreroll preroll(player, session, session.device().frame_rate_hz);
    std::map<std::int64_t, Frame> frames;
    std::set<std::uint32_t> quality_levels;
    for (std::uint64_t n = 0; n < times.count(); ++n) {
        EXPECT_TRUE(!has_preroll || preroll.preroll(times.at(n)));
        const flight::FrameInput instant = player.at(times.at(n));
        session.display().plan({instant.state, instant.phase, times.at(n)});
        session.draw();
        const display::FrameRecord& record = session.display().record();
        frames[times.at(n).ns] = {
            session.frame_hash(),
            record.terrain.pending,
            record.terrain.triangles,
            record.terrain.tau_px + 100.0 * record.governor.quality_level + (record.governor.changed ? 1000 : 0),
            {}};
        quality_levels.insert(record.governor.quality_level);
    }
    if (most_quality_levels != nullptr) *most_quality_levels = quality_levels.size();
    return frames;
}

TEST(FramePreroll, WhatTheGovernorDecidesIsTheSameHoweverAFrameIsReached) {
    std::size_t quality_levels = 0;
    const auto all = governed(options(0, 4, kStep_s), true, &quality_levels);
    ASSERT_GT(quality_levels, 1u) << "it has something to decide";
    for (const double frames : {1.0, 9.0, 33.0, 70.0, 110.0})
        EXPECT_EQ(differences(all, governed(options(frames * kStep_s, 4, kStep_s), true)), 0u) << "from frame " << frames;
    for (const double frames : {7.0, -15.0, -1.0})
        EXPECT_EQ(differences(all, governed(options(0, 4, frames * kStep_s), true)), 0u) << "every " << frames << "th";
    EXPECT_GT(differences(all, governed(options(70 * kStep_s, 4, kStep_s), false)), 0u) << "control";
    const auto between = governed(options(0.011, 3.611, 0.15), true);
    EXPECT_EQ(differences(between, governed(options(0.011, 3.611, -0.15), true)), 0u);
}

ReplayOptions with_a_choice(double from_s, double to_s, double step_s) {
    static const std::string kDesign = files().folder.write("either.toml",
                                                            "name = \"either\"\n[terrain]\nrenderer = \"auto\"\n"
                                                            "[terrain.texture]\ntechnique = \"plain\"\n");
    ReplayOptions o = options(from_s, to_s, step_s);
    o.picture.design = kDesign;
    return o;
}

/// Rays cost what `rays_ms` says, and triangles a millisecond a thousand.
std::map<std::int64_t, Frame> chosen(const ReplayOptions& asked, double rays_ms, bool has_preroll,
                                     std::size_t* traced = nullptr) {
    DisplaySession session(asked.picture, false);
    effects::CostTable costs = costs_of_triangles();
    costs[effects::Overhead::rays].ms_per_megapixel = rays_ms / (1e-6 * kSmall.width * kSmall.height);
    session.display().memory().budget.hold(0, costs);
    FlightPlayer player({asked.log, asked.picture.bus, asked.switches, asked.switch_config}, session.display());
    const FrameInstants times(asked, player.first(), player.last(), session.device().frame_rate_hz);
    FramePreroll preroll(player, session, session.device().frame_rate_hz);
    std::map<std::int64_t, Frame> frames;
    for (std::uint64_t n = 0; n < times.count(); ++n) {
        EXPECT_TRUE(!has_preroll || preroll.preroll(times.at(n)));
        const flight::FrameInput instant = player.at(times.at(n));
        session.display().plan({instant.state, instant.phase, times.at(n)});
        session.draw();
        const display::TerrainRecord& terrain = session.display().record().terrain;
        const bool by_rays = terrain.renderer.view() == "trace";
        frames[times.at(n).ns] = {session.frame_hash(), terrain.pending, terrain.triangles, terrain.triangles_ms + by_rays, {}};
        if (traced != nullptr) *traced += by_rays ? 1 : 0;
    }
    return frames;
}

/// Rays draw the terrain until its triangles have arrived, and two seconds longer.
TEST(FramePreroll, TheChosenRendererIsTheSameHoweverAFrameIsReached) {
    constexpr double kDear_ms = 1e6;
    std::size_t traced = 0;
    const auto all = chosen(with_a_choice(0, 4, kStep_s), kDear_ms, true, &traced);
    ASSERT_GT(traced, 0u);
    ASSERT_LT(traced, all.size());
    for (const double frames : {1.0, 33.0, 70.0, 110.0})
        EXPECT_EQ(differences(all, chosen(with_a_choice(frames * kStep_s, 4, kStep_s), kDear_ms, true)), 0u) << "from " << frames;
    for (const double frames : {7.0, -15.0})
        EXPECT_EQ(differences(all, chosen(with_a_choice(0, 4, frames * kStep_s), kDear_ms, true)), 0u) << "every " << frames;
    EXPECT_GT(differences(all, chosen(with_a_choice(70 * kStep_s, 4, kStep_s), kDear_ms, false)), 0u) << "control";
}

/// Cruise is stated from 0.6 s on, and the bus is believed a second later; its design takes half a second.
class TurningCircle final : public test_support::FlownCircle {
public:
    std::optional<flight::FlightPhase> stated_phase(base::Time time) const override {
        if ((time - begin()).to_seconds() < 0.6) return flight::kTakeoffFirstClimb;
        return flight::FlightPhase{flight::Scenario::cruise, 0};
    }
};

const std::string kPlaces = "[[data.element]]\nrole = \"place\"\ntechnique = \"billboard\"\n";

ReplayOptions of_two_designs(double from_s, double to_s, double step_s) {
    static const test_support::FlownFiles kFiles{TurningCircle()};
    static const std::string kDesign = kFiles.folder.write("climb.toml",
                                                           "name = \"climb\"\n[effects]\nfade_s = 0.5\n[phases]\n"
                                                           "cruise = \"lines.toml\"\n" +
                                                               kPlaces);
    static const std::string kLines = kFiles.folder.write("lines.toml",
                                                          "name = \"lines\"\n[terrain.texture]\ntechnique = \"plain\"\n"
                                                          "[terrain.sketch]\ncontours = 1\n[effects]\nfade_s = 0.5\n" +
                                                              kPlaces + "[labels]\nmost_changes = 20\npopulation = 0\n");
    ReplayOptions o = kFiles.options("unused");
    o.picture.size = kSmall;
    o.picture.design = kDesign;
    o.from_s = from_s;
    o.to_s = to_s;
    o.step_s = step_s;
    return o;
}

TEST(FramePreroll, AFadeOfTwoDesignsIsTheSameHoweverAFrameIsReached) {
    const auto all = run(of_two_designs(1.4, 2.4, kStep_s), true);
    for (const double frames : {47.0, 48.0, 49.0, 55.0, 60.0, 66.0})
        EXPECT_EQ(differences(all, run(of_two_designs(frames * kStep_s, 2.4, kStep_s), true)), 0u) << "from frame " << frames;
    for (const double frames : {3.0, -1.0})
        EXPECT_EQ(differences(all, run(of_two_designs(1.4, 2.4, frames * kStep_s), true)), 0u) << "every " << frames << "th";
    EXPECT_GT(differences(all, run(of_two_designs(50 * kStep_s, 2.4, kStep_s), false)), 0u) << "control";
}

/// On the small lane a map is of an earlier frame.
ReplayOptions with_saliency(double from_s, double to_s, double step_s) {
    ReplayOptions o = options(from_s, to_s, step_s);
    o.picture.device = "es2-small";
    o.picture.with.add(effects::Effect::saliency);
    return o;
}

TEST(FramePreroll, ASaliencyMapIsTheSameHoweverAFrameIsReached) {
    const auto all = run(with_saliency(0, 1.4, kStep_s), true);
    for (const double frames : {3.0, 14.0, 15.0, 16.0, 31.0})
        EXPECT_EQ(differences(all, run(with_saliency(frames * kStep_s, 1.4, kStep_s), true)), 0u) << "from frame " << frames;
    for (const double frames : {4.0, -1.0})
        EXPECT_EQ(differences(all, run(with_saliency(0, 1.4, frames * kStep_s), true)), 0u) << "every " << frames << "th";
    EXPECT_GT(differences(all, run(with_saliency(20 * kStep_s, 1.4, kStep_s), false)), 0u) << "control";
}

/// So many places along the way that most of them have to wait.
const std::string& crowded_scene() {
    static const std::string kPath = [] {
        host_sim::SceneDraft draft{"crowd", "a test", 1, {}};
        host_sim::LayerDraft layer;
        layer.name = "places";
        layer.role = scene::LayerRole::place;
        std::uint32_t state = 5;
        const auto next = [&] { return static_cast<double>((state = state * 1664525u + 1013904223u) >> 8) / (1u << 24); };
        for (int n = 0; n < 400; ++n) {
            layer.points.push_back(
                test_support::scene_point(47.03 + 0.06 * next(), 9.64 + 0.06 * next(), std::numeric_limits<float>::quiet_NaN()));
            layer.names.push_back("Ort " + std::to_string(n));
        }
        draft.layers = {layer};
        const std::vector<std::uint8_t> bytes = host_sim::sdb_bytes(draft);
        std::string path = files().folder.file("crowd.sdb");
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path;
    }();
    return kPath;
}

ReplayOptions crowded(double from_s, double to_s, double step_s) {
    ReplayOptions o = options(from_s, to_s, step_s);
    o.picture.scene = crowded_scene();
    o.picture.size = kWithLabels;
    return o;
}

TEST(FramePreroll, LabelsAreTheSameHoweverAFrameIsReached) {
    const auto all = run(crowded(0, 5, kStep_s), true);
    std::uint32_t placed = 0, changes = 0, suppressed = 0;
    for (const auto& [time, frame] : all) {
        placed = std::max(placed, frame.labels.placed);
        suppressed = std::max(suppressed, frame.labels.suppressed);
        changes += frame.labels.changed;
    }
    ASSERT_GT(placed, 3u);
    ASSERT_GT(suppressed, 20u);
    ASSERT_GT(changes, placed) << "some went and others came";
    for (const double frames : {1.0, 16.0, 45.0, 100.0, 140.0})
        EXPECT_EQ(differences(all, run(crowded(frames * kStep_s, 5, kStep_s), true)), 0u) << "from frame " << frames;
    for (const double frames : {7.0, -1.0, -31.0})
        EXPECT_EQ(differences(all, run(crowded(0, 5, frames * kStep_s), true)), 0u) << "every " << frames << "th";
    EXPECT_GT(differences(all, run(crowded(100 * kStep_s, 5, kStep_s), false)), 0u) << "control";
}

/// Each of the two designs has labels of its own.
TEST(FramePreroll, LabelsOfTwoDesignsAreTheSameHoweverAFrameIsReached) {
    const auto crowd = [](double from_s, double step_s) {
        ReplayOptions o = of_two_designs(from_s, 3, step_s);
        o.picture.scene = crowded_scene();
        o.picture.size = kWithLabels;
        return o;
    };
    const auto all = run(crowd(0, kStep_s), true);
    std::set<std::uint32_t> placed;
    for (const auto& [time, frame] : all) placed.insert(frame.labels.placed);
    ASSERT_GT(placed.size(), 3u) << "it turns";
    for (const double frames : {40.0, 46.0, 47.0, 48.0, 49.0, 52.0, 59.0, 60.0, 61.0, 70.0})
        EXPECT_EQ(differences(all, run(crowd(frames * kStep_s, kStep_s), true)), 0u) << "from frame " << frames;
    for (const double frames : {3.0, -1.0})
        EXPECT_EQ(differences(all, run(crowd(0, frames * kStep_s), true)), 0u) << "every " << frames << "th";
}

/// In the climb terrain is a hazard that counts for much, in cruise for little.
ReplayOptions weighed(double from_s, double step_s) {
    const auto priority = [](double terrain, double within_m) {
        return "[priority]\nterrain = " + std::to_string(terrain) + "\nhazard_within_m = " + std::to_string(within_m) + "\n";
    };
    static const std::string kClimb = files().folder.write(
        "weighed_climb.toml",
        "name = \"climb\"\n[effects]\nfade_s = 0.5\n[phases]\ncruise = \"weighed_cruise.toml\"\n" + priority(0.1, 3000));
    static const std::string kCruise =
        files().folder.write("weighed_cruise.toml", "name = \"cruise\"\n[effects]\nfade_s = 0.5\n" + priority(0.4, 2600));
    ReplayOptions o = of_two_designs(from_s, 4, step_s);
    o.picture.design = kClimb;
    return o;
}

TEST(FramePreroll, RaisedWeightsAreTheSameHoweverAFrameIsReached) {
    const auto all = run(weighed(0, kStep_s), true);
    std::set<double> weights;
    for (const auto& [time, frame] : all) weights.insert(frame.terrain_weight);
    ASSERT_GT(weights.size(), 4u) << "hazards raise it, and it turns";
    for (const double frames : {1.0, 20.0, 46.0, 47.0, 48.0, 49.0, 52.0, 60.0, 61.0, 90.0})
        EXPECT_EQ(differences(all, run(weighed(frames * kStep_s, kStep_s), true)), 0u) << "from frame " << frames;
    for (const double frames : {3.0, -1.0})
        EXPECT_EQ(differences(all, run(weighed(0, frames * kStep_s), true)), 0u) << "every " << frames << "th";
    EXPECT_GT(differences(all, run(weighed(90 * kStep_s, kStep_s), false)), 0u) << "control";
}

/// Names give way where there are many; on the small lane for two intervals of a second, else for four of half a second.
ReplayOptions budgeted(double from_s, double step_s, const char* device) {
    const std::string priority = "[priority]\nterrain = 1\ndata = 0.6\nclutter_budget = 0.05\n" + kPlaces;
    static const std::string kClimb = files().folder.write(
        "budgeted_climb.toml",
        "name = \"climb\"\n[effects]\nfade_s = 0.5\n[phases]\ncruise = \"budgeted_cruise.toml\"\n" + priority);
    static const std::string kCruise = files().folder.write(
        "budgeted_cruise.toml", "name = \"cruise\"\n[effects]\nfade_s = 0.5\n[labels]\nmost_changes = 20\n" + priority);
    ReplayOptions o = of_two_designs(from_s, 4, step_s);
    o.picture.design = kClimb;
    o.picture.device = device;
    o.picture.scene = crowded_scene();
    return o;
}

/// From the first frame after a fade, within an interval, at its end, long after: what one device shows holds on the other.
TEST(FramePreroll, ABudgetOfClutterIsHeldTheSameHoweverAFrameIsReached) {
    const std::pair<const char*, std::vector<double>> begins[] = {{"es3-mid", {16, 60}}, {"es2-small", {49, 90}}};
    for (const auto& [device, frames_from] : begins) {
        const auto all = run(budgeted(0, kStep_s, device), true);
        std::size_t decluttering = 0;
        std::uint32_t decluttered = 0;
        for (const auto& [time, frame] : all) {
            decluttering += frame.is_decluttered ? 1 : 0;
            decluttered = std::max(decluttered, frame.labels.decluttered);
        }
        ASSERT_GT(decluttering, all.size() / 3) << device;
        ASSERT_GT(decluttered, 1u) << device;
        for (const double frames : frames_from)
            EXPECT_EQ(differences(all, run(budgeted(frames * kStep_s, kStep_s, device), true)), 0u) << "from frame " << frames;
        EXPECT_EQ(differences(all, run(budgeted(0, -15 * kStep_s, device), true)), 0u) << "every 15th, backwards";
        EXPECT_GT(differences(all, run(budgeted(100 * kStep_s, kStep_s, device), false)), 0u) << "control";
    }
}

/// A run that begins late, on what another one has decided.
struct Begun {
    explicit Begun(const ReplayOptions& asked)
        : session(asked.picture, false),
          player({asked.log, asked.picture.bus, asked.switches, asked.switch_config}, session.display()),
          preroll(player, session, session.device().frame_rate_hz) {}
    [[nodiscard]] base::Time at(double seconds) const { return player.first() + base::Duration::from_seconds(seconds); }
    std::uint64_t draw(base::Time time) {
        const flight::FrameInput instant = player.at(time);
        session.display().plan({instant.state, instant.phase, time});
        session.draw();
        return session.frame_hash();
    }
    DisplaySession session;
    FlightPlayer player;
    FramePreroll preroll;
};

TEST(FramePreroll, WhatWasGivenUpOrDecidedInPartsGivesTheSameFrame) {
    constexpr double kLate_s = 7;
    const auto all = run(crowded(kLate_s, kLate_s, kStep_s), true);
    {
        Begun begun(crowded(0, 8, kStep_s));
        const base::Time late = begun.at(kLate_s);
        const std::int64_t undecided = begun.preroll.undecided_before(late);
        EXPECT_GE(undecided, 14);
        int left = 5;
        begun.preroll.decide_before(late, [&left] { return left-- > 0; });
        EXPECT_EQ(begun.preroll.undecided_before(late), undecided - 5);
        static_cast<void>(begun.draw(begun.at(3)));  // a picture in between that nothing led to
        begun.preroll.leave();
        EXPECT_TRUE(begun.preroll.preroll(late));
        EXPECT_EQ(begun.preroll.undecided_before(late), 0);
        EXPECT_EQ(begun.draw(late), all.begin()->second.hash);
    }
    Begun control(crowded(0, 8, kStep_s));
    EXPECT_NE(control.draw(control.at(kLate_s)), all.begin()->second.hash);
}

/// The governor's frames are told; giving up leaves nothing that a later frame would notice.
TEST(FramePreroll, IsToldHowFarItIsAndMayBeGivenUp) {
    const ReplayOptions asked = options(0, 4, kStep_s);
    Begun begun(asked);
    begun.session.display().memory().budget.hold(kScarce_ms, costs_of_triangles(), test_support::six_levels());
    std::uint64_t most = 0, total = 0;
    bool goes_on = false;
    begun.preroll.set_told([&](std::uint64_t done, std::uint64_t all) {
        most = std::max(most, done);
        total = all;
        return goes_on || done < 30;
    });
    EXPECT_FALSE(begun.preroll.preroll(begun.at(4)));
    EXPECT_EQ(most, 30u);
    EXPECT_EQ(total, 120u);
    goes_on = true;
    EXPECT_TRUE(begun.preroll.preroll(begun.at(4)));
    EXPECT_GT(most, 30u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_frame_preroll
