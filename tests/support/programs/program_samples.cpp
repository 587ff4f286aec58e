#include "tests/support/programs/program_samples.hpp"

#include <cstdint>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "render_core/base/hash.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/programs/running_program.hpp"

namespace tedavis::test_support {
namespace {

constexpr int kFixes = 30;  // one a second, north-east of 46.98 N 10.02 E, over the fractal raster

std::string formatted(const char* format, double a, double b) {
    char text[200];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

std::string igc() {
    std::string text = "AXXX001\nHFDTE120420\nHFALGALTGPS:ELL\n";
    for (int i = 0; i < kFixes; ++i) {
        char line[60];
        std::snprintf(line, sizeof line, "B0947%02d4658%03dN01001%03dEA0290003000\n", i, 800 + 5 * i, 200 + 5 * i);
        text += line;
    }
    return text;
}

std::string gpx() {
    std::string text = "<gpx><trk><trkseg>";
    for (int i = 0; i < kFixes; ++i) {
        text += formatted("<trkpt lat='%.5f' lon='%.5f'><ele>3000</ele>", 46.98 + 1e-4 * i, 10.02 + 1e-4 * i);
        text += formatted("<time>2020-04-12T09:47:%02.0fZ</time></trkpt>%.0s", i, 0);
    }
    return text + "</trkseg></trk></gpx>\n";
}

std::string json() {
    std::string text = "[";
    for (int i = 0; i < kFixes; ++i) {
        text += (i > 0 ? ",\n" : "") + formatted("{\"timestamp\":%.0f,\"altitude\":%.0f,", 1586684820000.0 + 1000.0 * i, 9500);
        text += formatted("\"latitude\":%.5f,\"longitude\":%.5f}", 46.98 + 1e-4 * i, 10.02 + 1e-4 * i);
    }
    return text + "]\n";
}

std::string csv() {
    std::string text = "time,latitude_deg,longitude_deg,height_msl_m\n";
    for (int i = 0; i < kFixes; ++i)
        text += formatted("%.0f,%.5f,", 1586684820.0 + i, 46.98 + 1e-4 * i) + formatted("%.5f,%.0f\n", 10.02 + 1e-4 * i, 3000);
    return text;
}

std::string little_endian(std::uint32_t value, int bytes) {
    std::string text;
    for (int n = 0; n < bytes; ++n) text += static_cast<char>(value >> (8 * n) & 0xFF);
    return text;
}

/// A gzip file (RFC 1952) of one stored block (RFC 1951).
std::string packed_csv() {
    const std::string text = csv();
    const auto length = static_cast<std::uint32_t>(text.size());
    return std::string("\x1f\x8b\x08\0\0\0\0\0\0\xff\x01", 11) + little_endian(length, 2) + little_endian(~length, 2) + text +
           little_endian(base::crc32(text.data(), text.size()), 4) + little_endian(length, 4);
}

/// One picture, as small as sheets are.
std::string sheet() {
    return "title = 'One'\ncolumns = 1\nterrain = 'none.tif'\nwidth_px = 64\nheight_px = 48\n\n"
           "[pose]\nlatitude_deg = 46.98\nlongitude_deg = 10.02\naltitude_msl_m = 3500\nheading_deg = 0\n\n"
           "[[group]]\ntitle = 'All'\n[[group.picture]]\ntitle = 'Default'\ndesign = 'default'\n";
}

std::string scene() {
    return "name = 'masts'\n[[layer]]\nname = 'masts'\nsource = 'masts.csv'\nrole = 'obstacle'\nheight_variable = 'height'\n"
           "[[layer.attribute]]\nname = 'height'\nunit = 'm'\n";
}
std::string masts() { return "longitude,latitude,name,height\n10.02,46.98,A,40\n10.03,46.99,B,60\n"; }

/// Cut in its middle, its last row is short.
std::string gaze() { return "x,y,who\n0.5,0.25,first\n0.75,0.5,second\n"; }

/// A binary portable pixmap.
std::string image() {
    std::string text = "P6 64 64 255\n";
    for (int n = 0; n < 64 * 64 * 3; ++n) text += static_cast<char>(n % 251);
    return text;
}

/// Cut anywhere behind its first line, its last row is short.
std::string tour() {
    return "time_s,latitude_deg,longitude_deg,altitude_m,heading_deg,pitch_deg,roll_deg\n"
           "0,46.98,10.02,3500,0,-10,0\n20,46.99,10.03,3400,20,-5,0\n";
}

void run(const std::vector<std::string>& words) {
    std::vector<std::string> line = words;
    line.insert(line.begin(), ProgramSamples::program());
    const ProgramResult result = run_program(line);
    if (result.code != 0) throw std::runtime_error("a sample could not be made: " + words[0] + ": " + result.err);
}

}  // namespace

std::string ProgramSamples::program() { return test_support::binary_dir() + "/bin/tedavis"; }

void ProgramSamples::make(const std::string& name) const {
    static const std::map<std::string, std::string> kShipped = {
        {"scenario.toml", "scenarios/default.toml"},    {"design.toml", "designs/default.toml"},
        {"palette.toml", "palettes/alpine.toml"},       {"device.toml", "devices/es3-mid.toml"},
        {"panel.toml", "switches/one_hot.toml"},        {"bus.toml", "buses/canaerospace.toml"},
        {"aircraft.toml", "aircraft/light_piston.toml"}};
    static const std::map<std::string, std::string (*)()> kWritten = {
        {"flight.igc", igc},           {"flight.gpx", gpx},   {"flight.json", json}, {"flight.csv", csv},
        {"flight.csv.gz", packed_csv}, {"sheet.toml", sheet}, {"image.ppm", image},  {"tour.csv", tour},
        {"masts.csv", masts},          {"scene.toml", scene}, {"gaze.csv", gaze}};
    if (const auto shipped = kShipped.find(name); shipped != kShipped.end()) {
        std::filesystem::copy_file(test_support::source_dir() + "/configs/" + shipped->second, folder_.file(name));
    } else if (const auto written = kWritten.find(name); written != kWritten.end()) {
        folder_.write(name, written->second());
        if (name == "scene.toml") (void)path("masts.csv");  // which it names
    } else {
        make_with_program(name);
    }
}

void ProgramSamples::make_with_program(const std::string& name) const {
    if (name == "raster.tif") {
        run({"terrain", "fractal", "--size", "129", "-o", folder_.file(name)});
    } else if (name == "terrain.tdb") {
        run({"terrain", "build", path("raster.tif"), "-o", folder_.file(name)});
    } else if (name == "picture.png") {
        run({"shot", "--pose", "46.98,10.02,3500,0,0,0", "--size", "64x48", "-o", folder_.file(name)});
    } else if (name == "scene.sdb") {
        run({"scene", "build", path("scene.toml"), "-o", folder_.file(name)});
    } else if (name == "run.log" || name == "run.switches") {
        run({"scenario", "build", "default", "-o", folder_.file("scenario")});
        std::filesystem::rename(folder_.file("scenario/flight.log"), folder_.file("run.log"));
        std::filesystem::rename(folder_.file("scenario/flight.switches"), folder_.file("run.switches"));
    } else if (name == "run" || name == "replay.toml") {
        run({"replay", path("run.log"), "--frames", "hash", "--size", "64x48", "--to", "1", "-o", folder_.file("run"),
             "--save-config", folder_.file("replay.toml")});
    } else if (name == "frames.jsonl") {
        std::filesystem::copy_file(path("run") + "/" + name, folder_.file(name));
    } else {
        throw std::runtime_error(name + ": no such sample");
    }
}

const ProgramSamples& ProgramSamples::get() {
    static const ProgramSamples samples;
    return samples;
}

std::string ProgramSamples::path(const std::string& name) {
    const ProgramSamples& samples = get();
    if (!std::filesystem::exists(samples.folder_.file(name))) samples.make(name);
    return samples.folder_.file(name);
}

std::string ProgramSamples::read(const std::string& name) {
    (void)path(name);
    return get().folder_.read(name);
}

}  // namespace tedavis::test_support
