#include "render_core/effects/device.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/files/device_files.hpp"

namespace tedavis::effects::test_device {
namespace {

using test_support::shipped_device;
using test_support::source_file;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string good() { return source_file("configs/devices/es2-small.toml"); }

/// The sentence that a text is refused with; empty when it is accepted.
std::string refusal(const std::string& text) {
    const auto device = read_device_settings(text, "x.toml");
    return device.ok() ? "" : std::string(device.error().message.view());
}

TEST(Device, ShippedFilesLoadWithTheirNames) {
    for (const char* name : {"es2-small", "es3-mid", "desktop", "sc2"}) EXPECT_EQ(shipped_device(name).name.view(), name);
}

TEST(Device, ShippedFilesSayWhatTheDesignSays) {
    const DeviceSettings small = shipped_device("es2-small");
    EXPECT_EQ(small.capability.lane, Lane::es2);
    EXPECT_EQ(small.capability.gl.calls, CallClass::es2);
    EXPECT_EQ(small.triangle_budget, 60'000u);
    EXPECT_EQ(small.width_px, 640u);
    EXPECT_EQ(small.height_px, 480u);
    EXPECT_TRUE(small.capability.depth24_targets);
    EXPECT_LE(small.budget.total(base::MemoryKind::cpu) + small.budget.total(base::MemoryKind::gpu), std::uint64_t{64} << 20)
        << "the whole table, not only what is in use";
    const DeviceSettings mid = shipped_device("es3-mid");
    EXPECT_EQ(mid.capability.lane, Lane::es3);
    EXPECT_EQ(mid.triangle_budget, 250'000u);
    EXPECT_EQ(mid.width_px, 1024u);
    EXPECT_EQ(mid.height_px, 768u);
    EXPECT_EQ(mid.frame_rate_hz, 30.0);
    EXPECT_EQ(shipped_device("desktop").triangle_budget, 600'000u);
    const DeviceSettings sc2 = shipped_device("sc2");
    EXPECT_EQ(sc2.capability.lane, Lane::es2);
    EXPECT_EQ(sc2.capability.gl.calls, CallClass::sc2);
    EXPECT_FALSE(sc2.capability.depth24_targets);
}

TEST(Device, ForbidsEffectsByName) {
    const auto with = [](const std::string& names) {
        return replaced(good(), "[gl]", "[effects]\nforbid = [" + names + "]\n\n[gl]");
    };
    const auto device = read_device_settings(with("\"silhouettes\", \"haze\""), "x.toml");
    ASSERT_TRUE(device.ok());
    EXPECT_TRUE(device.value().forbidden.has(Effect::silhouettes));
    EXPECT_TRUE(device.value().forbidden.has(Effect::haze));
    EXPECT_FALSE(device.value().forbidden.has(Effect::drape));
    EXPECT_NE(refusal(with("\"aurora\"")).find("no effect has this name"), std::string::npos);
    EXPECT_NE(refusal(with("\"warning_colors\"")).find("always stands"), std::string::npos);
}

TEST(Device, AffordsAntialiasingWhereItsFileSaysSo) {
    EXPECT_TRUE(shipped_device("desktop").affords_antialiasing);
    for (const char* board : {"es2-small", "es3-mid", "sc2"}) EXPECT_FALSE(shipped_device(board).affords_antialiasing) << board;
    const std::string desktop = source_file("configs/devices/desktop.toml"), key = "affords_antialiasing = true";
    const auto with = [&](const std::string& other) { return refusal(replaced(desktop, key, other)); };
    EXPECT_EQ(with(key), "") << "a control";
    EXPECT_NE(with("affords_antialiasing = \"yes\"").find("'affords_antialiasing' must be true or false"), std::string::npos);
    EXPECT_NE(with(key + "\nforbid = [\"antialiasing\"]").find("'affords_antialiasing' is beside a 'forbid'"), std::string::npos);
    const std::string needs = "'affords_antialiasing' needs calls = \"es3\" and off_screen_pictures = 2";
    EXPECT_NE(refusal(replaced(desktop, "off_screen_pictures = 2", "off_screen_pictures = 1")).find(needs), std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "[gl]", "[effects]\n" + key + "\n\n[gl]")).find(needs), std::string::npos);
}

TEST(Device, NamesFaultsOfDriversThatItIgnores) {
    const auto with = [](const std::string& names) { return replaced(good(), "[gl]", "[gl]\nignore_faults = [" + names + "]"); };
    const auto device = read_device_settings(with("\"adreno-program-binaries\""), "x.toml");
    ASSERT_TRUE(device.ok());
    ASSERT_EQ(device.value().capability.gl.ignored_faults.size(), 1u);
    EXPECT_EQ(device.value().capability.gl.ignored_faults[0].view(), "adreno-program-binaries");
    EXPECT_TRUE(shipped_device("es2-small").capability.gl.ignored_faults.empty());
    EXPECT_NE(refusal(with("\"" + std::string(40, 'x') + "\"")).find("at most 31 letters"), std::string::npos);
    EXPECT_NE(refusal(with("\"a\", \"b\", \"c\", \"d\", \"e\"")), "");
}

TEST(Device, ShippedBudgetsHoldTheirOwnPictureAndChunks) {
    for (const char* name : {"es2-small", "es3-mid", "desktop", "sc2"}) {
        const DeviceSettings device = shipped_device(name);
        const std::uint64_t color_and_depth = std::uint64_t{8} * device.width_px * device.height_px;
        EXPECT_GE(device.budget.find(kRenderTargets)->bytes, color_and_depth) << name;
        constexpr std::uint64_t kChunkVertices = 65 * 65, kChunkTriangles = 64 * 64 * 2;
        EXPECT_GE(device.budget.find(kTerrainVertices)->bytes, device.max_chunk_slots * kChunkVertices * 12) << name;
        EXPECT_GE(device.budget.find(kTerrainIndices)->bytes, device.max_chunk_slots * kChunkTriangles * 6) << name;
        EXPECT_GE(device.capability.gl.max_texture_px, device.width_px) << name;
        EXPECT_GE(device.drape_pages, 49u) << name;
        EXPECT_GE(device.budget.find(kTerrainDrape)->bytes, device.drape_pages * std::uint64_t{129} * 129 * 4) << name;
        EXPECT_GE(device.budget.find(kTerrainDrapePages)->bytes, device.drape_pages * std::uint64_t{129} * 129 * 4) << name;
        for (const base::BudgetLine& line : device.budget.lines()) {
            EXPECT_EQ(line.use.capacity, line.bytes);
            EXPECT_FALSE(line.owner.empty());
            EXPECT_FALSE(line.reason.empty());
        }
    }
}

TEST(Device, RefusalsNameTheFileTheLineAndTheKey) {
    EXPECT_EQ(refusal(good()), "");
    const std::string text = refusal(replaced(good(), "width_px = 640", "width_px = 6"));
    EXPECT_NE(text.find("x.toml:3: 'width_px'"), std::string::npos) << text;
}

TEST(Device, MissingParts) {
    EXPECT_NE(refusal(replaced(good(), "frame_rate_hz = 30\n", "")).find("frame_rate_hz"), std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "[gl]", "[lg]")).find("[gl]"), std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "name = \"font_atlas\"", "name = \"other\"")).find("'font_atlas' of kind \"gpu\""),
              std::string::npos);
    EXPECT_NE(refusal("").find("x.toml"), std::string::npos);
}

