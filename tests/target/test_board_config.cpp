#include "target/board_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bus/canaerospace/identifier_table.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::target::test_board_config {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kRoot = test_support::source_dir();

/// A board file in a folder of its own, whose first lines name the shipped files.
struct Board {
    test_support::TemporaryFolder folder;
    std::string path = folder.file("board.toml");

    std::string load_text(const std::string& text) {
        folder.write("board.toml", text);
        const auto settings = load_board_settings(path.c_str());
        return settings.ok() ? "" : std::string(settings.error().message.view());
    }
    /// With lines 1 to 5 right; `rest` begins in line 6.
    std::string load_with(const std::string& rest) { return load_text(head() + rest); }
    BoardSettings settings(const std::string& rest) {
        EXPECT_EQ(load_with(rest), "");
        return load_board_settings(path.c_str()).value();
    }
    static std::string head() {
        return "title = 'a board'\ndevice = '" + kRoot + "/configs/devices/es3-mid.toml'\ndesign = '" + kRoot +
               "/configs/designs/approach.toml'\npalettes = '" + kRoot + "/configs/palettes'\nbus = '" + kRoot +
               "/configs/buses/canaerospace.toml'\n";
    }
};

TEST(BoardConfig, ReadsEverySetting) {
    Board board;
    const BoardSettings settings = board.settings(
        "[terrain]\ndatabase = 'data/area.tdb'\n[scene]\ndatabase = 'data/area.sdb'\n[costs]\nfile = "
        "'costs.toml'\n[programs]\nfolder = 'sc2.programs'\n[can]\ninterface = 'can1'\nfd = true\n"
        "filter = false\nreceive_buffer_bytes = 65536\nreopen_s = 2.5\n[switches]\nconfig = '" +
        kRoot +
        "/configs/switches/one_hot.toml'\n[surface]\nbackend = 'osmesa'\nwidth_px = 800\nheight_px = 600\n[display]\nlegend = "
        "'whole'\n[memory]\ntouch = "
        "false\n");
    EXPECT_EQ(settings.title.view(), "a board");
    EXPECT_EQ(settings.device.name.view(), "es3-mid");
    EXPECT_EQ(settings.terrain.view(), board.folder.file("data/area.tdb")) << "found from the board file";
    EXPECT_EQ(settings.scene.view(), board.folder.file("data/area.sdb"));
    EXPECT_EQ(settings.costs.view(), board.folder.file("costs.toml"));
    EXPECT_EQ(settings.programs.view(), board.folder.file("sc2.programs"));
    EXPECT_EQ(settings.can.interface_name.view(), "can1");
    EXPECT_TRUE(settings.can.can_fd);
    EXPECT_TRUE(settings.can.filters.empty());
    EXPECT_EQ(settings.can.receive_buffer_bytes, 65536u);
    EXPECT_EQ(settings.can.reopen_interval, base::Duration::milliseconds(2500));
    EXPECT_TRUE(settings.has_switches);
    EXPECT_EQ(settings.switches.lines.size(), 7u);
    EXPECT_EQ(settings.surface.view(), "osmesa");
    EXPECT_EQ(settings.width_px, 800u);
    EXPECT_EQ(settings.height_px, 600u);
    EXPECT_EQ(settings.legend, flight::LegendShow::whole);
    EXPECT_EQ(settings.residency, platform::Residency::lazy);
}

TEST(BoardConfig, AScreenIsNamedByDriverConnectorAndMode) {
    Board board;
    const BoardSettings settings = board.settings(
        "[can]\ninterface = 'can0'\n[surface]\nbackend = 'kms'\n[screen]\ndriver = 'virtio_gpu'\nconnector = 'HDMI-A-1'\nmode = "
        "'1024x768@60'\n");
    EXPECT_EQ(settings.surface.view(), "kms");
    EXPECT_EQ(settings.screen.driver.view(), "virtio_gpu");
    EXPECT_EQ(settings.screen.connector.view(), "HDMI-A-1");
    EXPECT_EQ(settings.screen.mode.width_px, 1024u);
    EXPECT_EQ(settings.screen.mode.refresh_mhz, 60000u);
    const BoardSettings bare = board.settings("[can]\ninterface = 'can0'\n[surface]\nbackend = 'kms'\n");
    EXPECT_TRUE(bare.screen.driver.empty() && bare.screen.path.empty() && bare.screen.connector.empty());
    EXPECT_TRUE(bare.screen.mode.is_preferred());
    const BoardSettings by_path = board.settings(
        "[can]\ninterface = 'can0'\n[surface]\nbackend = 'kms'\n[screen]\npath = '/dev/dri/by-path/platform-gpu-card'\n");
    EXPECT_EQ(by_path.screen.path.view(), "/dev/dri/by-path/platform-gpu-card");
}

