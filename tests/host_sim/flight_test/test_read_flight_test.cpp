#include "host_sim/flight_test/read_flight_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_read_flight_test {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kExpect = "[[expect]]\nat_s = 3\nphase = \"cruise\"\n";

class ReadTest : public ::testing::Test {
protected:
    FlightTest read(const std::string& text) {
        faults_ = ScriptFaults();
        return read_flight_test(place_.write("a.toml", text), {}, faults_);
    }
    std::vector<std::string> faults_of(const std::string& text) {
        static_cast<void>(read(text));
        return faults_.sentences();
    }
    test_support::TemporaryFolder place_;
    ScriptFaults faults_;
};

TEST_F(ReadTest, HasDefaultsForAllButWhatIsExpected) {
    const FlightTest test = read(kExpect);
    EXPECT_THAT(faults_.sentences(), IsEmpty());
    EXPECT_EQ(test.title, "a");
    EXPECT_EQ(test.picture.device, "es2-small");
    EXPECT_EQ(test.picture.design, "default");
    EXPECT_TRUE(test.has_steps);
    EXPECT_GT(test.end_s, 3) << "the bus goes on beyond the last expectation";
    EXPECT_GT(test.start.speed_mps, 0);
}

TEST_F(ReadTest, TakesShippedNamesAndPathsFromItsFolder) {
    place_.write("my_bus.toml", "protocol = \"canaerospace\"\n[phase]\nstatus_identifier = 1900\n");
    const FlightTest test =
        read("title = \"t\"\ndesign = \"cruise\"\nbus = \"./my_bus.toml\"\nswitches = \"coded_parity\"\naircraft = \"jet\"\n" +
             kExpect);
    EXPECT_THAT(faults_.sentences(), IsEmpty());
    EXPECT_THAT(test.picture.design, EndsWith("configs/designs/cruise.toml"));
    EXPECT_THAT(test.picture.bus, EndsWith("/my_bus.toml"));
    EXPECT_EQ(test.bus.phase.status_identifier, 1900);
    EXPECT_EQ(test.panel.lines.size(), 5u);
}

TEST_F(ReadTest, AnIncludedFileGivesWhatTheIncludingOneDoesNotSay) {
    place_.write("base.toml", "title = \"base\"\ndesign = \"cruise\"\n[[step]]\nat_s = 2\nphase = \"cruise\"\n" + kExpect);
    const FlightTest test =
        read("title = \"own\"\ninclude = [\"base.toml\"]\n[[step]]\nat_s = 1\nphase = \"ground\"\n" + kExpect);
    EXPECT_THAT(faults_.sentences(), IsEmpty());
    EXPECT_EQ(test.title, "own");
    EXPECT_THAT(test.picture.design, EndsWith("cruise.toml"));
    ASSERT_EQ(test.steps.size(), 2u);
    EXPECT_EQ(test.steps[0].at_s, 1) << "in order of time";
    EXPECT_EQ(test.expectations.size(), 2u);
}

TEST_F(ReadTest, AStartIsMergedKeyByKey) {
    place_.write("base.toml", "[start]\naltitude_msl_m = 1000\nspeed_kt = 90\nheading_deg = 90\n");
    const FlightTest test = read("include = [\"base.toml\"]\n[start]\nspeed_mps = 50\n" + kExpect);
    EXPECT_THAT(faults_.sentences(), IsEmpty());
    EXPECT_EQ(test.start.altitude_msl_m, 1000);
    EXPECT_EQ(test.start.speed_mps, 50) << "in whatever unit the included one was";
    EXPECT_NEAR(test.start.heading_rad, 1.5707963, 1e-6);
    place_.write("base.toml", "\n[start]\nheading_deg = 900\n");
    EXPECT_THAT(faults_of("include = [\"base.toml\"]\n[start]\nspeed_mps = 50\n" + kExpect),
                ElementsAre(HasSubstr("base.toml:3: 'heading_deg'")));
}

TEST_F(ReadTest, ARampBeginsAtAValue) {
    const std::string ramp = "[[step]]\nat_s = 2\nramp = { radio_height_m = 100 }\nover_s = 1\n" + kExpect;
    EXPECT_THAT(faults_of(ramp), ElementsAre(HasSubstr("a.toml:1: the ramp of 'radio_height' begins where it has no value")));
    EXPECT_THAT(faults_of("[[step]]\nat_s = 1\nhold = { radio_height_m = 50 }\n" + ramp), IsEmpty());
}

TEST_F(ReadTest, NothingChangesThePanelWhileAContactBounces) {
    const std::string bounce = "[[step]]\nat_s = 1\nbounce = { line = \"CRUISE\", times = 101, gap_ms = 10 }\n";
    EXPECT_THAT(faults_of(bounce + "[[step]]\nat_s = 1.5\nswitch = \"GROUND\"\n" + kExpect),
                ElementsAre(HasSubstr("a.toml:4: the bounce of ")));
    EXPECT_THAT(faults_of(bounce + "[[step]]\nat_s = 2\nswitch = \"GROUND\"\n" + kExpect), IsEmpty());
}

TEST_F(ReadTest, AllThatIsWrongIsToldAtOnce) {
    EXPECT_THAT(
        faults_of("titel = \"x\"\ndesign = \"cruse\"\n[[step]]\nat_s = 1\nswich = \"CRUISE\"\n" + kExpect + "flag = []\n"),
        ElementsAre(HasSubstr("a.toml:1: unknown key 'titel'; say title"), HasSubstr("a.toml:2: 'design': there is no file"),
                    HasSubstr("a.toml:5: unknown key 'swich'"), HasSubstr("a.toml:9: unknown key 'flag'")));
}

