#include "target/self_test.hpp"

#include <memory>
#include <utility>

#include "bus/canaerospace/bus_settings.hpp"
#include "platform/files/memory_byte_source.hpp"
#include "platform/reservation/memory_reservation.hpp"
#include "platform/surface_factory.hpp"
#include "render_core/display/display.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/gl/readback.hpp"
#include "target/json_line.hpp"
#include "target/self_test/embedded_files.hpp"
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
    SelfTest(const SelfTestInputs& inputs, SelfTestReport& report) : inputs_(inputs), report_(report), terrain_(inputs.terrain) {}
    ~SelfTest() {
        if (display_) display_->stop();
        display_.reset();
        if (surface_) surface_->release_current();
    }
    SelfTest(const SelfTest&) = delete;
    SelfTest& operator=(const SelfTest&) = delete;

    void run() {
        if (!read_settings() || !open_surface() || !start_display()) return;
        const KnownFlight flight = play_known_flight(inputs_.log, bus_, display_->planner());
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
                         read("es2-small.toml", inputs_.device, settings_.device, &effects::read_device_settings) &&
                         read("default.toml", inputs_.design, settings_.design, read_design);
        settings_.width_px = kKnownPictureWidth;
        settings_.height_px = kKnownPictureHeight;
        return all;
    }

    bool open_surface() {
        const auto lane =
            settings_.device.capability.lane == effects::Lane::es2 ? platform::ContextLane::es2 : platform::ContextLane::es3;
        auto surface = platform::make_surface("egl", {settings_.width_px, settings_.height_px, lane});
        if (!surface.ok()) {
            report_.add("surface", false, surface.error().message.view());
            return false;
        }
        surface_ = std::move(surface.value());
        const bool current = surface_->make_current();
        report_.add("surface", current, current ? "egl, 640 x 480, no window" : "cannot be made current");
        return current;
    }

    bool start_display() {
        const std::uint64_t picture_bytes = std::uint64_t{4} * settings_.width_px * settings_.height_px;
        auto reserved =
            platform::reserve_memory(display::DisplayMemory::bytes_needed(settings_.device.budget), platform::Residency::lazy);
        auto picture = platform::reserve_memory(picture_bytes, platform::Residency::lazy);
        if (!reserved.ok() || !picture.ok()) {
            report_.add("memory", false, (reserved.ok() ? picture : reserved).error().message.view());
            return false;
        }
        memory_ = std::move(reserved.value());
        picture_ = std::move(picture.value());
        display_ = std::make_unique<display::Display>();
        const base::Error error =
            display_->start(settings_, memory_.arena(), *surface_, {&terrain_, &reader_, terrain::ArrivalMode::exact});
        if (error) {
            report_.add("display", false, error.message.view());
            return false;
        }
        report_.add("display", true, display_->gl().driver_text().view());
        return true;
    }

    void draw(const KnownFlight& flight) {
        display::settle(*display_, {flight.aircraft, flight.phase, flight.now});
        display_->plan({flight.aircraft, flight.phase, flight.now});
        display_->draw(*surface_);
        report_.add("presented", surface_->present() == base::SurfaceState::ready, "one frame");
        const display::FrameRecord& record = display_->record();
        report_.add("flags", record.flags.empty(), record.flags.empty() ? "none" : record.flags[0].view());
        report_.add_count("terrain_triangles", record.terrain.triangles, 1000, settings_.device.triangle_budget);
        base::Arena arena = picture_.arena();
        const auto pixels = arena.allocate_array<std::uint8_t>(static_cast<std::size_t>(picture_.bytes()));
        if (gl::read_pixels(display_->gl(), settings_.width_px, settings_.height_px, pixels))
            check_known_picture(pixels, report_);
        else
            report_.add("picture", false, "cannot be read back");
        report_.add_count("gl_errors", display_->gl().take_error(), 0, 0);
        report_.add_count("gl_calls_outside_device", display_->gl().denied().total, 0, 0);
    }

    const SelfTestInputs& inputs_;
    SelfTestReport& report_;
    platform::MemoryByteSource terrain_;
    base::SynchronousReader reader_{terrain_, base::kMaxReadTickets};
    display::DisplaySettings settings_;
    bus::BusSettings bus_;
    std::unique_ptr<base::Surface> surface_;
    platform::MemoryReservation memory_, picture_;
    std::unique_ptr<display::Display> display_;
};

void print_json(const SelfTestReport& report, std::FILE* out) {
    JsonLine json;
    json.open_object().boolean("self_test", report.holds()).text("version", TEDAVIS_VERSION).open_list("checks");
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
            {{"alpine", text_of(embedded::k_alpine_toml)},
             {"data_radar", text_of(embedded::k_data_radar_toml)},
             {"data_wind", text_of(embedded::k_data_wind_toml)}}};
}

void run_self_test(const SelfTestInputs& inputs, SelfTestReport& report) { SelfTest(inputs, report).run(); }

void print_self_test(const SelfTestReport& report, bool json, std::FILE* out) {
    if (json) return print_json(report, out);
    for (const SelfCheck& check : report.checks())
        std::fprintf(out, "%-7s %-24s %s\n", check.holds ? "ok" : "FAILED", check.name.c_str(), check.finding.c_str());
    std::fprintf(out, "self-test: %s\n", report.holds() ? "passed" : "FAILED");
}

}  // namespace tedavis::target
