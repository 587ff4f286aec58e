#include "render_core/effects/calibration.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace tedavis::effects::test_calibration {
namespace {

/// Each cost tells its line and its place in it.
std::string good() {
    std::ostringstream text;
    text << "device = \"es3-mid\"\nrenderer = \"llvmpipe\"\nwidth_px = 1024\nheight_px = 768\ndate = \"2026-11-22T22:57:48Z\"\n";
    int n = 0;
    const auto line = [&](std::string_view name) {
        ++n;
        text << "[cost." << name << "]\nfixed_ms = " << n << "\nms_per_megapixel = " << n << ".25\nms_per_thousand = " << n
             << ".5\n";
    };
    for (std::size_t e = 0; e < kEffectCount; ++e) line(row_of(static_cast<Effect>(e)).name);
    for (const std::string_view name : kOverheadNames) line(name);
    return text.str() +
           "[[quality]]\ntau_factor = 1\ndetail_factor = 1\ngiven_up = []\nms = 40\nerror_px = 1\nerror_color = 0\n" +
           "[[quality]]\ntau_factor = 2\ndetail_factor = 0.5\ngiven_up = [\"antialiasing\", \"silhouettes\"]\nms = 20\n"
           "error_px = 2.25\nerror_color = 0.75\n";
}

const CalibrationSubject kSubject{"es3-mid", "llvmpipe", 1024, 768};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text) {
    const auto read = read_calibration(text, "c.toml", kSubject);
    return read.ok() ? "" : std::string(read.error().message.view());
}

TEST(Calibration, IsReadWhole) {
    const auto read = read_calibration(good(), "c.toml", kSubject);
    ASSERT_TRUE(read.ok()) << read.error().message.c_str();
    const Calibration& c = read.value();
    EXPECT_TRUE(c.costs.is_known);
    EXPECT_EQ(c.date.view(), "2026-11-22T22:57:48Z");
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        EXPECT_EQ(c.costs.effects[n].fixed_ms, static_cast<double>(n + 1));
        EXPECT_EQ(c.costs.effects[n].ms_per_megapixel, static_cast<double>(n + 1) + 0.25);
        EXPECT_EQ(c.costs.effects[n].ms_per_thousand, static_cast<double>(n + 1) + 0.5);
    }
    EXPECT_EQ(c.costs.overheads[kOverheads - 1].fixed_ms, static_cast<double>(kEffectCount + kOverheads));
}

TEST(Calibration, HasTheMeasuredLevels) {
    const auto read = read_calibration(good(), "c.toml", kSubject);
    ASSERT_TRUE(read.ok()) << read.error().message.c_str();
    const QualityLevels& levels = read.value().quality;
    ASSERT_EQ(levels.count, 2u);
    EXPECT_TRUE(levels.at[0].given_up.is_empty());
    const QualityLevel& level = levels.at[1];
    EXPECT_EQ(level.tau_factor, 2);
    EXPECT_EQ(level.detail_factor, 0.5);
    EXPECT_EQ(level.ms, 20);
    EXPECT_EQ(level.error_px, 2.25);
    EXPECT_EQ(level.error_color, 0.75);
    for (std::size_t e = 0; e < kEffectCount; ++e) {
        const auto effect = static_cast<Effect>(e);
        EXPECT_EQ(level.given_up.has(effect), effect == Effect::antialiasing || effect == Effect::silhouettes);
    }
}

TEST(Calibration, WithoutLevelsItMustBeMeasuredAnew) {
    const std::string text = good();
    const std::string message = refusal(text.substr(0, text.find("[[quality]]")));
    EXPECT_NE(message.find("the quality levels are missing; measure it anew with `tedavis calibrate`"), std::string::npos)
        << message;
    std::string seven = text;
    for (int n = 0; n < 5; ++n) seven += text.substr(text.rfind("[[quality]]"));
    EXPECT_NE(refusal(seven).find("at most 6 quality levels"), std::string::npos) << refusal(seven);
}

/// Forged files: each would trade what may not be traded, or offer a level that is never right.
TEST(Calibration, ForgedLevelsAreRefusedWithTheirLine) {
    for (const std::string name : {"terrain", "warning_colors", "ground_data", "adjacent", "haze", "vertical_lines"}) {
        const std::string message = refusal(replaced(good(), "\"silhouettes\"]", "\"" + name + "\"]"));
        EXPECT_NE(message.find("'" + name + "' may not be given up for time"), std::string::npos) << message;
        EXPECT_EQ(message.find("c.toml:"), 0u) << message;
    }
    EXPECT_NE(refusal(replaced(good(), "\"silhouettes\"]", "\"symbology\"]")).find("'symbology' is no effect"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "\nms = 20", "\nms = 41")).find("of two quality levels one is at least as accurate"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "tau_factor = 1\n", "tau_factor = 1.5\n")).find("the design's own picture"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "error_px = 2.25", "error_px = -1")).find("error_px"), std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "tau_factor = 2\n", "tau_factor = 2\npixels = 3\n")).find("unknown key"),
              std::string::npos);
}

TEST(Calibration, OfAnotherDeviceRendererOrSizeIsRefusedInOneSentence) {
    EXPECT_EQ(refusal(good()), "");
    const std::string device = refusal(replaced(good(), "es3-mid", "desktop"));
    EXPECT_NE(device.find("c.toml:1"), std::string::npos) << device;
    EXPECT_NE(device.find("measured for 'desktop', not for 'es3-mid'"), std::string::npos) << device;
    EXPECT_NE(refusal(replaced(good(), "llvmpipe", "Vivante")).find("'Vivante', not for 'llvmpipe'"), std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "1024", "640")).find("another size"), std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "768", "480")).find("tedavis calibrate"), std::string::npos);
    EXPECT_TRUE(read_calibration(replaced(good(), "es3-mid", "desktop"), "c.toml").ok()) << "nobody asked for whom";
}

TEST(Calibration, ThatLacksACostIsRefused) {
    for (const std::string name : {"haze", "terrain", "adjacent", "frame", "glyphs"}) {
        const std::string message = refusal(replaced(good(), "[cost." + name + "]", "[other." + name + "]"));
        EXPECT_NE(message.find("the cost of '" + name + "' is missing"), std::string::npos) << message;
    }
    EXPECT_NE(refusal("device = \"es3-mid\"\nrenderer = \"llvmpipe\"\nwidth_px = 1024\nheight_px = 768\n").find("is missing"),
              std::string::npos);
    EXPECT_NE(refusal("").find("device"), std::string::npos);
}

TEST(Calibration, CostsAreNumbersFromZeroOn) {
    for (const char* const wrong : {"-0.5", "nan", "inf", "\"2\""})
        EXPECT_NE(refusal(replaced(good(), "fixed_ms = 1\n", std::string("fixed_ms = ") + wrong + "\n")).find("fixed_ms"),
                  std::string::npos)
            << wrong;
    EXPECT_NE(refusal(replaced(good(), "[cost.haze]", "[cost.haze]\nms = 3")).find("unknown key"), std::string::npos);
}

}  // namespace
}  // namespace tedavis::effects::test_calibration
