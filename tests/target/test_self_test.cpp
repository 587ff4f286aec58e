#include "target/self_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/target/captured_output.hpp"

namespace tedavis::target::test_self_test {
namespace {

using ::testing::HasSubstr;

/// The embedded inputs in memory of the test's own, to be damaged.
struct Damaged {
    std::string log{embedded_inputs().log.begin(), embedded_inputs().log.end()};
    std::vector<unsigned char> terrain{embedded_inputs().terrain.begin(), embedded_inputs().terrain.end()};
    std::string bus{embedded_inputs().bus}, device{embedded_inputs().device}, design{embedded_inputs().design};
    std::string palette{embedded_inputs().palettes[0].text};

    [[nodiscard]] SelfTestReport report() const {
        SelfTestReport result;
        SelfTestInputs inputs = embedded_inputs();
        inputs.log = {log.data(), log.size()};
        inputs.terrain = {terrain.data(), terrain.size()};
        inputs.bus = bus;
        inputs.device = device;
        inputs.design = design;
        inputs.palettes[0].text = palette;
        run_self_test(inputs, result);
        return result;
    }
    void replace(std::string& text, const std::string& old, const std::string& by) {
        const std::size_t at = text.rfind(old);
        ASSERT_NE(at, std::string::npos) << old;
        text.replace(at, old.size(), by);
    }
};

std::string failures(const SelfTestReport& report) {
    std::string names;
    for (const SelfCheck& check : report.checks())
        if (!check.holds) names += std::string(check.name.view()) + " ";
    return names;
}

TEST(SelfTest, HoldsAsItIsShipped) {
    const SelfTestReport report = Damaged().report();
    EXPECT_TRUE(report.holds()) << failures(report);
    EXPECT_GE(report.checks().size(), 40u);
    SelfTestReport again;
    run_self_test(embedded_inputs(), again);
    EXPECT_TRUE(again.holds()) << "a second time in one process";
}

TEST(SelfTest, OneChangedBitInTheLogIsSeen) {
    Damaged damaged;
    damaged.replace(damaged.log, " 46D#", " 46C#");  // the last heading comes under another identifier
    EXPECT_FALSE(damaged.report().holds());
    Damaged other;
    const std::size_t line = other.log.rfind(" 137#");
    char& digit = other.log[line + 5 + 8 + 2];  // behind the four header bytes and one more
    digit = digit == 'F' ? 'E' : 'F';
    EXPECT_EQ(failures(other.report()).substr(0, 6), "pitch ");
}

TEST(SelfTest, ThePartOfTheStartSeesTheSameInTheLogAndDrawsNothing) {
    const auto tested = [](const std::string& log, const std::string& bus) {
        SelfTestInputs inputs = embedded_inputs();
        inputs.log = {log.data(), log.size()};
        inputs.bus = bus;
        SelfTestReport report;
        run_start_test(inputs, report);
        return report;
    };
    Damaged damaged;
    const SelfTestReport sound = tested(damaged.log, damaged.bus);
    EXPECT_TRUE(sound.holds()) << failures(sound);
    EXPECT_EQ(sound.find("surface"), nullptr);
    EXPECT_EQ(sound.find("height_above_terrain"), nullptr) << "it has no terrain";
    EXPECT_THAT(failures(tested(damaged.log, "no settings")), HasSubstr("canaerospace.toml"));
    const std::size_t line = damaged.log.rfind(" 137#");
    char& digit = damaged.log[line + 5 + 8 + 2];
    digit = digit == 'F' ? 'E' : 'F';
    EXPECT_EQ(failures(tested(damaged.log, damaged.bus)), "pitch ");
    EXPECT_THAT(failures(tested("", damaged.bus)), HasSubstr("log_frames"));
}

/// What a driver or a library of the same process may have done before.
TEST(SelfTest, SpoiltArithmeticIsSeen) {
    const auto tested = [](int rounding) {
        SelfTestReport start, whole;
        std::fesetround(rounding);
        run_start_test(embedded_inputs(), start);
        check_arithmetic("arithmetic", whole);
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(start.holds(), whole.holds());
        return failures(start);
    };
    EXPECT_EQ(tested(FE_TONEAREST), "");
    for (const int rounding : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) EXPECT_EQ(tested(rounding).substr(0, 11), "arithmetic ");
}

TEST(SelfTest, ACutLogIsSeen) {
    Damaged damaged;
    damaged.log.resize(damaged.log.size() / 2);
    EXPECT_THAT(failures(damaged.report()), HasSubstr("log_frames"));
    damaged.log.clear();
    EXPECT_THAT(failures(damaged.report()), HasSubstr("log_frames"));
    Damaged noise;
    noise.log.insert(0, "(not a stamp) can0 137#00\n");
    EXPECT_THAT(failures(noise.report()), HasSubstr("log_broken_lines"));
}

TEST(SelfTest, OneFlippedBitInTheTerrainIsSeen) {
    for (const std::size_t place : {std::size_t{3}, std::size_t{60}, std::size_t{500}, std::size_t{40000}}) {
        Damaged damaged;
        damaged.terrain[place] ^= 1;
        EXPECT_FALSE(damaged.report().holds()) << "byte " << place;
    }
    Damaged cut;
    cut.terrain.resize(cut.terrain.size() - 1);
    EXPECT_THAT(failures(cut.report()), HasSubstr("display"));
}

TEST(SelfTest, WrongSettingsAreSeenWithTheirPlace) {
    Damaged damaged;
    damaged.device.insert(0, "nonsense = 1\n");
    const SelfTestReport report = damaged.report();
    ASSERT_EQ(report.checks().size(), 6u) << "those of arithmetic and geodesy need no settings";
    EXPECT_THAT(report.checks()[4].finding.c_str(), HasSubstr("es2-small.toml:1: "));
}

TEST(SelfTest, APictureInOtherColorsOrWithoutSymbologyIsSeen) {
    Damaged sky;
    sky.replace(sky.design, "horizon_color = \"#9cc4e8\"", "horizon_color = \"#e8c49c\"");
    EXPECT_THAT(failures(sky.report()), HasSubstr("sky_"));
    Damaged bare;
    bare.replace(bare.design, "altitude = true", "altitude = false");
    EXPECT_EQ(failures(bare.report()), "text_altitude ");
}

TEST(SelfTest, IsPrintedForReadersAndForScripts) {
    SelfTestReport report;
    report.add("first", true, "fine");
    report.add("second", false, "a \"quoted\" fault");
    EXPECT_EQ(printed([&](std::FILE* out) { print_self_test(report, false, out); }),
              "ok      first                    fine\nFAILED  second                   a \"quoted\" fault\nself-test: FAILED\n");
    const auto json = nlohmann::json::parse(printed([&](std::FILE* out) { print_self_test(report, true, out); }));
    EXPECT_EQ(json.at("self_test"), false);
    EXPECT_EQ(json.at("checks").size(), 2u);
    EXPECT_EQ(json.at("checks").at(1), (nlohmann::json{{"name", "second"}, {"holds", false}, {"finding", "a \"quoted\" fault"}}));
}

TEST(SelfTest, TheWholeReportFitsOneLineOfJson) {
    const SelfTestReport report = Damaged().report();
    const auto json = nlohmann::json::parse(printed([&](std::FILE* out) { print_self_test(report, true, out); }));
    EXPECT_EQ(json.at("checks").size(), report.checks().size());
}

}  // namespace
}  // namespace tedavis::target::test_self_test
