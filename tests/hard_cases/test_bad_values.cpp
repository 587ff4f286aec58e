// Files of the right kind with values that cannot be: no numbers, infinities, numbers out of all range, words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <sstream>

#include "host_sim/input_file.hpp"
#include "render_core/base/hash.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/program_words.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::tests::test_bad_values {
namespace {

using test_support::expect_refusal;
using test_support::ProgramOutcome;
using ::testing::HasSubstr;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// "key = 12.5  # why" in parts; no key where the line assigns no single number.
struct NumberLine {
    std::string key, after;
};
NumberLine number_in(const std::string& line) {
    const std::size_t equals = line.find(" = ");
    if (equals == std::string::npos || line[0] == '#') return {};
    const std::size_t first = equals + 3, last = line.find_first_not_of("-+.0123456789eE", first);
    if (last == first || first >= line.size() || line[first] == '"') return {};
    return {line.substr(0, equals), last == std::string::npos ? "" : line.substr(last)};
}

class EveryNumber : public ::testing::TestWithParam<const char*> {};

// Every number of every shipped file of a kind, made impossible one by one.
TEST_P(EveryNumber, OfTheShippedFilesIsBounded) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directory(place.file(GetParam()));
    std::size_t tried = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test_support::source_dir() + "/configs/" + GetParam())) {
        if (entry.path().extension() != ".toml") continue;
        const std::vector<std::string> lines = lines_of(host_sim::read_file(entry.path().string()));
        const std::string name = std::string(GetParam()) + "/" + entry.path().filename().string();
        for (std::size_t n = 0; n < lines.size(); ++n) {
            const NumberLine number = number_in(lines[n]);
            if (number.key.empty()) continue;
            for (const char* value : {"nan", "-inf", "inf", "-1e30", "1e30", "\"word\"", "99999999999999999999"}) {
                std::string text;
                for (std::size_t k = 0; k < lines.size(); ++k)
                    text += (k == n ? number.key + " = " + value + number.after : lines[k]) + "\n";
                SCOPED_TRACE(name + ": " + number.key + " = " + value);
                expect_refusal(test_support::run_words({"check", place.write(name, text)}), name + ":" + std::to_string(n + 1));
                ++tried;
            }
        }
    }
    EXPECT_GT(tried, 20u);
}

INSTANTIATE_TEST_SUITE_P(Configs, EveryNumber,
                         ::testing::Values("designs", "palettes", "devices", "buses", "switches", "scenarios"),
                         [](const auto& place) { return std::string(place.param); });

TEST(BadValues, InFlights) {
    const test_support::TemporaryFolder place;
    const std::string head = "time,latitude_deg,longitude_deg,height_msl_m\n1586684820,46.98,10.02,3000\n";
    struct Case {
        std::string name, text, where;
    };
    for (const Case& c :
         {Case{"nan.csv", head + "1586684821,nan,10.02,3000\n", "nan.csv:3: 'nan'"},
          Case{"inf.csv", head + "1586684821,46.98,10.02,inf\n", "inf.csv:3: 'inf'"},
          Case{"far.csv", head + "1586684821,146.98,10.02,3000\n", "far.csv:3: '146.98' is out of range"},
          Case{"high.csv", head + "1586684821,46.98,10.02,1e9\n", "high.csv:3: '1e9' is out of range"},
          Case{"late.csv", head + "15866848210,46.98,10.02,3000\n", "late.csv:3: '15866848210' is no time"},
          Case{"one.csv", head, "one.csv: no two fixes"},
          Case{"years.csv", head + "1586684821,46.98,10.02,3000\n1686684820,46.98,10.02,3000\n1686684821,46.98,10.02,3000\n",
               "years.csv: its fixes span 1157 days"},
          Case{"nan.json", R"([{"timestamp":NaN,"latitude":46.98,"longitude":10.02}])", "nan.json: no valid JSON from byte"},
          Case{"huge.json", R"([{"timestamp":1e999,"latitude":46.98,"longitude":10.02}])", "huge.json: holds a value"},
          Case{"pole.json", R"([{"timestamp":1586684820,"latitude":95,"longitude":10.02}])", "pole.json: none of its 1 rows"},
          Case{"nan.gpx",
               "<gpx><trk><trkseg><trkpt lat='nan' lon='inf'><time>2020-04-12T09:47:00Z</time></trkpt></trkseg></trk></gpx>",
               "nan.gpx: no track point"},
          Case{"day.igc", "AXXX\nHFDTE991399\nB0947004658800N01001200EA0290003000\n", "day.igc:2: the date record"},
          Case{"text.igc", "AXXX\nHFDTE120420\nB0947xx4658800N01001200EA0290003000\n", "text.igc: no usable B record"}}) {
        SCOPED_TRACE(c.name);
        expect_refusal(test_support::run_words({"convert", place.write(c.name, c.text), "-o", place.file("x.log")}), c.where);
        EXPECT_FALSE(std::filesystem::exists(place.file("x.log")));
    }
}