TEST(Device, WrongValues) {
    EXPECT_NE(refusal(replaced(good(), "lane = \"es2\"", "lane = \"es4\"")).find("one of: es2, es3"), std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "lane = \"es2\"", "lane = \"es3\"")).find("needs calls 'es3'"), std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "frame_rate_hz = 30", "frame_rate_hz = nan")).find("frame_rate_hz"), std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "triangle_budget = 60000", "triangle_budget = -1")).find("triangle_budget"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(good(), "name = \"font_atlas\"", "name = \"symbology\"")).find("is there already"),
              std::string::npos);
    EXPECT_NE(refusal(good() + "colour = 3\n").find("colour"), std::string::npos) << "an unknown key";
}

TEST(Device, MayHaveRoomForTracedTerrain) {
    const auto with = [](const char* name, const char* kind) {
        return good() + "\n[[budget]]\nname = \"" + name + "\"\nkind = \"" + kind +
               "\"\nbytes = 5000\nowner = \"draw\"\nreason = \"x\"\n";
    };
    EXPECT_EQ(refusal(with("traced_terrain", "cpu")), "");
    const std::string without_edges = replaced(good(), "name = \"picture_edges\"", "name = \"other\"");
    EXPECT_EQ(refusal(without_edges), "") << "nor does every device measure clutter";
    EXPECT_NE(refusal(replaced(good(), "name = \"picture_edges\"\nkind = \"cpu\"", "name = \"picture_edges\"\nkind = \"gpu\""))
                  .find("'picture_edges' of kind \"cpu\""),
              std::string::npos);
    EXPECT_NE(refusal(with("traced_terrain", "gpu")).find("'traced_terrain' of kind \"cpu\""), std::string::npos);
    EXPECT_NE(refusal(with("traced_pictures", "cpu")).find("'traced_pictures' of kind \"gpu\""), std::string::npos);
    for (const char* name : {"es3-mid", "desktop"}) {
        const DeviceSettings device = shipped_device(name);
        EXPECT_GE(device.budget.find(kTracedPictures)->bytes, std::uint64_t{20} * device.width_px * device.height_px) << name;
    }
    EXPECT_EQ(shipped_device("es2-small").budget.find(kTracedTerrain), nullptr);
}

TEST(Device, ARequiredLineOfTheOtherKindIsMissing) {
    const std::string wrong_kind =
        replaced(good(), "name = \"font_atlas\"\nkind = \"gpu\"", "name = \"font_atlas\"\nkind = \"cpu\"");
    EXPECT_NE(refusal(wrong_kind).find("'font_atlas' of kind \"gpu\""), std::string::npos);
}

TEST(Device, MayHaveADeadline) {
    const auto with = read_device_settings("deadline_ms = 33.0\n" + good(), "x.toml");
    ASSERT_TRUE(with.ok()) << with.error().message.c_str();
    EXPECT_EQ(with.value().deadline_ms, 33);
    EXPECT_EQ(shipped_device("es2-small").deadline_ms, 0) << "none unless it is stated";
    EXPECT_NE(refusal("deadline_ms = -1\n" + good()).find("deadline_ms"), std::string::npos);
}

TEST(Device, CallExceptionsAreRead) {
    const std::string text = replaced(
        good(), "calls = \"es2\"", "calls = \"es2\"\nalso = [\"DrawRangeElements\"]\nnever = [\"GenerateMipmap\", \"Finish\"]");
    const auto device = read_device_settings(text, "x.toml");
    ASSERT_TRUE(device.ok()) << device.error().message.c_str();
    EXPECT_EQ(device.value().capability.gl.also[0].view(), "DrawRangeElements");
    EXPECT_EQ(device.value().capability.gl.never.size(), 2u);
    EXPECT_NE(refusal(replaced(good(), "calls = \"es2\"", "calls = \"es2\"\nalso = [\"\"]")).find("GL call's name"),
              std::string::npos);
}

}  // namespace
}  // namespace tedavis::effects::test_device
