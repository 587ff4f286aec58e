#include "host_sim/flight_test/recorded_script.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "host_sim/flight_test/read_flight_test.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_recorded_script {
namespace {

RecordedScript sample(std::size_t signals) {
    RecordedScript script;
    script.title = "a \"quoted\" flight\n";
    script.notes = {
        "A note with a\nbreak, and many words that do not fit into one line of a script that somebody reads with care."};
    script.settings = {{"design", ""}, {"device", "es3-mid"}};
    RecordedExpectation one;
    one.kind = WindowKind::within;
    one.from_s = 1.5;
    one.to_s = 2.75;
    one.facts = {{FactKind::phase, "", "cruise"},
                 {FactKind::flag, "terrain.missing", kFlagThere},
                 {FactKind::flag, "phase.disagreement", kFlagGone},
                 {FactKind::effect, "haze", "skipped"}};
    const char* const names[] = {"pitch", "roll", "true_heading", "latitude", "longitude", "ground_speed", "true_track"};
    for (std::size_t n = 0; n < signals; ++n) one.facts.push_back({FactKind::signal, names[n], "valid"});
    one.words = "1.50 s: it happens.";
    script.expectations = {one};
    return script;
}

/// The reader of scripts is the oracle; few signals stand on one line, many on several.
TEST(RecordedScript, IsReadAsItIsMeant) {
    for (const std::size_t signals : {1u, 7u}) {
        const test_support::TemporaryFolder place;
        const std::string text = recorded_script_text(sample(signals));
        ScriptFaults faults;
        const FlightTest test = read_flight_test(place.write("a.toml", text), {}, faults);
        EXPECT_THAT(faults.sentences(), ::testing::IsEmpty()) << text;
        EXPECT_EQ(test.title, "a \"quoted\" flight\n");
        EXPECT_EQ(test.picture.design, "default");
        ASSERT_EQ(test.expectations.size(), 1u);
        const Expectation& read = test.expectations[0];
        EXPECT_EQ(read.kind, WindowKind::within);
        EXPECT_NEAR(read.from_s, 1.5, 1e-9);
        EXPECT_NEAR(read.to_s, 2.75, 1e-9);
        EXPECT_EQ(read.conditions.size(), 4 + signals);
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 130u);
    }
}

TEST(RecordedScript, NamesFilesFromItsFolder) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directories(place.file("a/b"));
    EXPECT_EQ(path_in_script(place.file("a/b/x.log"), place.file("a")), "./b/x.log");
    EXPECT_EQ(path_in_script(place.file("a/x"), place.file("a")), "./x");
    EXPECT_EQ(path_in_script(place.file("x.log"), place.file("a/b")), "../../x.log");
    EXPECT_EQ(path_in_script("/usr/x.log", place.file("a")), "/usr/x.log");
    std::filesystem::create_directory_symlink(place.file("a/b"), place.file("link"));
    EXPECT_EQ(path_in_script(place.file("x.log"), place.file("link")),
              std::filesystem::weakly_canonical(place.file("x.log")).string())
        << "../ leads from the link elsewhere than it reads";
}

}  // namespace
}  // namespace tedavis::host_sim::test_recorded_script