TEST(BoardConfig, DefaultsAreThoseOfADisplay) {
    Board board;
    const BoardSettings settings = board.settings("[can]\ninterface = 'can0'\n");
    EXPECT_TRUE(settings.terrain.empty());
    EXPECT_TRUE(settings.records.empty());
    EXPECT_FALSE(settings.has_switches);
    EXPECT_EQ(settings.surface.view(), "egl");
    EXPECT_EQ(settings.legend, flight::LegendShow::key);
    EXPECT_EQ(settings.width_px, settings.device.width_px);
    EXPECT_EQ(settings.height_px, settings.device.height_px);
    EXPECT_EQ(settings.residency, platform::Residency::touched);
    EXPECT_FALSE(settings.can.filters.empty());
}

struct Fault {
    const char* rest;
    int line;
    const char* says;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << "line " << fault.line << ": " << fault.says; }
class BoardFault : public ::testing::TestWithParam<Fault> {};

TEST_P(BoardFault, IsNamedWithFileAndLine) {
    Board board;
    const std::string message = board.load_with(GetParam().rest);
    EXPECT_THAT(message, StartsWith(board.path + ":" + std::to_string(GetParam().line) + ": "));
    EXPECT_THAT(message, HasSubstr(GetParam().says));
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one sentence";
}

INSTANTIATE_TEST_SUITE_P(
    Each, BoardFault,
    ::testing::Values(
        Fault{"[can]\ninterface = 7\n", 7, "interface"}, Fault{"[can]\ninterface = ''\n", 7, "1 to 15 bytes"},
        Fault{"[can]\ninterface = 'a_very_long_interface'\n", 7, "1 to 15 bytes"},
        Fault{"[can]\ninterface = 'can0'\nreopen_s = 0\n", 8, "reopen_s"},
        Fault{"[can]\ninterface = 'can0'\nreceive_buffer_bytes = 1\n", 8, "receive_buffer_bytes"},
        Fault{"[can]\ninterface = 'can0'\nbitrate = 1000000\n", 8, "bitrate"},
        Fault{"[can]\ninterface = 'can0'\n[surface]\nbackend = 'drm'\n", 9, "kms, osmesa"},
        Fault{"[can]\ninterface = 'can0'\n[screen]\nmode = 'preferred'\n", 8, "backend = \"kms\""},
        Fault{"[surface]\nbackend = 'kms'\n[screen]\nmode = '1024'\n[can]\ninterface = 'can0'\n", 9, "1024x768@60"},
        Fault{"[surface]\nbackend = 'kms'\n[screen]\npath = '/dev/dri/card1'\n[can]\ninterface = 'can0'\n", 9, "by-path"},
        Fault{"[surface]\nbackend = 'kms'\n[screen]\ndriver = 'vc4'\npath = '/dev/dri/by-path/x'\n[can]\ninterface "
              "= 'can0'\n",
              10, "remove one"},
        Fault{"[surface]\nbackend = 'kms'\n[screen]\ndriver = 'a_driver_with_much_too_long_a_name'\n[can]\ninterface "
              "= 'can0'\n",
              9, "too long"},
        Fault{"[surface]\nbackend = 'kms'\n[screen]\ncard = 1\n[can]\ninterface = 'can0'\n", 9, "card"},
        Fault{"[can]\ninterface = 'can0'\n[surface]\nwidth_px = 8\n", 9, "width_px"},
        Fault{"[can]\ninterface = 'can0'\n[surface]\nheight_px = nan\n", 9, "height_px"},
        Fault{"[can]\ninterface = 'can0'\n[terrain]\ndatabase = ''\n", 9, "write its path"},
        Fault{"[can]\ninterface = 'can0'\n[records]\nsocket = ''\n", 9, "write its path"},
        Fault{"[can]\ninterface = 'can0'\n[switches]\nconfig = 'none.toml'\n", 9, "none.toml"},
        Fault{"[can]\ninterface = 'can0'\n[memory]\ntouch = 1\n", 9, "touch"}, Fault{"[can]\ninterface = 'can0'\n[can]\n", 8, ""},
        Fault{"[can\n", 6, ""}));

