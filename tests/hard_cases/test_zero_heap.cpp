// After the start nothing of ours allocates, over the whole default flight: bus, switches, phases, terrain and picture.
// tests/heap_control shows that an allocation in any library folder would be seen.
#include <gtest/gtest.h>

#include "host_sim/heap_trap/heap_trap.hpp"
#include "platform/files/file_byte_source.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/flight_loop.hpp"
#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::test_zero_heap {
namespace {

using host_sim::HeapTrap;

constexpr double kWholeFlight_s = 416;

struct Setup {
    const char* backend;
    const char* device;
};

void fly_whole_flight(const Setup& setup) {
    const test_support::RecordedFlight flight = test_support::default_flight();
    const test_support::TemporaryFolder folder;
    const test_support::DefaultTerrain built;
    const std::string database(built.image.begin(), built.image.end());
    platform::FileByteSource log = std::move(platform::open_file(folder.write("flight.log", flight.log).c_str()).value());
    platform::FileByteSource terrain = std::move(platform::open_file(folder.write("t.tdb", database).c_str()).value());
    test_support::HeadlessDisplay display(setup.backend, setup.device, 320, 240, &terrain);
    const auto loop = std::make_unique<test_support::FlightLoop>(flight, log, display);

    HeapTrap trap;
    for (double to = 0; to <= kWholeFlight_s; to += 20) {
        static_cast<void>(loop->fly_to(to, base::Duration::seconds(1)));
        EXPECT_TRUE(loop->reload_design());
    }
    static_cast<void>(loop->fly_to(kWholeFlight_s, base::Duration::seconds(1)));
    trap.close();

    EXPECT_EQ(trap.counts().ours, 0u) << trap.first_of_ours();
    EXPECT_GT(trap.counts().driver, 0u) << "the control: this driver does allocate";
    const test_support::FlightLoop::Seen& seen = loop->seen();
    EXPECT_EQ(seen.frames, 417u);
    EXPECT_EQ(seen.good, seen.frames);
    EXPECT_GT(seen.frames_with_terrain, 200u);
    EXPECT_TRUE(seen.by_switch && seen.by_can && seen.by_motion) << "every source of the phase has spoken";
    EXPECT_GT(loop->position().offset, flight.log.size() * 99 / 100);
}

TEST(ZeroHeap, OverTheWholeDefaultFlightOnEgl) { fly_whole_flight({"egl", "es3-mid"}); }

TEST(ZeroHeap, OverTheWholeDefaultFlightOnTheLastBackendAndTheSmallestDevice) {
    fly_whole_flight({test_support::headless_backends().back().c_str(), "es2-small"});
}

}  // namespace
}  // namespace tedavis::test_zero_heap
