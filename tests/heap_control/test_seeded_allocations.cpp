// The control of the zero-heap test: one allocation in the code of any library folder, made while the flight runs, is seen
// by the trap, and seen to come from there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/heap_trap/heap_trap.hpp"
#include "platform/files/file_byte_source.hpp"
#include "tests/heap_control/seeded_allocation.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/flight_loop.hpp"
#if defined(TEDAVIS_SEED_TARGET)
#include "target/live_flight.hpp"
#endif

namespace tedavis::test_seeded_allocations {
namespace {

using host_sim::HeapTrap;
using ::testing::HasSubstr;

/// A flight in the air, and what of the board's loop can run beside it without a board.
class Flying : public testing::Test {
protected:
    void SetUp() override {
        log_ = std::move(platform::open_file(folder_.write("flight.log", flight_.log).c_str()).value());
        const std::string database(built_.image.begin(), built_.image.end());
        terrain_ = std::move(platform::open_file(folder_.write("t.tdb", database).c_str()).value());
        display_ = std::make_unique<test_support::HeadlessDisplay>("egl", "es2-small", 160, 120, &terrain_);
        loop_ = std::make_unique<test_support::FlightLoop>(flight_, log_, *display_);
        fly_on();
    }
    /// Ten seconds: frames, phases, a new design, and more of the log from the disk.
    void fly_on() {
        flown_s_ += 10;
        static_cast<void>(loop_->fly_to(flown_s_, base::Duration::seconds(2)));
        EXPECT_TRUE(loop_->reload_design());
    }
    /// Runs `work` under the trap with one allocation seeded into `library`.
    template <class Work>
    static std::uint64_t trapped(const char* library, Work work) {
        HeapTrap trap;
        heap_control::arm(library);
        work();
        heap_control::disarm();
        trap.close();
        if (trap.counts().ours > 0) {
            EXPECT_NE(heap_control::seeded_function(), "") << "an allocation that nobody seeded:\n" << trap.first_of_ours();
            EXPECT_THAT(trap.first_of_ours(), HasSubstr(heap_control::seeded_function() + "+")) << "the trap names the function";
        }
        return trap.counts().ours;
    }

    test_support::RecordedFlight flight_ = test_support::default_flight();
    test_support::TemporaryFolder folder_;
    test_support::DefaultTerrain built_;
    platform::FileByteSource log_, terrain_;
    std::unique_ptr<test_support::HeadlessDisplay> display_;
    std::unique_ptr<test_support::FlightLoop> loop_;
    double flown_s_ = 0;
};

TEST_F(Flying, AnAllocationInEveryLibraryThatFliesIsCaught) {
    for (const char* library : {"base", "earth", "flight", "terrain", "design", "gl", "draw", "display", "bus", "platform"}) {
        EXPECT_EQ(trapped(library, [this] { fly_on(); }), 1u) << library;
        EXPECT_THAT(heap_control::seeded_function(), HasSubstr(library));
    }
}

TEST_F(Flying, WithoutASeedTheSameCodeAllocatesNothing) {
    EXPECT_EQ(trapped("no_such_library", [this] { fly_on(); }), 0u);
    EXPECT_EQ(heap_control::seeded_function(), "");
}

TEST(SeededAllocation, InEffectsIsCaught) {
    // Nothing of this folder runs in flight yet: its reader of device files does, once, under the trap.
    const std::string path = "configs/devices/es2-small.toml";
    const std::string text = test_support::source_file(path);
    HeapTrap trap;
    heap_control::arm("effects");
    const bool ok = effects::read_device_settings(text, path).ok();
    heap_control::disarm();
    trap.close();
    EXPECT_TRUE(ok);
    EXPECT_GT(trap.counts().ours, 1u) << "the seeded one and those of the parser";
    EXPECT_THAT(heap_control::seeded_function(), HasSubstr("effects"));
    EXPECT_THAT(trap.first_of_ours(), HasSubstr(heap_control::seeded_function() + "+"));
}

#if defined(TEDAVIS_SEED_TARGET)
struct NoBus final : bus::CanSocketPort {
    bus::OpenedSocket open(const bus::SocketCanSettings&) override { return {-1, {"no bus here"}}; }
};
base::Time still_time() { return base::Time{} + base::Duration::seconds(100); }

TEST_F(Flying, AnAllocationInTheBoardProgramIsCaught) {
    const auto settings = std::make_unique<target::BoardSettings>();
    NoBus port;
    const target::EventLog silent([](void*, std::string_view) {}, nullptr);
    const auto live =
        std::make_unique<target::LiveFlight>(*settings, port, nullptr, bus::LiveClocks{&still_time, &still_time}, silent);
    live->start(still_time());
    const auto run = [&](double seconds) {
        static_cast<void>(live->at(still_time() + base::Duration::from_seconds(seconds), display_->display().planner()));
    };
    EXPECT_EQ(trapped("no_such_library", [&] { run(1); }), 0u);
    EXPECT_EQ(trapped("target", [&] { run(2); }), 1u);
}
#endif

}  // namespace
}  // namespace tedavis::test_seeded_allocations
