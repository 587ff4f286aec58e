#include "host_sim/commands/record_input.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_record_input {
namespace {

class RecordInput : public ::testing::Test {
protected:
    FlightTest input(const std::string& named) {
        options_.input = named;
        return recorded_input(options_);
    }
    test_support::TemporaryFolder place_;
    RecordOptions options_;
};

TEST_F(RecordInput, ALogIsALogAndANameAScenario) {
    const std::string log = place_.write("a.log", "");
    EXPECT_EQ(input(log).log, log);
    EXPECT_EQ(input(log).picture.device, "es2-small");
    EXPECT_EQ(input("default").scenario, "default");
    EXPECT_EQ(input("default").log, "");
    options_.switches = log;
    test_support::expect_user_error([&] { static_cast<void>(input("default")); }, "has its own");
}

TEST_F(RecordInput, AGeneratedFlightHasSwitchesAndAScene) {
    for (const char* name : {"flight.log", "flight.switches", "scene.sdb"}) place_.write(name, "");
    const FlightTest test = input(place_.path());
    EXPECT_EQ(test.log, place_.file("flight.log"));
    EXPECT_EQ(test.switch_log, place_.file("flight.switches"));
    EXPECT_EQ(test.picture.scene, place_.file("scene.sdb"));
}

TEST_F(RecordInput, ARunNamesWhatItWasMadeOf) {
    std::filesystem::create_directory(place_.file("run"));
    place_.write("my.log", "");
    place_.write("run/summary.json",
                 R"({"log": "my.log", "design": "cruise", "device": "es3-mid", "aircraft": "", "switches": ""})");
    FlightTest test = input(place_.file("run"));
    EXPECT_TRUE(std::filesystem::equivalent(test.log, place_.file("my.log")));
    EXPECT_EQ(test.picture.design, "cruise");
    EXPECT_EQ(test.picture.device, "es3-mid");
    options_.design = "takeoff";
    EXPECT_EQ(input(place_.file("run")).picture.design, "takeoff") << "an option comes first";
    std::filesystem::remove(place_.file("my.log"));
    test_support::expect_user_error([&] { static_cast<void>(input(place_.file("run"))); }, "its log my.log is not there");
}

/// A replay of a part is recorded as that part, whichever way its frames were flown.
TEST_F(RecordInput, ARunHasTheSpanOfItsFrames) {
    place_.write("frames.jsonl",
                 "{\"frame\":0,\"time_s\":180.0,\"hash\":\"a\"}\n{\"frame\":1,\"time_s\":165.5,\"hash\":\"b\"}\n"
                 "{\"frame\":2,\"time_s\":150.0,\"hash\":\"c\"}\n");
    options_.input = place_.path();
    EXPECT_EQ(recorded_span(options_).from_s, 150.0);
    EXPECT_EQ(recorded_span(options_).to_s, 180.0);
    options_.to_s = 160;
    EXPECT_EQ(recorded_span(options_).from_s, std::nullopt) << "an option takes the place of both";
    EXPECT_EQ(recorded_span(options_).to_s, 160.0);
    options_ = RecordOptions();
    options_.input = "default";
    EXPECT_EQ(recorded_span(options_).to_s, std::nullopt);
}

TEST_F(RecordInput, AnotherFolderIsRefused) {
    test_support::expect_user_error([&] { static_cast<void>(input(place_.path())); }, "is neither the folder of a replay");
}

}  // namespace
}  // namespace tedavis::host_sim::test_record_input