TEST(BadValues, InBytesThatAreNoText) {
    const test_support::TemporaryFolder place;
    const std::string flight = place.write("latin.igc",
                                           "AXXX\nHFDTE120420\nHFGIDGLIDERID:D-\xE9\xFF\nB0947004658800N01001200EA0290003000\n"
                                           "B0947014658800N01001200EA0290003000\n");
    const ProgramOutcome outcome = test_support::run_words({"convert", flight, "-o", place.file("x.log"), "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.notes;
    EXPECT_THAT(outcome.results, HasSubstr("D-\xEF\xBF\xBD")) << "what is no UTF-8 is replaced";
}

using terrain::ChunkEntry;
using terrain::FileHeader;

/// A database whose header or first chunk entry was changed and signed anew.
template <class Change>
std::string forged_tdb(const test_support::TemporaryFolder& place, Change change) {
    static const host_sim::Raster raster = test_support::make_rough_raster(70, 66);
    static const std::vector<std::uint8_t> sound = test_support::build_image(raster);
    std::vector<std::uint8_t> bytes = sound;
    FileHeader h;
    std::memcpy(&h, bytes.data(), sizeof h);
    std::uint64_t first_page;
    std::memcpy(&first_page, bytes.data() + h.page_table_offset, sizeof first_page);
    terrain::DirectoryPage page;
    std::memcpy(&page, bytes.data() + first_page, sizeof page);
    change(h, page.entries[0]);
    page.crc = base::crc32(&page.level, sizeof page - offsetof(terrain::DirectoryPage, level));
    h.header_crc = base::crc32(&h, offsetof(FileHeader, header_crc));
    std::memcpy(bytes.data(), &h, sizeof h);
    std::memcpy(bytes.data() + first_page, &page, sizeof page);
    return place.write("forged.tdb", std::string(bytes.begin(), bytes.end()));
}

TEST(BadValues, ATerrainDatabaseThatIsSignedAnewUnchangedIsSound) {
    const test_support::TemporaryFolder place;
    EXPECT_EQ(test_support::run_words({"terrain", "info", forged_tdb(place, [](FileHeader&, ChunkEntry&) {})}).code, 0);
}

TEST(BadValues, InHeadersOfTerrainDatabases) {
    const test_support::TemporaryFolder place;
    const auto refuses = [&](const char* what, auto change) {
        SCOPED_TRACE(what);
        expect_refusal(test_support::run_words({"terrain", "info", forged_tdb(place, change)}), "forged.tdb: ");
    };
    struct Place {
        const char* name;
        double FileHeader::*value;
    };
    for (const Place& p :
         {Place{"west", &FileHeader::west_deg}, Place{"north", &FileHeader::north_deg},
          Place{"step east", &FileHeader::step_lon_deg}, Place{"step south", &FileHeader::step_lat_deg},
          Place{"geoid west", &FileHeader::undulation_west_deg}, Place{"geoid north", &FileHeader::undulation_north_deg},
          Place{"geoid step", &FileHeader::undulation_step_deg}}) {
        for (const double value : {std::nan(""), std::numeric_limits<double>::infinity(), -1e300}) {
            refuses(p.name, [&](FileHeader& h, ChunkEntry&) { h.*p.value = value; });
        }
    }
    for (float FileHeader::*value : {&FileHeader::min_height_m, &FileHeader::max_height_m, &FileHeader::le90_m}) {
        refuses("height", [&](FileHeader& h, ChunkEntry&) { h.*value = std::nanf(""); });
    }
    refuses("tolerance", [&](FileHeader& h, ChunkEntry&) { h.tolerance_m[1] = std::nanf(""); });
    for (std::uint32_t FileHeader::*value :
         {&FileHeader::columns, &FileHeader::rows, &FileHeader::levels, &FileHeader::page_count, &FileHeader::undulation_columns,
          &FileHeader::undulation_rows}) {
        for (const std::uint32_t count : {0u, 1u, 0xFFFFFFFFu})
            refuses("count", [&](FileHeader& h, ChunkEntry&) { h.*value = count; });
    }
    for (const std::uint64_t chunks : {std::uint64_t{0}, std::uint64_t{1} << 40})
        refuses("chunks", [&](FileHeader& h, ChunkEntry&) { h.chunk_count = chunks; });
    refuses("page table", [&](FileHeader& h, ChunkEntry&) { h.page_table_offset = std::uint64_t{1} << 40; });
    refuses("lattice flags", [&](FileHeader& h, ChunkEntry&) { h.lattice_flags = 0xFF; });
    for (const std::uint64_t offset : {std::uint64_t{0xFFFFFFFFFFFFFFFFu}, std::uint64_t{1} << 40})
        refuses("geoid offset", [&](FileHeader& h, ChunkEntry&) { h.undulation_offset = offset; });
    refuses("size", [&](FileHeader& h, ChunkEntry&) { h.file_bytes += 1; });
}

TEST(BadValues, InChunkEntriesOfTerrainDatabases) {
    const test_support::TemporaryFolder place;
    const auto refuses = [&](const char* what, auto change) {
        SCOPED_TRACE(what);
        expect_refusal(test_support::run_words({"terrain", "info", forged_tdb(place, change)}), "forged.tdb: ");
    };
    const float nan = std::nanf("");
    refuses("above", [&](FileHeader&, ChunkEntry& e) { e.above_m = nan; });
    refuses("below", [&](FileHeader&, ChunkEntry& e) { e.below_m = -1; });
    refuses("bound", [&](FileHeader&, ChunkEntry& e) { e.bound_m = nan; });
    refuses("lowest", [&](FileHeader&, ChunkEntry& e) { e.min_height_m = nan; });
    refuses("highest", [&](FileHeader&, ChunkEntry& e) { e.max_height_m = std::numeric_limits<float>::infinity(); });
    refuses("centre", [&](FileHeader&, ChunkEntry& e) { e.centre_m[1] = std::nan(""); });
    refuses("axes", [&](FileHeader&, ChunkEntry& e) { e.axes[4] = nan; });
    refuses("extent", [&](FileHeader&, ChunkEntry& e) { e.half_extent_m[2] = nan; });
    refuses("level", [&](FileHeader&, ChunkEntry& e) { e.level = 9; });
    refuses("place", [&](FileHeader&, ChunkEntry& e) { e.i = 7; });
    refuses("strip above", [&](FileHeader&, ChunkEntry& e) { e.strip_above_m = nan; });
    refuses("children", [&](FileHeader&, ChunkEntry& e) { e.children = 15; });
    refuses("flags", [&](FileHeader&, ChunkEntry& e) { e.flags = 0; });
    refuses("vertices", [&](FileHeader&, ChunkEntry& e) { e.vertex_count = 0xFFFF; });
    refuses("offset", [&](FileHeader&, ChunkEntry& e) { e.payload.offset = ~std::uint64_t{0}; });
    refuses("bytes", [&](FileHeader&, ChunkEntry& e) { e.payload.bytes += 4; });
}

}  // namespace
}  // namespace tedavis::tests::test_bad_values
