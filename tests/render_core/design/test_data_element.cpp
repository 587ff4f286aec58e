#include "render_core/design/data_element.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/design/data_style.hpp"
#include "tests/support/display/grey_palettes.hpp"

namespace tedavis::design::test_data_element {
namespace {

struct Read {
    DataElementList elements;
    std::string fault;
};
Read read(const std::string& text) {
    test_support::GreyPalettes palettes;
    base::ConfigReader reader(text, "d.toml");
    Read result;
    base::ConfigSection data = reader.root().section("data");
    read_data_elements(data, palettes, result.elements);
    if (!reader.finish()) result.fault = std::string(reader.error().message.view());
    return result;
}

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int n = 0; n < times; ++n) all += text;
    return all;
}

TEST(DataElement, EveryKeyIsRead) {
    const Read whole = read(R"([[data.element]]
layer = "tracks"
technique = "spheres"
color = "#102030"
attribute = "cross_wind"
palette = "grey"
classes = 4
second_attribute = "wind_speed"
second_palette = "grey"
second_breaks = [5, 9]
size_attribute = "fuel"
size_m = 120
heights_m = [1000, 2000.5]
heights_over_ground = true
levels = [30]
opacity = 0.5
ghost = 0.25
halo_px = 1.5
link = true
detail = 0.75
[data.element.uncertainty]
technique = "widening"
strength = 0.4
levels = 3
)");
    EXPECT_EQ(whole.fault, "");
    ASSERT_EQ(whole.elements.size(), 1u);
    const DataElement& element = whole.elements[0];
    EXPECT_EQ(element.layer.view(), "tracks");
    EXPECT_EQ(element.technique, DataTechnique::spheres);
    EXPECT_EQ(element.color, (Color{0x10, 0x20, 0x30}));
    EXPECT_EQ(element.by_color.attribute.view(), "cross_wind");
    EXPECT_EQ(element.by_color.scale.breaks.size(), 3u);
    EXPECT_EQ(element.by_second_color.attribute.view(), "wind_speed");
    ASSERT_EQ(element.by_second_color.scale.breaks.size(), 2u);
    EXPECT_EQ(element.by_second_color.scale.breaks[1], 9);
    EXPECT_EQ(element.size_attribute.view(), "fuel");
    EXPECT_EQ(element.size_m, 120);
    ASSERT_EQ(element.heights_m.size(), 2u);
    EXPECT_EQ(element.heights_m[1], 2000.5);
    EXPECT_TRUE(element.heights_over_ground);
    ASSERT_EQ(element.levels.size(), 1u);
    EXPECT_EQ(element.levels[0], 30);
    EXPECT_EQ(element.opacity, 0.5);
    EXPECT_EQ(element.ghost, 0.25);
    EXPECT_EQ(element.halo_px, 1.5);
    EXPECT_TRUE(element.link);
    EXPECT_EQ(element.detail, 0.75);
    EXPECT_EQ(element.uncertainty, ElementUncertainty::widening);
    EXPECT_EQ(element.uncertainty_strength, 0.4);
    EXPECT_EQ(element.uncertainty_levels, 3u);
}

TEST(DataElement, EveryTechniqueHasItsName) {
    for (std::size_t n = 0; n < kDataTechniques; ++n) {
        const Read one = read("[[data.element]]\nlayer = \"a\"\ntechnique = \"" + std::string(kDataTechniqueNames[n]) + "\"\n");
        EXPECT_EQ(one.fault, "");
        ASSERT_EQ(one.elements.size(), 1u);
        EXPECT_EQ(one.elements[0].technique, static_cast<DataTechnique>(n));
    }
}

