#include "platform/runtime/display_host.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "platform/surface_factory.hpp"
#include "render_core/display/calibration_subject.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/memory_bytes.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/even_costs.hpp"

namespace tedavis::platform::test_display_host {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr base::Time kNow{1};

DisplayHostSettings shipped() {
    DisplayHostSettings settings;
    settings.display.device = test_support::shipped_device("es2-small");
    settings.display.design = test_support::shipped_design("default");
    settings.display.width_px = 64;
    settings.display.height_px = 48;
    return settings;
}

const std::string& terrain_path() {
    static const std::string path = test_support::source_dir() + "/target/self_test_data/terrain.tdb";
    return path;
}

/// Terrain that cannot be used, each kind in a file of its own.
struct BadTerrain {
    test_support::TemporaryFolder folder;
    std::string sound = test_support::source_file("target/self_test_data/terrain.tdb");
    std::string absent = folder.file("absent.tdb");
    std::string text = folder.write("text.tdb", std::string(600, '.'));
    std::string cut = folder.write("cut.tdb", sound.substr(0, 3000));
};

std::string message(const HostFault& fault) { return std::string(fault.error.message.view()); }

const display::FrameRecord& drawn(DisplayHost& host) {
    host.display().plan({{}, {}, kNow});
    host.display().draw(host.surface());
    EXPECT_EQ(host.surface().present(), base::SurfaceState::ready);
    return host.display().record();
}

bool has_flag(const display::FrameRecord& record, std::string_view name) {
    return std::any_of(record.flags.begin(), record.flags.end(), [name](const auto& flag) { return flag.view() == name; });
}

/// A surface that is lost when the test says so, and counts how often it was asked to become current.
class LosableSurface final : public base::Surface {
public:
    struct State {
        bool is_lost = false;
        int asked = 0, released = 0;
        SurfaceSettings settings;
    };
    LosableSurface(std::unique_ptr<base::Surface> inner, State& state) : inner_(std::move(inner)), state_(state) {}
    [[nodiscard]] std::uint32_t width() const override { return inner_->width(); }
    [[nodiscard]] std::uint32_t height() const override { return inner_->height(); }
    [[nodiscard]] bool make_current() override {
        ++state_.asked;
        return !state_.is_lost && inner_->make_current();
    }
    void release_current() override {
        ++state_.released;
        inner_->release_current();
    }
    [[nodiscard]] void* proc_address(const char* name) override { return inner_->proc_address(name); }
    [[nodiscard]] base::SurfaceState present() override {
        return state_.is_lost ? base::SurfaceState::context_lost : inner_->present();
    }
    [[nodiscard]] const char* backend_name() const override { return inner_->backend_name(); }

