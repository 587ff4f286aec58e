// Ctrl-C in mid-work: what is left is whole or nothing at all, and the exit code says that the user stopped it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bus/candump/candump_log_source.hpp"
#include "host_sim/evaluation/evaluation_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/program_samples.hpp"
#include "tests/support/programs/running_program.hpp"

namespace tedavis::tests::test_interrupt_signal {
namespace {

using test_support::ProgramResult;
using test_support::ProgramSamples;
using test_support::ProgramSetting;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kInterruptedCode = 130;

class InterruptSignal : public ::testing::Test {
protected:
    /// Sends the signal once a file has grown, so that the program is at work for certain.
    ProgramResult stop(std::vector<std::string> words, const std::string& growing, std::uintmax_t bytes, int which = SIGINT) {
        words.insert(words.begin(), ProgramSamples::program());
        ProgramSetting setting;
        setting.signal = which;
        setting.signal_when = [=] {
            std::error_code not_there;
            const auto size = std::filesystem::file_size(growing, not_there);
            return !not_there && size >= bytes;
        };
        return test_support::run_program(words, setting);
    }

    test_support::TemporaryFolder place_;
};

/// Hours of flight, so that no machine is done before the signal comes.
std::string long_flight() {
    std::string text = "time,latitude_deg,longitude_deg,height_msl_m\n";
    for (int i = 0; i < 86'400; ++i) {
        char line[100];
        std::snprintf(line, sizeof line, "%d,%.6f,%.6f,%.1f\n", 1586684820 + i, 46.5 + 0.1 * std::sin(i * 1e-3),
                      9.75 + 0.1 * std::cos(i * 1e-3), 3000.0);
        text += line;
    }
    return text;
}

TEST_F(InterruptSignal, ConvertKeepsAValidLogThatEndsEarly) {
    const std::string flight = place_.write("f.csv", long_flight());
    const ProgramResult result =
        stop({"convert", flight, "-o", place_.file("f.log"), "--json"}, place_.file("f.log.part"), 100'000);
    EXPECT_EQ(result.code, kInterruptedCode) << result.err;
    EXPECT_THAT(result.err, HasSubstr("interrupted; the log is valid and ends early"));
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["interrupted"], true);
    EXPECT_EQ(json, nlohmann::json::parse(place_.read("f.log.json")));
    const std::string log = place_.read("f.log");
    EXPECT_EQ(log.back(), '\n');
    bus::CandumpLogSource source({log.data(), log.size()});
    std::vector<bus::CanFrame> frames(4096);
    while (source.read(base::Time{INT64_MAX}, {frames.data(), frames.size()}) > 0) {
    }
    EXPECT_EQ(source.statistics().frames, json["frames"]);
    EXPECT_EQ(source.statistics().malformed, 0u);
    EXPECT_EQ(place_.entries(), 3u) << "the flight, the log and its companion";
}

TEST_F(InterruptSignal, TerrainBuildGoesOnWhereItWasStopped) {
    const std::string raster = place_.file("r.tif"), work = place_.file("t.tdb.part/journal");
    ASSERT_EQ(test_support::run_program({ProgramSamples::program(), "terrain", "fractal", "--size", "1025", "-o", raster}).code,
              0);
    for (const int which : {SIGINT, SIGTERM}) {
        std::filesystem::remove_all(place_.file("t.tdb.part"));
        const ProgramResult result = stop({"terrain", "build", raster, "-o", place_.file("t.tdb")}, work, 0, which);
        EXPECT_EQ(result.code, kInterruptedCode) << result.err;
        EXPECT_EQ(result.err, "tedavis: interrupted; the same command goes on from here\n");
        EXPECT_EQ(place_.entries(), 2u) << "the raster and the work folder";
    }
    EXPECT_EQ(test_support::run_program({ProgramSamples::program(), "terrain", "build", raster, "-o", place_.file("t.tdb")}).code,
              0);
    EXPECT_EQ(place_.entries(), 2u) << "the raster and the database";
}

TEST_F(InterruptSignal, TerrainBuildKeepsWhatWasThereBefore) {
    const std::string older = "TEDAVTDB, an older one", raster = place_.file("r.tif"), database = place_.write("t.tdb", older);
    ASSERT_EQ(test_support::run_program({ProgramSamples::program(), "terrain", "fractal", "--size", "1025", "-o", raster}).code,
              0);
    EXPECT_EQ(stop({"terrain", "build", raster, "-o", database}, place_.file("t.tdb.part/journal"), 0).code, kInterruptedCode);
    EXPECT_EQ(place_.read("t.tdb"), older);
}

TEST_F(InterruptSignal, ScenarioBuildLeavesNotEvenItsFolder) {
    std::string text = ProgramSamples::read("scenario.toml");
    for (int i = 0; i < 6; ++i)
        text += "\n[[leg]]\nkind = \"stand\"\nphase = \"ground\"\nstated_by = \"can\"\nduration_s = 600\n";
    const std::string scenario = place_.write("s.toml", text);
    const ProgramResult result =
        stop({"scenario", "build", scenario, "-o", place_.file("a/b")}, place_.file("a/b/flight.log.part"), 10'000);
    EXPECT_EQ(result.code, kInterruptedCode) << result.err;
    EXPECT_EQ(result.err, "tedavis: interrupted; nothing was written\n");
    EXPECT_EQ(place_.entries(), 1u) << "the scenario only";
}

TEST_F(InterruptSignal, EvaluateKeepsThePicturesSoFar) {
    std::vector<std::string> words{"evaluate", "--json", "-o", place_.file("out")};
    for (int n = 0; n < 2000; ++n) words.push_back(ProgramSamples::path("picture.png"));
    const ProgramResult result = stop(words, place_.file("out/picture-3.sheet.png"), 0);
    EXPECT_EQ(result.code, kInterruptedCode) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["interrupted"], true);
    ASSERT_GE(json["pictures"].size(), 1u);
    EXPECT_LT(json["pictures"].size(), 2000u);
    EXPECT_EQ(json, nlohmann::json::parse(place_.read("out/evaluation.json")));
    const auto files = std::distance(std::filesystem::directory_iterator(place_.file("out")), {});
    const std::size_t views = host_sim::all_view_files("picture").size();
    EXPECT_EQ(static_cast<std::size_t>(files), views * json["pictures"].size() + 1) << "the views of those pictures alone";
}

TEST_F(InterruptSignal, AKilledProgramLeavesNoHalfFileUnderTheNameOfAWholeOne) {
    const std::string flight = place_.write("f.csv", long_flight());
    ProgramSetting setting;
    setting.signal = SIGKILL;  // which no program can catch
    setting.signal_when = [this] {
        std::error_code not_there;
        const auto size = std::filesystem::file_size(place_.file("f.log.part"), not_there);
        return !not_there && size > 0;
    };
    const ProgramResult result =
        test_support::run_program({ProgramSamples::program(), "convert", flight, "-o", place_.file("f.log")}, setting);
    EXPECT_EQ(result.signal, SIGKILL);
    EXPECT_FALSE(std::filesystem::exists(place_.file("f.log")));
    EXPECT_FALSE(std::filesystem::exists(place_.file("f.log.json")));
}

TEST_F(InterruptSignal, ProgressIsDrawnOnATerminalOnly) {
    const std::string program = ProgramSamples::program(), raster = ProgramSamples::path("raster.tif"),
                      flight = ProgramSamples::path("flight.csv");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{program, "terrain", "build", raster, "-o", place_.file("t.tdb")},
          {program, "terrain", "check", ProgramSamples::path("terrain.tdb"), raster},
          {program, "convert", flight, "-o", place_.file("f.log")},
          {program, "scenario", "build", "default", "-o", place_.file("s")}}) {
        const ProgramResult plain = test_support::run_program(words);
        EXPECT_EQ(plain.code, 0);
        EXPECT_THAT(plain.err, Not(HasSubstr("%")));
        EXPECT_THAT(plain.err, Not(HasSubstr("\r")));
        ProgramSetting setting;
        setting.terminal = true;
        const ProgramResult live = test_support::run_program(words, setting);
        EXPECT_EQ(live.code, 0);
        EXPECT_THAT(live.err, HasSubstr(" %")) << words[1] << " " << words[2];
        EXPECT_EQ(live.out, plain.out) << "the result is the same";
    }
}

}  // namespace
}  // namespace tedavis::tests::test_interrupt_signal