TEST(DataElement, LayersAreChosenByNameOrByRole) {
    const Read by_role = read("[[data.element]]\nrole = \"storm_cell\"\n");
    EXPECT_EQ(by_role.fault, "");
    EXPECT_EQ(by_role.elements[0].role, scene::LayerRole::storm_cell);
    EXPECT_TRUE(by_role.elements[0].layer.view().empty());
    EXPECT_NE(read("[[data.element]]\nlayer = \"a\"\nrole = \"place\"\n").fault.find("give one"), std::string::npos);
    EXPECT_NE(read("[[data.element]]\nrole = \"phantom\"\n").fault, "");
}

TEST(DataElement, DashedRimsAreForSigns) {
    for (std::size_t n = 0; n < kDataTechniques; ++n) {
        const std::string name(kDataTechniqueNames[n]);
        const std::string fault = read("[[data.element]]\nlayer = \"a\"\ntechnique = \"" + name +
                                       "\"\n[data.element.uncertainty]\ntechnique = \"dashed_rim\"\n")
                                      .fault;
        EXPECT_EQ(fault.empty(), name == "billboard") << fault;
    }
}

TEST(DataElement, APathwayTakesNoKeysOfTubesAndIsForWhatIsPlanned) {
    const auto fault = [](const std::string& technique, const std::string& keys) {
        return read("[[data.element]]\n" + keys + "technique = \"" + technique + "\"\n").fault;
    };
    const std::string layer = "layer = \"a\"\n";
    for (const std::string key : {"size_attribute = \"speed\"\n", "second_attribute = \"speed\"\nsecond_palette = \"grey\"\n"}) {
        EXPECT_NE(fault("pathway", layer + key).find("'pathway'"), std::string::npos) << fault("pathway", layer + key);
        EXPECT_EQ(fault("tube", layer + key).find("'pathway'"), std::string::npos) << "control";
    }
    EXPECT_NE(fault("pathway", "own = \"trail\"\n").find("is planned"), std::string::npos);
    EXPECT_EQ(fault("tube", "own = \"trail\"\n"), "");
    EXPECT_EQ(fault("pathway", layer + "size_m = 150\nhalo_px = 1\nghost = 0.3\nopacity = 0.9\ndetail = 0.5\n"), "");
}

TEST(DataElement, TheSurfaceGridIsForWhatHasASurface) {
    for (std::size_t n = 0; n < kDataTechniques; ++n) {
        const std::string name(kDataTechniqueNames[n]);
        const Read got = read("[[data.element]]\nlayer = \"a\"\ntechnique = \"" + name + "\"\ngrid = true\n");
        const bool is_surface = name == "tube" || name == "space_time" || name == "prism" || name == "solid" ||
                                name == "ribbon" || name == "isosurface";
        EXPECT_EQ(got.fault.find("d.toml:4: 'grid' is for tubes") != std::string::npos, !is_surface) << name << got.fault;
        EXPECT_EQ(asks_for_grid(got.elements), true) << name;
    }
    EXPECT_FALSE(asks_for_grid(read("[[data.element]]\nlayer = \"a\"\n").elements));
}

TEST(DataElement, LinksAreForWhatFloats) {
    for (std::size_t n = 0; n < kDataTechniques; ++n) {
        const std::string name(kDataTechniqueNames[n]);
        const std::string fault = read("[[data.element]]\nlayer = \"a\"\ntechnique = \"" + name + "\"\nlink = true\n").fault;
        const auto technique = static_cast<DataTechnique>(n);
        const bool stands = technique <= DataTechnique::ribbon || technique == DataTechnique::isosurface;
        EXPECT_EQ(fault.find("'link'") != std::string::npos, stands) << name;
    }
}