TEST_F(ReadTest, AFaultIsToldOnce) {
    EXPECT_THAT(faults_of("title = \n" + kExpect), ElementsAre(HasSubstr("a.toml:1: ")));
    EXPECT_THAT(faults_of("[[step]]\nat_s = \"$t\"\nhold = { pitch_deg = \"$p\" }\nphase = \"cruise\"\n" + kExpect),
                ElementsAre(HasSubstr("a.toml:2: '$t' is no parameter"), HasSubstr("a.toml:3: '$p' is no parameter")));
    EXPECT_THAT(faults_of("switches = \"one_hott\"\n[[step]]\nat_s = 1\nswitch = \"CRUISE\"\n" + kExpect),
                ElementsAre(HasSubstr("a.toml:1: 'switches'")));
    EXPECT_THAT(faults_of("bus = \"none\"\nswitches = \"none\"\n" + kExpect),
                ElementsAre(HasSubstr("a.toml:1: 'bus'"), HasSubstr("a.toml:2: 'switches'")));
}

TEST_F(ReadTest, FilesOfItsInputAreThere) {
    EXPECT_THAT(faults_of("terrain = \"nowhere\"\nscene = \"nope\"\n[input]\nscenario = \"nope\"\n" + kExpect),
                ElementsAre(HasSubstr("a.toml:1: 'terrain'"), HasSubstr("a.toml:2: 'scene'"), HasSubstr("a.toml:4: 'scenario'")));
    EXPECT_THAT(faults_of("[input]\nlog = \"nolog\"\n" + kExpect), ElementsAre(HasSubstr("a.toml:2: 'log': there is no file")));
    place_.write("flight", "x");
    EXPECT_EQ(read("[input]\nlog = \"flight\"\n" + kExpect).log, place_.file("flight")) << "from the script's folder";
}

TEST_F(ReadTest, TimesBeyondTheInputAreFaults) {
    EXPECT_THAT(faults_of("[input]\nlasts_s = 2\n" + kExpect),
                ElementsAre(HasSubstr("a.toml:3: this [[expect]] lies beyond the end")));
    EXPECT_THAT(faults_of("[[step]]\nat_s = 9\nphase = \"cruise\"\n" + kExpect),
                ElementsAre(HasSubstr("a.toml:1: this [[step]] lies beyond the last expectation")));
}

TEST_F(ReadTest, InputsExcludeEachOther) {
    place_.write("f.log", "");
    EXPECT_THAT(faults_of("[input]\nlog = \"./f.log\"\nscenario = \"default\"\n" + kExpect),
                ElementsAre(HasSubstr("a log and a scenario")));
    EXPECT_THAT(faults_of("[input]\nscenario = \"default\"\n[[step]]\nat_s = 1\nphase = \"cruise\"\n" + kExpect),
                ElementsAre(HasSubstr("a.toml:3: a [[step]] beside a log")));
    EXPECT_THAT(faults_of(""), ElementsAre(HasSubstr("expects nothing")));
    EXPECT_THAT(faults_of("[input]\nscenario = \"default\"\nlasts_s = 9\n[start]\nspeed_mps = 3\n" + kExpect),
                ElementsAre(HasSubstr("'lasts_s' belongs to steps"), HasSubstr("a.toml:4: [start] belongs to steps")));
}

TEST_F(ReadTest, ContradictionsAreFaults) {
    EXPECT_THAT(faults_of(kExpect + "[[expect]]\nfrom_s = 1\nto_s = 4\nphase = \"ground\"\n"),
                ElementsAre(HasSubstr("phase ground contradicts phase cruise")));
}

TEST_F(ReadTest, WithoutASwitchThatIsThrownNoneStatesThePhase) {
    const std::string expect = "[[expect]]\nat_s = 3\nphase_source = \"switch\"\n";
    EXPECT_THAT(faults_of(expect), ElementsAre(HasSubstr("a.toml:1: 'phase_source': no switch is thrown; add a [[step]]")));
    for (const char* const thrown :
         {"switch = \"CRUISE\"", "lines = { CRUISE = 1 }", "bounce = { line = \"CRUISE\", times = 5, gap_ms = 3 }"})
        EXPECT_THAT(faults_of("[[step]]\nat_s = 1\n" + std::string(thrown) + "\n" + expect), IsEmpty()) << thrown;
    place_.write("f.log", "");
    place_.write("f.switches", "");
    EXPECT_THAT(faults_of("[input]\nlog = \"./f.log\"\n" + expect), ElementsAre(HasSubstr("say switch_log")));
    EXPECT_THAT(faults_of("[input]\nlog = \"./f.log\"\nswitch_log = \"./f.switches\"\n" + expect), IsEmpty());
    EXPECT_THAT(faults_of("[input]\nscenario = \"default\"\n" + expect), IsEmpty()) << "it has a panel";
}

TEST_F(ReadTest, AFaultyFileThatItNamesIsToldAtTheKey) {
    place_.write("b.toml", "protocol = \"other\"\n");
    EXPECT_THAT(faults_of("\nbus = \"./b.toml\"\n" + kExpect), ElementsAre(HasSubstr("a.toml:2: 'bus': ")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_read_flight_test
