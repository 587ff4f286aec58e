// Means of winds against another program's circular statistics; tests/golden/wind says how they were made.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/scene/wind.hpp"
#include "tests/support/files/hard_case.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::scene::test_wind_reference {
namespace {

struct Reference {
    double from_deg = 0, constancy = 0, speed_mps = 0;
    WindMean winds;
    double sum_of_directions_deg = 0;
    std::size_t count = 0;
};

std::vector<Reference> read_references() {
    std::ifstream file(test_support::source_dir() + "/tests/golden/wind/reference.txt");
    std::string comment;
    while (file.peek() == '#') std::getline(file, comment);
    std::vector<Reference> sets;
    for (Reference set; file >> set.count >> set.from_deg >> set.constancy >> set.speed_mps; set = {}) {
        for (std::size_t n = 0; n < set.count; ++n) {
            double from_deg = 0, speed_mps = 0;
            file >> from_deg >> speed_mps;
            set.sum_of_directions_deg += from_deg;
            const double from_rad = base::radians(from_deg);
            set.winds.add(-speed_mps * std::sin(from_rad), -speed_mps * std::cos(from_rad));
        }
        sets.push_back(set);
    }
    EXPECT_TRUE(file.eof()) << "nothing but sets";
    return sets;
}

double between_deg(double a_deg, double b_deg) { return std::abs(std::remainder(a_deg - b_deg, 360)); }

TEST(WindReference, MeansAreThoseOfAnotherProgram) {
    const std::vector<Reference> sets = read_references();
    ASSERT_EQ(sets.size(), 7u);
    double worst_deg = 0;
    for (const Reference& set : sets) {
        const Wind mean = set.winds.mean();
        EXPECT_EQ(set.winds.count(), set.count);
        EXPECT_NEAR(mean.constancy, set.constancy, 1e-9) << set.count;
        EXPECT_NEAR(mean.speed_mps, set.speed_mps, 1e-9) << set.count;
        EXPECT_EQ(mean.state, set.constancy < kMinConstancy ? WindState::variable : WindState::steady) << set.count;
        const double off_deg = between_deg(base::degrees(mean.from_rad), set.from_deg);
        EXPECT_TRUE(mean.state == WindState::variable || off_deg < 1e-6) << set.count << ": " << off_deg;
        if (mean.state == WindState::steady) worst_deg = std::fmax(worst_deg, off_deg);
    }
    test_support::record_worst("A35", worst_deg);
}

TEST(WindReference, MeansOfDirectionsAsNumbersAreOthers) {
    int far_off = 0;
    double worst_deg = 0;
    for (const Reference& set : read_references()) {
        const double off_deg = between_deg(set.sum_of_directions_deg / static_cast<double>(set.count), set.from_deg);
        far_off += off_deg > 20 ? 1 : 0;
        if (set.winds.mean().state == WindState::steady) worst_deg = std::fmax(worst_deg, off_deg);
    }
    EXPECT_GE(far_off, 2) << "the control: sets across north";
    EXPECT_GT(worst_deg, 20);
    test_support::record_control("A35", worst_deg);
}

}  // namespace
}  // namespace tedavis::scene::test_wind_reference
