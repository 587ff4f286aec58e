#include "host_sim/commands/bus_encode.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/canaerospace/message_decoder.hpp"
#include "bus/candump/candump_line.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
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

/// The fourth byte; the halves of a position and repeated values count on, and 0 follows 255.
TEST(BusEncode, TheMessageCodeCanBeStated) {
    BusEncodeOptions options;
    options.values = {"pitch_deg=5", "phase=cruise", "phase=cruise", "latitude_deg=47.2602"};
    options.code = 255;
    const auto run = test_support::run_command([&](Console& console) { return run_bus_encode(options, console); });
    for (const char* const frame : {"137#090200FF", "726#091000FF", "726#09100000", "40C#091E00FF", "40C#091F0000"})
        EXPECT_THAT(run.results, HasSubstr(frame));
}

/// As the guide says: of three messages a second apart the receiver takes the first alone, unless their codes count.
TEST(BusEncode, AReceiverDropsMessagesWithTheCodeBefore) {
    const std::string path = resolve_config("canaerospace", "buses");
    const auto settings = bus::load_bus_settings(read_file(path), path);
    ASSERT_TRUE(settings.ok());
    bus::MessageDecoder decoder(settings.value());
    const auto taken = [&](double at_s, unsigned code) {
        BusEncodeOptions options;
        options.values = {"phase=cruise"};
        options.at_s = at_s;
        options.code = code;
        const auto run = test_support::run_command([&](Console& console) { return run_bus_encode(options, console); });
        bus::CanFrame frame;
        const std::string line = run.results.substr(0, run.results.find('\n'));
        EXPECT_EQ(bus::parse_candump_line(line, frame).kind, bus::LineKind::frame);
        return decoder.decode(frame).kind == bus::MessageKind::phase;
    };
    EXPECT_TRUE(taken(10, 0));
    EXPECT_FALSE(taken(11, 0));
    EXPECT_FALSE(taken(12, 0));
    for (unsigned n = 0; n < 4; ++n) EXPECT_TRUE(taken(20 + n, n)) << n;
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
