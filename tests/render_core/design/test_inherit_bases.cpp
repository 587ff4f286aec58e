#include "render_core/design/inherit_bases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "render_core/design/design_settings.hpp"

namespace tedavis::design::test_inherit_bases {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Designs by name, and the one palette "grey" that names who asked for it.
class Files final : public DesignSource {
public:
    explicit Files(std::map<std::string, std::string> texts) : texts_(std::move(texts)) {}
    base::Result<Palette, base::Error> find(const base::StatedFile& palette) override {
        palette_stated_in = std::string(palette.stated_in);
        return alpine_palette();
    }
    base::Result<DesignText, base::Error> find_design(const base::StatedFile& design) override {
        const auto found = texts_.find(std::string(design.name));
        if (found == texts_.end()) return base::fail(base::Error{"no design is called so"});
        return DesignText{found->second, found->first};
    }
    std::string palette_stated_in;

private:
    std::map<std::string, std::string> texts_;
};

struct Outcome {
    DesignSettings design;
    std::string fault, palette_stated_in;
    std::size_t phases = 0;
};
Outcome read(const std::string& text, const std::map<std::string, std::string>& bases) {
    Files files(bases);
    NamedPhases phases;
    const auto design = read_design_settings(text, "d.toml", files, &phases);
    if (!design.ok()) return {{}, std::string(design.error().message.view()), "", 0};
    return {design.value(), "", files.palette_stated_in, phases.size()};
}

TEST(InheritBases, WhatADesignDoesNotSayIsItsBases) {
    const Outcome both = read("name = 'd'\nbased_on = 'b'\n[terrain]\ntau_px = 3\n",
                              {{"b", "name = 'b'\n[view]\ndpi = 120\n[terrain]\ntau_px = 5\npalette = 'grey'\n"}});
    ASSERT_EQ(both.fault, "");
    EXPECT_EQ(both.design.name.view(), "d");
    EXPECT_EQ(both.design.terrain.tau_px, 3);
    EXPECT_EQ(both.design.view.dpi, 120);
    EXPECT_EQ(both.palette_stated_in, "b") << "its path is found from there";
    const Outcome alone = read("name = 'd'\n[terrain]\ntau_px = 3\n", {});
    EXPECT_NE(alone.design.view.dpi, 120) << "the control";
}

TEST(InheritBases, ASpacingTakesThePlaceOfAnInheritedOneInAnotherUnit) {
    const std::map<std::string, std::string> bases = {
        {"b", "name = 'b'\n[terrain.grid]\nspacing_arcmin = 1\ncolor = '#102030'\n"}};
    const Outcome miles = read("name = 'd'\nbased_on = 'b'\n[terrain.grid]\nspacing_nm = 1\n", bases);
    ASSERT_EQ(miles.fault, "");
    EXPECT_EQ(miles.design.terrain.style.grid.spacing_m, 1852);
    EXPECT_FALSE(miles.design.terrain.style.grid.is_angular());
    EXPECT_EQ(miles.design.terrain.style.grid.line, (Color{0x10, 0x20, 0x30})) << "what it does not state stays";
    const Outcome none = read("name = 'd'\nbased_on = 'b'\n[terrain.grid]\nstrength = 0\n", bases);
    EXPECT_EQ(none.fault, "");
    EXPECT_FALSE(none.design.terrain.style.grid.is_shown());
    EXPECT_TRUE(read("name = 'd'\nbased_on = 'b'\n", bases).design.terrain.style.grid.is_angular()) << "the control";
}

TEST(InheritBases, ABaseMayBeBasedOnAnother) {
    const Outcome all = read("name = 'd'\nbased_on = 'b'\n", {{"b", "name = 'b'\nbased_on = 'c'\n[view]\ndpi = 120\n"},
                                                              {"c", "name = 'c'\n[view]\ndpi = 200\nmode = 'map'\n"}});
    ASSERT_EQ(all.fault, "");
    EXPECT_EQ(all.design.view.dpi, 120) << "the nearest one counts";
    EXPECT_EQ(all.design.view.mode, ViewMode::map);
}

TEST(InheritBases, ElementsAreFoundByName) {
    const std::string base =
        "name = 'b'\n[[data.element]]\nname = 'ways'\nrole = 'trajectory'\ntechnique = 'tube'\nsize_m = 60\n"
        "[[data.element]]\nrole = 'place'\ntechnique = 'billboard'\n";
    const Outcome named = read("name = 'd'\nbased_on = 'b'\n[[data.element]]\nname = 'ways'\nghost = 0.5\n", {{"b", base}});
    ASSERT_EQ(named.fault, "");
    ASSERT_EQ(named.design.data.elements.size(), 2u);
    EXPECT_EQ(named.design.data.elements[0].size_m, 60);
    EXPECT_EQ(named.design.data.elements[0].ghost, 0.5);
    const Outcome unnamed = read("name = 'd'\nbased_on = 'b'\n[[data.element]]\nrole = 'road'\n", {{"b", base}});
    ASSERT_EQ(unnamed.design.data.elements.size(), 1u) << "a list without names is the whole list";
    EXPECT_EQ(read("name = 'd'\nbased_on = 'b'\n[data]\nelement = []\n", {{"b", base}}).design.data.elements.size(), 0u);
    EXPECT_THAT(read(base + "[[data.element]]\nname = 'ways'\nrole = 'road'\n", {}).fault,
                StartsWith("d.toml:11: 'name' is taken by another element"));
}

TEST(InheritBases, NameAndPhasesAreEachDesignsOwn) {
    const std::string base = "name = 'b'\n[phases]\ncruise = 'c'\n[view]\ndpi = 120\n";
    const Outcome without = read("name = 'd'\nbased_on = 'b'\n", {{"b", base}});
    EXPECT_EQ(without.fault, "");
    EXPECT_EQ(without.phases, 0u);
    EXPECT_EQ(read("name = 'd'\nbased_on = 'b'\n[phases]\ntakeoff = 'x'\n", {{"b", base}}).phases, 1u);
    EXPECT_EQ(read(base, {}).phases, 1u) << "the control";
    EXPECT_THAT(read("based_on = 'b'\n", {{"b", base}}).fault, HasSubstr("key 'name' is missing"));
}

TEST(InheritBases, FaultsNameTheFileThatIsWrong) {
    const std::string head = "name = 'd'\n\nbased_on = 'b'\n";
    EXPECT_EQ(read(head, {}).fault, "d.toml:3: no design is called so");
    EXPECT_EQ(read("name = 'd'\nbased_on = 7\n", {}).fault, "d.toml:2: 'based_on' must be a text in quotes");
    EXPECT_EQ(read(head, {{"b", "name = 'b'\nbased_on = 'c'\n"}}).fault, "b:2: no design is called so");
    EXPECT_EQ(read(head, {{"b", "name = 'b'\n[view]\nzoom = 2\n"}}).fault, "b:3: unknown key 'view.zoom'; correct or remove it");
    EXPECT_THAT(read(head, {{"b", "name = 'b'\n[view]\ndpi = 5\n"}}).fault, StartsWith("b:3: 'dpi' must be a number"));
    EXPECT_EQ(read(head + "[view]\ndpi = 96\n", {{"b", "name = 'b'\n[view]\ndpi = 5\n"}}).fault, "") << "never read";
    EXPECT_THAT(read(head, {{"b", "name = 'b\n"}}).fault, StartsWith("b:1: "));
}

TEST(InheritBases, ACircleIsRefused) {
    const std::map<std::string, std::string> circle{{"b", "name = 'b'\nbased_on = 'c'\n"},
                                                    {"c", "name = 'c'\n\nbased_on = 'b'\n"}};
    EXPECT_THAT(read("name = 'd'\nbased_on = 'b'\n", circle).fault,
                StartsWith("c:3: 'based_on' names a design that is itself based on this one"));
    EXPECT_THAT(read("name = 'd'\nbased_on = 'd.toml'\n", {{"d.toml", "name = 'd'\n"}}).fault,
                StartsWith("d.toml:2: 'based_on'"));
}

TEST(InheritBases, AChainHasAnEnd) {
    std::map<std::string, std::string> chain;
    for (std::size_t n = 1; n <= kMaxBases; ++n)
        chain[std::to_string(n)] =
            "name = 'x'\n" + (n < kMaxBases ? "based_on = '" + std::to_string(n + 1) + "'\n" : "[view]\ndpi = 77\n");
    const std::string first = "name = 'd'\nbased_on = '1'\n";
    const Outcome whole = read(first, chain);
    EXPECT_EQ(whole.fault, "");
    EXPECT_EQ(whole.design.view.dpi, 77);
    chain["8"] = "name = 'x'\nbased_on = '9'\n";
    chain["9"] = "name = 'x'\n";
    EXPECT_EQ(read(first, chain).fault, "8:2: 'based_on' is one base too many; at most 8 stand behind a design");
}

}  // namespace
}  // namespace tedavis::design::test_inherit_bases
