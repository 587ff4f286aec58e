#include "target/self_test.hpp"

#include <memory>
#include <utility>

#include "bus/canaerospace/bus_settings.hpp"
#include "platform/files/memory_byte_source.hpp"
#include "platform/reservation/memory_reservation.hpp"
#include "platform/runtime/display_host.hpp"
#include "render_core/base/float_environment.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/gl/readback.hpp"
#include "target/json_line.hpp"
#include "target/self_test/embedded_files.hpp"
#include "target/self_test/geodesy_check.hpp"
#include "target/self_test/known_flight.hpp"
#include "target/self_test/known_picture.hpp"

namespace tedavis::target {
namespace {

template <std::size_t N>
std::string_view text_of(const unsigned char (&bytes)[N]) {
    return {reinterpret_cast<const char*>(bytes), N - 1};  // the embedded zero behind it
}

/// The design's palettes come from the program as well.
class EmbeddedPalettes final : public design::DesignSource {
public:
    explicit EmbeddedPalettes(base::Span<const NamedPalette> palettes) : palettes_(palettes) {}
    base::Result<design::Palette, base::Error> find(const base::StatedFile& stated) override {
        for (const NamedPalette& palette : palettes_)
            if (palette.name == stated.name) return design::read_palette(palette.text, palette.name);
        return base::fail(base::Error{"is none of the palettes that the self-test has"});
    }
    base::Result<design::DesignText, base::Error> find_design(const base::StatedFile& /*design*/) override {
        return base::fail(base::Error{"the design of the self-test is based on none; leave 'based_on' out"});
    }

private:
    base::Span<const NamedPalette> palettes_;
};

/// The parts of the test, each of which needs those before it.
class SelfTest {
public:
    SelfTest(const SelfTestInputs& inputs, SelfTestReport& report) : inputs_(inputs), report_(report), terrain_(inputs.terrain) {
        settings_.terrain.bytes = &terrain_;
    }

    void run() {
        if (!read_settings() || !start_display()) return;
        const KnownFlight flight = play_known_flight(inputs_.log, bus_, host_.display().planner());
        check_known_flight(flight, report_);
        draw(flight);
    }

private:
    template <class Settings, class Load>
    bool read(const char* name, std::string_view text, Settings& settings, Load load) {
        auto loaded = load(text, name);
        if (loaded.ok())
            settings = loaded.value();
        else
            report_.add(name, false, loaded.error().message.view());
        return loaded.ok();
    }

    bool read_settings() {
        EmbeddedPalettes palettes(inputs_.palettes);
        const auto read_design = [&palettes](std::string_view text, std::string_view name) {
            return design::read_design_settings(text, name, palettes);
        };
        const bool all = read("canaerospace.toml", inputs_.bus, bus_, &bus::load_bus_settings) &&
                         read("es2-small.toml", inputs_.device, settings_.display.device, &effects::read_device_settings) &&
                         read("default.toml", inputs_.design, settings_.display.design, read_design);
        settings_.display.width_px = kKnownPictureWidth;
        settings_.display.height_px = kKnownPictureHeight;
        return all;
    }

    bool start_display() {
        using platform::HostPart;
        const platform::HostFault fault = host_.start(settings_);
        if (fault.part == HostPart::surface || fault.part == HostPart::context) {
            const bool is_made = fault.part == HostPart::context;
            report_.add("surface", false, is_made ? "cannot be made current" : fault.error.message.view());
            return false;
        }
        report_.add("surface", true, "egl, 640 x 480, no window");
        auto picture =
            platform::reserve_memory(std::uint64_t{4} * kKnownPictureWidth * kKnownPictureHeight, platform::Residency::lazy);
        if (fault.part == HostPart::memory || !picture.ok()) {
            report_.add("memory", false, (picture.ok() ? fault.error : picture.error()).message.view());
            return false;
        }
        picture_ = std::move(picture.value());
        report_.add("display", !fault, fault ? fault.error.message.view() : host_.display().gl().driver_text().view());
        return !fault;
    }

