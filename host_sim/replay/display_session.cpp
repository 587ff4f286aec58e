#include "host_sim/replay/display_session.hpp"

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "platform/surface_factory.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/gl/readback.hpp"

namespace tedavis::host_sim {
namespace {

effects::DeviceSettings load_device(const std::string& name) {
    const std::string path = resolve_config(name, "devices");
    auto device = effects::read_device_settings(read_file(path), path);
    if (!device.ok()) throw UserError(std::string(device.error().sentence.view()));
    return device.value();
}

design::DesignSettings load_design(const PictureOptions& options) {
    const std::string path = resolve_config(options.design, "designs");
    auto design = design::read_design_settings(read_file(path), path);
    if (!design.ok()) throw UserError(std::string(design.error().sentence.view()));
    if (options.tau_px) design.value().terrain.tau_px = *options.tau_px;
    return design.value();
}

}  // namespace

DisplaySession::DisplaySession(const PictureOptions& options, bool generated_flight) : device_(load_device(options.device)) {
    display::DisplaySettings settings;
    settings.device = device_;
    settings.design = load_design(options);
    settings.width_px = options.size ? options.size->width : device_.width_px;
    settings.height_px = options.size ? options.size->height : device_.height_px;
    settings.generated_flight = generated_flight;
    if (!options.terrain.empty()) {
        auto file = platform::open_file(options.terrain.c_str());
        if (!file.ok()) throw UserError(std::string(file.error().sentence.view()));
        terrain_file_ = std::move(file.value());
    }
    const auto lane = device_.capability.lane == effects::Lane::es2 ? platform::ContextLane::es2 : platform::ContextLane::es3;
    auto surface =
        platform::make_surface(options.gl == GlChoice::egl ? "egl" : "osmesa", {settings.width_px, settings.height_px, lane});
    if (!surface.ok()) throw UserError(std::string(surface.error().sentence.view()));
    surface_ = std::move(surface.value());
    if (!surface_->make_current()) throw UserError("--gl: the drawing surface cannot be made current; try the other --gl");
    auto reservation = platform::reserve_memory(display::Display::bytes_needed(device_), platform::Residency::lazy);
    if (!reservation.ok()) throw UserError(std::string(reservation.error().sentence.view()));
    reservation_ = std::move(reservation.value());
    display_ = std::make_unique<display::Display>();
    const gl::GlError error =
        display_->start(settings, reservation_.arena(), *surface_, options.terrain.empty() ? nullptr : &terrain_file_);
    if (!error.sentence.empty())
        throw UserError((options.terrain.empty() ? std::string() : options.terrain + ": ") + std::string(error.sentence.view()));
    pixels_.resize(std::size_t{settings.width_px} * settings.height_px * 4);
}

DisplaySession::~DisplaySession() {
    if (display_) display_->stop();
    display_.reset();
    if (surface_) surface_->release_current();
}

std::string DisplaySession::gl_description() {
    const gl::DriverFacts& driver = display_->gl().driver();
    return std::string(surface_->backend_name()) + ": " + std::string(driver.renderer.view()) + ", " +
           std::string(driver.version.view());
}

void DisplaySession::draw() {
    display_->draw(*surface_);
    if (!gl::read_pixels(display_->gl(), width(), height(), {pixels_.data(), pixels_.size()}))
        throw UserError("--gl: the picture cannot be read back; try the other --gl");
}

std::uint64_t DisplaySession::frame_hash() const {
    return base::frame_hash(pixels_.data(), surface_->width(), surface_->height(), true);
}

}  // namespace tedavis::host_sim
