#include "host_sim/commands/bus_encode.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_bus_encode {
namespace {

using ::testing::HasSubstr;

test_support::CommandRun encode(const std::vector<std::string>& values, bool json = false) {
    BusEncodeOptions options;
    options.values = values;
    options.at_s = 1.5;
    return test_support::run_command([&](Console& console) { return run_bus_encode(options, console); }, json);
}

/// The payloads are IEEE 754 numbers, big-endian: 5, -12.5 and 47.2602, as any converter of floats gives them.
TEST(BusEncode, WritesCandumpLines) {
    const auto run = encode({"pitch_deg=5", "roll_deg=-12.5", "latitude_deg=47.2602"});
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.results,
              "(0000000001.500000) can0 137#0902000040A00000\n"
              "(0000000001.500125) can0 138#09020000C1480000\n"
              "(0000000001.500250) can0 40C#091E00004047A14E\n"
              "(0000000001.500375) can0 40C#091F00013BCD35A8\n");
}

TEST(BusEncode, WritesPhases) {
    EXPECT_THAT(encode({"phase=approach.final"}).results, HasSubstr("726#091000002B0001FF")) << "2B hex: 43; FMS";
    EXPECT_THAT(encode({"phase=approach.final", "phase_origin=pilot"}).results, HasSubstr("726#091000002B0002FF"));
    EXPECT_EQ(encode({"phase=cruise"}, true).json()["lines"].size(), 1u);
}

TEST(BusEncode, AllThatIsWrongIsToldAtOnceAndNothingIsPrinted) {
    const auto run =
        encode({"airsped_kt=90", "pitch=5", "pitch_deg=x", "roll_deg", "phase=aproach", "phase_origin=me", "roll_deg=1"});
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.results, "");
    EXPECT_THAT(run.notes, HasSubstr("say indicated_airspeed"));
    EXPECT_THAT(run.notes, HasSubstr("pitch_deg or pitch_rad"));
    EXPECT_THAT(run.notes, HasSubstr("'x' is no decimal number"));
    EXPECT_THAT(run.notes, HasSubstr("roll_deg: no signal=value"));
    EXPECT_THAT(run.notes, HasSubstr("no such phase; say approach"));
    EXPECT_THAT(run.notes, HasSubstr("phase_origin=me: no sender"));
}

/// Nothing that a receiver refuses is printed.
TEST(BusEncode, ImpossibleValuesAreFaults) {
    for (const char* const word : {"pitch_deg=1e300", "pitch_deg=500", "latitude_deg=120", "true_heading_deg=400",
                                   "ground_speed_mps=-4", "baro_setting_hpa=0x10", "phase_origin=fms"}) {
        const auto run = encode({word});
        EXPECT_EQ(run.code, 2) << word;
        EXPECT_EQ(run.results, "") << word;
        EXPECT_THAT(run.notes, HasSubstr(word));
    }
    EXPECT_EQ(encode({"phase=cruise", "phase_origin=fms", "phase_origin=pilot"}).code, 2);
}

TEST(BusEncode, AnInterfaceHasAName) {
    for (const char* const name : {"an_interface_name_too_long", "a b", "", "a/b"}) {
        BusEncodeOptions options;
        options.values = {"pitch_deg=1"};
        options.interface_name = name;
        test_support::expect_user_error(
            [&] { static_cast<void>(test_support::run_command([&](Console& c) { return run_bus_encode(options, c); })); },
            "--interface");
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_bus_encode