TEST(DataElement, TheOwnFlightIsAskedForInsteadOfALayer) {
    const Read own = read("[[data.element]]\nown = \"trail\"\n[[data.element]]\nown = \"wind\"\n");
    EXPECT_EQ(own.fault, "");
    ASSERT_EQ(own.elements.size(), 2u);
    EXPECT_EQ(own.elements[0].own, OwnData::trail);
    EXPECT_EQ(own.elements[1].own, OwnData::wind);
    EXPECT_EQ(subject_of(own.elements[1]).view(), "own wind");
    EXPECT_TRUE(asks_for_own(own.elements));
    const Read others = read("[[data.element]]\nlayer = \"a\"\n[[data.element]]\nrole = \"place\"\n");
    EXPECT_EQ(subject_of(others.elements[0]).view(), "a");
    EXPECT_EQ(subject_of(others.elements[1]).view(), "place");
    EXPECT_EQ(subject_of(DataElement()).view(), "") << "of one that no file has named";
    EXPECT_FALSE(asks_for_own(others.elements));
    EXPECT_NE(read("[[data.element]]\nown = \"trail\"\nlayer = \"a\"\n").fault.find("give one"), std::string::npos);
    EXPECT_NE(read("[[data.element]]\nown = \"none\"\n").fault, "");
}

TEST(DataElement, OtherAircraftAreAskedForByTheirRole) {
    EXPECT_TRUE(asks_for_traffic(read("[[data.element]]\nlayer = \"a\"\n[[data.element]]\nrole = \"traffic\"\n").elements));
    EXPECT_FALSE(asks_for_traffic(read("[[data.element]]\nlayer = \"a\"\n[[data.element]]\nrole = \"place\"\n").elements));
}

TEST(DataElement, KindsAreForWhatStandsForOneThing) {
    const auto fault = [](const std::string& technique, const std::string& more = "") {
        return read("[[data.element]]\nlayer = 'a'\nattribute = 'kind'\npalette = 'kinds'\ntechnique = '" + technique + "'\n" +
                    more)
            .fault;
    };
    for (const char* const technique : {"prism", "solid", "ribbon", "billboard"}) EXPECT_EQ(fault(technique), "") << technique;
    for (const char* const technique : {"spheres", "bars", "arrows", "barbs", "isosurface", "tube", "diagram"})
        EXPECT_NE(fault(technique).find("shows numbers"), std::string::npos) << technique;
    EXPECT_NE(fault("solid", "second_attribute = 'kind'\nsecond_palette = 'kinds'\n").find("tubes show numbers"),
              std::string::npos);
}

TEST(DataElement, OrderIsKept) {
    const Read two = read("[[data.element]]\nlayer = \"a\"\n[[data.element]]\nlayer = \"b\"\n");
    ASSERT_EQ(two.elements.size(), 2u);
    EXPECT_EQ(two.elements[1].layer.view(), "b");
}

TEST(DataElement, FaultsNameTheirKeyAndLine) {
    const std::string one = "[[data.element]]\nlayer = \"a\"\n";
    EXPECT_NE(read("[[data.element]]\n").fault.find("'layer'"), std::string::npos);
    EXPECT_NE(read(one + "technique = \"smoke\"\n").fault.find("d.toml:3"), std::string::npos);
    EXPECT_NE(read(one + "palette = \"grey\"\n").fault.find("name one"), std::string::npos);
    EXPECT_NE(read(one + "attribute = \"x\"\npalette = \"none\"\n").fault.find("no palette"), std::string::npos);
    EXPECT_NE(read(one + "levels = [1, 2, 3, 4, 5]\n").fault.find("too many"), std::string::npos);
    EXPECT_NE(read(one + "[data.element.uncertainty]\nlevels = 1\n").fault.find("2 to 16"), std::string::npos);
    EXPECT_NE(read(one + "heights_over_ground = true\n").fault.find("state them"), std::string::npos);
    EXPECT_NE(read(one + "opasity = 1\n").fault.find("opasity"), std::string::npos);
    EXPECT_NE(read(repeated(one, static_cast<int>(kMaxDataElements) + 1)).fault.find("at most 12"), std::string::npos);
    EXPECT_EQ(read(repeated(one, static_cast<int>(kMaxDataElements))).fault, "");
}

}  // namespace
}  // namespace tedavis::design::test_data_element
