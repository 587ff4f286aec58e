#include "host_sim/importers/flight_importer.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_flight_importer {
namespace {

const char kIgc[] = "AXXX001\nHFDTE120420\nB0947004637500N00955250EA0123401300\n";
const char kGpx[] = "<gpx><trk><trkseg><trkpt lat='1' lon='2'><time>2020-04-12T09:47:00Z</time></trkpt></trkseg></trk></gpx>";
const char kJson[] = R"([{"timestamp":1586684820000,"latitude":1,"longitude":2}])";
const char kCsv[] = "time,latitude_deg,longitude_deg\n0,1,2\n";

TEST(FlightImporter, TellsTheFormatByContent) {
    const test_support::TemporaryFolder folder;
    EXPECT_EQ(import_flight_file(folder.write("a", kIgc)).format, "IGC");
    EXPECT_EQ(import_flight_file(folder.write("b.txt", kGpx)).format, "GPX");
    EXPECT_EQ(import_flight_file(folder.write("c.csv", std::string("\xEF\xBB\xBF\n") + kJson)).format, "ADS-B JSON");
    EXPECT_EQ(import_flight_file(folder.write("d.json", kCsv)).format, "CSV");
    gzFile packed = gzopen(folder.file("e.gz").c_str(), "wb");
    gzputs(packed, kJson);
    gzclose(packed);
    EXPECT_EQ(import_flight_file(folder.file("e.gz")).format, "ADS-B JSON");
}

TEST(FlightImporter, TellsABusLogByItsFirstLine) {
    const test_support::TemporaryFolder folder;
    const std::string log = "(1586684820.000000) can0 400#0000000000000000\n";
    EXPECT_TRUE(is_bus_log_file(folder.write("a.log", log)));
    EXPECT_TRUE(is_bus_log_file(folder.write("b.log", "\n" + log)));
    gzFile packed = gzopen(folder.file("c.log.gz").c_str(), "wb");
    gzputs(packed, log.c_str());
    gzclose(packed);
    EXPECT_TRUE(is_bus_log_file(folder.file("c.log.gz")));
    for (const char* const text : {kIgc, kGpx, kJson, kCsv, "", "(no stamp\n"})
        EXPECT_FALSE(is_bus_log_file(folder.write("d", text)));
    test_support::expect_user_error([&] { (void)is_bus_log_file(folder.file("missing")); }, "missing");
    EXPECT_EQ(recorded_format(folder.write("a.igc", "AXXX\nHFDTE200319\nB0900004600000N00900000EA0100001000\n")), "IGC");
    EXPECT_EQ(recorded_format(folder.write("a.gpx", "<?xml version='1.0'?>")), "GPX");
    EXPECT_EQ(recorded_format(folder.write("a.json", " [{}]")), "ADS-B JSON");
    for (const std::string& other : {log, std::string("hello"), std::string(), std::string("\0A", 2)})
        EXPECT_EQ(recorded_format(folder.write("other", other)), "");
}

TEST(FlightImporter, RefusesEmptyAndBinaryFiles) {
    const test_support::TemporaryFolder folder;
    test_support::expect_user_error([&] { (void)import_flight_file(folder.write("a", " \n")); }, "the file is empty");
    test_support::expect_user_error(
        [&] {
            (void)import_flight_file(folder.write("b", std::string("\x7F"
                                                                   "ELF\0\0",
                                                                   6)));
        },
        "binary data");
}

TEST(FlightImporter, AFileThatIsNotWhatItsNameSays) {
    const test_support::TemporaryFolder folder;
    const auto refused = [&](const char* name, const std::string& text, const char* words) {
        test_support::expect_user_error([&] { (void)import_flight_file(folder.write(name, text)); }, words);
    };
    refused("a.igc", "hello world\n", "a.igc: is not the IGC flight that its name promises, which begins with a line A");
    refused("a.IGC.gz", "hello world\n", "is not the IGC flight");
    refused("a.gpx", "hello world\n", "is not the GPX flight that its name promises; give");
    refused("a.json", "hello world\n", "is not the ADS-B JSON flight");
    refused("a.csv", "hello world\n", "the column `latitude_deg` is missing");
    EXPECT_EQ(import_flight_file(folder.write("table.igc", kCsv)).format, "CSV") << "a table is one whatever its name";
    EXPECT_EQ(import_flight_file(folder.write("b.igc", kIgc)).format, "IGC");
}

TEST(FlightImporter, ABusLogNeedsNoConversion) {
    const test_support::TemporaryFolder folder;
    for (const char* line : {"(1586684820.000000) can0 13C#00\n", "\n(1.5)   vcan1 1ABCDE00##1DE.AD\n"})
        test_support::expect_user_error([&] { (void)import_flight_file(folder.write("a.log", line)); },
                                        "a.log: a bus log already; give it to 'tedavis replay' as it is");
    test_support::expect_user_error([&] { (void)import_flight_file(folder.write("b.log", "(a bracket) alone\n")); },
                                    "the column `latitude_deg` is missing from the first line");
}

ImportedFile two_aircraft() {
    ImportedFile file;
    file.flights = {{"4b1c22", "HBKRA", HeightDatum::wgs84_ellipsoid, {}}, {"4b088c", "HBDGE", HeightDatum::wgs84_ellipsoid, {}}};
    return file;
}

TEST(FlightImporter, ChoosesByIdentityOrCallsign) {
    EXPECT_EQ(choose_aircraft(two_aircraft(), "4B088C", "f").aircraft, "4b088c");
    EXPECT_EQ(choose_aircraft(two_aircraft(), "hbkra", "f").aircraft, "4b1c22");
    ImportedFile one = two_aircraft();
    one.flights.pop_back();
    EXPECT_EQ(choose_aircraft(one, "", "f").aircraft, "4b1c22");
}

TEST(FlightImporter, ListsTheChoices) {
    test_support::expect_user_error([] { (void)choose_aircraft(two_aircraft(), "", "f"); },
                                    "f: holds 2 aircraft; choose one with --aircraft: 4b1c22 (HBKRA), 4b088c (HBDGE)");
    test_support::expect_user_error([] { (void)choose_aircraft(two_aircraft(), "x", "f"); },
                                    "no aircraft 'x'; choose one with --aircraft: 4b1c22");
    ImportedFile nameless = two_aircraft();
    nameless.flights.pop_back();
    nameless.flights[0].aircraft = nameless.flights[0].callsign = "";
    test_support::expect_user_error([&] { (void)choose_aircraft(nameless, "x", "f"); },
                                    "f: no aircraft 'x'; leave out --aircraft, it names none");
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_importer