    static SurfaceSource source(State& state) {
        const auto make = [](const void* self,
                             const SurfaceSettings& settings) -> base::Result<std::unique_ptr<base::Surface>, base::Error> {
            State& of = *const_cast<State*>(static_cast<const State*>(self));  // as the test made it
            of.settings = settings;
            auto made = make_surface("egl", settings);
            if (!made.ok()) return base::fail(made.error());
            return std::unique_ptr<base::Surface>(new LosableSurface(std::move(made.value()), of));
        };
        return {"unused", make, &state};
    }

private:
    std::unique_ptr<base::Surface> inner_;
    State& state_;
};

TEST(DisplayHost, StartsWithTerrainOfAFileAndDraws) {
    DisplayHostSettings settings = shipped();
    settings.terrain.path = terrain_path().c_str();
    DisplayHost host;
    ASSERT_EQ(message(host.start(settings)), "");
    EXPECT_EQ(host.surface().width(), 64u);
    EXPECT_NE(host.display().planner().terrain_database(), nullptr);
    const display::FrameRecord& record = drawn(host);
    EXPECT_FALSE(has_flag(record, "terrain.missing") || has_flag(record, "terrain.failed"));
    EXPECT_EQ(host.terrain_fault().message.view(), "");
}

TEST(DisplayHost, WithoutTerrainNobodyAskedForAny) {
    DisplayHost host;
    ASSERT_FALSE(host.start(shipped()));
    EXPECT_EQ(host.display().planner().terrain_database(), nullptr);
    EXPECT_TRUE(has_flag(drawn(host), "terrain.missing"));
}

TEST(DisplayHost, TakesTerrainThatSomebodyHoldsAndMemoryThatSomebodyReserved) {
    const std::string file = test_support::source_file("target/self_test_data/terrain.tdb");
    const std::vector<std::uint8_t> image(file.begin(), file.end());
    test_support::MemoryBytes bytes(image);
    DisplayHostSettings settings = shipped();
    settings.terrain.bytes = &bytes;
    const auto reserved = reserve_memory(display::DisplayMemory::bytes_needed(settings.display.device.budget), Residency::lazy);
    settings.memory = reserved.value().arena();
    DisplayHost host;
    ASSERT_FALSE(host.start(settings));
    EXPECT_NE(host.display().planner().terrain_database(), nullptr);
    settings.memory = {};
    DisplayHost other;
    host.release_current();
    EXPECT_FALSE(other.start(settings)) << "control: its own";
    other.release_current();
    EXPECT_TRUE(host.make_current());
}

TEST(DisplayHost, MemoryThatIsTooSmallIsRefused) {
    DisplayHostSettings settings = shipped();
    const auto reserved = reserve_memory(4096, Residency::lazy);
    settings.memory = reserved.value().arena();
    DisplayHost host;
    EXPECT_EQ(host.start(settings).part, HostPart::display);
}

TEST(DisplayHost, TerrainThatCannotBeUsedIsRefusedWithItsPath) {
    const BadTerrain bad;
    for (const std::string& path : {bad.absent, bad.folder.path(), bad.text, bad.cut}) {
        DisplayHostSettings settings = shipped();
        settings.terrain.path = path.c_str();
        DisplayHost host;
        const HostFault fault = host.start(settings);
        EXPECT_EQ(fault.part, HostPart::terrain) << path;
        EXPECT_THAT(message(fault), StartsWith(path + ": "));
    }
    DisplayHost next;
    EXPECT_FALSE(next.start(shipped())) << "nothing of them is left on this thread";
}

TEST(DisplayHost, DamagedBytesWithoutAPathKeepTheSentenceOfTheDisplay) {
    const std::vector<std::uint8_t> none(600, '.');
    test_support::MemoryBytes bytes(none);
    DisplayHostSettings settings = shipped();
    settings.terrain.bytes = &bytes;
    DisplayHost host;
    const HostFault fault = host.start(settings);
    EXPECT_EQ(fault.part, HostPart::terrain);
    EXPECT_THAT(message(fault), StartsWith("the terrain database is not a terrain database"));
}

TEST(DisplayHost, RunsWithoutTerrainThatCannotBeUsedWhereItIsToldTo) {
    const BadTerrain bad;
    for (const std::string& path : {bad.absent, bad.folder.path(), bad.text, bad.cut}) {
        DisplayHostSettings settings = shipped();
        settings.terrain.path = path.c_str();
        settings.terrain_fault = TerrainFaultPolicy::run_without;
        settings.arrival = terrain::ArrivalMode::live;
        DisplayHost host;
        ASSERT_EQ(message(host.start(settings)), "");
        EXPECT_THAT(std::string(host.terrain_fault().message.view()), StartsWith(path + ": "));
        const display::FrameRecord& record = drawn(host);
        EXPECT_TRUE(has_flag(record, "terrain.failed")) << path;
        EXPECT_FALSE(has_flag(record, "terrain.missing")) << "which would say that nobody wanted any";
        EXPECT_EQ(host.display().gl().denied().total, 0u);
    }
}

TEST(DisplayHost, ASceneThatCannotBeUsedIsRefusedWithItsPath) {
    const test_support::TemporaryFolder folder;
    for (const std::string& path : {folder.file("absent.sdb"), folder.write("text.sdb", std::string(600, '.'))}) {
        DisplayHostSettings settings = shipped();
        settings.scene.path = path.c_str();
        settings.terrain_fault = TerrainFaultPolicy::run_without;  // of the terrain alone
        DisplayHost host;
        const HostFault fault = host.start(settings);
        EXPECT_EQ(fault.part, HostPart::scene) << path;
        EXPECT_THAT(message(fault), StartsWith(path + ": "));
    }
}

TEST(DisplayHost, ABudgetThatIsTooSmallIsTheDisplaysFault) {
    DisplayHostSettings settings = shipped();
    settings.terrain.path = terrain_path().c_str();
    settings.terrain_fault = TerrainFaultPolicy::run_without;  // the terrain is sound: running without it is no way out
    settings.display.device.budget.find(effects::kLodScratch)->bytes = 8;
    DisplayHost host;
    const HostFault fault = host.start(settings);
    EXPECT_EQ(fault.part, HostPart::display);
    EXPECT_THAT(message(fault), StartsWith("the budget line 'lod_scratch' has 8 of 8 bytes left"));
}

TEST(DisplayHost, MoreMemoryThanTheMachineHasIsRefused) {
    DisplayHostSettings settings = shipped();
    settings.display.device.budget.find(effects::kLodScratch)->bytes = std::uint64_t{1} << 60;
    DisplayHost host;
    const HostFault fault = host.start(settings);
    EXPECT_EQ(fault.part, HostPart::memory);
    EXPECT_THAT(message(fault), HasSubstr("the machine gives no block of "));
}

TEST(DisplayHost, ASurfaceThatCannotBeMadeIsRefused) {
    DisplayHostSettings settings = shipped();
    settings.surface.backend = "kms";
    DisplayHost host;
    const HostFault fault = host.start(settings);
    EXPECT_EQ(fault.part, HostPart::surface);
    EXPECT_THAT(message(fault), StartsWith("the surface 'kms' is not known"));
}

TEST(DisplayHost, TheSurfaceIsOfTheLaneAndSizeOfTheDisplay) {
    for (const char* const device : {"es2-small", "es3-mid"}) {
        LosableSurface::State state;
        DisplayHostSettings settings = shipped();
        settings.display.device = test_support::shipped_device(device);
        settings.surface = LosableSurface::source(state);
        DisplayHost host;
        ASSERT_EQ(message(host.start(settings)), "");
        EXPECT_EQ(state.settings.width_px, 64u);
        EXPECT_EQ(state.settings.height_px, 48u);
        EXPECT_EQ(state.settings.lane == ContextLane::es2, std::string_view(device) == "es2-small");
    }
}

TEST(DisplayHost, ASurfaceThatIsLostBeforeTheStartIsRefused) {
    LosableSurface::State state;
    state.is_lost = true;
    DisplayHostSettings settings = shipped();
    settings.surface = LosableSurface::source(state);
    DisplayHost host;
    const HostFault fault = host.start(settings);
    EXPECT_EQ(fault.part, HostPart::context);
    EXPECT_THAT(message(fault), StartsWith("the surface cannot be made current"));
}

TEST(DisplayHost, ASurfaceThatIsLostLaterCannotBeMadeCurrentAndTheHostGoesWithoutIt) {
    LosableSurface::State state;
    {
        DisplayHostSettings settings = shipped();
        settings.surface = LosableSurface::source(state);
        DisplayHost host;
        ASSERT_FALSE(host.start(settings));
        EXPECT_TRUE(host.make_current()) << "control";
        state.is_lost = true;
        EXPECT_FALSE(host.make_current());
        EXPECT_EQ(host.surface().present(), base::SurfaceState::context_lost);
    }
    EXPECT_EQ(state.asked, 4) << "start, twice by the test, and before the display is stopped";
    EXPECT_EQ(state.released, 1);
    DisplayHost next;
    EXPECT_FALSE(next.start(shipped()));
}

TEST(DisplayHost, HostsOfOneThreadDrawInTurn) {
    DisplayHostSettings settings = shipped();
    settings.terrain.path = terrain_path().c_str();
    DisplayHost first;
    ASSERT_FALSE(first.start(settings));
    first.release_current();
    DisplayHost second;
    ASSERT_FALSE(second.start(shipped()));
    EXPECT_TRUE(has_flag(drawn(second), "terrain.missing"));
    second.release_current();
    ASSERT_TRUE(first.make_current());
    EXPECT_FALSE(has_flag(drawn(first), "terrain.missing"));
    first.release_current();
}

TEST(DisplayHost, ADeviceWithoutACompilerNeedsItsFolderOfPrograms) {
    const test_support::TemporaryFolder folder;
    DisplayHostSettings settings = shipped();
    const std::string absent = folder.file("absent");
    settings.programs = absent;
    {
        DisplayHost host;
        EXPECT_FALSE(host.start(settings)) << "control: a device with a compiler does not look";
    }
    settings.display.device = test_support::shipped_device("sc2");
    {
        DisplayHost host;
        const HostFault fault = host.start(settings);
        EXPECT_EQ(fault.part, HostPart::programs);
        EXPECT_THAT(message(fault), HasSubstr(absent));
    }
    settings.programs = folder.path();
    DisplayHost host;
    EXPECT_EQ(host.start(settings).part, HostPart::display) << "the folder is there, and empty";
}

TEST(DisplayHost, HoldsADeadlineByCostsOfItsOwnAlone) {
    DisplayHost host;
    ASSERT_FALSE(host.start(shipped()));
    EXPECT_FALSE(host.hold_deadline(10, {}));
    EXPECT_FALSE(host.display().memory().budget.is_held()) << "no costs are known";
    std::string costs = test_support::even_costs(display::calibration_subject(host.display()));
    EXPECT_FALSE(host.hold_deadline(10, {"own.toml", costs}));
    EXPECT_TRUE(host.display().memory().budget.is_held());
    const std::string name = "es2-small";
    costs.replace(costs.find(name), name.size(), "es3-mid");
    EXPECT_THAT(std::string(host.hold_deadline(10, {"other.toml", costs}).message.view()), StartsWith("other.toml"));
    EXPECT_THAT(std::string(host.hold_deadline(10, {"empty.toml", ""}).message.view()), StartsWith("empty.toml"));
}

}  // namespace
}  // namespace tedavis::platform::test_display_host
