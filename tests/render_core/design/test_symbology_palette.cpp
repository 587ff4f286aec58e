#include "render_core/design/symbology_palette.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::design::test_symbology_palette {
namespace {

using test_support::source_file;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kShipped = "configs/palettes/symbology/standard.toml";

std::string shipped() { return source_file(kShipped); }

std::string replaced(const std::string& part, const std::string& by) {
    std::string text = shipped();
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), by);
}

/// Empty where the file is accepted.
std::string error_of(const std::string& text) {
    const auto read = load_symbology_palettes(text, "own.toml");
    return read.ok() ? std::string() : std::string(read.error().message.view());
}

TEST(SymbologyPalette, WithoutAFileItIsTheShippedOne) {
    const auto read = load_symbology_palettes(shipped(), kShipped);
    ASSERT_TRUE(read.ok()) << read.error().message.view();
    const SymbologyPalettes &file = read.value(), &built_in = standard_symbology_palettes();
    EXPECT_EQ(file.name, built_in.name);
    for (const SymbologyLight light : {SymbologyLight::day, SymbologyLight::night}) {
        for (std::size_t role = 0; role < kSymbolRoleCount; ++role)
            EXPECT_EQ(file.of(light).colors[role], built_in.of(light).colors[role]) << kSymbolRoleNames[role];
        EXPECT_EQ(file.of(light).type.value_large, built_in.of(light).type.value_large);
        EXPECT_EQ(file.of(light).type.value, built_in.of(light).type.value);
        EXPECT_EQ(file.of(light).type.label, built_in.of(light).type.label);
    }
    ASSERT_EQ(file.told_apart.size(), built_in.told_apart.size());
    for (std::size_t n = 0; n < file.told_apart.size(); ++n) {
        EXPECT_EQ(file.told_apart[n].first, built_in.told_apart[n].first);
        EXPECT_EQ(file.told_apart[n].second, built_in.told_apart[n].second);
        EXPECT_EQ(file.told_apart[n].by, built_in.told_apart[n].by);
    }
    EXPECT_EQ(kDaySymbology.colors, built_in.of(SymbologyLight::day).colors);
    EXPECT_NE(built_in.of(SymbologyLight::night).colors, kDaySymbology.colors);
}

TEST(SymbologyPalette, ReadsColorsByRoleAndLight) {
    const auto read = load_symbology_palettes(replaced("warning = \"#ff3030\"", "warning = \"#010203\""), "own.toml");
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read.value().of(SymbologyLight::day).color(SymbolRole::warning), (Color{1, 2, 3}));
    EXPECT_EQ(read.value().of(SymbologyLight::night).color(SymbolRole::warning),
              standard_symbology_palettes().of(SymbologyLight::night).color(SymbolRole::warning));
}

TEST(SymbologyPalette, PairsThatSomethingElseTellsApartCountEitherWay) {
    const SymbologyPalettes& palettes = standard_symbology_palettes();
    EXPECT_TRUE(palettes.are_told_apart(SymbolRole::engaged, SymbolRole::reference));
    EXPECT_TRUE(palettes.are_told_apart(SymbolRole::reference, SymbolRole::engaged));
    EXPECT_FALSE(palettes.are_told_apart(SymbolRole::engaged, SymbolRole::warning));
}

TEST(SymbologyPalette, EveryFaultIsOneSentenceAtItsLine) {
    EXPECT_EQ(error_of(shipped()), "");
    EXPECT_THAT(error_of(replaced("warning = \"#ff3030\"", "")), HasSubstr("'warning'"));
    EXPECT_THAT(error_of(replaced("\"#ff3030\"", "\"red\"")), StartsWith("own.toml:7: 'warning'"));
    EXPECT_THAT(error_of(replaced("\"#ff3030\"", "\"#ff303080\"")), HasSubstr("never translucent"));
    EXPECT_THAT(error_of(replaced("warning = \"#ff3030\"", "warming = \"#ff3030\"")), StartsWith("own.toml:"));
    EXPECT_THAT(error_of(replaced("[night]", "[dusk]")), HasSubstr("'night' is missing"));
    EXPECT_THAT(error_of(replaced("value_large = 1.25", "value_large = 3")), StartsWith("own.toml:"));
    EXPECT_THAT(error_of(replaced("value_large = 1.25", "value_large = 1")), HasSubstr("must not be larger than value_large"));
    EXPECT_THAT(error_of(replaced("label = 0.8", "label = 1.2")), HasSubstr("must not be larger than value"));
    EXPECT_THAT(error_of(replaced("[\"engaged\", \"reference\"]", "[\"engaged\", \"engaged\"]")), HasSubstr("one role twice"));
    EXPECT_THAT(error_of(replaced("[\"engaged\", \"reference\"]", "[\"engaged\", \"rim\"]")), HasSubstr("must name two of"));
    EXPECT_THAT(error_of(replaced("[\"engaged\", \"reference\"]", "[\"engaged\"]")), HasSubstr("must name two of"));
    EXPECT_THAT(error_of(replaced("name = \"standard\"", "name = \"\"")), HasSubstr("'name'"));
    EXPECT_THAT(error_of("name = [\n"), StartsWith("own.toml:"));
}

}  // namespace
}  // namespace tedavis::design::test_symbology_palette