    void draw(const KnownFlight& flight) {
        display::Display& display = host_.display();
        display::settle(display, {flight.aircraft, flight.phase, flight.now});
        display.plan({flight.aircraft, flight.phase, flight.now});
        display.draw(host_.surface());
        report_.add("presented", host_.surface().present() == base::SurfaceState::ready, "one frame");
        const display::FrameRecord& record = display.record();
        // The self-test's terrain is small: the track leaves it within the minute. Nothing else is flagged.
        const bool ends_only = record.flags.size() == 1 && record.flags[0].view() == "terrain.ends";
        report_.add("flags", ends_only, record.flags.empty() ? "none, expected terrain.ends" : record.flags[0].view());
        report_.add_count("terrain_triangles", record.terrain.triangles, 1000, settings_.display.device.triangle_budget);
        base::Arena arena = picture_.arena();
        const auto pixels = arena.allocate_array<std::uint8_t>(static_cast<std::size_t>(picture_.bytes()));
        if (gl::read_pixels(display.gl(), kKnownPictureWidth, kKnownPictureHeight, pixels))
            check_known_picture(pixels, report_);
        else
            report_.add("picture", false, "cannot be read back");
        report_.add_count("gl_errors", display.gl().take_error(), 0, 0);
        report_.add_count("gl_calls_outside_device", display.gl().denied().total, 0, 0);
    }

    const SelfTestInputs& inputs_;
    SelfTestReport& report_;
    platform::MemoryByteSource terrain_;
    platform::DisplayHostSettings settings_;
    bus::BusSettings bus_;
    platform::MemoryReservation picture_;
    platform::DisplayHost host_;
};

/// The flight of the start test is over no terrain.
class NoTerrain final : public flight::TerrainHeights {
public:
    base::Stamped<double> height_above_terrain(const flight::OwnShipEstimate&, base::Time) override { return {}; }
};

void print_json(const SelfTestReport& report, const char* title, std::FILE* out) {
    JsonLine json;
    json.open_object().boolean(title, report.holds()).text("version", TEDAVIS_VERSION).open_list("checks");
    for (const SelfCheck& check : report.checks())
        json.open_object()
            .text("name", check.name.view())
            .boolean("holds", check.holds)
            .text("finding", check.finding.view())
            .close_object();
    std::fputs(json.close_list().close_object().line().data(), out);
}

}  // namespace

SelfTestInputs embedded_inputs() noexcept {
    const std::string_view log = text_of(embedded::k_flight_log);
    return {{log.data(), log.size()},
            {embedded::k_terrain_tdb, embedded::k_terrain_tdb_size},
            text_of(embedded::k_canaerospace_toml),
            text_of(embedded::k_es2_small_toml),
            text_of(embedded::k_default_toml),
            {{"natural", text_of(embedded::k_natural_toml)}, {"data_radar", text_of(embedded::k_data_radar_toml)}}};
}

void check_arithmetic(const char* name, SelfTestReport& report) {
    const base::FloatFault fault = base::float_fault();
    report.add(name, fault == base::FloatFault::none, base::words_of(fault));
}

void run_self_test(const SelfTestInputs& inputs, SelfTestReport& report) {
    check_arithmetic("arithmetic", report);
    check_geodesy(report);
    SelfTest(inputs, report).run();
    check_arithmetic("arithmetic_after_drawing", report);
}

void run_start_test(const SelfTestInputs& inputs, SelfTestReport& report) {
    const auto settings = bus::load_bus_settings(inputs.bus, "canaerospace.toml");
    if (!settings.ok()) return report.add("canaerospace.toml", false, settings.error().message.view());
    check_arithmetic("arithmetic", report);
    NoTerrain terrain;
    check_known_flight(play_known_flight(inputs.log, settings.value(), terrain), report, false);
    check_geodesy(report);
}

void print_self_test(const SelfTestReport& report, bool json, std::FILE* out) {
    if (json) return print_json(report, "self_test", out);
    print_checks(report, "self-test", false, out);
}

void print_checks(const SelfTestReport& report, const char* title, bool json, std::FILE* out) {
    if (json) return print_json(report, title, out);
    for (const SelfCheck& check : report.checks())
        std::fprintf(out, "%-7s %-24s %s\n", check.holds ? "ok" : "FAILED", check.name.c_str(), check.finding.c_str());
    std::fprintf(out, "%s: %s\n", title, report.holds() ? "passed" : "FAILED");
}

}  // namespace tedavis::target
