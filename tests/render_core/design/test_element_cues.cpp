#include "render_core/design/element_cues.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/design/data_element.hpp"
#include "tests/support/display/grey_palettes.hpp"

namespace tedavis::design::test_element_cues {
namespace {

struct Read {
    ElementCues cues;
    std::string fault;
};
Read read(const std::string& keys, const std::string& technique = "tube") {
    test_support::GreyPalettes palettes;
    const std::string text = "[[data.element]]\nlayer = 'a'\ntechnique = '" + technique + "'\n[data.element.cues]\n" + keys;
    base::ConfigReader reader(text, "d.toml");
    DataElementList elements;
    base::ConfigSection data = reader.root().section("data");
    read_data_elements(data, palettes, elements);
    Read result;
    if (!reader.finish()) result.fault = std::string(reader.error().message.view());
    if (!elements.empty()) result.cues = elements[0].cues;
    return result;
}

TEST(ElementCues, EveryKeyIsRead) {
    const Read whole = read(R"(line_spacing_nm = 2
lines_to_ground = true
lines_move = "away"
line_speed_mps = 80
projection = 0.6
curtain = 0.3
)");
    EXPECT_EQ(whole.fault, "");
    EXPECT_EQ(whole.cues.line_spacing_m, 3704) << "metres in two nautical miles";
    EXPECT_TRUE(whole.cues.lines_to_ground);
    EXPECT_EQ(whole.cues.lines_move, LineMotion::away);
    EXPECT_EQ(whole.cues.line_speed_mps, 80);
    EXPECT_EQ(whole.cues.projection, 0.6);
    EXPECT_EQ(whole.cues.curtain, 0.3);
    EXPECT_EQ(read("line_spacing_m = 750\n").cues.line_spacing_m, 750);
    EXPECT_FALSE(ElementCues().is_any());
}

TEST(ElementCues, WhatMakesNoSenseIsRefused) {
    const std::string metres = "line_spacing_m = 1000\n";
    EXPECT_NE(read("").fault.find("asks for nothing"), std::string::npos);
    EXPECT_NE(read(metres + "line_spacing_nm = 1\n").fault.find("give one of them"), std::string::npos);
    EXPECT_NE(read("line_spacing_m = 5\n").fault.find("from 50"), std::string::npos);
    EXPECT_NE(read("curtain = 0.3\nlines_to_ground = true\n").fault.find("vertical lines"), std::string::npos);
    EXPECT_NE(read(metres + "lines_move = \"along\"\n").fault.find("line_speed_mps"), std::string::npos);
    EXPECT_NE(read(metres + "line_speed_mps = 10\n").fault.find("lines_move"), std::string::npos);
    EXPECT_NE(read(metres + "lines_move = \"down\"\nline_speed_mps = 10\n").fault, "");
    EXPECT_NE(read("curtain = 1.5\n").fault, "");
    EXPECT_NE(read("shadow = 0.5\ncurtain = 0.5\n").fault.find("shadow"), std::string::npos);
}

TEST(ElementCues, AreForLinesThatFloat) {
    for (std::size_t n = 0; n < kDataTechniques; ++n) {
        const auto technique = static_cast<DataTechnique>(n);
        const bool is_line =
            technique == DataTechnique::tube || technique == DataTechnique::space_time || technique == DataTechnique::ribbon;
        const std::string fault = read("curtain = 0.3\n", std::string(kDataTechniqueNames[n])).fault;
        EXPECT_EQ(fault.empty(), is_line) << kDataTechniqueNames[n] << fault;
    }
    EXPECT_NE(read("projection = 0.3\n", "ribbon").fault.find("lies on the ground"), std::string::npos);
    EXPECT_EQ(read("projection = 0.3\n", "space_time").fault, "");
}

}  // namespace
}  // namespace tedavis::design::test_element_cues
