/// A display that runs on the desk, started with the user's options, and the pixels that it draws.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/png_file.hpp"
#include "host_sim/replay/made_programs.hpp"
#include "platform/runtime/display_host.hpp"

namespace tedavis::host_sim {

using SurfaceMaker = std::function<base::Result<std::unique_ptr<base::Surface>, base::Error>(const platform::SurfaceSettings&)>;

/// The device of the options, without the effects that they forbid. Throws UserError.
[[nodiscard]] effects::DeviceSettings load_device(const PictureOptions& options);
/// The aircraft of a file or shipped name; none where `name` is empty. Throws UserError.
[[nodiscard]] design::AircraftSettings load_aircraft(const std::string& name);
/// The palette of the symbology; the standard one where the options name no file. Throws UserError.
[[nodiscard]] design::SymbologyPalettes load_symbology_palettes(const PictureOptions& options);
/// Settings with which a display without a screen is started, except designs, aircraft and programs. The options must outlive the
/// result.
[[nodiscard]] platform::DisplayHostSettings host_settings(const PictureOptions& options, const effects::DeviceSettings& device);
/// The message for a display that could not be started.
[[nodiscard]] std::string host_fault_text(const platform::HostFault& fault, const PictureOptions& options);

class DisplaySession {
public:
    /// Draws without a screen, with the GL of `options.gl`. Throws UserError with the message of what cannot be opened.
    DisplaySession(const PictureOptions& options, bool generated_flight);
    /// Draws on the surface that `make_surface` opens.
    DisplaySession(const PictureOptions& options, bool generated_flight, const SurfaceMaker& make_surface);
    /// True if the device file states a shader compiler. Throws UserError where the file cannot be read.
    [[nodiscard]] static bool has_compiler(const PictureOptions& options);
    /// The programs that a display with these options is started with, made by this machine's compiler; the device need not
    /// have one. No other session may be current. Throws UserError.
    [[nodiscard]] static MadePrograms make_programs(const PictureOptions& options);
    DisplaySession(const DisplaySession&) = delete;
    DisplaySession& operator=(const DisplaySession&) = delete;

    [[nodiscard]] display::Display& display() { return host_.display(); }
    /// Sessions of one thread draw in turn: call rest() on this one before another is opened or draws, and make_current() before
    /// this one draws again. Throws UserError where the surface is lost.
    void make_current();
    void rest() { host_.release_current(); }
    [[nodiscard]] const effects::DeviceSettings& device() const { return device_; }
    [[nodiscard]] std::uint32_t width() const { return host_.surface().width(); }
    [[nodiscard]] std::uint32_t height() const { return host_.surface().height(); }
    /// The GL and its renderer, "egl: llvmpipe (...)", which every run records.
    [[nodiscard]] std::string gl_description();

    /// Draws the planned frame and reads its pixels back, bottom row first.
    void draw();
    /// Draws the last frame again up to `last`, without the layers in front of it (Display::draw_up_to), and reads the pixels
    /// back.
    void draw_up_to(display::PictureLayer last);
    /// Shows the last picture where the surface has a screen. Throws UserError where the surface is lost.
    void present();
    [[nodiscard]] RgbaView pixels() const { return {pixels_.data(), width(), height(), true}; }
    [[nodiscard]] std::uint64_t frame_hash() const;
    /// A message after a part of the terrain database could not be used (flags "terrain.failing", "terrain.failed"); empty
    /// before.
    [[nodiscard]] std::string terrain_fault() const;

private:
    explicit DisplaySession(const effects::DeviceSettings& device) : device_(device) {}
    DisplaySession(const PictureOptions& options, bool generated_flight, const platform::SurfaceSource& surface);
    void open(const PictureOptions& options, bool generated_flight, const platform::SurfaceSource& surface,
              MadePrograms* programs);
    void start(const platform::DisplayHostSettings& settings, const PictureOptions& options);
    void read_back();

    effects::DeviceSettings device_;
    platform::DisplayHost host_;
    std::vector<std::uint8_t> pixels_;
    std::string terrain_name_;
    bool terrain_faulty_ = false;
};

}  // namespace tedavis::host_sim