TEST(BoardConfig, ParametersStandAboveTheDesigns) {
    Board board;
    const std::string can = "[can]\ninterface = 'can0'\n";
    const BoardSettings plain = board.settings(can);
    const BoardSettings above = board.settings(
        can +
        "[parameters]\ntau_px = 7.5\ndeadline_ms = 12\nfoci = ['shape = \"circle\", at = \"place\", place = \"DAVOS\"']\n"
        "[parameters.weights]\nterrain = 0.125\n[replay]\nlog = 'x'\n");
    EXPECT_EQ(above.design.terrain.tau_px, 7.5);
    EXPECT_EQ(above.device.deadline_ms, 12);
    EXPECT_EQ(above.design.foci.size(), plain.design.foci.size() + 1);
    EXPECT_EQ(above.design.priority.weights.of[design::kTerrainAspect], 0.125);
    EXPECT_NE(plain.design.terrain.tau_px, 7.5);
    EXPECT_THAT(board.load_with(can + "[parameters.weights]\nno_such_part = 1\n"), HasSubstr("has no aspect 'no_such_part'"));
}

TEST(BoardConfig, ACanSectionIsNeeded) {
    Board board;
    EXPECT_THAT(board.load_with(""), HasSubstr("interface"));
}

TEST(BoardConfig, FilesThatAreMissingOrWrongAreNamed) {
    Board board;
    EXPECT_THAT(board.load_text("device = 'absent.toml'\ndesign = 'absent.toml'\nbus = 'x'\n[can]\ninterface = 'can0'\n"),
                StartsWith(board.path + ":1: " + board.folder.file("absent.toml") + ": cannot be read"));
    board.folder.write("bad.toml", "name = 'bad'\ncolour = 'blue'\n");
    EXPECT_THAT(board.load_text("device = '" + kRoot + "/configs/devices/es3-mid.toml'\ndesign = 'bad.toml'\nbus = '" + kRoot +
                                "/configs/buses/canaerospace.toml'\n[can]\ninterface = 'can0'\n"),
                StartsWith(board.folder.file("bad.toml") + ":2: "))
        << "a fault inside a named file is reported there";
    EXPECT_THAT(board.load_text("device = ''\n"), StartsWith(board.path + ":1: "));
    EXPECT_THAT(board.load_text("device = '" + std::string(2000, 'd') + "'\n"), HasSubstr("use a shorter one"));
    EXPECT_THAT(std::string(load_board_settings("/nowhere/board.toml").error().message.view()), HasSubstr("/nowhere/board.toml"));
}

TEST(BoardConfig, TheShippedExamplesAreRight) {
    const auto desk = load_board_settings((kRoot + "/target/boards/desk_vcan.toml").c_str());
    ASSERT_TRUE(desk.ok()) << desk.error().message.view();
    EXPECT_EQ(desk.value().can.interface_name.view(), "vcan0");

    // The board's example names its neighbours in /etc/tedavis: put them beside it as the README says.
    const test_support::TemporaryFolder folder;
    for (const char* file : {"configs/devices/es2-small.toml", "configs/buses/canaerospace.toml", "configs/switches/one_hot.toml",
                             "target/boards/arm_board.toml"})
        std::filesystem::copy(kRoot + "/" + file, folder.path());
    for (const char* design : {"default", "takeoff", "cruise", "approach", "replanning"})
        std::filesystem::copy(kRoot + "/configs/designs/" + design + ".toml", folder.path());
    for (const auto& palette : std::filesystem::directory_iterator(kRoot + "/configs/palettes"))
        std::filesystem::copy(palette.path(), folder.path());
    const auto board = load_board_settings(folder.file("arm_board.toml").c_str());
    ASSERT_TRUE(board.ok()) << board.error().message.view();
    EXPECT_TRUE(board.value().has_switches);
    EXPECT_EQ(board.value().phases.size(), 4u);
    EXPECT_EQ(board.value().phases.at(board.value().phases.place_of(flight::kGoAroundReplanning)).name.view(), "replanning");
    EXPECT_EQ(board.value().terrain.view(), "/var/lib/tedavis/area.tdb");
}

