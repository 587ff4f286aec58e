#include "bus/canaerospace/identifier_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "render_core/base/units.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::bus::test_identifier_table {
namespace {

TEST(IdentifierTable, EachIdentifierOnceAndFound) {
    std::uint16_t before = 0;
    for (std::size_t i = 0; i < identifier_table().size(); ++i) {
        const IdentifierEntry& entry = identifier_table()[i];
        EXPECT_GT(entry.identifier, before) << "in ascending order";
        before = entry.identifier;
        EXPECT_EQ(identifier_index(entry.identifier), i);
        EXPECT_NE(entry.types, 0u);
        EXPECT_LE(entry.low, entry.high) << entry.name;
        EXPECT_LT(entry.rank, kMaxRanks);
    }
    EXPECT_EQ(identifier_index(310), kNotInTable);
    EXPECT_EQ(identifier_index(2047), kNotInTable);
    EXPECT_EQ(identifier_index(65535), kNotInTable);
}

TEST(IdentifierTable, EverySignalOfTheBusHasOnePreferredIdentifier) {
    std::map<flight::Signal, std::multiset<int>> ranks;
    for (std::uint16_t place = 0; place < place_count(); ++place)
        if (const IdentifierEntry& entry = entry_at(place); entry.signal != flight::Signal::count_)
            ranks[entry.signal].insert(entry.rank);
    for (std::size_t i = 0; i < flight::kSignalCount; ++i) {
        const auto signal = static_cast<flight::Signal>(i);
        if (is_computed(signal)) {
            EXPECT_EQ(ranks.count(signal), 0u) << flight::to_string(signal);
            continue;
        }
        ASSERT_EQ(ranks.count(signal), 1u) << flight::to_string(signal);
        EXPECT_EQ(ranks[signal].count(0), 1u) << flight::to_string(signal);
        for (const int rank : ranks[signal]) EXPECT_EQ(ranks[signal].count(rank), 1u);
    }
}

const IdentifierEntry& entry_of(std::uint16_t identifier) { return identifier_table()[identifier_index(identifier)]; }

TEST(IdentifierTable, ConversionsThereAndBack) {
    BusDialect other;
    other.acceleration = AccelerationUnit::mps2;
    other.pressure = PressureUnit::pa;
    other.heading = HeadingReference::magnetic;
    other.wind = WindDirection::to;
    other.variation = VariationSign::west_positive;
    for (const BusDialect& dialect : {BusDialect(), other})
        for (const IdentifierEntry& entry : identifier_table())
            for (const double number : {-170.0, -1.5, 0.0, 0.25, 90.0, 179.0}) {
                const SignalBinding binding = bind(entry, dialect);
                EXPECT_NEAR(from_si(binding, to_si(binding, number)), number, 1e-9) << entry.name;
            }
}

TEST(IdentifierTable, GuidanceStandsWhereTheBusFilePutsIt) {
    const GuidanceSettings absent, moved{1700};
    EXPECT_EQ(place_of(1832, absent), kNotInTable);
    EXPECT_EQ(place_of(0, absent), kNotInTable) << "without the section no identifier is guidance, also not its distances";
    EXPECT_EQ(place_of(311, moved), identifier_index(311)) << "the standard's stay";
    for (const IdentifierEntry& row : guidance_table()) {
        const std::uint16_t place = place_of(static_cast<std::uint16_t>(1700 + row.identifier), moved);
        ASSERT_LT(place, place_count());
        EXPECT_EQ(&entry_at(place), &row);
    }
    EXPECT_EQ(place_of(1699, moved), kNotInTable);
    EXPECT_EQ(place_of(1708, moved), kNotInTable);
}

TEST(IdentifierTable, DeviationsHaveTheSignOfTheDialectAndDirectionsItsNorth) {
    BusDialect dialect;
    dialect.deviation = DeviationSign::path;
    dialect.directions = HeadingReference::magnetic;
    for (const std::uint16_t identifier : {1042, 1044, 1087, 1088, 1091, 1092}) {
        const IdentifierEntry& entry = entry_of(identifier);
        EXPECT_EQ(to_si(bind(entry, dialect), 1), -to_si(bind(entry, {}), 1)) << entry.name;
        EXPECT_GT(to_si(bind(entry, {}), 1), 0) << entry.name;
    }
    EXPECT_EQ(to_si(bind(entry_of(1095), dialect), 1), to_si(bind(entry_of(1095), {}), 1)) << "a command is no deviation";
    for (const std::uint16_t identifier : {1120, 1125}) EXPECT_TRUE(bind(entry_of(identifier), dialect).is_magnetic);
    EXPECT_FALSE(bind(entry_of(1040), dialect).is_magnetic) << "the track is true by its name";
    EXPECT_FALSE(bind(entry_of(1125), {}).is_magnetic);
}

TEST(IdentifierTable, DialectsChangeUnitsSignsAndReferences) {
    const BusDialect standard;
    EXPECT_NEAR(to_si(bind(entry_of(302), standard), 1), 9.80665, 1e-12);
    EXPECT_NEAR(to_si(bind(entry_of(319), standard), 1013.25), 101325, 1e-9);
    EXPECT_NEAR(to_si(bind(entry_of(321), standard), -90), 1.5 * base::kPi, 1e-12);
    EXPECT_EQ(bind(entry_of(321), standard).signal, flight::Signal::true_heading);
    EXPECT_NEAR(to_si(bind(entry_of(334), standard), 10), base::radians(10), 1e-12);
    BusDialect dialect;
    dialect.acceleration = AccelerationUnit::mps2;
    dialect.pressure = PressureUnit::pa;
    dialect.heading = HeadingReference::magnetic;
    dialect.wind = WindDirection::to;
    dialect.variation = VariationSign::west_positive;
    EXPECT_EQ(to_si(bind(entry_of(302), dialect), 1), 1);
    EXPECT_EQ(to_si(bind(entry_of(319), dialect), 101325), 101325);
    EXPECT_EQ(bind(entry_of(321), dialect).signal, flight::Signal::magnetic_heading);
    EXPECT_NEAR(to_si(bind(entry_of(334), dialect), 10), base::radians(190), 1e-12);
    EXPECT_NEAR(to_si(bind(entry_of(1121), dialect), 3), -base::radians(3), 1e-12);
}

/// The shipped .dbc says the same as the table: every identifier of the standard's, its unit, and a float value.
TEST(IdentifierTable, ShippedDbcAgrees) {
    std::ifstream file(test_support::source_dir() + "/configs/buses/canaerospace.dbc");
    ASSERT_TRUE(file.is_open());
    std::map<int, std::string> names;
    std::map<int, std::string> units;
    std::set<int> floats;
    int current = 0;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "BO_") {
            words >> current >> names[current];
            EXPECT_LE(names[current].size(), 33u) << "32 characters and a colon";
        } else if (word == "SG_" && line.find(" Value : ") != std::string::npos) {
            EXPECT_NE(line.find(": 39|"), std::string::npos) << "big-endian, from the payload's first bit";
            units[current] = line.substr(line.find('"') + 1, line.rfind('"') - line.find('"') - 1);
        } else if (word == "SIG_VALTYPE_") {
            words >> current;
            floats.insert(current);
        }
    }
    for (const IdentifierEntry& entry : identifier_table()) {
        if (entry.glider_profile) continue;
        std::string name = entry.name;
        for (char& c : name) c = c == ' ' ? '_' : c;
        EXPECT_EQ(names[entry.identifier], name + ":");
        const bool clock = entry.unit == BusUnit::time_of_day || entry.unit == BusUnit::date;
        const bool has_unit = !clock && entry.unit != BusUnit::bits;
        if (has_unit) {
            EXPECT_EQ(units[entry.identifier], to_string(entry.unit)) << entry.name;
        }
        EXPECT_EQ(floats.count(entry.identifier) == 1, (entry.types & type_bit(DataType::float32)) != 0) << entry.name;
        names.erase(entry.identifier);
    }
    EXPECT_EQ(names.count(1830) + names.count(1831) + names.count(1852), 3u);
    for (int part = 0; part < kTrafficIdentifiers; ++part) EXPECT_EQ(names.count(1840 + part), 1u);
    for (const IdentifierEntry& entry : guidance_table()) {
        const int identifier = 1832 + entry.identifier;
        EXPECT_EQ(names.count(identifier), 1u) << entry.name;
        EXPECT_EQ(units[identifier], to_string(entry.unit)) << entry.name;
        EXPECT_EQ(floats.count(identifier) == 1, (entry.types & type_bit(DataType::float32)) != 0) << entry.name;
    }
    EXPECT_EQ(names.size(), 3u + kTrafficIdentifiers + kGuidanceIdentifiers)
        << "the phase, guidance, other aircraft, the legend, and nothing else";
}

}  // namespace
}  // namespace tedavis::bus::test_identifier_table
