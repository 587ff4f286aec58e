#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/option_texts.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kFlyExample =
    "Example:\n"
    "  tedavis fly flight.igc --terrain alps.tif -o out/flight\n"
    "converts the flight, builds a terrain database from alps.tif (once; it is kept in the cache), draws some 300 frames while\n"
    "the flight is over it, and writes out/flight/report.html.";

/// Of a flight that is a bus log.
void add_bus_options(CLI::App* command, ReplayOptions& o) {
    command->add_option("--switches", o.switches, "switch log of a bus log");
    command->add_option("--switch-config", o.switch_config, "file or shipped name")->capture_default_str();
    command->add_option("--bus", o.picture.bus, "bus file or shipped name: how the frames of a bus log are read")
        ->capture_default_str();
}

void add_look_options(CLI::App* command, PictureOptions& picture) {
    command->add_option("--design", picture.design, "design file or shipped name")->capture_default_str();
    command->add_option("--device", picture.device, "device file or shipped name")->capture_default_str();
    command->add_option("--aircraft-file", picture.aircraft,
                        "aircraft file or shipped name: speeds for the airspeed tape and the pilot's eye point");
    command->add_option_function<std::string>(
        "--size", [&picture](const std::string& text) { picture.size = size_from(text); }, "WIDTHxHEIGHT; default: the device's");
    static const std::map<std::string, GlChoice> kGl = {{"egl", GlChoice::egl}, {"osmesa", GlChoice::osmesa}};
    command
        ->add_option_function<std::string>(
            "--gl", [&picture](const std::string& word) { picture.gl = choice_from("--gl", word, kGl); }, "egl or osmesa")
        ->default_str("egl");
}

/// What is flown, over what and with which data.
void add_flown(CLI::App* command, FlyOptions& o) {
    command
        ->add_option("FLIGHT", o.flight.flight, "the recording: IGC, GPX, ADS-B JSON, CSV, or a bus log; may be gzip-compressed")
        ->required();
    command
        ->add_option("--terrain", o.terrain.rasters,
                     "terrain database (.tdb), or any raster that GDAL reads, from which one is built and kept in the cache; may "
                     "be repeated for several rasters")
        ->allow_extra_args(false);
    CLI::Option* const weather =
        command
            ->add_option("--weather", o.weather,
                         "grid of weather (GeoTIFF, netCDF, GRIB): wind, radar, or the file's only variable; may be repeated")
            ->allow_extra_args(false);
    command->add_option("--scene", o.scene, "spatial data: scene file or shipped name, which is built, or scene database (.sdb)")
        ->excludes(weather);
}

}  // namespace

void add_fly(CLI::App& app, CommandLine& line) {
    FlyOptions& o = line.fly;
    o.replay.spread = kFlyFrames;
    CLI::App* command = add_long_command(app, line, "fly", "from a recorded flight to its report, in one command",
                                         [&o](Console& console) { return run_fly(o, console); });
    add_flown(command, o);
    command->add_option("-o", o.replay.output, "folder to write to")->required();
    add_optional(command, "--frames", o.replay.spread,
                 "about so many frames, evenly, and one where a phase or a terrain alert begins; default: 300")
        ->check(CLI::Range(2u, kMaxSpread));
    command->add_flag("--yes", o.replay.yes, "begins a run of more than 20,000 frames or 4 GB without a question");
    add_strict(command, o.replay.strict);
    add_flight_options(command, o.flight);
    add_class(command, o.replay.aircraft_class, "that of the aircraft file, or glider for an IGC file");
    add_look_options(command, o.replay.picture);
    add_bus_options(command, o.replay);
    add_raster_options(command, o.terrain);
    command->footer(kFlyExample);
}

}  // namespace tedavis::host_sim