TEST(BoardConfig, AnAircraftFileMayBeNamed) {
    Board board;
    const std::string can = "[can]\ninterface = 'can0'\n";
    EXPECT_FALSE(board.settings(can).aircraft.is_stated());
    EXPECT_EQ(board.settings("aircraft = '" + kRoot + "/configs/aircraft/jet.toml'\n" + can).aircraft.name.view(), "jet");
    EXPECT_THAT(board.load_with("aircraft = 'none.toml'\n" + can), StartsWith(board.path + ":6: "));
    board.folder.write("own.toml", "name = 'own'\n[speeds]\nvne = 160\n");
    EXPECT_THAT(board.load_with("aircraft = 'own.toml'\n" + can),
                StartsWith(board.folder.file("own.toml") + ":3: 'vne' has no unit"));
}

TEST(BoardConfig, StatesTheSymbologysPaletteAndLight) {
    Board board;
    const std::string can = "[can]\ninterface = 'can0'\n";
    EXPECT_EQ(board.settings(can).symbology.name.view(), "standard");
    EXPECT_EQ(board.settings(can).light, design::SymbologyLight::day);
    EXPECT_EQ(board.settings("light = 'night'\n" + can).light, design::SymbologyLight::night);
    EXPECT_THAT(board.load_with("light = 'dusk'\n" + can), StartsWith(board.path + ":6: "));
    const std::string own = "symbology = '" + kRoot + "/configs/palettes/symbology/standard.toml'\n";
    EXPECT_EQ(board.settings(own + can).symbology.of(design::SymbologyLight::night).colors,
              design::standard_symbology_palettes().of(design::SymbologyLight::night).colors);
    board.folder.write("own.toml", "name = 'own'\n[day]\nscale = 'white'\n");
    EXPECT_THAT(board.load_with("symbology = 'own.toml'\n" + can), StartsWith(board.folder.file("own.toml") + ":3: 'scale'"));
}

TEST(BoardConfig, DesignsOfPhasesLieBesideTheDesignThatNamesThem) {
    Board board;
    const auto with = [&board](const std::string& phases) {
        board.folder.write("own.toml", "name = 'own'\n[phases]\n" + phases);
        return board.load_text("device = '" + kRoot + "/configs/devices/es3-mid.toml'\ndesign = 'own.toml'\nbus = '" + kRoot +
                               "/configs/buses/canaerospace.toml'\n[can]\ninterface = 'can0'\n");
    };
    board.folder.write("low.toml", "name = 'low'\n");
    EXPECT_EQ(with("takeoff = 'low'\napproach = 'low.toml'\n"), "");
    EXPECT_THAT(with("takeoff = 'absent'\n"), HasSubstr(board.folder.file("absent.toml")));
    board.folder.write("low.toml", "name = 'low'\ncolour = 'blue'\n");
    EXPECT_THAT(with("takeoff = 'low'\n"), StartsWith(board.folder.file("low.toml") + ":2: "));
    board.folder.write("low.toml", "name = 'low'\n[phases]\ncruise = 'high'\n");
    EXPECT_THAT(with("takeoff = 'low'\n"), HasSubstr("has a table [phases] itself"));
}

TEST(BoardConfig, BasesOfDesignsLieBesideThem) {
    Board board;
    const auto load = [&board] {
        return board.load_text("device = '" + kRoot + "/configs/devices/es3-mid.toml'\ndesign = 'own.toml'\nbus = '" + kRoot +
                               "/configs/buses/canaerospace.toml'\n[can]\ninterface = 'can0'\n");
    };
    board.folder.write("own.toml", "name = 'own'\nbased_on = 'base'\n[phases]\ncruise = 'high'\n");
    EXPECT_THAT(load(), StartsWith(board.folder.file("own.toml") + ":2: " + board.folder.file("base.toml") + ": cannot be read"));
    board.folder.write("base.toml", "name = 'base'\n[terrain]\ntau_px = 3\n");
    board.folder.write("high.toml", "name = 'high'\nbased_on = 'own'\n[view]\ndpi = 120\n");
    EXPECT_EQ(load(), "") << "high has no phases, though its base has";
    const BoardSettings settings = load_board_settings(board.path.c_str()).value();
    EXPECT_EQ(settings.design.terrain.tau_px, 3);
    EXPECT_EQ(settings.phases.at(1).terrain.tau_px, 3);
    EXPECT_EQ(settings.phases.at(1).view.dpi, 120);
    board.folder.write("base.toml", "name = 'base'\nbased_on = 'own'\n");
    EXPECT_THAT(load(), StartsWith(board.folder.file("base.toml") + ":2: 'based_on' names a design that is itself based on"));
}

TEST(PathBeside, StartsAtTheBoardFilesFolder) {
    EXPECT_EQ(path_beside("a/b/board.toml", "../x.toml").view(), "a/b/../x.toml");
    EXPECT_EQ(path_beside("board.toml", "x.toml").view(), "x.toml");
    EXPECT_EQ(path_beside("/etc/board.toml", "/var/x").view(), "/var/x");
    EXPECT_TRUE(path_beside("a/board.toml", std::string(1023, 'x')).cut());
}

TEST(BusFilters, PassWhatTheDecoderKnowsAndNothingElse) {
    bus::BusSettings bus;
    bus::SocketCanSettings can;
    add_bus_filters(can, bus);
    std::set<std::uint32_t> passed;
    for (std::uint32_t id = 0; id < 0x800; ++id)
        for (const bus::CanFilter& filter : can.filters)
            if ((id & filter.mask) == (filter.identifier & filter.mask)) passed.insert(id);
    std::set<std::uint32_t> known = {128, 1830, 1831};
    for (const bus::IdentifierEntry& entry : bus::identifier_table())
        if (!entry.glider_profile) known.insert(entry.identifier);
    EXPECT_EQ(passed, known);

    bus.traffic.first_identifier = 1840;
    bus::SocketCanSettings with_traffic;
    add_bus_filters(with_traffic, bus);
    const auto passes = [&](std::uint32_t id) {
        for (const bus::CanFilter& filter : with_traffic.filters)
            if ((id & filter.mask) == (filter.identifier & filter.mask)) return true;
        return false;
    };
    EXPECT_TRUE(passes(1840) && passes(1851) && passes(1830));
    EXPECT_FALSE(passes(1839) || passes(1852));
    bus.traffic = {};

    bus::StatedMessage message;
    message.identifier = 1899;
    ASSERT_TRUE(bus.messages.try_push_back(message));
    bus::SocketCanSettings with_message;
    add_bus_filters(with_message, bus);
    EXPECT_TRUE(std::any_of(with_message.filters.begin(), with_message.filters.end(), [](const bus::CanFilter& filter) {
        return (1899 & filter.mask) == (filter.identifier & filter.mask);
    })) << "a message that the bus file states";
    bus.messages = {};

    bus.display.legend_identifier = 1852;
    bus::SocketCanSettings with_legend;
    add_bus_filters(with_legend, bus);
    EXPECT_TRUE(std::any_of(with_legend.filters.begin(), with_legend.filters.end(), [](const bus::CanFilter& filter) {
        return (1852u & filter.mask) == (filter.identifier & filter.mask);
    }));
    bus.display = {};

    bus.guidance.first_identifier = 1832;
    bus::SocketCanSettings with_guidance;
    add_bus_filters(with_guidance, bus);
    const auto passes_guidance = [&](std::uint32_t id) {
        return std::any_of(with_guidance.filters.begin(), with_guidance.filters.end(),
                           [&](const bus::CanFilter& filter) { return (id & filter.mask) == (filter.identifier & filter.mask); });
    };
    EXPECT_TRUE(passes_guidance(1832) && passes_guidance(1839));
    EXPECT_FALSE(passes_guidance(1840));
    bus.guidance = {};

    bus.dialect.glider_identifiers = true;
    bus::SocketCanSettings glider;
    add_bus_filters(glider, bus);
    EXPECT_GT(glider.filters.size(), can.filters.size());

    bus::SocketCanSettings crowded;
    while (crowded.filters.size() < 500) ASSERT_TRUE(crowded.filters.try_push_back({1, 2}));
    add_bus_filters(crowded, bus);
    EXPECT_TRUE(crowded.filters.empty()) << "half a list would lose messages";
}

}  // namespace
}  // namespace tedavis::target::test_board_config
